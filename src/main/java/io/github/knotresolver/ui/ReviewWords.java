package io.github.knotresolver.ui;

import java.util.List;
import java.util.Locale;

import io.github.knotresolver.model.FilamentTrack;
import io.github.knotresolver.model.FrameStatus;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.ui.model.ReviewModel;

/** What a review says in words. */
final class ReviewWords {

	/** What the strip shows. */
	static final String LEGEND = "Confidence of each frame (line: 0.9); triangle: doubtful; square: checked; click: go there";

	private static final double LEAST = 0.005;

	private ReviewWords() {
	}

	/** The filament in one line. */
	static String headline(final ReviewModel model) {
		if (model.track().isEmpty())
			return model.movie().name() + ": " + model.movie().size() + " frames";
		final FilamentTrack track = model.track().get();
		final double pixel = model.movie().calibration().pixelSize();
		final String length = Double.isNaN(track.length())
			? ""
			: String.format(Locale.ROOT, "   %.2f%s %s", track.length() * pixel,
				Double.isNaN(track.lengthError())
					? ""
					: String.format(Locale.ROOT, " ± %.2f", track.lengthError() * pixel),
				model.movie().calibration().unit());
		return "filament " + track.id() + " of " + model.tracks().orElseThrow().filaments().size()
			+ length + "   " + track.anchor().label() + "   " + right(model, track) + " right, "
			+ doubtful(model, track) + " doubtful, " + without(track.frames()) + " lost";
	}

	/** Sure, corrected, or checked by a person. */
	private static long right(final ReviewModel model, final FilamentTrack track) {
		return track.frames().stream().filter(o -> o.contour().isPresent()).count()
			- doubtful(model, track);
	}

	private static long doubtful(final ReviewModel model, final FilamentTrack track) {
		return model.doubtful().stream().map(f -> track.frames().get(f - 1))
			.filter(o -> o.contour().isPresent()).count();
	}

	private static long without(final List<Observation> frames) {
		return frames.stream()
			.filter(o -> o.status() == FrameStatus.LOST || o.status() == FrameStatus.UNRESOLVED)
			.count();
	}

	/** What is going on, or is still to do. */
	static String status(final ReviewModel model, final boolean changed) {
		if (model.problem().isPresent())
			return model.problem().get();
		if (model.stage().isPresent())
			return (model.isReady() || model.tracks().isEmpty()
				? ""
				: "Look at the frames meanwhile; they can be corrected when this is done: ")
				+ model.stage().get() + " ...";
		return changed ? "Corrections are not saved yet." : " ";
	}

	/** After its confidence nobody need be told that a frame is doubtful. */
	private static String because(final String reason) {
		return reason.isEmpty() ? "" : "   because: " + reason.replaceFirst("^Doubtful: ", "");
	}

	/** Never 0 of what is more than that. */
	static String confidence(final double value) {
		return value > 0 && value < LEAST
			? "below 0.01"
			: String.format(Locale.ROOT, "%.2f", value);
	}

	/** The frame in one line. */
	static String frame(final ReviewModel model) {
		return model.shown().map(o -> {
			final String sure = Double.isNaN(o.confidence())
				? ""
				: "   confidence " + confidence(o.confidence());
			return "frame " + o.frame() + "   " + o.status().label() + sure
				+ (model.isChecked(o.frame()) ? "   checked" : "") + because(o.reason());
		}).orElse("frame " + model.frame());
	}
}
