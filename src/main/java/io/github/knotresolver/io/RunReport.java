package io.github.knotresolver.io;

import java.util.ArrayList;
import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;

import io.github.knotresolver.pipeline.Resolution;
import io.github.knotresolver.track.FrameStatus;

/** A result in a few lines, for people. */
public final class RunReport {

	private RunReport() {
	}

	/**
	 * @param result a measured result
	 * @return a few lines
	 */
	public static List<String> lines(final MeasuredResolution result) {
		final Resolution resolution = result.resolution();
		final List<String> lines = new ArrayList<>();
		final LengthStatistics s = LengthStatistics.of(result.frames());
		final String unit = " " + resolution.movie().calibration().unit();
		lines.add(resolution.movie().name() + ": " + resolution.resolved() + " of "
			+ resolution.movie().size() + " frames resolved"
			+ (Double.isNaN(s.median())
				? "."
				: ", median length " + NumberText.significant(s.median()) + unit + " (sd "
					+ NumberText.significant(s.sd()) + unit + ")."));
		for (final FrameStatus status : List.of(FrameStatus.UNRESOLVED, FrameStatus.LOST)) {
			final SortedSet<Integer> some = new TreeSet<>(resolution.frames().stream()
				.filter(f -> f.status() == status).map(f -> f.frame()).toList());
			if (!some.isEmpty())
				lines.add("Frames " + status.label() + ": " + FrameSelection.format(some)
					+ " (frames.csv says why).");
		}
		lines.addAll(resolution.notes());
		return lines;
	}
}
