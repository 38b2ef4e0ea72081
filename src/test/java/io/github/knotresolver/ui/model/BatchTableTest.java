package io.github.knotresolver.ui.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.stream.IntStream;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import io.github.knotresolver.io.BatchOutcome;
import io.github.knotresolver.io.BatchOutcome.Status;
import io.github.knotresolver.io.BatchRow;

/** What a batch shows at its end, and in which order its results are looked at. */
class BatchTableTest {

	@TempDir
	Path out;

	private BatchOutcome finished(final String name, final boolean byHand, final String... frames)
		throws IOException {
		final Path folder = Files.createDirectory(out.resolve(name));
		Files.writeString(folder.resolve("frames.csv"),
			"frame,status,confidence,checked\n" + String.join("\n", frames) + "\n");
		Files.writeString(folder.resolve("filaments.csv"), "filament,length,unit\n1,18.3061,µm\n");
		return new BatchOutcome(row(name, byHand), Status.FINISHED, Optional.of(name),
			name + ".tif: fine.");
	}

	private static BatchRow row(final String name, final boolean byHand) {
		return new BatchRow(2, "/data/" + name + ".tif", Map.of(), byHand, List.of());
	}

	private static List<Object> cells(final BatchTable table, final int row) {
		return IntStream.range(0, BatchTable.COLUMNS.size()).mapToObj(c -> table.cell(row, c))
			.toList();
	}

	@Test
	void everyMovieHasItsNumbersAndThoseInDoubtComeOneAfterTheOther() throws IOException {
		final BatchTable table = new BatchTable(out,
			List.of(finished("sure", false, "1,resolved,0.95,0", "2,corrected,1,1", "3,ignored,,0"),
				finished("doubtful", false, "1,resolved,0.4,0", "2,resolved,0.4,1", "3,lost,,0"),
				BatchOutcome.failed(row("none", false), "There is no such file."),
				finished("lost", false, "1,unresolved,,0", "2,absent,,0")));
		assertEquals(List.of("sure.tif", "finished", "", 2, 0, 0, 1, "18.31 µm", "", "fine."),
			cells(table, 0));
		assertEquals(List.of("doubtful.tif", "finished", "", 1, 1, 1, 1, "18.31 µm", "", "fine."),
			cells(table, 1));
		assertEquals(
			List.of("none.tif", "failed", "", "", "", "", "", "", "", "There is no such file."),
			cells(table, 2));
		assertEquals(OptionalInt.of(1), table.next(-1));
		assertEquals(OptionalInt.of(3), table.next(1));
		assertEquals(OptionalInt.empty(), table.next(3));
		assertTrue(table.summary().startsWith("3 of 4 movies have a result, with 3 frames"),
			table.summary());
		Files.writeString(out.resolve("doubtful/frames.csv"),
			"frame,status,confidence,checked\n1,resolved,0.4,1\n");
		table.refresh(1);
		assertEquals(OptionalInt.of(3), table.next(-1));
	}

	@Test
	void rowsThatAskForWorkByHandAreTheOnesToReview() throws IOException {
		final BatchTable table = new BatchTable(out,
			List.of(finished("doubtful", false, "1,resolved,0.4,0"),
				finished("asked", true, "1,resolved,0.99,0")));
		assertTrue(table.isAnyByHand());
		assertEquals("asked for", table.cell(1, 2));
		assertEquals(OptionalInt.of(1), table.next(-1));
		assertEquals(Optional.of(out.resolve("asked")), table.folder(1));
	}

	@Test
	void tablesOfAnotherVersionTellNothing() throws IOException {
		final BatchOutcome old = finished("old", false);
		Files.writeString(out.resolve("old/frames.csv"), "frame,status\n1,resolved\n");
		final BatchTable table = new BatchTable(out, List.of(old));
		assertEquals("", table.cell(0, 3));
		assertFalse(table.next(-1).isPresent());
	}
}
