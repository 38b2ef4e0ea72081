package io.github.knotresolver.ui.model;

import java.util.Comparator;
import java.util.List;

import io.github.knotresolver.model.FilamentTrack;
import io.github.knotresolver.model.FrameStatus;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.model.Tracks;

/** Where a person should look: frames whose contour may be wrong, or is missing. */
final class Doubts {

	private Doubts() {
	}

	/** @return the doubtful frames of a filament, the least certain first, then in order of time */
	static List<Integer> of(final Tracks tracks, final FilamentTrack track) {
		return track.frames().stream().filter(Doubts::isDoubtful)
			.filter(o -> !tracks.isChecked(track.id(), o))
			.sorted(
				Comparator.comparingDouble(Doubts::certainty).thenComparingInt(Observation::frame))
			.map(Observation::frame).toList();
	}

	/** @return the frame after or before one in this order, round and round; that one if there is none */
	static int step(final List<Integer> doubtful, final int frame, final int by) {
		if (doubtful.isEmpty())
			return frame;
		final int at = doubtful.indexOf(frame);
		final int next = at < 0 ? by > 0 ? 0 : -1 : at + by;
		return doubtful.get(Math.floorMod(next, doubtful.size()));
	}

	static boolean isDoubtful(final Observation o) {
		return switch (o.status()) {
			case RESOLVED -> !(o.confidence() >= Observation.SURE);
			case UNRESOLVED, LOST -> true;
			case CORRECTED, ABSENT, IGNORED -> false;
		};
	}

	/** What has no contour comes first. */
	private static double certainty(final Observation o) {
		return o.status() == FrameStatus.RESOLVED && o.confidence() >= 0 ? o.confidence() : -1;
	}
}
