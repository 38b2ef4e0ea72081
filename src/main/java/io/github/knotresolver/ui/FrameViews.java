package io.github.knotresolver.ui;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Stream;

import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.imagej.ReviewPictures;
import io.github.knotresolver.model.Alternative;
import io.github.knotresolver.model.FilamentTrack;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.ui.model.ReviewModel;

/** Small pictures of the frame under review: the courses that it allows, and its neighbours in time. */
final class FrameViews {

	private static final int NEIGHBOURS = 2;

	/** Of a small picture, in letters' heights, and its width for its height. */
	private static final double HIGH = 6, BROAD = 1.5;

	private final ReviewModel model;
	private final ReviewPictures pictures;
	private final Thumbnails alternatives, neighbours = new Thumbnails(contour -> {
	});

	/** @param hover told the contour of the course that the mouse is over */
	FrameViews(final ReviewModel model, final Consumer<Optional<Polyline>> hover) {
		this.model = model;
		pictures = new ReviewPictures(model.movie());
		alternatives = new Thumbnails(hover);
	}

	/** @return the courses, the one that is shown first */
	Thumbnails alternatives() {
		return alternatives;
	}

	/** @return the frames before and after */
	Thumbnails neighbours() {
		return neighbours;
	}

	/**
	 * Shows what the model says now.
	 *
	 * @param more pixels by which pictures may be higher than usual
	 */
	void refresh(final FilamentTrack track, final double more) {
		final Observation shown = track.frames().get(model.frame() - 1);
		final List<Observation> near = track.frames().subList(
			Math.max(0, model.frame() - 1 - NEIGHBOURS),
			Math.min(track.frames().size(), model.frame() + NEIGHBOURS));
		final List<Alternative> others = shown.alternatives().subList(0,
			Math.min(ReviewActions.MOST_ALTERNATIVES, shown.alternatives().size()));
		final double high = HIGH * neighbours.getFontMetrics(neighbours.getFont()).getHeight()
			+ more;
		final ReviewPictures.Small small = pictures.small(model.tracks().orElseThrow(), track,
			Stream.concat(near.stream().flatMap(o -> o.contour().stream()),
				others.stream().map(Alternative::contour)).toList(),
			new ReviewPictures.Size((int) (BROAD * high), (int) high, neighbours.sharpness()));
		alternatives.show(courses(shown, others, small));
		neighbours.show(near.stream()
			.map(o -> new Thumbnails.Item("frame " + o.frame(), Integer.toString(o.frame()),
				"Go to frame " + o.frame(), small.paint(o.frame(), o.contour()), o == shown,
				Optional.empty(), () -> model.goTo(o.frame())))
			.toList());
	}

	private List<Thumbnails.Item> courses(final Observation shown, final List<Alternative> others,
		final ReviewPictures.Small small) {
		final List<Thumbnails.Item> courses = new ArrayList<>();
		courses.add(new Thumbnails.Item("alternative 1", "1: as shown",
			"What is shown; a click says that it is right (key: 1)",
			small.paint(shown.frame(), shown.contour()), true, Optional.empty(), model::accept));
		for (int i = 0; i < others.size(); i++) {
			final int index = i;
			final Optional<Polyline> contour = Optional.of(others.get(i).contour());
			final String dearer = String.format(Locale.ROOT, "%+.1f",
				others.get(i).cost() - shown.cost());
			courses.add(new Thumbnails.Item("alternative " + (i + 2), (i + 2) + ": " + dearer,
				"Another course of this frame, its price " + dearer
					+ " against what is shown; a click takes it (key: " + (i + 2) + ")",
				small.paint(shown.frame(), contour), false, contour, () -> model.take(index)));
		}
		return courses;
	}
}
