package io.github.knotresolver.session;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

import io.github.knotresolver.geometry.Drag;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.Constraint;
import io.github.knotresolver.model.Constraint.Kind;
import io.github.knotresolver.model.FilamentTrack;
import io.github.knotresolver.model.FrameStatus;
import io.github.knotresolver.model.Observation;

/**
 * What a person said of contours, put over what was found. Whole contours stand, also where nothing was
 * to be seen. In a scene, which has one course for each filament and frame, a course is bent to pass the
 * places that were told, as it is when it is dragged by hand, and one that was refused is left out;
 * where one filament is resolved, its courses were chosen to fit already.
 */
final class GivenContours {

	private final List<Constraint> said;
	private final boolean isScene;

	/**
	 * @param said all that was said
	 * @param isScene whether a scene was resolved, in place of one filament
	 */
	GivenContours(final List<Constraint> said, final boolean isScene) {
		this.said = said.stream().filter(c -> c.kind().isOfContour()).toList();
		this.isScene = isScene;
	}

	/**
	 * @param found a filament, in the pixels in which it was spoken of
	 * @return the same with what was said of it; what cannot be followed leaves its frame unresolved
	 */
	FilamentTrack over(final FilamentTrack found) {
		final Map<Integer, List<Constraint>> frames = new HashMap<>();
		for (final Constraint c : said)
			if (c.filament() == found.id())
				frames.computeIfAbsent(c.frame(), f -> new ArrayList<>()).add(c);
		return new FilamentTrack(found.id(), found.anchor(), found.fixedEnd(), found.length(),
			found.lengthError(), found.frames().stream()
				.map(o -> over(o, frames.getOrDefault(o.frame(), List.of()))).toList());
	}

	private Observation over(final Observation found, final List<Constraint> words) {
		if (found.status() == FrameStatus.CORRECTED || found.status() == FrameStatus.IGNORED)
			return found;
		final Optional<Polyline> contour = words.stream().filter(c -> c.kind() == Kind.CONTOUR)
			.map(Constraint::shape).reduce((first, last) -> last);
		if (contour.isPresent())
			return corrected(found, contour.get(), Observation.GIVEN);
		if (!isScene)
			return found;
		final Observation bent = bent(found, words);
		return words.stream().anyMatch(c -> bent.contour().filter(c::refuses).isPresent())
			? unresolved(found,
				"The user refused the only course that was found; draw the contour.")
			: bent;
	}

	private static Observation corrected(final Observation found, final Polyline contour,
		final String reason) {
		return new Observation(found.frame(), FrameStatus.CORRECTED, reason, Optional.of(contour),
			found.junctions(), 1, 0, 1);
	}

	private static Observation bent(final Observation found, final List<Constraint> words) {
		final List<Constraint> places = words.stream()
			.filter(c -> c.kind() == Kind.THROUGH || c.kind() == Kind.TIP).toList();
		if (places.isEmpty())
			return found;
		if (found.contour().isEmpty() || !isNear(found.contour().get(), places))
			return unresolved(found,
				"What was found does not come near the place that the user gave; draw the whole contour.");
		Polyline contour = found.contour().get();
		for (int round = 0; round < SessionTuning.BEND_ROUNDS && !pass(contour, places); round++)
			for (final Constraint c : places)
				contour = toward(contour, c);
		return pass(contour, places)
			? corrected(found, contour, "Bent to the places that the user gave.")
			: unresolved(found,
				"What was found cannot be bent to all places that the user gave; draw the whole contour.");
	}

	private static Observation unresolved(final Observation found, final String reason) {
		return Observation.without(found.frame(), FrameStatus.UNRESOLVED, reason);
	}

	/** Farther off than what follows a place that is dragged, nothing is meant. */
	private static boolean isNear(final Polyline contour, final List<Constraint> places) {
		return places.stream()
			.allMatch(c -> farthest(contour, c) <= Drag.FOLLOWING * contour.length());
	}

	private static boolean pass(final Polyline contour, final List<Constraint> places) {
		return places.stream().allMatch(c -> farthest(contour, c) <= SessionTuning.PASSES);
	}

	private static double farthest(final Polyline contour, final Constraint word) {
		double farthest = 0;
		for (int i = 0; i < word.shape().size(); i++)
			farthest = Math.max(farthest, distance(contour, word, word.shape().point(i)));
		return farthest;
	}

	private static double distance(final Polyline contour, final Constraint word,
		final Point place) {
		return word.kind() == Kind.TIP
			? contour.last().distanceTo(place)
			: contour.distanceTo(place);
	}

	private static Polyline toward(final Polyline contour, final Constraint word) {
		Polyline bent = contour;
		for (int i = 0; i < word.shape().size(); i++) {
			final Point place = word.shape().point(i);
			if (distance(bent, word, place) > SessionTuning.PASSES)
				bent = (word.kind() == Kind.TIP ? Drag.tip(bent) : Drag.nearest(bent, place))
					.to(place);
		}
		return bent;
	}
}
