package io.github.knotresolver.imagej.tiff;

import java.util.Arrays;
import java.util.stream.IntStream;

import ij.ImagePlus;
import ij.ImageStack;

/**
 * What the planes of a file are.
 *
 * @param channels number of channels
 * @param slices number of Z slices
 * @param frames number of frames
 * @param plane index of the plane, from 0, that has channel c, slice z and frame t,
 *          at place {@code c + channels (z + slices t)}
 */
record TiffAxes(int channels, int slices, int frames, int[] plane) {

	TiffAxes {
		plane = plane.clone();
	}

	/** Planes in ImageJ's order: channels first, frames last. */
	static TiffAxes inOrder(final int channels, final int slices, final int frames) {
		return new TiffAxes(channels, slices, frames,
			IntStream.range(0, channels * slices * frames).toArray());
	}

	/** @return the array of planes */
	@Override
	public int[] plane() {
		return plane.clone();
	}

	/**
	 * @param order the axes C, Z and T, the fastest first
	 * @return the planes of a file that has them in this order
	 */
	static TiffAxes ordered(final String order, final int channels, final int slices,
		final int frames) {
		final int[] sizes = {channels, slices, frames};
		final int[] steps = new int[3];
		int step = 1;
		for (final char axis : order.toCharArray()) {
			steps["CZT".indexOf(axis)] = step;
			step *= sizes["CZT".indexOf(axis)];
		}
		final int[] plane = new int[channels * slices * frames];
		for (int t = 0; t < frames; t++)
			for (int z = 0; z < slices; z++)
				for (int c = 0; c < channels; c++)
					plane[c + channels * (z + slices * t)] = c * steps[0] + z * steps[1]
						+ t * steps[2];
		return new TiffAxes(channels, slices, frames, plane);
	}

	/** Puts the planes of an image, which are in the file's order, into ImageJ's. */
	void arrange(final ImagePlus image) {
		final ImageStack given = image.getStack();
		if (!Arrays.equals(plane, IntStream.range(0, plane.length).toArray())) {
			image.setStack(given instanceof RawStack raw ? raw.ordered(plane) : ordered(given));
		}
		image.setDimensions(channels, slices, frames);
	}

	private ImageStack ordered(final ImageStack given) {
		final ImageStack stack = new ImageStack(given.getWidth(), given.getHeight());
		for (final int i : plane)
			stack.addSlice(given.getSliceLabel(i + 1), given.getProcessor(i + 1));
		return stack;
	}

	/** @return how many planes there are */
	int planes() {
		return plane.length;
	}
}
