
package io.github.knotresolver.session;

import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;

import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;
import io.github.knotresolver.track.FrameView;
import io.github.knotresolver.track.LightLeft;
import io.github.knotresolver.track.SceneTracks;
import io.github.knotresolver.track.Track;

/**
 * Whether a movie shows one clamped filament or several, where its graphs leave that open: the
 * one explanation is right that leaves less light, with a price for each filament.
 */
final class OneOrMany {

	private final PreparedMovie prepared;
	private final Workers workers;
	private final Progress progress;

	OneOrMany(final PreparedMovie prepared, final Workers workers, final Progress progress) {
		this.prepared = prepared;
		this.workers = workers;
		this.progress = progress;
	}

	/**
	 * @param one one clamped filament
	 * @param many several
	 * @return whether one explains the movie no worse
	 */
	boolean isOne(final Track one, final SceneTracks many) {
		final LightLeft left = new LightLeft(prepared.frames(), prepared.kinds(), workers,
			progress);
		return left.price(contours(List.of(one.frames())), 1) <= left.price(
			contours(many.filaments().stream().map(SceneTracks.Filament::frames).toList()),
			many.filaments().size());
	}

	/** For each frame all contours that are known. */
	private List<List<Polyline>> contours(final List<List<Observation>> filaments) {
		final Map<Integer, List<Polyline>> byFrame = filaments.stream().flatMap(List::stream)
			.filter(o -> o.contour().isPresent()).collect(Collectors.groupingBy(Observation::frame,
				Collectors.mapping(o -> o.contour().orElseThrow(), Collectors.toList())));
		return prepared.frames().stream().map(FrameView::frame)
			.map(f -> byFrame.getOrDefault(f, List.of())).toList();
	}
}
