package io.github.knotresolver.imagej.tiff;

import java.io.IOException;
import java.io.StringReader;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.TreeMap;

import javax.xml.XMLConstants;
import javax.xml.parsers.DocumentBuilder;
import javax.xml.parsers.DocumentBuilderFactory;
import javax.xml.parsers.ParserConfigurationException;

import org.w3c.dom.Element;
import org.w3c.dom.NodeList;
import org.xml.sax.InputSource;
import org.xml.sax.SAXException;
import org.xml.sax.helpers.DefaultHandler;

import ij.measure.Calibration;
import io.github.knotresolver.model.UserException;

/**
 * The metadata of an OME-TIFF: size of the pixels, time between frames, axes and
 * their order. See the OME-TIFF specification, docs.openmicroscopy.org/ome-model. The
 * XML is not trusted: nothing outside of it is read.
 */
public final class OmeXml {

	private static final String MICROMETRE = "\u00b5m", SECOND = "s";

	private final Element pixels;

	private OmeXml(final Element pixels) {
		this.pixels = pixels;
	}

	/**
	 * @param description the text of a TIFF's {@code ImageDescription}; may be null
	 * @return whether it is OME-XML with an image's pixels
	 */
	public static boolean isOme(final String description) {
		return description != null && description.contains("<OME")
			&& description.contains("<Pixels")
			|| description != null && description.contains("<OME:OME")
				&& description.contains("Pixels");
	}

	/**
	 * @param name of the file, for messages
	 * @param description OME-XML
	 * @return what it tells
	 * @throws UserException if it is no XML, or tells of several images
	 */
	public static OmeXml parse(final String name, final String description) {
		final NodeList images;
		try {
			images = builder().parse(new InputSource(new StringReader(description.strip())))
				.getElementsByTagNameNS("*", "Pixels");
		} catch (final SAXException | IOException | ParserConfigurationException e) {
			throw new UserException(name + " has OME metadata that cannot be read ("
				+ e.getMessage() + "); save it again as an ordinary TIFF.", e);
		}
		if (images.getLength() != 1)
			throw new UserException(name + " holds " + images.getLength()
				+ " images of its OME metadata, but a movie is one; save that one alone.");
		return new OmeXml((Element) images.item(0));
	}

	private static DocumentBuilder builder() throws ParserConfigurationException {
		final DocumentBuilderFactory factory = DocumentBuilderFactory.newInstance();
		factory.setNamespaceAware(true);
		factory.setFeature(XMLConstants.FEATURE_SECURE_PROCESSING, true);
		factory.setFeature("http://apache.org/xml/features/disallow-doctype-decl", true);
		factory.setAttribute(XMLConstants.ACCESS_EXTERNAL_DTD, "");
		factory.setAttribute(XMLConstants.ACCESS_EXTERNAL_SCHEMA, "");
		factory.setXIncludeAware(false);
		factory.setExpandEntityReferences(false);
		final DocumentBuilder builder = factory.newDocumentBuilder();
		builder.setErrorHandler(new DefaultHandler());
		return builder;
	}

	/**
	 * Puts size of pixels and time between frames in, as far as they are told.
	 *
	 * @param calibration that of an image
	 */
	public void calibrate(final Calibration calibration) {
		final double x = number(pixels, "PhysicalSizeX"), y = number(pixels, "PhysicalSizeY");
		if (x > 0) {
			calibration.pixelWidth = x;
			calibration.pixelHeight = y > 0 ? y : x;
			calibration.setUnit(text(pixels, "PhysicalSizeXUnit", MICROMETRE));
		}
		final double interval = number(pixels, "TimeIncrement");
		if (interval > 0) {
			calibration.frameInterval = interval;
			calibration.setTimeUnit(text(pixels, "TimeIncrementUnit", SECOND));
		} else
			timesOfPlanes(calibration);
	}

	/** The median time between frames, where each plane tells its own. */
	private void timesOfPlanes(final Calibration calibration) {
		final TreeMap<Integer, Double> times = new TreeMap<>();
		String unit = SECOND;
		for (final Element plane : elements("Plane")) {
			final double time = number(plane, "DeltaT");
			if (Double.isNaN(time) || integer(plane, "TheC", 0) != 0
				|| integer(plane, "TheZ", 0) != 0)
				continue;
			times.put(integer(plane, "TheT", 0), time);
			unit = text(plane, "DeltaTUnit", SECOND);
		}
		if (times.size() < 2 || times.lastKey() - times.firstKey() != times.size() - 1)
			return;
		final double[] at = times.values().stream().mapToDouble(t -> t).toArray();
		final double[] steps = new double[at.length - 1];
		Arrays.setAll(steps, i -> at[i + 1] - at[i]);
		Arrays.sort(steps);
		if (steps[steps.length / 2] > 0) {
			calibration.frameInterval = steps[steps.length / 2];
			calibration.setTimeUnit(unit);
		}
	}

	/**
	 * @param path the file
	 * @param planes how many the file has
	 * @return the axes of its planes
	 * @throws UserException if some are in other files, or missing
	 */
	TiffAxes axes(final Path path, final int planes) {
		final int c = integer(pixels, "SizeC", 1), z = integer(pixels, "SizeZ", 1),
			t = integer(pixels, "SizeT", 1);
		final String order = text(pixels, "DimensionOrder", "XYCZT").replaceAll("[^CZT]", "");
		if (order.length() != 3 || c < 1 || z < 1 || t < 1)
			throw new UserException(path
				+ " has OME metadata without the order of its axes; save it again as an ordinary TIFF.");
		if ((double) c * z * t != planes)
			throw new UserException(path + " has " + planes
				+ " planes, but its OME metadata tell of " + c + " channels, " + z + " slices and "
				+ t
				+ " frames; open the whole set of files in Fiji (Bio-Formats) and save it as one TIFF.");
		return moved(TiffAxes.ordered(order, c, z, t), order);
	}

	/** {@code TiffData} may tell for each plane in which image of the file it is. */
	private TiffAxes moved(final TiffAxes axes, final String order) {
		final int c = axes.channels(), z = axes.slices(), t = axes.frames();
		final int[] plane = axes.plane();
		int next = 0;
		for (final Element data : elements("TiffData")) {
			final int ifd = integer(data, "IFD", next);
			final int count = integer(data, "PlaneCount",
				data.hasAttribute("IFD") ? 1 : plane.length - ifd);
			int place = position(order, axes, integer(data, "FirstC", 0),
				integer(data, "FirstZ", 0), integer(data, "FirstT", 0));
			for (int k = 0; k < count && place < plane.length
				&& ifd + k < plane.length; k++, place++)
				plane[inImageJ(order, axes, place)] = ifd + k;
			next = ifd + count;
		}
		final boolean each = Arrays.stream(plane).distinct().count() == plane.length;
		return each ? new TiffAxes(c, z, t, plane) : axes;
	}

	/** Where a plane stands in the file's order. */
	private static int position(final String order, final TiffAxes axes, final int c, final int z,
		final int t) {
		int place = 0, step = 1;
		for (final char axis : order.toCharArray()) {
			place += step * (axis == 'C' ? c : axis == 'Z' ? z : t);
			step *= size(axes, axis);
		}
		return place;
	}

	/** Where the plane at a place of the file's order stands in ImageJ's. */
	private static int inImageJ(final String order, final TiffAxes axes, final int place) {
		int rest = place;
		int c = 0, z = 0, t = 0;
		for (final char axis : order.toCharArray()) {
			final int at = rest % size(axes, axis);
			rest /= size(axes, axis);
			if (axis == 'C')
				c = at;
			else if (axis == 'Z')
				z = at;
			else
				t = at;
		}
		return c + axes.channels() * (z + axes.slices() * t);
	}

	private static int size(final TiffAxes axes, final char axis) {
		return axis == 'C' ? axes.channels() : axis == 'Z' ? axes.slices() : axes.frames();
	}

	private List<Element> elements(final String name) {
		final NodeList nodes = pixels.getElementsByTagNameNS("*", name);
		final List<Element> elements = new ArrayList<>();
		for (int i = 0; i < nodes.getLength(); i++)
			elements.add((Element) nodes.item(i));
		return elements;
	}

	private static String text(final Element element, final String name, final String otherwise) {
		return element.hasAttribute(name) ? element.getAttribute(name) : otherwise;
	}

	private static double number(final Element element, final String name) {
		try {
			return Double.parseDouble(text(element, name, "NaN"));
		} catch (final NumberFormatException e) {
			return Double.NaN;
		}
	}

	private static int integer(final Element element, final String name, final int otherwise) {
		final double value = number(element, name);
		return value == Math.rint(value) && value >= 0 && value <= Integer.MAX_VALUE
			? (int) value
			: otherwise;
	}
}
