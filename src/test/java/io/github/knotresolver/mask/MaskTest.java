
package io.github.knotresolver.mask;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;

import net.imglib2.img.Img;
import net.imglib2.type.logic.BitType;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.Ascii;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.mask.ConnectedComponents.MaskObject;

class MaskTest {

	private static final Img<BitType> TWO = Ascii.mask("""
		#........
		.#...##..
		.....##..
		.........
		""");

	@Test
	void objectsAreEightConnectedAndNumberedByRows() {
		assertEquals(List.of(new MaskObject(1, 2, 0, 0, 1, 1, true),
			new MaskObject(2, 4, 5, 1, 6, 2, false)), ConnectedComponents.of(TWO).objects());
	}

	@Test
	void objectIsFoundByPlace() {
		final ConnectedComponents components = ConnectedComponents.of(TWO);
		assertEquals(2, components.at(5, 2).orElseThrow().label());
		assertTrue(components.at(4, 2).isEmpty());
		assertTrue(components.at(-1, 99).isEmpty());
		assertEquals(1, components.nearest(new Point(3.4, 1)).orElseThrow().label() - 1);
		assertEquals(1, components.nearest(new Point(-50, -50)).orElseThrow().label());
		assertTrue(ConnectedComponents.of(Ascii.mask("...")).nearest(new Point(1, 0)).isEmpty());
	}

	@Test
	void specksAndBorderObjectsGo() {
		final String block = Ascii.draw(Ascii.mask("""
			.........
			.....##..
			.....##..
			.........
			"""));
		assertEquals(block, Ascii.draw(MaskRepair.removeSpecks(TWO, 3)));
		assertEquals(block, Ascii.draw(MaskRepair.dropBorderObjects(TWO)));
		assertEquals(Ascii.draw(TWO), Ascii.draw(MaskRepair.removeSpecks(TWO, 2)));
	}

	@Test
	void pinHolesAreFilledAndLoopsAndBaysStay() {
		assertEquals(Ascii.draw(Ascii.mask("""
			#########.
			####...##.
			####...##.
			#########.
			##......##
			""")), Ascii.draw(MaskRepair.fillPinHoles(Ascii.mask("""
			#########.
			#.##...##.
			##.#...##.
			#########.
			##......##
			"""), 2)));
	}

	@Test
	void followerKeepsTheObjectUnderThePoint() {
		final List<Img<BitType>> masks = List.of(Ascii.mask("""
			##.......
			......##.
			......##.
			"""), Ascii.mask("""
			.........
			##....#..
			......#..
			"""), Ascii.mask("""
			.........
			.........
			#########
			"""));
		final List<Optional<Img<BitType>>> found = ObjectFollower.follow(masks, new Point(7, 1));
		assertEquals(Ascii.draw(Ascii.mask("""
			.........
			......#..
			......#..
			""")), Ascii.draw(found.get(1).orElseThrow()));
		assertTrue(found.get(2).isPresent());
	}

	@Test
	void lostObjectIsFoundAgainFromTheLastGoodMask() {
		final Img<BitType> there = Ascii.mask("...##..");
		final Img<BitType> elsewhere = Ascii.mask("##.....");
		final List<Optional<Img<BitType>>> found = ObjectFollower
			.follow(List.of(Ascii.mask("......."), there, elsewhere, there), new Point(4, 0));
		assertFalse(found.get(0).isPresent());
		assertFalse(found.get(2).isPresent());
		assertEquals(Ascii.draw(there), Ascii.draw(found.get(3).orElseThrow()));
	}

	@Test
	void clampedObjectIsNotTakenForAForeignOneThatTouchedIt() {
		final Img<BitType> apart = Ascii.mask("""
			...............
			.####..........
			......#########
			......#########
			""");
		final Img<BitType> touching = Ascii.mask("""
			...............
			.######........
			......#########
			......#########
			""");
		final List<Img<BitType>> masks = List.of(apart, touching, apart);
		final Point clamp = new Point(1, 1);
		assertEquals(9,
			ConnectedComponents.of(ObjectFollower.follow(masks, clamp).get(2).orElseThrow())
				.objects().get(0).maxX() - 5,
			"the published rule takes the larger");
		assertEquals(4,
			ConnectedComponents
				.of(ObjectFollower.followClamped(masks, clamp, 2).get(2).orElseThrow()).objects()
				.get(0).maxX());
	}

	@Test
	void clampedObjectThatLeavesItsClampIsFollowedByOverlap() {
		final Img<BitType> moved = Ascii.mask("...####");
		final List<Optional<Img<BitType>>> found = ObjectFollower
			.followClamped(List.of(Ascii.mask("#####.."), moved), new Point(0, 0), 1);
		assertEquals(Ascii.draw(moved), Ascii.draw(found.get(1).orElseThrow()));
	}

	@Test
	void impossibleReachAndSizesAreRefused() {
		final List<Img<BitType>> masks = List.of(TWO, Ascii.mask("##"));
		assertTrue(assertThrows(IllegalArgumentException.class,
			() -> ObjectFollower.followClamped(masks, new Point(0, 0), -1)).getMessage()
			.contains("-1.0"));
		assertTrue(assertThrows(IllegalArgumentException.class,
			() -> ObjectFollower.follow(masks, new Point(0, 0))).getMessage().contains("9 x 4"));
	}

	@Test
	void overlapCountsSharedPixelsByLabel() {
		assertArrayEquals(new int[]{5, 1, 3}, ConnectedComponents.of(TWO).overlap(Ascii.mask("""
			##.......
			..##.##..
			..##..#..
			.........
			""")));
	}
}
