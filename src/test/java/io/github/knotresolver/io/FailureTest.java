
package io.github.knotresolver.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;

import org.apache.commons.math3.exception.MaxCountExceededException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import io.github.knotresolver.model.UserException;
import io.github.knotresolver.progress.CancelledException;

/** What a person is told when work ends early, and where the trace of a bug is kept. */
class FailureTest {

	private static final String MEMORY = "give Java more";

	@TempDir
	Path folder;

	@Test
	void whatAUserCanMendIsToldAsItIs() throws IOException {
		final Failure failure = failure(new UserException("threshold must be below 1,\nbut is 2."));
		assertEquals(new Failure(Failure.Kind.USER, "threshold must be below 1, but is 2."),
			failure);
		assertEquals(List.of(), files());
	}

	@Test
	void everythingElseIsABugWithItsTraceInAFileThatTheSentenceNames() throws IOException {
		for (final Throwable bug : List.of(new IllegalArgumentException("The radius is 0."),
			new MaxCountExceededException(120), new NullPointerException(),
			new UnsupportedOperationException("JsonObject"), new StackOverflowError(),
			new AssertionError("never"))) {
			final Failure failure = failure(bug);
			assertEquals(Failure.Kind.BUG, failure.kind());
			assertEquals(1, failure.sentence().lines().count());
			assertTrue(failure.sentence().contains("bug"), failure.sentence());
			assertTrue(failure.sentence().contains(bug.getClass().getSimpleName()),
				failure.sentence());
			final Path log = files().get(0);
			assertTrue(failure.sentence().contains(log.toString()), failure.sentence());
			final String text = Files.readString(log);
			assertTrue(text.startsWith("KnotResolver "), text);
			assertTrue(text.contains("at " + FailureTest.class.getName()), text);
			assertTrue(text.contains(bug.toString()), text);
			Files.delete(log);
		}
	}

	@Test
	void allBugsOfAProcessAreInOneFile() throws IOException {
		final FailureLog log = new FailureLog(folder);
		Failure.of(new IllegalStateException("first"), MEMORY, log);
		Failure.of(new IllegalStateException("second"), MEMORY, log);
		assertEquals(1, files().size());
		final String text = Files.readString(files().get(0));
		assertTrue(text.contains("first") && text.contains("second"), text);
	}

	@Test
	void aLogThatCannotBeWrittenIsNotNamed() {
		final String sentence = Failure
			.of(new IllegalStateException("x"), MEMORY, new FailureLog(folder.resolve("absent")))
			.sentence();
		assertFalse(sentence.contains("absent"), sentence);
		assertTrue(sentence.contains("no log could be written"), sentence);
	}

	@Test
	void tracesAreShownToWhoAsks() {
		final FailureLog log = new FailureLog(folder);
		final List<String> shown = new ArrayList<>();
		log.echo(shown::add);
		Failure.of(new UserException("No filament."), MEMORY, log);
		Failure.of(new IllegalStateException("broken"), MEMORY, log);
		assertEquals(2, shown.size());
		assertTrue(shown.get(0).contains("UserException: No filament."), shown.get(0));
		assertTrue(shown.get(1).contains("at " + FailureTest.class.getName()), shown.get(1));
	}

	@Test
	void cancelIsNoFailure() {
		assertEquals(Failure.Kind.CANCELLED, failure(new CancelledException()).kind());
	}

	@Test
	void tooLittleMemoryComesWithAdvice() {
		final Failure failure = failure(new OutOfMemoryError("Java heap space"));
		assertEquals(Failure.Kind.MEMORY, failure.kind());
		assertTrue(failure.sentence().endsWith("; give Java more."), failure.sentence());
	}

	/** Java's own messages are often a path and nothing else. */
	@Test
	void failuresOfTheDiskSayWhatIsWrong() {
		assertEquals("The result could not be written: No space left on device.",
			failure(new IOException("No space left on device")).sentence());
		assertEquals(
			"The result could not be written: /a may not be written; check its permissions.",
			failure(new AccessDeniedException("/a")).sentence());
		assertEquals("The result could not be written: /a is not there any more.",
			failure(new UncheckedIOException(new NoSuchFileException("/a"))).sentence());
		assertEquals("The result could not be written: the disk refused it (IOException).",
			failure(new IOException()).sentence());
	}

	private Failure failure(final Throwable cause) {
		return Failure.of(cause, MEMORY, new FailureLog(folder));
	}

	private List<Path> files() throws IOException {
		try (Stream<Path> files = Files.list(folder)) {
			return files.toList();
		}
	}
}
