
package io.github.knotresolver.mask;

import net.imglib2.RandomAccessibleInterval;
import net.imglib2.img.Img;
import net.imglib2.type.logic.BitType;

import io.github.knotresolver.image.Pixels;

/** Takes out of a mask what is not a filament. Inputs are not changed. */
public final class MaskRepair {

	private MaskRepair() {
	}

	/**
	 * Fills small 4-connected holes. The loop of a filament may be small, so the
	 * size should be, too.
	 *
	 * @implNote op names="knotresolver.fillPinHoles"
	 * @param mask any mask
	 * @param pixels size up to which holes are filled
	 * @return a new mask without pin holes
	 */
	public static Img<BitType> fillPinHoles(final RandomAccessibleInterval<BitType> mask,
		final int pixels) {
		final boolean[] background = Pixels.bits(mask);
		for (int at = 0; at < background.length; at++)
			background[at] = !background[at];
		final int width = Pixels.width(mask);
		final boolean[] kept = ConnectedComponents.label(background, width, false)
			.bits(hole -> hole.touchesBorder() || hole.pixels() > pixels);
		for (int at = 0; at < kept.length; at++)
			kept[at] = !kept[at];
		return Pixels.mask(kept, width);
	}

	/**
	 * Removes small 8-connected objects.
	 *
	 * @implNote op names="knotresolver.removeSpecks"
	 * @param mask any mask
	 * @param pixels size below which 8-connected objects go
	 * @return a new mask without specks
	 */
	public static Img<BitType> removeSpecks(final RandomAccessibleInterval<BitType> mask,
		final int pixels) {
		return ConnectedComponents.of(mask).mask(object -> object.pixels() >= pixels);
	}

	/**
	 * Removes objects that touch the border.
	 *
	 * @implNote op names="knotresolver.dropBorderObjects"
	 * @param mask any mask
	 * @return a new mask without the objects that touch the border of the frame
	 */
	public static Img<BitType> dropBorderObjects(final RandomAccessibleInterval<BitType> mask) {
		return ConnectedComponents.of(mask).mask(object -> !object.touchesBorder());
	}
}
