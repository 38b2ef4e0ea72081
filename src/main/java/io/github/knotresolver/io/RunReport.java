package io.github.knotresolver.io;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SortedSet;
import java.util.TreeSet;

import io.github.knotresolver.model.FrameStatus;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.model.Tracks;
import io.github.knotresolver.options.FrameSelection;

/** A result in a few lines, for people. */
public final class RunReport {

	private RunReport() {
	}

	/**
	 * @param result a measured result
	 * @return a few lines
	 */
	public static List<String> lines(final MeasuredTracks result) {
		final Tracks tracks = result.tracks();
		final List<String> lines = new ArrayList<>();
		final LengthStatistics s = LengthStatistics.of(result.frames());
		final String unit = " " + tracks.movie().calibration().unit();
		lines.add(tracks.movie().name() + ": " + tracks.resolved() + " of "
			+ tracks.movie().size() + " frames resolved"
			+ (Double.isNaN(s.median())
				? "."
				: ", median length " + NumberText.significant(s.median()) + unit + " (sd "
					+ NumberText.significant(s.sd()) + unit + ")."));
		for (final FrameStatus status : List.of(FrameStatus.UNRESOLVED, FrameStatus.LOST)) {
			final SortedSet<Integer> some = new TreeSet<>(tracks.only().frames().stream()
				.filter(f -> f.status() == status).map(f -> f.frame()).toList());
			if (!some.isEmpty())
				lines.add("Frames " + status.label() + ": " + FrameSelection.format(some)
					+ " (frames.csv says why).");
		}
		lines.addAll(tracks.notes());
		return lines;
	}

	/**
	 * @param result a measured result
	 * @return why frames have no contour, one line for each reason; none for frames
	 *         that were left out as asked
	 */
	public static List<String> reasons(final MeasuredTracks result) {
		final Map<String, SortedSet<Integer>> frames = new LinkedHashMap<>();
		for (final Observation frame : result.tracks().only().frames())
			if (frame.status() == FrameStatus.UNRESOLVED || frame.status() == FrameStatus.LOST)
				frames.computeIfAbsent(frame.reason(), r -> new TreeSet<>()).add(frame.frame());
		final List<String> lines = new ArrayList<>();
		frames.forEach((reason, some) -> lines.add((some.size() == 1 ? "Frame " : "Frames ")
			+ FrameSelection.format(some) + ": " + reason));
		return lines;
	}
}
