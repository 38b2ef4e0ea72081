package io.github.knotresolver.imagej;

import java.awt.AlphaComposite;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.EOFException;
import java.io.IOException;
import java.nio.file.Path;

import javax.imageio.IIOException;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.metadata.IIOMetadata;
import javax.imageio.stream.ImageInputStream;

import org.w3c.dom.Node;
import org.w3c.dom.NodeList;

import ij.ImagePlus;
import ij.ImageStack;
import ij.process.ColorProcessor;
import io.github.knotresolver.io.GifBlocks;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.progress.Progress;

/**
 * The frames of a GIF, each put over those before as the file says: many programs
 * write only what changed, with a palette of its own for each frame. ImageJ's reader
 * knows neither.
 */
final class GifFile {

	private static final String STREAM = "javax_imageio_gif_stream_1.0",
		IMAGE = "javax_imageio_gif_image_1.0";
	private static final int INT_BYTES = 4;

	private final ImageReader reader;
	private BufferedImage canvas;

	private GifFile(final ImageReader reader) {
		this.reader = reader;
	}

	/**
	 * @param file a GIF file
	 * @param progress may cancel
	 * @return its frames; 8 bit if all are grey, else RGB
	 * @throws UserException if it is damaged, or too large
	 * @throws IOException if it cannot be read
	 */
	static ImagePlus open(final Path file, final Progress progress) throws IOException {
		final int frames = count(file);
		final ImageReader reader = ImageIO.getImageReadersByFormatName("gif").next();
		try (ImageInputStream in = ImageIO.createImageInputStream(file.toFile())) {
			reader.setInput(in);
			final ImagePlus image = new ImagePlus(file.getFileName().toString(),
				new GifFile(reader).frames(file, frames, progress));
			image.setDimensions(1, 1, image.getStackSize());
			return GreyImage.of(image);
		} catch (final IIOException | IndexOutOfBoundsException | NegativeArraySizeException
			| IllegalArgumentException e) {
			throw damaged(file, "its frames cannot be read", e);
		} finally {
			reader.dispose();
		}
	}

	private static int count(final Path file) throws IOException {
		try {
			return GifBlocks.frames(file);
		} catch (final EOFException e) {
			throw damaged(file, "it ends before its last frame", e);
		}
	}

	private static UserException damaged(final Path file, final String why, final Exception cause) {
		return new UserException(
			file + " is damaged: " + why + "; copy the file again from its source.", cause);
	}

	private ImageStack frames(final Path file, final int count, final Progress progress)
		throws IOException {
		final Node screen = child(tree(reader.getStreamMetadata(), STREAM),
			"LogicalScreenDescriptor");
		final int width = number(screen, "logicalScreenWidth"),
			height = number(screen, "logicalScreenHeight");
		if ((double) width * height * INT_BYTES > Runtime.getRuntime().maxMemory())
			throw new UserException("There is not enough memory for " + file + ": its frames are "
				+ width + " x " + height + "; give Java more.");
		canvas = new BufferedImage(width, height, BufferedImage.TYPE_INT_ARGB);
		final ImageStack stack = new ImageStack(width, height);
		for (int i = 0; i < count; i++) {
			progress.checkCancelled();
			stack.addSlice(frame(i));
		}
		return stack;
	}

	/** Shows the frame, then leaves the canvas as the file says. */
	private ColorProcessor frame(final int i) throws IOException {
		final Node tree = tree(reader.getImageMetadata(i), IMAGE);
		final Node place = child(tree, "ImageDescriptor");
		final Node control = child(tree, "GraphicControlExtension");
		final String disposal = control == null ? "none" : text(control, "disposalMethod");
		final BufferedImage before = disposal.equals("restoreToPrevious") ? copy() : null;
		final BufferedImage part = reader.read(i);
		final int left = number(place, "imageLeftPosition"),
			top = number(place, "imageTopPosition");
		final Graphics2D g = canvas.createGraphics();
		g.drawImage(part, left, top, null);
		final ColorProcessor shown = opaque();
		if (disposal.equals("restoreToBackgroundColor")) {
			g.setComposite(AlphaComposite.Clear);
			g.fillRect(left, top, part.getWidth(), part.getHeight());
		}
		g.dispose();
		if (before != null)
			canvas = before;
		return shown;
	}

	private BufferedImage copy() {
		final BufferedImage copy = new BufferedImage(canvas.getWidth(), canvas.getHeight(),
			BufferedImage.TYPE_INT_ARGB);
		copy.setData(canvas.getData());
		return copy;
	}

	/** What is transparent shows black. */
	private ColorProcessor opaque() {
		final BufferedImage shown = new BufferedImage(canvas.getWidth(), canvas.getHeight(),
			BufferedImage.TYPE_INT_RGB);
		final Graphics2D g = shown.createGraphics();
		g.drawImage(canvas, 0, 0, Color.BLACK, null);
		g.dispose();
		return new ColorProcessor(shown);
	}

	private static Node tree(final IIOMetadata metadata, final String format) {
		return metadata.getAsTree(format);
	}

	private static Node child(final Node tree, final String name) {
		final NodeList children = tree.getChildNodes();
		for (int i = 0; i < children.getLength(); i++)
			if (children.item(i).getNodeName().equals(name))
				return children.item(i);
		return null;
	}

	private static String text(final Node node, final String name) {
		final Node value = node == null ? null : node.getAttributes().getNamedItem(name);
		if (value == null)
			throw new IllegalArgumentException("There is no " + name + ".");
		return value.getNodeValue();
	}

	private static int number(final Node node, final String name) {
		return Integer.parseInt(text(node, name));
	}
}
