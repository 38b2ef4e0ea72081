package io.github.knotresolver.imagej;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import ij.IJ;
import ij.ImagePlus;

class PixelSumTest {

	/** Larger than what is summed at once, in the last pixel of the last plane. */
	@ParameterizedTest
	@ValueSource(strings = {"8-bit", "16-bit", "32-bit", "RGB"})
	void oneOtherPixelIsNoticedAndForgivenWhenItIsBack(final String type) {
		final ImagePlus image = IJ.createImage("m", type + " ramp", 301, 207, 3);
		final PixelSum before = PixelSum.of(image);
		assertTrue(before.isSame());
		image.setSlice(2);
		image.setRoi(3, 4, 5, 6);
		assertTrue(before.isSame(), "looking changes nothing");
		final var plane = image.getStack().getProcessor(3);
		final int old = plane.get(300, 206);
		plane.set(300, 206, old ^ 1);
		assertFalse(before.isSame());
		plane.set(300, 206, old);
		assertTrue(before.isSame());
		image.getStack().deleteLastSlice();
		assertFalse(before.isSame());
	}
}
