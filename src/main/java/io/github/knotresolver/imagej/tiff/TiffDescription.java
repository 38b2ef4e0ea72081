package io.github.knotresolver.imagej.tiff;

import java.io.IOException;
import java.io.StringReader;
import java.nio.file.Path;
import java.util.Optional;
import java.util.Properties;

import com.google.gson.JsonObject;
import com.google.gson.JsonParseException;
import com.google.gson.JsonParser;

import ij.measure.Calibration;
import io.github.knotresolver.model.UserException;

/**
 * What the text beside the first image tells of all: axes, their order, size of the
 * pixels, time between frames. Understood are ImageJ's lines, OME-XML, and the axes
 * of tifffile.
 */
final class TiffDescription {

	private static final int INCH = 2, CENTIMETRE = 3;
	/** What programs write that know no resolution. */
	private static final double DEFAULT_DPI = 72;

	private final Path path;
	private final TiffPage page;
	private final Properties imageJ = new Properties();

	/**
	 * @param path the file
	 * @param page its first image
	 */
	TiffDescription(final Path path, final TiffPage page) {
		this.path = path;
		this.page = page;
		if (page.description().startsWith("ImageJ="))
			try {
				imageJ.load(new StringReader(page.description()));
			} catch (final IOException | IllegalArgumentException e) {
				throw TiffStructure.damaged(path, "its description is no text of ImageJ's");
			}
	}

	/** @return how many images ImageJ's lines promise; 0 if they say nothing */
	int promised() {
		return (int) number("images", 0);
	}

	boolean isOme() {
		return OmeXml.isOme(page.description());
	}

	/** @return whether it tells more than ImageJ's opener understands */
	boolean isForeign() {
		return isOme() || page.description().startsWith("{");
	}

	/**
	 * @param planes how many there are
	 * @param perImage how many of them each image has
	 * @return what they are, if it is told
	 */
	Optional<TiffAxes> axes(final int planes, final int perImage) {
		if (isOme())
			return Optional
				.of(OmeXml.parse(path.toString(), page.description()).axes(path, planes));
		if (page.description().startsWith("{"))
			return axesOfTifffile(planes);
		if (!imageJ.containsKey("channels") && !imageJ.containsKey("slices")
			&& !imageJ.containsKey("frames"))
			return Optional.empty();
		final int c = (int) number("channels", 1), z = (int) number("slices", 1),
			t = (int) number("frames", 1);
		return Optional.of(c > 0 && z > 0 && t > 0 && (double) c * z * t == planes
			? TiffAxes.inOrder(c, z, t)
			: TiffAxes.inOrder(perImage, planes / perImage, 1));
	}

	/** {@code {"shape": [24, 2, 54, 100], "axes": "TCYX"}}. */
	private Optional<TiffAxes> axesOfTifffile(final int planes) {
		final int[] sizes = {1, 1, 1};
		final StringBuilder order = new StringBuilder();
		try {
			final JsonObject json = JsonParser.parseString(page.description()).getAsJsonObject();
			final String axes = json.has("axes") ? json.get("axes").getAsString() : "";
			for (int i = axes.length() - 1; i >= 0; i--) {
				final int axis = "CZT".indexOf(axes.charAt(i));
				if (axis < 0 || order.indexOf(axes.substring(i, i + 1)) >= 0)
					continue;
				order.append(axes.charAt(i));
				sizes[axis] = json.getAsJsonArray("shape").get(i).getAsInt();
			}
		} catch (final JsonParseException | IllegalStateException | UnsupportedOperationException
			| NumberFormatException | IndexOutOfBoundsException | ClassCastException
			| NullPointerException e) {
			return Optional.empty();
		}
		if (order.length() == 0)
			return Optional.empty();
		for (final char axis : "CZT".toCharArray())
			if (order.indexOf(String.valueOf(axis)) < 0)
				order.append(axis);
		return sizes[0] > 0 && sizes[1] > 0 && sizes[2] > 0
			&& (double) sizes[0] * sizes[1] * sizes[2] == planes
				? Optional.of(TiffAxes.ordered(order.toString(), sizes[0], sizes[1], sizes[2]))
				: Optional.empty();
	}

	/** Puts what is told of pixels and time, as ImageJ's opener does, into an image's. */
	void calibrate(final Calibration calibration) {
		if (isOme()) {
			OmeXml.parse(path.toString(), page.description()).calibrate(calibration);
			return;
		}
		final double x = page.resolution(TiffPage.X_RESOLUTION),
			y = page.resolution(TiffPage.Y_RESOLUTION);
		final String unit = unit(x);
		if (unit != null && x > 0) {
			calibration.pixelWidth = 1 / x;
			calibration.pixelHeight = y > 0 ? 1 / y : 1 / x;
			calibration.setUnit(unit);
		}
		final double interval = number("finterval", 0);
		if (interval > 0) {
			calibration.frameInterval = interval;
			calibration.setTimeUnit(imageJ.getProperty("tunit", "s"));
		}
	}

	private String unit(final double resolution) {
		if (imageJ.containsKey("unit"))
			return imageJ.getProperty("unit");
		return switch (page.resolutionUnit()) {
			case INCH -> resolution == DEFAULT_DPI ? null : "inch";
			case CENTIMETRE -> "cm";
			default -> null;
		};
	}

	private double number(final String key, final double otherwise) {
		try {
			return Double.parseDouble(imageJ.getProperty(key, String.valueOf(otherwise)));
		} catch (final NumberFormatException e) {
			throw new UserException(path + " says that " + key + " is '" + imageJ.getProperty(key)
				+ "', which is no number; save it again in ImageJ.", e);
		}
	}
}
