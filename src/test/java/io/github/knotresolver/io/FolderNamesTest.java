package io.github.knotresolver.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class FolderNamesTest {

	@ParameterizedTest
	@CsvSource({"a.tif,a", "a.b.tif,a.b", "a,a", "ä ö.ome.tif,ä ö.ome", "a-2.tif,a-2",
		"batch.csv.tif,batch.csv-2", "BATCH.CSV.tif,BATCH.CSV-2", "con.tif,_con",
		"COM1.x.tif,_COM1.x", "a:b*c?.tif,a_b_c_", "' a. .tif',a"})
	void isTheMoviesNameWithoutItsEnding(final String movie, final String name) {
		assertEquals(name, new FolderNames(BatchList.FILE).next(movie, n -> true));
	}

	@ParameterizedTest
	@ValueSource(strings = {".tif", "..tif", "...tif", "....", "", "/", "..", ".", " .tif",
		"\0.tif", "a\0b.tif", "../x.tif", "a/b.tif", "C:\\x.tif"})
	void isAlwaysOnePlainName(final String movie) {
		final String name = new FolderNames().next(movie, n -> true);
		assertTrue(name.matches("[^/\\\\\\p{Cntrl}:.]+"), name);
	}

	@Test
	void longNamesAreCut() {
		final FolderNames names = new FolderNames();
		final String first = names.next("ü".repeat(127) + ".tif", n -> true),
			second = names.next("ü".repeat(126) + "x.tif", n -> true);
		assertTrue(first.getBytes(StandardCharsets.UTF_8).length < 200, first);
		assertEquals(first + "-2", second);
	}

	@Test
	void noTwoAreTheSameOnAnySystem() {
		final FolderNames names = new FolderNames();
		assertEquals("Cell", names.next("Cell.tif", n -> true));
		assertEquals("cell-2", names.next("cell.tif", n -> true));
		assertEquals("Cell-2-2", names.next("Cell-2.tif", n -> true));
		assertEquals("\u00e9", names.next("\u00e9.tif", n -> true));
		assertEquals("e\u0301-2", names.next("e\u0301.tif", n -> true));
	}

	@Test
	void whatIsNotFreeIsNumberedOn() {
		assertEquals("a-4", new FolderNames().next("a.tif", n -> n.equals("a-4")));
	}
}
