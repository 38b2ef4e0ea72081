package io.github.knotresolver.command;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageTypeSpecifier;
import javax.imageio.ImageWriter;
import javax.imageio.metadata.IIOMetadata;
import javax.imageio.metadata.IIOMetadataNode;
import javax.imageio.stream.ImageOutputStream;

/** A film as an animated GIF that is repeated for ever. */
final class FilmGif implements AutoCloseable {

	private static final String FORMAT = "javax_imageio_gif_image_1.0";
	private static final int HUNDREDTHS = 10;

	private final ImageWriter writer = ImageIO.getImageWritersByFormatName("gif").next();
	private final ImageOutputStream out;

	FilmGif(final Path file) throws IOException {
		Files.deleteIfExists(file);
		out = ImageIO.createImageOutputStream(file.toFile());
		writer.setOutput(out);
		writer.prepareWriteSequence(null);
	}

	/** Adds a picture that is shown for so many tenths of a second. */
	void add(final BufferedImage picture, final int tenths) throws IOException {
		final IIOMetadata data = writer
			.getDefaultImageMetadata(ImageTypeSpecifier.createFromRenderedImage(picture), null);
		final IIOMetadataNode root = (IIOMetadataNode) data.getAsTree(FORMAT);
		final IIOMetadataNode control = child(root, "GraphicControlExtension");
		control.setAttribute("disposalMethod", "none");
		control.setAttribute("userInputFlag", "FALSE");
		control.setAttribute("transparentColorFlag", "FALSE");
		control.setAttribute("transparentColorIndex", "0");
		control.setAttribute("delayTime", Integer.toString(tenths * HUNDREDTHS));
		final IIOMetadataNode loop = new IIOMetadataNode("ApplicationExtension");
		loop.setAttribute("applicationID", "NETSCAPE");
		loop.setAttribute("authenticationCode", "2.0");
		loop.setUserObject(new byte[]{1, 0, 0});
		child(root, "ApplicationExtensions").appendChild(loop);
		data.setFromTree(FORMAT, root);
		writer.writeToSequence(new IIOImage(picture, null, data), null);
	}

	private static IIOMetadataNode child(final IIOMetadataNode root, final String name) {
		for (int i = 0; i < root.getLength(); i++)
			if (root.item(i).getNodeName().equals(name))
				return (IIOMetadataNode) root.item(i);
		final IIOMetadataNode made = new IIOMetadataNode(name);
		root.appendChild(made);
		return made;
	}

	@Override
	public void close() throws IOException {
		writer.endWriteSequence();
		out.close();
		writer.dispose();
	}
}
