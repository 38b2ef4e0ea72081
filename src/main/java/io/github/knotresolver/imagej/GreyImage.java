package io.github.knotresolver.imagej;

import java.awt.image.IndexColorModel;

import ij.ImagePlus;
import ij.ImageStack;
import ij.process.ByteProcessor;
import ij.process.ImageProcessor;
import io.github.knotresolver.model.UserException;

/** Grey values that are stored as colours. */
final class GreyImage {

	private static final int RGB_BITS = 24;

	private GreyImage() {
	}

	/**
	 * @param image any image; it stays as it is
	 * @return an 8-bit image of the same grey values, if it is an RGB image without any
	 *         colour; else the image itself
	 */
	static ImagePlus of(final ImagePlus image) {
		if (image.getBitDepth() != RGB_BITS)
			return image;
		final ImageStack stack = new ImageStack(image.getWidth(), image.getHeight());
		for (int i = 1; i <= image.getStackSize(); i++) {
			final ByteProcessor grey = grey((int[]) image.getStack().getProcessor(i).getPixels(),
				image.getWidth(), image.getHeight());
			if (grey == null)
				return image;
			stack.addSlice(image.getStack().getSliceLabel(i), grey);
		}
		final ImagePlus converted = new ImagePlus(image.getTitle(), stack);
		converted.setDimensions(image.getNChannels(), image.getNSlices(), image.getNFrames());
		converted.setCalibration(image.getCalibration());
		if (image.getOriginalFileInfo() != null)
			converted.setFileInfo(image.getOriginalFileInfo());
		return converted;
	}

	/** Null if there is a colour. */
	private static ByteProcessor grey(final int[] pixels, final int width, final int height) {
		final byte[] grey = new byte[pixels.length];
		for (int i = 0; i < pixels.length; i++) {
			final int red = pixels[i] >> 16 & 0xff, green = pixels[i] >> 8 & 0xff,
				blue = pixels[i] & 0xff;
			if (red != green || green != blue)
				return null;
			grey[i] = (byte) red;
		}
		return new ByteProcessor(width, height, grey);
	}

	/**
	 * Puts the grey values of a palette in place of its numbers.
	 *
	 * @param image read from a kind of file in which a palette has no meaning but
	 *          colours
	 * @throws UserException if the palette has other colours
	 */
	static void applyPalette(final ImagePlus image) {
		if (image.getBitDepth() != 8
			|| !(image.getProcessor().getColorModel() instanceof IndexColorModel palette))
			return;
		final byte[] table = new byte[256];
		for (int i = 0; i < palette.getMapSize(); i++) {
			if (palette.getRed(i) != palette.getGreen(i)
				|| palette.getGreen(i) != palette.getBlue(i))
				throw new UserException("'" + image.getTitle()
					+ "' has a palette of colours, so its numbers are no intensities; convert it with Image > Type > RGB Color and then 8-bit.");
			table[i] = (byte) palette.getRed(i);
		}
		final ImageStack stack = new ImageStack(image.getWidth(), image.getHeight());
		for (int i = 1; i <= image.getStackSize(); i++) {
			final ImageProcessor ip = image.getStack().getProcessor(i);
			final byte[] from = (byte[]) ip.getPixels(), to = new byte[from.length];
			for (int k = 0; k < from.length; k++)
				to[k] = table[from[k] & 0xff];
			stack.addSlice(image.getStack().getSliceLabel(i),
				new ByteProcessor(image.getWidth(), image.getHeight(), to));
		}
		final int c = image.getNChannels(), z = image.getNSlices(), t = image.getNFrames();
		image.setStack(stack);
		image.setDimensions(c, z, t);
	}
}
