
package io.github.knotresolver.imagej;

import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

import ij.ImagePlus;
import ij.io.FileInfo;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.options.InputOptions;

/** What an image must be to be a movie, each refusal in one sentence. */
final class MovieChecks {

	private static final int RGB_BITS = 24;
	private static final Pattern IMAGES = Pattern.compile("(?m)^images=(\\d{1,9})\\s*$");

	private MovieChecks() {
	}

	/** Grey values, several frames, the channel there, time along one axis. */
	static void requireTimeSeries(final ImagePlus image, final InputOptions options) {
		final String name = "'" + image.getTitle() + "'";
		if (image.getBitDepth() == RGB_BITS)
			throw new UserException(name
				+ " is an RGB image, but intensities are needed; convert it with Image > Type > 8-bit, or take one channel with Image > Color > Split Channels.");
		requireAllFrames(name, image);
		if (options.channel() > image.getNChannels())
			throw new UserException("channel must be from 1 to " + image.getNChannels() + " for "
				+ name + ", but is " + options.channel() + ".");
		final int slices = image.getNSlices(), frames = image.getNFrames();
		if (slices > 1 && frames > 1)
			throw new UserException(name + " has " + slices + " Z slices and " + frames
				+ " frames, but a movie has one slice a frame; make a projection with Image > Stacks > Z Project.");
		if (ImageMovie.isAlongChannels(image)) {
			requireChannelsAsTime(name, image, options);
			return;
		}
		if (slices <= 1 && frames <= 1)
			throw new UserException(
				name + " has one frame only, but a movie has several; open the whole stack.");
		if (ImageMovie.isAlongZ(image) && !options.zAsTime())
			throw new UserException(name + " is a Z-stack of " + slices
				+ " slices, not a time series; if the slices are frames, add z_as_time, or swap Z and T in ImageJ's Image > Properties.");
	}

	private static void requireChannelsAsTime(final String name, final ImagePlus image,
		final InputOptions options) {
		if (!options.zAsTime())
			throw new UserException(name + " has " + image.getNChannels()
				+ " channels and one frame, but a movie has several frames; if the channels are frames, add z_as_time, or swap channels and frames in ImageJ's Image > Properties.");
		if (options.channel() != 1)
			throw new UserException("channel must be 1 if the channels of " + name
				+ " are read as frames, but is " + options.channel() + ".");
	}

	/** With too little memory ImageJ opens the first frames of a file, and says so only once. */
	private static void requireAllFrames(final String name, final ImagePlus image) {
		final FileInfo info = image.getOriginalFileInfo();
		if (info == null || image.changes || info.description == null
			|| !info.description.startsWith("ImageJ="))
			return;
		final Matcher images = IMAGES.matcher(info.description);
		if (images.find() && Long.parseLong(images.group(1)) > image.getStackSize())
			throw new UserException(name + " has " + image.getStackSize() + " of the "
				+ images.group(1)
				+ " frames of its file, as if there had been too little memory to open it; give more in Edit > Options > Memory & Threads and open it again, or duplicate the part that you want.");
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
