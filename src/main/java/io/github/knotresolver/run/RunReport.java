package io.github.knotresolver.run;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SortedSet;
import java.util.TreeSet;

import io.github.knotresolver.io.NumberText;
import io.github.knotresolver.measure.FilamentSummary;
import io.github.knotresolver.measure.LengthStatistics;
import io.github.knotresolver.measure.MeasuredFilament;
import io.github.knotresolver.measure.MeasuredTracks;
import io.github.knotresolver.model.Calibration;
import io.github.knotresolver.model.FilamentTrack;
import io.github.knotresolver.model.FrameStatus;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.model.Tracks;
import io.github.knotresolver.options.FrameSelection;

/** A result in a few lines, for people. */
public final class RunReport {

	private static final int SPREAD_DIGITS = 2;

	private RunReport() {
	}

	/**
	 * @param result a measured result
	 * @return a few lines
	 */
	public static List<String> lines(final MeasuredTracks result) {
		final List<String> lines = new ArrayList<>();
		lines.add(headline(result));
		if (result.isSeveral())
			result.filaments().forEach(f -> lines.add(line(f, result.calibration())));
		for (final FrameStatus status : List.of(FrameStatus.UNRESOLVED, FrameStatus.LOST))
			for (final MeasuredFilament filament : result.filaments()) {
				final SortedSet<Integer> some = frames(filament, status);
				if (!some.isEmpty())
					lines.add(frames(result, filament) + "rames " + status.label() + ": "
						+ FrameSelection.format(some) + " (frames.csv says why).");
			}
		lines.addAll(result.tracks().notes());
		return lines;
	}

	private static String headline(final MeasuredTracks result) {
		final Tracks tracks = result.tracks();
		final int frames = tracks.movie().size();
		if (tracks.filaments().isEmpty())
			return tracks.movie().name() + ": no filament was found in " + frames + " frames.";
		if (result.isSeveral())
			return tracks.movie().name() + ": " + tracks.filaments().size() + " filaments; "
				+ tracks.filaments().stream().mapToInt(FilamentTrack::resolved).sum() + " of "
				+ tracks.filaments().stream().mapToLong(RunReport::inView).sum()
				+ " filament-frames resolved.";
		final LengthStatistics s = LengthStatistics.of(result.frames());
		final String unit = " " + result.calibration().unit();
		return tracks.movie().name() + ": " + tracks.resolved() + " of " + frames
			+ " frames resolved"
			+ (Double.isNaN(s.median())
				? "."
				: ", median length " + NumberText.significant(s.median()) + unit + " (sd "
					+ NumberText.significant(s.sd(), SPREAD_DIGITS) + unit + ").");
	}

	private static String line(final MeasuredFilament filament, final Calibration c) {
		final FilamentSummary s = FilamentSummary.of(filament, c);
		final FilamentTrack track = filament.track();
		if (s.firstFrame().isEmpty())
			return "Filament " + track.id() + " (" + track.anchor().label() + "): never in view.";
		return "Filament " + track.id() + " (" + track.anchor().label() + "): frames "
			+ s.firstFrame().getAsInt() + "-" + s.lastFrame().getAsInt() + ", resolved in "
			+ track.resolved()
			+ (Double.isNaN(s.length())
				? ""
				: ", length " + NumberText.significant(s.length()) + " " + c.unit())
			+ s.gliding().map(g -> ", glides at " + NumberText.significant(g.speed()) + " "
				+ c.unit() + "/" + c.timeUnit()).orElse("")
			+ ".";
	}

	private static long inView(final FilamentTrack track) {
		return track.frames().stream().filter(FilamentSummary::isInView).count();
	}

	private static SortedSet<Integer> frames(final MeasuredFilament filament,
		final FrameStatus status) {
		return new TreeSet<>(filament.track().frames().stream().filter(f -> f.status() == status)
			.map(Observation::frame).toList());
	}

	private static String frames(final MeasuredTracks result, final MeasuredFilament filament) {
		return result.isSeveral() ? "Filament " + filament.track().id() + ", f" : "F";
	}

	/**
	 * @param result a measured result
	 * @return why frames have no contour, one line for each reason; none for frames
	 *         that were left out as asked
	 */
	public static List<String> reasons(final MeasuredTracks result) {
		final List<String> lines = new ArrayList<>();
		for (final MeasuredFilament filament : result.filaments()) {
			final Map<String, SortedSet<Integer>> frames = new LinkedHashMap<>();
			for (final Observation frame : filament.track().frames())
				if (frame.status() == FrameStatus.UNRESOLVED || frame.status() == FrameStatus.LOST)
					frames.computeIfAbsent(frame.reason(), r -> new TreeSet<>()).add(frame.frame());
			frames.forEach((reason, some) -> lines
				.add(frames(result, filament) + (some.size() == 1 ? "rame " : "rames ")
					+ FrameSelection.format(some) + ": " + reason));
		}
		return lines;
	}
}
