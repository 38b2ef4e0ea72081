package io.github.knotresolver.session;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;

import io.github.knotresolver.image.Enlargement;
import io.github.knotresolver.image.LineAppearance;
import io.github.knotresolver.mask.ConnectedComponents;
import io.github.knotresolver.mask.ConnectedComponents.MaskObject;
import io.github.knotresolver.model.Polarity;
import io.github.knotresolver.skeleton.AppearanceFinder;
import io.github.knotresolver.track.FrameView;

/**
 * The check before the work: what a user should know about the movie, and what is done
 * about it, one sentence each.
 */
final class EvidenceNotes {

	static final String DARK = "Polarity: dark lines on a brighter background; the movie is inverted for the search.";

	private EvidenceNotes() {
	}

	/** What a few frames say. */
	static List<String> early(final AppearanceFinder.Found found) {
		final LineAppearance a = found.appearance();
		final List<String> notes = new ArrayList<>();
		if (a.polarity() == Polarity.DARK)
			notes.add(DARK);
		if (found.doubtful())
			notes.add(
				"Polarity: lines of the other kind are nearly as strong; if the wrong ones were followed, set polarity to "
					+ (a.polarity() == Polarity.DARK ? "bright." : "dark."));
		if (found.enlargement().isEnlarged())
			notes.add(enlarged(found.enlargement()));
		if (a.binning() > 1)
			notes.add(String.format(Locale.ROOT,
				"Width: lines are %.1f px wide; the movie is resolved in blocks of %d x %d pixels.",
				a.width(), a.binning(), a.binning()));
		if (a.hasReference() && a.clarity() < SessionTuning.FAINT)
			notes.add(String.format(Locale.ROOT,
				"Few photons: lines are only %.1f times as strong as their noise; wider filters are used, and frames may be doubtful.",
				a.clarity()));
		return notes;
	}

	/** What stays in all frames. */
	static List<String> of(final StillSpots still) {
		final List<String> notes = new ArrayList<>();
		if (still.hot() > 0)
			notes.add("Hot pixels: " + still.hot()
				+ (still.hot() == 1 ? " single pixel is" : " single pixels are")
				+ " far too bright in all frames; what surrounds them says how bright they should be.");
		if (still.count() > 0)
			notes.add("Still spots: " + still.count()
				+ (still.count() == 1 ? " round bright spot stays" : " round bright spots stay")
				+ " in place in all frames; their light was taken off the frames.");
		return notes;
	}

	private static String enlarged(final Enlargement e) {
		return e.factor() > 1
			? "Enlarged: pixels come in blocks of " + e.factor()
				+ "; nothing is lost by that, but give the original movie if there is one, and see that the pixel size is that of the small pixels."
			: "Enlarged or smoothed: neighbouring pixels share their noise, so errors of measured values may be larger than stated; give the original movie if there is one.";
	}

	/** What all frames say. */
	static List<String> late(final List<FrameView> frames, final int blank,
		final Clipping clipping) {
		final List<String> notes = new ArrayList<>();
		final int objects = objects(frames);
		if (objects > 1)
			notes.add("Several objects: " + objects
				+ " separate lines in most frames; which of them is a filament is decided by how they move.");
		if (clipping.isClipped())
			notes.add(String.format(Locale.ROOT,
				"Saturated: %.0f %% of the lines' length has the largest brightness; how bright what was cut off is follows from what surrounds it.",
				100 * clipping.share()));
		if (blank > 0)
			notes.add("Blank frames: " + blank + ", dark or bright throughout, "
				+ (blank == 1 ? "is" : "are") + " left out; frames.csv says which.");
		return notes;
	}

	/** The number of long lines that do not touch, in the middle one of all frames. */
	private static int objects(final List<FrameView> frames) {
		final int[] counts = frames.stream().mapToInt(EvidenceNotes::objects).sorted().toArray();
		return counts.length == 0 ? 0 : counts[counts.length / 2];
	}

	/** The number of long lines that do not touch. */
	static int objects(final FrameView frame) {
		final int[] lengths = frame.evidence().map(e -> e.skeleton())
			.map(s -> ConnectedComponents.of(s).objects())
			.orElseGet(() -> ConnectedComponents.of(frame.mask()).objects()).stream()
			.mapToInt(MaskObject::pixels).sorted().toArray();
		return (int) Arrays.stream(lengths)
			.filter(n -> n > SessionTuning.OBJECT * lengths[lengths.length - 1]).count();
	}
}
