
package io.github.knotresolver.skeleton;

import static org.junit.jupiter.api.Assertions.assertEquals;

import net.imglib2.img.Img;
import net.imglib2.type.logic.BitType;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.Ascii;

class BranchPixelsTest {

	private static final Img<BitType> TEE = Ascii.mask("""
		...#...
		...#...
		#######
		.......
		""");

	@Test
	void branchPixelsHaveThreeNeighboursOrMore() {
		assertEquals(Ascii.draw(Ascii.mask("""
			.......
			...#...
			..###..
			.......
			""")), Ascii.draw(BranchPixels.of(TEE)));
	}

	@Test
	void endPixelsHaveOneNeighbour() {
		assertEquals(Ascii.draw(Ascii.mask("""
			...#...
			.......
			#.....#
			.......
			""")), Ascii.draw(EndPixels.of(TEE)));
	}

	@Test
	void singlePixelIsNeither() {
		assertEquals(".", Ascii.draw(BranchPixels.of(Ascii.mask("#"))));
		assertEquals(".", Ascii.draw(EndPixels.of(Ascii.mask("#"))));
	}
}
