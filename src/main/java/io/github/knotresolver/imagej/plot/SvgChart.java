package io.github.knotresolver.imagej.plot;

import java.awt.Dimension;
import java.awt.RenderingHints;
import java.awt.geom.Rectangle2D;
import java.awt.image.RenderedImage;
import java.io.IOException;
import java.io.OutputStream;
import java.io.Writer;
import java.nio.file.Files;
import java.nio.file.Path;

import javax.imageio.ImageIO;
import javax.xml.parsers.DocumentBuilderFactory;
import javax.xml.parsers.ParserConfigurationException;

import org.apache.batik.svggen.ImageHandlerBase64Encoder;
import org.apache.batik.svggen.SVGGeneratorContext;
import org.apache.batik.svggen.SVGGraphics2D;
import org.apache.batik.svggen.SVGGraphics2DIOException;
import org.jfree.chart.JFreeChart;
import org.w3c.dom.Document;
import org.w3c.dom.Element;

/**
 * Charts as SVG, in UTF-8. Upright letters stay letters, turned ones are outlines (that is
 * how JFreeChart turns them). The same chart gives the same bytes, whatever the locale.
 */
final class SvgChart {

	private static final String NAMESPACE = "http://www.w3.org/2000/svg";

	private SvgChart() {
	}

	/**
	 * One chart at a time: Batik's number formats are shared by all threads.
	 *
	 * @param file to write
	 * @param chart what to draw
	 * @param width of the picture in points
	 * @param height of the picture in points
	 * @throws IOException if the file cannot be written
	 */
	static synchronized void write(final Path file, final JFreeChart chart, final int width,
		final int height) throws IOException {
		final SVGGeneratorContext context = SVGGeneratorContext.createDefault(document());
		context.setImageHandler(new PngEncoder());
		context.setComment(null);
		final SVGGraphics2D graphics = new SVGGraphics2D(context, false);
		graphics.setSVGCanvasSize(new Dimension(width, height));
		graphics.setRenderingHint(RenderingHints.KEY_INTERPOLATION,
			RenderingHints.VALUE_INTERPOLATION_NEAREST_NEIGHBOR);
		chart.draw(graphics, new Rectangle2D.Double(0, 0, width, height));
		final Element root = graphics.getRoot();
		root.setAttribute("viewBox", "0 0 " + width + " " + height);
		try (Writer writer = Files.newBufferedWriter(file)) {
			graphics.stream(root, writer, false, false);
		}
	}

	/** Pictures inside a chart, by Java's own encoder: Batik's comes with a rasterizer. */
	private static final class PngEncoder extends ImageHandlerBase64Encoder {

		@Override
		public void encodeImage(final RenderedImage image, final OutputStream to)
			throws SVGGraphics2DIOException {
			try {
				ImageIO.write(image, "png", to);
			} catch (final IOException e) {
				throw new SVGGraphics2DIOException(e.getMessage(), e);
			}
		}
	}

	private static Document document() {
		try {
			return DocumentBuilderFactory.newDefaultInstance().newDocumentBuilder()
				.getDOMImplementation().createDocument(NAMESPACE, "svg", null);
		} catch (final ParserConfigurationException e) {
			throw new IllegalStateException("Java's own XML parser cannot be configured", e);
		}
	}
}
