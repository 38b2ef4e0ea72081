package io.github.knotresolver.ui;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.OptionalInt;

import org.junit.jupiter.api.Test;

/** What a row of ImageJ's tables tells of its frame. */
class TableClicksTest {

	private static final String HEADINGS = " \tframe\ttime [s]\tfilament";

	@Test
	void aRowTellsFrameAndFilament() {
		assertEquals(OptionalInt.of(12), TableClicks.number(HEADINGS, "3\t12\t5.500\t2", "frame"));
		assertEquals(OptionalInt.of(2),
			TableClicks.number(HEADINGS, "3\t12\t5.500\t2.000", "filament"));
		assertEquals(OptionalInt.empty(), TableClicks.number(HEADINGS, "3\t\t5.5\t", "filament"));
		assertEquals(OptionalInt.empty(), TableClicks.number(HEADINGS, "3\t1.5\t5.5", "frame"));
		assertEquals(OptionalInt.empty(), TableClicks.number("x\ty", "1\t2", "frame"));
	}
}
