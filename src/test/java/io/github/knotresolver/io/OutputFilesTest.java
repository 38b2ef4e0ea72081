package io.github.knotresolver.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import io.github.knotresolver.model.UserException;

class OutputFilesTest {

	@TempDir
	Path home;

	@Test
	void filesAreAbsentUntilCommittedAndLeaveNothingBeside() throws IOException {
		try (OutputFiles files = reserve("a.csv", false)) {
			Files.writeString(files.path().resolve("a.csv"), "ours");
			Files.writeString(files.path().resolve("a.png"), "ours");
			assertEquals(List.of(), names());
			files.commit("a.csv");
		}
		assertEquals(List.of("a.csv", "a.png"), names());
		Files.delete(home.resolve("a.png"));
		try (OutputFiles files = reserve("b.csv", false)) {
			Files.writeString(files.path().resolve("b.csv"), "half");
		}
		assertEquals(List.of("a.csv"), FileTrees.names(home));
	}

	@Test
	void nothingIsOverwrittenUnasked() throws IOException {
		final Path file = Files.writeString(home.resolve("a.csv"), "ours");
		assertTrue(refusal("a.csv", false).contains("add force"));
		reserve("a.csv", true).close();
		assertTrue(refusal("a.csv", true, file).contains("is a file that is read"));
		Files.writeString(file, "theirs");
		assertTrue(refusal("a.csv", true).contains("not written by this program"));
		Files.delete(file);
		Files.writeString(home.resolve("a.png"), "x");
		assertTrue(refusal("a.csv", false).contains("a.png"));
		assertEquals("x", Files.readString(home.resolve("a.png")));
	}

	@Test
	void whatMakesItImpossibleIsSaidBeforeTheWork() throws IOException {
		Files.createDirectory(home.resolve("folder"));
		assertTrue(refusal("folder", true).contains("cannot be written"));
		assertTrue(refusal("absent/a.csv", true).contains("cannot be written"));
		assertTrue(refusal("x".repeat(300), true).contains("longer than"));
		Files.createSymbolicLink(home.resolve("link"), home.resolve("nowhere"));
		assertTrue(refusal("link", true).contains("not written by this program"));
	}

	private OutputFiles reserve(final String name, final boolean force, final Path... inputs)
		throws IOException {
		return OutputFiles.reserve(home.resolve(name), List.of("a.png"), OutputFilesTest::isOurs,
			force, List.of(inputs));
	}

	private static boolean isOurs(final Path file) {
		try {
			return Files.readString(file).equals("ours");
		} catch (final IOException e) {
			throw new IllegalStateException(e);
		}
	}

	private String refusal(final String name, final boolean force, final Path... inputs) {
		return assertThrows(UserException.class, () -> reserve(name, force, inputs).close())
			.getMessage();
	}

	private List<String> names() throws IOException {
		return FileTrees.names(home).stream().filter(n -> !n.startsWith(".")).toList();
	}
}
