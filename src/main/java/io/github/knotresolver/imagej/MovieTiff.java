package io.github.knotresolver.imagej;

import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;

import net.imglib2.type.numeric.RealType;
import net.imglib2.type.numeric.integer.UnsignedByteType;
import net.imglib2.view.Views;

import ij.ImagePlus;
import ij.ImageStack;
import ij.io.FileInfo;
import ij.io.FileSaver;
import ij.io.TiffEncoder;
import ij.process.ByteProcessor;
import ij.process.ImageProcessor;
import ij.process.ShortProcessor;
import io.github.knotresolver.model.Calibration;
import io.github.knotresolver.model.Movie;

/** Writes a movie of 8 or 16 bit as a TIFF stack with its calibration. */
public final class MovieTiff {

	private MovieTiff() {
	}

	/**
	 * @param movie 8 bit; any other type is written as 16 bit, whole numbers from 0
	 *          to 65535
	 * @param file the file to write
	 * @throws IOException if a file cannot be written
	 */
	public static void write(final Movie movie, final Path file) throws IOException {
		final ImagePlus image = image(movie);
		final FileInfo info = image.getFileInfo();
		info.description = new FileSaver(image).getDescriptionString();
		info.nImages = movie.size();
		info.pixels = image.getStack().getImageArray();
		try (OutputStream out = new BufferedOutputStream(Files.newOutputStream(file))) {
			new TiffEncoder(info).write(out);
		}
	}

	/**
	 * @param movie an 8 or 16 bit movie
	 * @return the movie as an image of ImageJ, time along the third axis
	 */
	public static ImagePlus image(final Movie movie) {
		final boolean isByte = movie.frames().getType() instanceof UnsignedByteType;
		final ImageStack stack = new ImageStack(movie.width(), movie.height());
		for (int t = 0; t < movie.size(); t++)
			stack.addSlice("", processor(movie, t, isByte));
		final ImagePlus image = new ImagePlus(movie.name(), stack);
		image.setDimensions(1, 1, movie.size());
		image.setOpenAsHyperStack(true);
		calibrate(image.getCalibration(), movie.calibration());
		return image;
	}

	private static void calibrate(final ij.measure.Calibration image, final Calibration movie) {
		image.pixelWidth = movie.pixelSize();
		image.pixelHeight = movie.pixelSize();
		image.setUnit(movie.unit());
		if (!movie.hasTimeUnit())
			return;
		image.frameInterval = movie.frameInterval();
		image.setTimeUnit(movie.timeUnit());
		image.fps = 1 / movie.frameInterval();
	}

	private static ImageProcessor processor(final Movie movie, final int frame,
		final boolean isByte) {
		final ImageProcessor processor = isByte
			? new ByteProcessor(movie.width(), movie.height())
			: new ShortProcessor(movie.width(), movie.height());
		int i = 0;
		for (final RealType<?> pixel : Views.flatIterable(movie.frame(frame)))
			processor.set(i++, (int) pixel.getRealDouble());
		return processor;
	}
}
