package io.github.knotresolver.command;

import java.awt.TextField;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

import ij.ImagePlus;
import ij.gui.GenericDialog;
import ij.gui.YesNoCancelDialog;
import io.github.knotresolver.imagej.ImageCalibration;
import io.github.knotresolver.model.Calibration;

/** What a person is asked about an image that does not tell enough to be a movie. */
final class MovieQuestions {

	private static final String TITLE = "Resolve Filament...";

	private final ImagePlus image;

	MovieQuestions(final ImagePlus image) {
		this.image = image;
	}

	/**
	 * Asks whether the slices of a Z-stack are frames.
	 *
	 * @param known the answer, if it was given before
	 * @return the answer; empty if the user gave up
	 */
	Optional<Boolean> isTimeAlongZ(final boolean known) {
		if (known || image.getNFrames() > 1 || image.getNSlices() <= 1)
			return Optional.of(known);
		final YesNoCancelDialog dialog = new YesNoCancelDialog(null, TITLE, "'" + image.getTitle()
			+ "' is a Z-stack of " + image.getNSlices()
			+ " slices, not a time series.\nAre its slices frames? (The image stays as it is.)");
		return dialog.cancelPressed() ? Optional.empty() : Optional.of(dialog.yesPressed());
	}

	/**
	 * Asks for the pixel size and the frame interval, if neither the image nor the
	 * user has told them.
	 *
	 * @param given what the user has told, by key
	 * @return what is known now, by key; empty if the user gave up
	 */
	Optional<Map<String, String>> calibration(final Map<String, String> given) {
		final Calibration known = ImageCalibration.of(image);
		final boolean askSize = !known.hasLengthUnit() && given.get("pixel_size").isBlank();
		final boolean askTime = !known.hasTimeUnit() && given.get("frame_interval").isBlank();
		if (!askSize && !askTime)
			return Optional.of(Map.of());
		final GenericDialog dialog = new GenericDialog(TITLE);
		dialog.addMessage(
			"'" + image.getTitle() + "' does not say " + (askSize ? "how large its pixels are" : "")
				+ (askSize && askTime ? ", nor " : "") + (askTime ? "how long a frame lasts" : "")
				+ ".\nLeave a field empty to get results in pixels or frames.");
		if (askSize)
			dialog.addStringField("Pixel size (µm)", "", 8);
		if (askTime)
			dialog.addStringField("Frame interval (s)", "", 8);
		dialog.showDialog();
		if (dialog.wasCanceled())
			return Optional.empty();
		final Map<String, String> told = new LinkedHashMap<>();
		final List<?> fields = dialog.getStringFields();
		if (askSize)
			told.put("pixel_size", text(fields.get(0)));
		if (askTime)
			told.put("frame_interval", text(fields.get(fields.size() - 1)));
		return Optional.of(told);
	}

	/** Read from the component: {@code getNextString()} would record a key of its own. */
	private static String text(final Object field) {
		return ((TextField) field).getText();
	}
}
