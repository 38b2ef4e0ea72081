package io.github.knotresolver.imagej;

import java.awt.image.BufferedImage;
import java.awt.image.DataBufferInt;
import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;

import ij.ImagePlus;
import ij.VirtualStack;
import ij.io.FileInfo;
import ij.io.FileSaver;
import ij.io.TiffEncoder;
import ij.plugin.filter.AVI_Writer;
import ij.process.ColorProcessor;
import ij.process.ImageProcessor;
import io.github.knotresolver.model.Tracks;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.progress.Progress;

/**
 * The movie with its contours drawn in, frame by frame: each is drawn when it is
 * asked for, so that the stack may be larger than memory.
 */
final class OverlayStack extends VirtualStack {

	private static final int RGB_BITS = 24;
	private static final int FILM_QUALITY = 85;

	private final Tracks tracks;
	private final ContourPainter painter;
	private final Progress progress;

	/**
	 * @param tracks a result
	 * @param scale edge of a movie's pixel in the stack
	 * @param painter paints its frames
	 * @param progress asked before every frame
	 */
	OverlayStack(final Tracks tracks, final int scale, final ContourPainter painter,
		final Progress progress) {
		super(tracks.movie().width() * scale, tracks.movie().height() * scale);
		this.tracks = tracks;
		this.painter = painter;
		this.progress = progress;
		setBitDepth(RGB_BITS);
	}

	@Override
	public int size() {
		return tracks == null ? 0 : tracks.movie().size();
	}

	@Override
	public int getSize() {
		return size();
	}

	@Override
	public ImageProcessor getProcessor(final int n) {
		progress.checkCancelled();
		final BufferedImage picture = painter.paint(n - 1);
		return new ColorProcessor(picture.getWidth(), picture.getHeight(),
			((DataBufferInt) picture.getRaster().getDataBuffer()).getData());
	}

	@Override
	public Object getPixels(final int n) {
		return getProcessor(n).getPixels();
	}

	@Override
	public String getSliceLabel(final int n) {
		return ContourPainter.label(tracks, n - 1);
	}

	/**
	 * Writes a stack as an ordinary TIFF, one frame after the other. One of more than
	 * 4 GB is written as ImageJ does: all frames in a row after the first directory.
	 *
	 * @param image an image with a virtual stack
	 * @param file the file to write
	 * @throws IOException if it cannot be written
	 */
	static void write(final ImagePlus image, final Path file) throws IOException {
		try (OutputStream out = new BufferedOutputStream(Files.newOutputStream(file))) {
			write(image, out);
		}
	}

	/** Writes it to a stream, with one frame in memory at a time. */
	static void write(final ImagePlus image, final OutputStream out) throws IOException {
		final FileInfo info = image.getFileInfo();
		info.description = new FileSaver(image).getDescriptionString();
		info.nImages = image.getStackSize();
		info.virtualStack = (VirtualStack) image.getStack();
		info.sliceLabels = new String[info.nImages];
		for (int n = 1; n <= info.nImages; n++)
			info.sliceLabels[n - 1] = image.getStack().getSliceLabel(n);
		new TiffEncoder(info).write(out);
	}

	/**
	 * Writes a stack as a film that any player and slide show takes.
	 *
	 * @param image an image with an RGB stack
	 * @param file the AVI file (JPEG frames) to write; replaced if it is there
	 * @param framesPerSecond above 0 to 60
	 * @throws UserException if the speed is out of range
	 * @throws IOException if a file cannot be written
	 */
	static void writeFilm(final ImagePlus image, final Path file, final double framesPerSecond)
		throws IOException {
		if (!(framesPerSecond > 0 && framesPerSecond <= 60))
			throw new UserException(
				"The speed must be above 0 and at most 60 frames per second, but is "
					+ framesPerSecond + ".");
		// The stack may be larger than memory, so it is not copied.
		final ImagePlus film = new ImagePlus(image.getTitle(), image.getStack());
		film.getCalibration().fps = framesPerSecond;
		Files.deleteIfExists(file);
		new AVI_Writer().writeImage(film, file.toString(), AVI_Writer.JPEG_COMPRESSION,
			FILM_QUALITY);
	}
}
