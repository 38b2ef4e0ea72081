
package io.github.knotresolver.imagej;

import java.util.ArrayList;
import java.util.List;

import net.imglib2.img.basictypeaccess.array.ArrayDataAccess;
import net.imglib2.img.basictypeaccess.array.ByteArray;
import net.imglib2.img.basictypeaccess.array.FloatArray;
import net.imglib2.img.basictypeaccess.array.ShortArray;
import net.imglib2.img.planar.PlanarImg;
import net.imglib2.type.NativeType;
import net.imglib2.type.numeric.integer.UnsignedByteType;
import net.imglib2.type.numeric.integer.UnsignedShortType;
import net.imglib2.type.numeric.real.FloatType;
import net.imglib2.util.Fraction;

import ij.ImagePlus;
import ij.ImageStack;
import ij.process.ImageProcessor;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.options.InputOptions;

/**
 * An ImageJ image seen as a movie: one channel over time. The pixels are shared
 * with the image (8, 16, 32 bit), not copied; they are read, never written. A
 * virtual stack is read once.
 */
public final class ImageMovie {

	private ImageMovie() {
	}

	/**
	 * @param image an image; it stays as it is
	 * @param options channel, axis of time and calibration
	 * @return the movie
	 * @throws UserException if the image is no movie of one filament
	 *           in grey values; one sentence that says what to do
	 */
	public static Movie of(final ImagePlus image, final InputOptions options) {
		return ofGrey(GreyImage.of(image), options);
	}

	private static Movie ofGrey(final ImagePlus image, final InputOptions options) {
		MovieChecks.requireTimeSeries(image, options);
		final List<Object> planes = planes(image, options);
		MovieChecks.requireContrast(image.getTitle(), planes);
		final long[] size = {image.getWidth(), image.getHeight(), planes.size()};
		final var calibration = options.over(ImageCalibration.of(image));
		return switch (image.getBitDepth()) {
			case 8 -> new Movie(image.getTitle(), bytes(planes, size), calibration);
			case 16 -> new Movie(image.getTitle(), shorts(planes, size), calibration);
			default -> new Movie(image.getTitle(), floats(planes, size), calibration);
		};
	}

	/** @return whether the image has its frames along Z */
	static boolean isAlongZ(final ImagePlus image) {
		return image.getNFrames() == 1 && image.getNSlices() > 1;
	}

	/**
	 * @param image an image
	 * @return whether all that it has several of is channels
	 */
	public static boolean isAlongChannels(final ImagePlus image) {
		return image.getNFrames() == 1 && image.getNSlices() == 1 && image.getNChannels() > 1;
	}

	/**
	 * @param image an image
	 * @return whether its frames are read from another axis than that of time
	 */
	public static boolean isTimeElsewhere(final ImagePlus image) {
		return isAlongZ(image) || isAlongChannels(image);
	}

	private static List<Object> planes(final ImagePlus image, final InputOptions options) {
		final boolean alongZ = isAlongZ(image), alongChannels = isAlongChannels(image);
		final int frames = alongChannels
			? image.getNChannels()
			: alongZ ? image.getNSlices() : image.getNFrames();
		final List<Object> planes = new ArrayList<>(frames);
		for (int t = 1; t <= frames; t++) {
			final int index = image.getStackIndex(alongChannels ? t : options.channel(),
				alongZ ? t : 1, alongZ || alongChannels ? 1 : t);
			planes.add(pixels(image.getStack(), index));
		}
		return planes;
	}

	/** Some virtual stacks give the same array again and again. */
	private static Object pixels(final ImageStack stack, final int index) {
		final ImageProcessor plane = stack.getProcessor(index);
		return stack.isVirtual() ? plane.getPixelsCopy() : plane.getPixels();
	}

	private static PlanarImg<UnsignedByteType, ByteArray> bytes(final List<Object> planes,
		final long[] size) {
		final PlanarImg<UnsignedByteType, ByteArray> img = planar(
			planes.stream().map(p -> new ByteArray((byte[]) p)).toList(), size);
		img.setLinkedType(new UnsignedByteType(img));
		return img;
	}

	private static PlanarImg<UnsignedShortType, ShortArray> shorts(final List<Object> planes,
		final long[] size) {
		final PlanarImg<UnsignedShortType, ShortArray> img = planar(
			planes.stream().map(p -> new ShortArray((short[]) p)).toList(), size);
		img.setLinkedType(new UnsignedShortType(img));
		return img;
	}

	private static PlanarImg<FloatType, FloatArray> floats(final List<Object> planes,
		final long[] size) {
		final PlanarImg<FloatType, FloatArray> img = planar(
			planes.stream().map(p -> new FloatArray((float[]) p)).toList(), size);
		img.setLinkedType(new FloatType(img));
		return img;
	}

	private static <T extends NativeType<T>, A extends ArrayDataAccess<A>> PlanarImg<T, A> planar(
		final List<A> planes, final long[] size) {
		return new PlanarImg<>(planes, size, new Fraction());
	}
}
