package io.github.knotresolver.skeleton;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import net.imglib2.img.Img;
import net.imglib2.img.array.ArrayImgs;
import net.imglib2.type.logic.BitType;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.Ascii;

class SpursTest {

	@Test
	void aShortSideBranchGoesAndALongOneStays() {
		final Img<BitType> pruned = Spurs.prune(Ascii.mask("""
			......#.............
			......#.............
			......#.............
			......#.............
			......#.....#.......
			......#.....#.......
			####################
			"""), 4);
		final String drawn = Ascii.draw(pruned);
		assertEquals(5, drawn.lines().limit(5).filter(l -> l.charAt(6) == '#').count(), drawn);
		assertTrue(drawn.lines().limit(5).noneMatch(l -> l.charAt(12) == '#'), drawn);
		assertEquals(3, new LinePixels(pruned).ends().length);
	}

	@Test
	void aForkedEndKeepsOneProng() {
		final Img<BitType> pruned = Spurs.prune(Ascii.mask("""
			................#...
			...............#....
			###############.....
			...............#....
			................#...
			.................#..
			"""), 5);
		final String drawn = Ascii.draw(pruned);
		assertTrue(drawn.endsWith("..#.."), drawn);
		assertEquals(0,
			drawn.lines().limit(2).mapToLong(l -> l.chars().filter(c -> c == '#').count()).sum());
	}

	@Test
	void aLineWithoutJunctionStaysHoweverShort() {
		assertPruned("""
			.....
			.###.
			.....
			""", """
			.....
			.###.
			.....
			""", 9);
	}

	@Test
	void everyEndIsWalkedFromAFewTimesHoweverManyThereAre() {
		for (final int teeth : new int[]{10, 100, 1000}) {
			final Img<BitType> comb = ArrayImgs.bits(6L * teeth + 6, 8);
			for (int x = 0; x < comb.dimension(0); x++)
				comb.getAt(x, 4).set(true);
			for (int tooth = 1; tooth <= teeth; tooth++)
				for (int y = 4 - 1 - tooth % 3; y < 4; y++)
					comb.getAt(6 * tooth, y).set(true);
			final LinePixels line = new LinePixels(comb);
			final int walks = Spurs.prune(line, 5);
			assertTrue(walks <= 3 * teeth + 4, walks + " walks for " + teeth + " teeth");
			assertEquals(2, line.ends().length);
		}
	}

	private static void assertPruned(final String before, final String after, final int length) {
		assertEquals(Ascii.draw(Ascii.mask(after)),
			Ascii.draw(Spurs.prune(Ascii.mask(before), length)));
	}
}
