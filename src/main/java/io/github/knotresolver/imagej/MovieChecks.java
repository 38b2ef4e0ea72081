
package io.github.knotresolver.imagej;

import java.util.List;

import ij.ImagePlus;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.options.InputOptions;

/** What an image must be to be a movie, each refusal in one sentence. */
final class MovieChecks {

	private static final int RGB_BITS = 24;

	private MovieChecks() {
	}

	/** Grey values, several frames, the channel there, time along one axis. */
	static void requireTimeSeries(final ImagePlus image, final InputOptions options) {
		final String name = "'" + image.getTitle() + "'";
		if (image.getBitDepth() == RGB_BITS)
			throw new UserException(name
				+ " is an RGB image, but intensities are needed; convert it with Image > Type > 8-bit, or take one channel with Image > Color > Split Channels.");
		if (options.channel() > image.getNChannels())
			throw new UserException("channel must be from 1 to " + image.getNChannels()
				+ " for " + name + ", but is " + options.channel() + ".");
		final int slices = image.getNSlices(), frames = image.getNFrames();
		if (slices > 1 && frames > 1)
			throw new UserException(name + " has " + slices + " Z slices and " + frames
				+ " frames, but a movie has one slice a frame; make a projection with Image > Stacks > Z Project.");
		if (slices <= 1 && frames <= 1)
			throw new UserException(
				name + " has one frame only, but a movie has several; open the whole stack.");
		if (ImageMovie.isAlongZ(image) && !options.zAsTime())
			throw new UserException(name + " is a Z-stack of " + slices
				+ " slices, not a time series; if the slices are frames, add --z-as-time (in ImageJ: z_as_time, or swap Z and T in Image > Properties).");
	}

	/** At least one frame in which not all pixels are equal. */
	static void requireContrast(final String name, final List<Object> planes) {
		if (planes.stream().allMatch(MovieChecks::isConstant))
			throw new UserException("All pixels are equal in every frame of '" + name
				+ "', so there is no filament to find; open another movie.");
	}

	private static boolean isConstant(final Object plane) {
		if (plane instanceof byte[] b)
			return isConstant(b);
		return plane instanceof short[] s ? isConstant(s) : isConstant((float[]) plane);
	}

	private static boolean isConstant(final byte[] pixels) {
		for (final byte p : pixels)
			if (p != pixels[0])
				return false;
		return true;
	}

	private static boolean isConstant(final short[] pixels) {
		for (final short p : pixels)
			if (p != pixels[0])
				return false;
		return true;
	}

	/** NaN is no intensity: a frame of NaN is constant too. */
	private static boolean isConstant(final float[] pixels) {
		float first = Float.NaN;
		for (final float p : pixels) {
			if (Float.isNaN(first))
				first = p;
			else if (!Float.isNaN(p) && p != first)
				return false;
		}
		return true;
	}
}
