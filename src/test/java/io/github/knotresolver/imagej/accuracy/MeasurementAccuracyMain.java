package io.github.knotresolver.imagej.accuracy;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeSet;

import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.imagej.ImageFile;
import io.github.knotresolver.imagej.ImageMovie;
import io.github.knotresolver.imagej.accuracy.Coverage.Tally;
import io.github.knotresolver.io.ContoursCsv;
import io.github.knotresolver.measure.DominantFrequency;
import io.github.knotresolver.measure.MeasuredTracks;
import io.github.knotresolver.measure.MovieMeasurements;
import io.github.knotresolver.measure.Quantity;
import io.github.knotresolver.measure.TravellingWave;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.options.InputOptions;
import io.github.knotresolver.options.RunOptions;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.session.Session;
import io.github.knotresolver.simulate.FilamentProperties;
import io.github.knotresolver.simulate.FilamentSimulator;
import io.github.knotresolver.simulate.FilamentSimulator.Trajectory;
import io.github.knotresolver.simulate.MediumProperties;
import io.github.knotresolver.simulate.MotorProperties;
import io.github.knotresolver.simulate.Schedule;
import io.github.knotresolver.simulate.SimulatedMovie;
import io.github.knotresolver.simulate.SimulationParameters;

/**
 * The whole way, for {@code scripts/measurement-accuracy}: simulated movies are
 * resolved with the defaults and measured, and the intervals are compared with
 * the truth. Writes the tables of {@code docs/measurements.md}.
 */
public final class MeasurementAccuracyMain {

	private static final double[] LENGTHS = {5, 8, 11, 14, 18}, DENSITIES = {25, 50};
	/** Not among the seeds that the method was developed with. */
	private static final long FIRST_SEED = 4201;
	private static final int FRAMES = 40;
	private static final double INTERVAL = 2.5;
	private static final Wave WAVE = new Wave(0.0371, 0.22);
	private static final int WAVE_FRAMES = 60;
	private static final List<Quantity> QUANTITIES = List.of(Quantity.LENGTH, Quantity.END_TO_END,
		Quantity.TIP_ANGLE, Quantity.TURNING_NUMBER, Quantity.RADIUS_OF_GYRATION,
		Quantity.BENDING_ENERGY);

	private final PrintStream out;

	private MeasurementAccuracyMain(final PrintStream out) {
		this.out = out;
	}

	/**
	 * @param args number of filaments, number of beating filaments, and perhaps a
	 *          folder of rendered movies with their truth
	 * @throws IOException if a movie cannot be read
	 */
	public static void main(final String[] args) throws IOException {
		final MeasurementAccuracyMain main = new MeasurementAccuracyMain(System.out);
		main.frames(Integer.parseInt(args[0]));
		main.oscillations(Integer.parseInt(args[1]));
		if (args.length > 2)
			main.bench(Path.of(args[2]));
	}

	private void frames(final int filaments) {
		out.println(
			"| movies | frames (wrong) | mean error of length | "
				+ String.join(" | ",
					QUANTITIES.stream().map(q -> q.label().toLowerCase(Locale.ROOT)).toList())
				+ " |");
		out.println("|---|---|---|" + "---|".repeat(QUANTITIES.size()));
		for (final Pictures pictures : Pictures.values()) {
			final Coverage coverage = new Coverage();
			for (int k = 0; k < filaments; k++)
				coverage.add(coverage(pictures, k, FRAMES));
			final StringBuilder row = new StringBuilder(String.format(Locale.ROOT,
				"| %s | %d (%d) | %+.2f %% |", pictures.label(), coverage.frames(),
				coverage.wrong(), 100 * coverage.of(Quantity.LENGTH).meanRelativeError()));
			for (final Quantity q : QUANTITIES)
				row.append(' ').append(coverage.of(q).cell()).append(" |");
			out.println(row);
		}
	}

	/** One filament, resolved and measured. */
	static Coverage coverage(final Pictures pictures, final int filament, final int frames) {
		final Coverage coverage = new Coverage();
		final SimulatedMovie movie = pictures.movie(filament(filament, frames),
			FIRST_SEED + filament);
		final MeasuredTracks result = measured(movie.movie());
		for (int t = 0; t < movie.truth().size(); t++) {
			final Optional<Polyline> contour = result.tracks().only().frames().get(t).contour();
			if (contour.isPresent())
				coverage.add(result.filaments().get(0).measurements().orElseThrow().frames().get(t),
					contour.get(), movie.truth().get(t), movie.movie().calibration().pixelSize());
		}
		return coverage;
	}

	private static Trajectory filament(final int k, final int frames) {
		return new FilamentSimulator(
			new SimulationParameters(FilamentProperties.microtubule(LENGTHS[k % LENGTHS.length]),
				MotorProperties.dynein(DENSITIES[k / LENGTHS.length % DENSITIES.length]),
				MediumProperties.WATER, new Schedule(INTERVAL * frames, frames, 0.005, 30),
				FIRST_SEED + k))
			.run(Progress.NONE);
	}

	private static MeasuredTracks measured(final Movie movie) {
		return MeasuredTracks.of(new Session(movie, RunOptions.parse(Map.of()).parameters(movie))
			.solve(List.of(), Progress.NONE), Progress.NONE);
	}

	private void oscillations(final int filaments) {
		out.println();
		out.println(
			"| movies | number | tip angle: dominant frequency | believed | wave: frequency (rms) | wave: speed |");
		out.println("|---|---|---|---|---|---|");
		for (final Pictures pictures : Pictures.values()) {
			final Tally frequency = new Tally(), waves = new Tally(), speed = new Tally();
			int believed = 0;
			for (int k = 0; k < filaments; k++) {
				final MovieMeasurements m = measured(
					pictures.movie(WAVE.trajectory(WAVE_FRAMES, FIRST_SEED + k), k).movie())
					.filaments().get(0).measurements().orElseThrow();
				final Optional<DominantFrequency> d = m.dominantFrequency(Quantity.TIP_ANGLE);
				d.ifPresent(f -> frequency.add(f.frequency() - WAVE.frequency(), f.standardError(),
					WAVE.frequency()));
				if (d.filter(DominantFrequency::isSignificant).isPresent())
					believed++;
				TravellingWave.of(m.tangentAngleKymograph()).ifPresent(w -> {
					waves.add(w.frequency() - WAVE.frequency(), Double.POSITIVE_INFINITY,
						WAVE.frequency());
					speed.add(w.speed() - WAVE.speed(), w.speedError(), WAVE.speed());
				});
			}
			out.printf(Locale.ROOT, "| %s | %d | %s | %d | %.2g Hz | %s |%n", pictures.label(),
				filaments, frequency.cell(), believed, waves.rms(), speed.cell());
		}
	}

	private void bench(final Path folder) throws IOException {
		out.println();
		out.println("| movie | right frames | mean error of length | end-to-end, mean error |");
		out.println("|---|---|---|---|");
		final List<Double> lengths = new ArrayList<>(), ends = new ArrayList<>();
		for (final Path file : movies(folder)) {
			final String name = file.getFileName().toString().replace(".tif", "");
			final Map<Integer, Polyline> truth = ContoursCsv
				.read(folder.resolve(name.replaceFirst("_snr.*", "") + "_gt.csv"));
			final Coverage coverage = new Coverage();
			final MeasuredTracks result = measured(
				ImageMovie.of(ImageFile.open(file), InputOptions.DEFAULT));
			for (final Map.Entry<Integer, Polyline> t : truth.entrySet()) {
				final int i = t.getKey() - 1;
				result.tracks().only().frames().get(i).contour()
					.ifPresent(c -> coverage.add(
						result.filaments().get(0).measurements().orElseThrow().frames().get(i), c,
						t.getValue(), result.calibration().pixelSize()));
			}
			if (coverage.frames() == 0)
				continue;
			final double length = coverage.of(Quantity.LENGTH).meanRelativeError();
			final double end = coverage.of(Quantity.END_TO_END).meanError()
				/ (coverage.of(Quantity.LENGTH).meanError() / length);
			lengths.add(length);
			ends.add(end);
			out.printf(Locale.ROOT, "| %s | %d of %d | %+.2f %% | %+.2f %% of the length |%n", name,
				coverage.frames(), truth.size(), 100 * length, 100 * end);
		}
		out.printf(Locale.ROOT, "| mean | | %+.2f %% | %+.2f %% |%n", 100 * mean(lengths),
			100 * mean(ends));
	}

	private static double mean(final List<Double> values) {
		return values.stream().mapToDouble(v -> v).average().orElse(Double.NaN);
	}

	private static TreeSet<Path> movies(final Path folder) throws IOException {
		final TreeSet<Path> found = new TreeSet<>();
		try (
			DirectoryStream<Path> files = Files.newDirectoryStream(folder, "L*_snr10{,_add}.tif")) {
			files.forEach(found::add);
		}
		return found;
	}
}
