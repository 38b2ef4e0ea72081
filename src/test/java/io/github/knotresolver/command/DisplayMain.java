package io.github.knotresolver.command;

import java.awt.EventQueue;
import java.awt.Toolkit;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;

import ij.ImageJ;
import ij.ImagePlus;
import ij.WindowManager;
import ij.plugin.frame.RoiManager;
import ij.text.TextWindow;
import io.github.knotresolver.imagej.ContourTables;
import io.github.knotresolver.imagej.ImageMovie;
import io.github.knotresolver.imagej.ResultDisplay;
import io.github.knotresolver.imagej.RoiConverter;
import io.github.knotresolver.imagej.TestImages;
import io.github.knotresolver.measure.MeasuredTracks;
import io.github.knotresolver.model.Anchor;
import io.github.knotresolver.model.FilamentTrack;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.model.Settings;
import io.github.knotresolver.model.Tracks;
import io.github.knotresolver.options.InputOptions;
import io.github.knotresolver.progress.Progress;

/**
 * How long a finished result of 120 frames takes until it is in overlay, ROI
 * Manager and tables. Started by {@code scripts/measure-display}, which gives it
 * a display.
 */
final class DisplayMain {

	private static final int FRAMES = 120, POINTS = 200, RUNS = 11;

	private DisplayMain() {
	}

	public static void main(final String[] args) throws Exception {
		new ImageJ();
		final ImagePlus image = TestImages.movie(FRAMES, 8);
		image.show();
		final Movie movie = ImageMovie.of(image, InputOptions.DEFAULT);
		final MeasuredTracks result = MeasuredTracks.of(
			detailed(TestImages.resolve(movie, Settings.DEFAULT, Progress.NONE)), Progress.NONE);
		final double[] millis = new double[RUNS];
		for (int run = 0; run < RUNS; run++) {
			final long start = System.nanoTime();
			show(image, result);
			millis[run] = (System.nanoTime() - start) / 1e6;
			closeTables(image);
		}
		final double[] later = Arrays.copyOfRange(millis, 1, RUNS);
		Arrays.sort(later);
		System.out.printf(Locale.ROOT,
			"%d frames, %d points in all: first time %.0f ms, then %.0f ms (median of %d).%n",
			FRAMES, result.tracks().only().frames().stream().flatMap(f -> f.contour().stream())
				.mapToInt(c -> c.size()).sum(),
			millis[0], later[later.length / 2], later.length);
		System.exit(0);
	}

	/** With as many points as a filament of 20 um has at 0.1 um a pixel. */
	private static Tracks detailed(final Tracks r) {
		final List<Observation> frames = r.only().frames().stream()
			.map(f -> new Observation(f.frame(), f.status(), f.reason(),
				f.contour().map(c -> c.divided(POINTS - 1)), f.junctions(), f.candidates(),
				f.cost(), f.confidence()))
			.toList();
		return new Tracks(
			r.movie(), r.settings(), List.of(new FilamentTrack(1, Anchor.CLAMPED,
				r.only().fixedEnd(), r.only().length(), r.only().lengthError(), frames)),
			r.notes());
	}

	private static void show(final ImagePlus image, final MeasuredTracks result) throws Exception {
		final ResultDisplay display = new ResultDisplay(image, result.tracks(),
			RoiConverter.forImage(image, 1));
		display.overlay();
		display.fill(RoiManager.getRoiManager());
		new ContourTables(image.getTitle(), result).show();
		EventQueue.invokeAndWait(() -> {
			// All that was to be drawn has been.
		});
		Toolkit.getDefaultToolkit().sync();
	}

	private static void closeTables(final ImagePlus image) {
		for (final String table : new String[]{"-contours", "-frames"})
			((TextWindow) WindowManager.getWindow(image.getTitle() + table)).close(false);
	}
}
