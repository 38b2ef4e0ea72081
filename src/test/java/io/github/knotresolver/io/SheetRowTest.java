package io.github.knotresolver.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import io.github.knotresolver.model.UserException;

/** A movie's row in a batch sheet is written, and nothing else is changed. */
class SheetRowTest {

	private static final Map<String, String> TUNED = Map.of("threshold", "0.46", "iterations", "3",
		"contraction_bias", "0.1", "smooth_factor", "0.2", "log_size", "9", "log_sigma", "1.5");

	@TempDir
	Path home;

	@Test
	void aNewSheetIsReadBackAsItWasMeant() throws IOException {
		final Path sheet = home.resolve("sheet.csv"), movie = home.resolve("in/a, b.tif");
		final SheetRow row = new SheetRow(sheet, movie);
		assertFalse(row.isThere());
		row.write(TUNED, false);
		assertTrue(row.isThere());
		final BatchRow read = BatchSheet.read(sheet).rows().get(0);
		assertEquals(movie.toString(), read.movie());
		assertEquals(new TreeMap<>(TUNED), read.texts());
		assertEquals(List.of(), read.notes());
	}

	@Test
	void otherRowsAndColumnsStayAndNothingIsReplacedUnasked() throws IOException {
		final Path sheet = home.resolve("sheet.csv");
		final String before = "Mine,FileName,FolderPath,segThresh\n\"x, y\",c.tif,,0.3\nz,d.tif,,0.4\n";
		Files.writeString(sheet, before);
		final SheetRow row = new SheetRow(sheet, home.resolve("d.tif"));
		assertThrows(UserException.class, () -> row.write(TUNED, false));
		assertEquals(before, Files.readString(sheet));
		row.write(TUNED, true);
		new SheetRow(sheet, home.resolve("e.tif")).write(Map.of("threshold", "otsu"), false);
		final List<String> lines = Files.readAllLines(sheet);
		assertEquals(4, lines.size());
		assertTrue(lines.get(0).startsWith("Mine,FileName,FolderPath,segThresh,segIteration"));
		assertTrue(lines.get(1).startsWith("\"x, y\",c.tif,,0.3,"), lines.get(1));
		assertTrue(lines.get(2).startsWith("z,d.tif,,0.46,3,"), lines.get(2));
		assertEquals(Map.of("threshold", "0.3"), BatchSheet.read(sheet).rows().get(0).texts());
		assertEquals(Map.of(), BatchSheet.read(sheet).rows().get(2).texts());
	}

	@Test
	void whatIsNoSheetIsLeftAlone() throws IOException {
		final Path sheet = home.resolve("other.csv");
		for (final String text : List.of("a,b\n1,2\n", "FileName;FolderPath\na.tif;\n")) {
			Files.writeString(sheet, text);
			assertThrows(UserException.class,
				() -> new SheetRow(sheet, home.resolve("a.tif")).write(TUNED, true));
			assertEquals(text, Files.readString(sheet));
		}
	}
}
