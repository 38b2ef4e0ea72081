package io.github.knotresolver.session;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

import io.github.knotresolver.image.LineAppearance;
import io.github.knotresolver.model.Polarity;
import io.github.knotresolver.skeleton.AppearanceFinder;

/** What a user should know about how the movie was looked at, one sentence each. */
final class EvidenceNotes {

	static final String DARK = "Polarity: dark lines on a brighter background; the movie is inverted for the search.";

	private EvidenceNotes() {
	}

	static List<String> of(final AppearanceFinder.Found found, final int blank) {
		final LineAppearance a = found.appearance();
		final List<String> notes = new ArrayList<>();
		if (a.polarity() == Polarity.DARK)
			notes.add(DARK);
		if (found.doubtful())
			notes.add("Polarity: lines of the other kind are nearly as strong; if the wrong ones were followed, set polarity to "
				+ (a.polarity() == Polarity.DARK ? "bright." : "dark."));
		if (a.binning() > 1)
			notes.add(String.format(Locale.ROOT,
				"Width: lines are %.1f px wide; the movie was resolved in blocks of %d x %d pixels.",
				a.width(), a.binning(), a.binning()));
		if (blank > 0)
			notes.add("Blank frames: " + blank + " without light " + (blank == 1 ? "is" : "are")
				+ " left out; frames.csv says which.");
		return notes;
	}
}
