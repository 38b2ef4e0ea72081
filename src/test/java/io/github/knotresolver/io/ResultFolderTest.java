
package io.github.knotresolver.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import io.github.knotresolver.model.UserException;

class ResultFolderTest {

	@TempDir
	Path home;

	@Test
	void isAbsentUntilCommittedAndLeavesNothingBeside() throws IOException {
		final Path out = home.resolve("a/b/result");
		try (ResultFolder folder = ResultFolder.prepare(out, false)) {
			Files.writeString(folder.path().resolve("x.txt"), "x");
			assertFalse(Files.exists(out));
			folder.commit();
		}
		assertEquals("x", Files.readString(out.resolve("x.txt")));
		assertEquals(List.of("a"), names(home));
		assertEquals(List.of("result"), names(out.getParent()));
	}

	@Test
	void removesEverythingIfNotCommitted() throws IOException {
		try (ResultFolder folder = ResultFolder.prepare(home.resolve("result"), false)) {
			Files.createDirectories(folder.path().resolve("deep/deeper"));
			Files.writeString(folder.path().resolve("deep/deeper/x.txt"), "x");
		}
		assertEquals(List.of(), names(home));
	}

	@Test
	void takesAnEmptyFolder() throws IOException {
		final Path out = Files.createDirectory(home.resolve("result"));
		write(out, "new", false);
		assertEquals("new", Files.readString(out.resolve(FramesCsv.FILE)));
		assertEquals(List.of("result"), names(home));
	}

	@Test
	void replacesAnEarlierResultOnlyWhenForced() throws IOException {
		final Path out = home.resolve("result");
		write(out, "old", false);
		Files.writeString(out.resolve("stale.txt"), "old");
		final String refusal = refusal(out, false);
		assertTrue(refusal.contains("--force"), refusal);
		assertEquals("old", Files.readString(out.resolve(FramesCsv.FILE)));

		write(out, "new", true);
		assertEquals("new", Files.readString(out.resolve(FramesCsv.FILE)));
		assertFalse(Files.exists(out.resolve("stale.txt")));
		assertEquals(List.of("result"), names(home));
	}

	@Test
	void neverReplacesWhatIsNotAResult() throws IOException {
		final Path out = Files.createDirectory(home.resolve("documents"));
		Files.writeString(out.resolve("thesis.txt"), "years of work");
		Files.writeString(out.resolve(ParametersJson.FILE), "{\"program\": \"another\"}");
		assertTrue(refusal(out, true).contains("not a result"));
		assertEquals(List.of(ParametersJson.FILE, "thesis.txt"), names(out));
	}

	@Test
	void refusesAFileAndAFolderInsideAFile() throws IOException {
		final Path file = Files.writeString(home.resolve("file"), "x");
		assertTrue(refusal(file, true).contains("is a file"));
		assertTrue(refusal(file.resolve("result"), true).contains("is a file"));
	}

	@Test
	void keepsTheEarlierResultIfTheNewOneFails() throws IOException {
		final Path out = home.resolve("result");
		write(out, "old", false);
		try (ResultFolder folder = ResultFolder.prepare(out, true)) {
			Files.writeString(folder.path().resolve(FramesCsv.FILE), "half");
		}
		assertEquals("old", Files.readString(out.resolve(FramesCsv.FILE)));
		assertEquals(List.of("result"), names(home));
	}

	private static void write(final Path out, final String text, final boolean force)
		throws IOException {
		try (ResultFolder folder = ResultFolder.prepare(out, force)) {
			Files.writeString(folder.path().resolve(ParametersJson.FILE),
				"{\"program\": \"KnotResolver\"}");
			Files.writeString(folder.path().resolve(FramesCsv.FILE), text);
			folder.commit();
		}
	}

	private static String refusal(final Path out, final boolean force) {
		return assertThrows(UserException.class, () -> ResultFolder.prepare(out, force))
			.getMessage();
	}

	private static List<String> names(final Path folder) throws IOException {
		try (Stream<Path> files = Files.list(folder)) {
			return files.map(f -> f.getFileName().toString()).sorted().toList();
		}
	}
}
