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
import io.github.knotresolver.imagej.ImageMovie;
import io.github.knotresolver.model.Calibration;
import io.github.knotresolver.options.InputOptions;
import io.github.knotresolver.options.UnitText;

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
		final boolean channels = ImageMovie.isAlongChannels(image);
		if (known || image.getNFrames() > 1 || image.getNSlices() <= 1 && !channels)
			return Optional.of(known);
		final YesNoCancelDialog dialog = new YesNoCancelDialog(null, TITLE,
			"'" + image.getTitle()
				+ (channels
					? "' has " + image.getNChannels()
						+ " channels and one frame.\nAre its channels frames?"
					: "' is a Z-stack of " + image.getNSlices()
						+ " slices, not a time series.\nAre its slices frames?")
				+ " (The image stays as it is.)");
		return dialog.cancelPressed() ? Optional.empty() : Optional.of(dialog.yesPressed());
	}

	/**
	 * Asks for the pixel size and the frame interval, if neither the image nor the
	 * user has told them, and for the pixel size in µm if its unit is in doubt.
	 *
	 * @param given what the user has told, by key
	 * @return what is known now, by key; empty if the user gave up
	 */
	Optional<Map<String, String>> calibration(final Map<String, String> given) {
		final Calibration known = ImageCalibration.of(image);
		final boolean askSize = given.get("pixel_size").isBlank()
			? !known.hasLengthUnit() || isDoubtful(known, given)
			: isDoubtful(known, given);
		final boolean askTime = !known.hasTimeUnit() && given.get("frame_interval").isBlank();
		if (!askSize && !askTime)
			return Optional.of(Map.of());
		final GenericDialog dialog = new GenericDialog(TITLE);
		dialog.addMessage("'" + image.getTitle() + "' "
			+ (known.hasLengthUnit() && askSize
				? "says that its pixels are " + known.pixelSize() + " " + known.unit() + " large"
					+ (askTime ? ", and " : "")
				: "")
			+ missing(askSize && !known.hasLengthUnit(), askTime)
			+ ".\nLeave a field empty to get results in pixels or frames.");
		if (askSize)
			dialog.addStringField("Pixel size (µm)", given.get("pixel_size"), 8);
		if (askTime)
			dialog.addStringField("Frame interval (s)", "", 8);
		dialog.showDialog();
		if (dialog.wasCanceled())
			return Optional.empty();
		final Map<String, String> told = new LinkedHashMap<>();
		final List<?> fields = dialog.getStringFields();
		if (askSize) {
			told.put("pixel_size", text(fields.get(0)));
			told.put("unit", unit(known, told.get("pixel_size"), given));
		}
		if (askTime)
			told.put("frame_interval", text(fields.get(fields.size() - 1)));
		return Optional.of(told);
	}

	/** A number without unit beside an image in another unit than µm, or no microscope's. */
	private static boolean isDoubtful(final Calibration known, final Map<String, String> given) {
		if (!given.get("unit").isBlank() || !known.hasLengthUnit())
			return false;
		return given.get("pixel_size").isBlank()
			? !InputOptions.isPlausible(known)
			: !known.unit().equals(UnitText.MICROMETRE);
	}

	/** What the answer is in; an image's own unit is named only where it was in doubt. */
	private static String unit(final Calibration known, final String size,
		final Map<String, String> given) {
		if (!known.hasLengthUnit())
			return given.get("unit");
		return size.isBlank() ? Calibration.NONE.unit() : UnitText.MICROMETRE;
	}

	private static String missing(final boolean size, final boolean time) {
		return (size || time ? "does not say " : "") + (size ? "how large its pixels are" : "")
			+ (size && time ? ", nor " : "") + (time ? "how long a frame lasts" : "");
	}

	/** Read from the component: {@code getNextString()} would record a key of its own. */
	private static String text(final Object field) {
		return ((TextField) field).getText();
	}
}
