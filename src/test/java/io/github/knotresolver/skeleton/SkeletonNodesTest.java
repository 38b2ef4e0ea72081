
package io.github.knotresolver.skeleton;

import static org.junit.jupiter.api.Assertions.assertEquals;

import net.imglib2.img.Img;
import net.imglib2.type.logic.BitType;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.Ascii;

class SkeletonNodesTest {

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
			""")), Ascii.draw(SkeletonNodes.branches(TEE)));
	}

	@Test
	void endPixelsHaveOneNeighbour() {
		assertEquals(Ascii.draw(Ascii.mask("""
			...#...
			.......
			#.....#
			.......
			""")), Ascii.draw(SkeletonNodes.ends(TEE)));
	}

	@Test
	void singlePixelIsNeither() {
		assertEquals(".", Ascii.draw(SkeletonNodes.branches(Ascii.mask("#"))));
		assertEquals(".", Ascii.draw(SkeletonNodes.ends(Ascii.mask("#"))));
	}
}
