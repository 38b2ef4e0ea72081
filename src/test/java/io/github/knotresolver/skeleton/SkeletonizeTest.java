
package io.github.knotresolver.skeleton;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;

import net.imglib2.img.Img;
import net.imglib2.type.logic.BitType;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import io.github.knotresolver.Ascii;
import io.github.knotresolver.image.Pixels;
import io.github.knotresolver.mask.ConnectedComponents;

class SkeletonizeTest {

	@Test
	void wideBarBecomesItsMiddleLine() {
		assertEquals(Ascii.draw(Ascii.mask("""
			...........
			...........
			.#########.
			...........
			...........
			""")), Ascii.draw(Skeletonize.thin(Ascii.mask("""
			...........
			.#########.
			.#########.
			.#########.
			...........
			"""))));
	}

	@Test
	void staircaseKeepsNoCorners() {
		assertEquals(Ascii.draw(Ascii.mask("""
			.....
			.#...
			..#..
			...#.
			....#
			""")), Ascii.draw(Skeletonize.thin(Ascii.mask("""
			##...
			.##..
			..##.
			...##
			....#
			"""))));
	}

	@Test
	void tipOnTheFilamentClosesALoopAndHasNoEnd() {
		final Img<BitType> line = Skeletonize.thin(Ascii.mask("""
			..............
			..########....
			.##########...
			.###....###...
			.###....###...
			.#############
			.#############
			.#############
			..............
			"""));
		assertEquals(1, ConnectedComponents.of(line).objects().size());
		assertEquals(1, holes(line));
		assertEquals(1, count(SkeletonNodes.ends(line)));
		assertTrue(count(SkeletonNodes.branches(line)) >= 1, Ascii.draw(line));
	}

	@Test
	void parallelOverlapLeavesOneLineBetweenTwoForks() {
		final Img<BitType> line = Skeletonize.thin(Ascii.mask("""
			###...................###
			.####...............####.
			...####...........####...
			.....###############.....
			......#############......
			......#############......
			.....###############.....
			...####...........####...
			.####...............####.
			###...................###
			"""));
		assertEquals(4, count(SkeletonNodes.ends(line)), Ascii.draw(line));
		assertEquals(2, ConnectedComponents.of(SkeletonNodes.branches(line)).objects().size(),
			Ascii.draw(line));
	}

	@Test
	void loopWithAClosedHoleLeavesNoLoop() {
		final Img<BitType> line = Skeletonize.thin(Ascii.mask("""
			....####......
			...######.....
			...######.....
			....####......
			.############.
			.############.
			"""));
		assertEquals(0, holes(line));
		assertEquals(1, ConnectedComponents.of(line).objects().size());
	}

	@Test
	void touchingForeignFilamentBranchesOff() {
		final Img<BitType> line = Skeletonize.thin(Ascii.mask("""
			......##......
			......##......
			......##......
			......##......
			##############
			##############
			##############
			"""));
		assertEquals(3, count(SkeletonNodes.ends(line)), Ascii.draw(line));
		assertEquals(1, ConnectedComponents.of(SkeletonNodes.branches(line)).objects().size(),
			Ascii.draw(line));
	}

	@Test
	void fullAndEmptyFramesSurvive() {
		assertEquals(0, count(Skeletonize.thin(Ascii.mask("...\n..."))));
		assertEquals(1, ConnectedComponents
			.of(Skeletonize.thin(Ascii.mask("#####\n#####\n#####\n#####"))).objects().size());
		assertEquals(1, count(Skeletonize.thin(Ascii.mask("#"))));
	}

	@ParameterizedTest
	@ValueSource(ints = {1, 2, 3, 4, 5, 6, 7, 8})
	void thinningKeepsPartsAndHolesAndCanDoNoMore(final int seed) {
		final String where = "seed " + seed;
		final Random random = new Random(seed);
		for (int trial = 0; trial < 40; trial++) {
			final Img<BitType> mask = blobs(random, 12 + random.nextInt(30),
				10 + random.nextInt(30));
			final Img<BitType> line = Skeletonize.thin(mask);
			final String drawn = where + "\n" + Ascii.draw(mask) + "\n\n" + Ascii.draw(line);
			assertTrue(isWithin(line, mask), drawn);
			assertEquals(ConnectedComponents.of(mask).objects().size(),
				ConnectedComponents.of(line).objects().size(), drawn);
			assertEquals(holes(mask), holes(line), drawn);
			assertArrayEquals(Pixels.bits(line), Pixels.bits(Skeletonize.thin(line)), drawn);
			assertNothingMoreCanGo(line, drawn);
		}
	}

	@ParameterizedTest
	@ValueSource(ints = {0, 17, 45, 60, 80, 90, 133, 171})
	void straightFilamentHasTwoEndsAndNoBranch(final int degrees) {
		final int size = 81;
		final boolean[] bits = new boolean[size * size];
		final double c = Math.cos(Math.toRadians(degrees));
		final double s = Math.sin(Math.toRadians(degrees));
		for (int i = 0; i < bits.length; i++) {
			final double x = i % size - 40, y = i / size - 40;
			final double beyond = Math.max(0, Math.abs(c * x + s * y) - 30);
			bits[i] = Math.hypot(beyond, c * y - s * x) <= 2.5;
		}
		final Img<BitType> line = Skeletonize.thin(Pixels.mask(bits, size));
		assertEquals(2, count(SkeletonNodes.ends(line)), Ascii.draw(line));
		assertEquals(0, count(SkeletonNodes.branches(line)), Ascii.draw(line));
		final boolean[] kept = Pixels.bits(line);
		for (int i = 0; i < kept.length; i++)
			if (kept[i])
				assertTrue(Math.abs(c * (i / size - 40) - s * (i % size - 40)) <= 1.3,
					"off the middle\n" + Ascii.draw(line));
	}

	/** Removing any pixel but an end parts the line or opens a hole. */
	private static void assertNothingMoreCanGo(final Img<BitType> line, final String drawn) {
		final boolean[] bits = Pixels.bits(line);
		final boolean[] ends = Pixels.bits(SkeletonNodes.ends(line));
		final int width = Pixels.width(line);
		final int parts = ConnectedComponents.of(line).objects().size();
		final int holes = holes(line);
		for (int i = 0; i < bits.length; i++) {
			if (!bits[i] || ends[i])
				continue;
			bits[i] = false;
			final Img<BitType> without = Pixels.mask(bits, width);
			assertTrue(parts != ConnectedComponents.of(without).objects().size()
				|| holes != holes(without), "superfluous pixel " + i + "\n" + drawn);
			bits[i] = true;
		}
	}

	private static Img<BitType> blobs(final Random random, final int width, final int height) {
		final boolean[] bits = new boolean[width * height];
		for (int disc = 0; disc < 14; disc++) {
			final double x = random.nextDouble() * width;
			final double y = random.nextDouble() * height;
			final double radius = 1 + 4 * random.nextDouble();
			final boolean value = random.nextInt(4) > 0;
			for (int i = 0; i < bits.length; i++)
				if (Math.hypot(i % width - x, i / width - y) <= radius)
					bits[i] = value;
		}
		for (int i = 0; i < bits.length; i++)
			if (random.nextInt(60) == 0)
				bits[i] ^= true;
		return Pixels.mask(bits, width);
	}

	/** Background parts that are 4-connected and do not reach the border. */
	private static int holes(final Img<BitType> mask) {
		final int width = Pixels.width(mask), height = Pixels.height(mask);
		final boolean[] bits = Pixels.bits(mask);
		final boolean[] seen = bits.clone();
		int holes = 0;
		for (int i = 0; i < bits.length; i++) {
			if (seen[i])
				continue;
			final java.util.ArrayDeque<Integer> todo = new java.util.ArrayDeque<>();
			todo.add(i);
			seen[i] = true;
			boolean open = false;
			while (!todo.isEmpty()) {
				final int at = todo.remove(), x = at % width, y = at / width;
				open |= x == 0 || y == 0 || x == width - 1 || y == height - 1;
				for (final int[] step : new int[][]{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
					final int u = x + step[0], v = y + step[1];
					if (u < 0 || v < 0 || u >= width || v >= height || seen[v * width + u])
						continue;
					seen[v * width + u] = true;
					todo.add(v * width + u);
				}
			}
			if (!open)
				holes++;
		}
		return holes;
	}

	private static boolean isWithin(final Img<BitType> line, final Img<BitType> mask) {
		final boolean[] a = Pixels.bits(line), b = Pixels.bits(mask);
		for (int i = 0; i < a.length; i++)
			if (a[i] && !b[i])
				return false;
		return true;
	}

	private static int count(final Img<BitType> mask) {
		int count = 0;
		for (final boolean bit : Pixels.bits(mask))
			if (bit)
				count++;
		return count;
	}
}
