
package io.github.knotresolver.imagej;

import java.util.AbstractList;
import java.util.List;
import java.util.function.Function;
import java.util.stream.IntStream;

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
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.options.InputOptions;

/**
 * An ImageJ image seen as a movie: one channel over time. The pixels are shared
 * with the image (8, 16, 32 bit), not copied; they are read, never written. Frames of a
 * virtual stack are read when they are needed.
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
		final int[] indices = new int[frames];
		for (int t = 1; t <= frames; t++)
			indices[t - 1] = image.getStackIndex(alongChannels ? t : options.channel(),
				alongZ ? t : 1, alongZ || alongChannels ? 1 : t);
		final ImageStack stack = image.getStack();
		return stack.isVirtual()
			? new VirtualPlanes(stack, indices, image.getBitDepth(),
				Runtime.getRuntime().maxMemory())
			: IntStream.of(indices).mapToObj(n -> stack.getProcessor(n).getPixels()).toList();
	}

	private static PlanarImg<UnsignedByteType, ByteArray> bytes(final List<Object> planes,
		final long[] size) {
		final PlanarImg<UnsignedByteType, ByteArray> img = planar(planes,
			p -> new ByteArray((byte[]) p), size);
		img.setLinkedType(new UnsignedByteType(img));
		return img;
	}

	private static PlanarImg<UnsignedShortType, ShortArray> shorts(final List<Object> planes,
		final long[] size) {
		final PlanarImg<UnsignedShortType, ShortArray> img = planar(planes,
			p -> new ShortArray((short[]) p), size);
		img.setLinkedType(new UnsignedShortType(img));
		return img;
	}

	private static PlanarImg<FloatType, FloatArray> floats(final List<Object> planes,
		final long[] size) {
		final PlanarImg<FloatType, FloatArray> img = planar(planes,
			p -> new FloatArray((float[]) p), size);
		img.setLinkedType(new FloatType(img));
		return img;
	}

	/** The image asks for a plane whenever it comes to one. */
	private static <T extends NativeType<T>, A extends ArrayDataAccess<A>> PlanarImg<T, A> planar(
		final List<Object> planes, final Function<Object, A> access, final long[] size) {
		final List<A> accesses = new AbstractList<>() {

			@Override
			public A get(final int i) {
				return access.apply(planes.get(i));
			}

			@Override
			public int size() {
				return planes.size();
			}
		};
		return new PlanarImg<>(accesses, size, new Fraction());
	}
}
