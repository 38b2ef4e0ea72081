package io.github.knotresolver.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.IntStream;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import io.github.knotresolver.model.UserException;

/** A result is complete or absent, and nothing of the user's is touched. */
class ResultFolderTest {

	private static final String RESOLVED = "{\"program\": \"KnotResolver\", \"options\": {}}";

	@TempDir
	Path home;
	private Path out;

	@BeforeEach
	void nameTheFolder() throws IOException {
		home = home.toRealPath();
		out = home.resolve("result");
	}

	@Test
	void isAbsentUntilCommittedAndLeavesNothingBeside() throws IOException {
		out = home.resolve("a/b/result");
		try (ResultFolder folder = reserve(false)) {
			fill(folder, "x");
			assertFalse(Files.exists(out));
			folder.commit();
		}
		assertEquals("x", Files.readString(out.resolve(FramesCsv.FILE)));
		assertEquals(List.of("a"), FileTrees.names(home));
		assertEquals(List.of("result"), FileTrees.names(out.getParent()));
	}

	@Test
	void removesEverythingIfNotCommitted() throws IOException {
		try (ResultFolder folder = reserve(false)) {
			fill(folder, "x");
		}
		assertEquals(List.of(), FileTrees.names(home));
	}

	@Test
	void takesAnEmptyFolderAndOneThatOnlyTheDesktopWroteTo() throws IOException {
		Files.createDirectory(out);
		write("new", false);
		assertEquals("new", Files.readString(out.resolve(FramesCsv.FILE)));
		out = Files.createDirectory(home.resolve("seen"));
		Files.writeString(out.resolve(".DS_Store"), "x");
		write("new", false);
		assertEquals(List.of(".DS_Store", FramesCsv.FILE, ParametersJson.FILE),
			FileTrees.names(out));
		assertEquals(List.of("result", "seen"), FileTrees.names(home));
	}

	@Test
	void replacesAnEarlierResultOnlyWhenForced() throws IOException {
		write("old", false);
		Files.writeString(out.resolve("overlay.avi"), "old");
		final String refusal = refusal(false);
		assertTrue(refusal.contains("add force"), refusal);
		assertEquals("old", Files.readString(out.resolve(FramesCsv.FILE)));

		write("new", true);
		assertEquals("new", Files.readString(out.resolve(FramesCsv.FILE)));
		assertEquals(List.of(FramesCsv.FILE, ParametersJson.FILE), FileTrees.names(out));
		assertEquals(List.of("result"), FileTrees.names(home));
	}

	@Test
	void foreignFilesAndFoldersStay() throws IOException {
		write("old", false);
		Files.writeString(out.resolve("corrections.csv"), "drawn by hand");
		Files.writeString(out.resolve("overlay.avi"), "old");
		Files.writeString(out.resolve("tip_angle_spectrum-02.svg"), "old");
		Files.writeString(out.resolve("curvature_kymograph.tif"), "old");
		Files.writeString(out.resolve("control_kymograph.tif"), "of another program");
		Files.writeString(out.resolve("dye_spectrum.png"), "of another program");
		Files.createDirectories(out.resolve("figures/deep"));
		Files.writeString(out.resolve("figures/deep/contours.csv"), "copied");
		write("new", true);
		assertEquals("new", Files.readString(out.resolve(FramesCsv.FILE)));
		assertEquals("drawn by hand", Files.readString(out.resolve("corrections.csv")));
		assertEquals("copied", Files.readString(out.resolve("figures/deep/contours.csv")));
		assertEquals(List.of("control_kymograph.tif", "corrections.csv", "dye_spectrum.png",
			"figures", FramesCsv.FILE, ParametersJson.FILE), FileTrees.names(out));
		assertEquals(List.of("result"), FileTrees.names(home));
	}

	@Test
	void folderWithTheNameOfAFileIsRefused() throws IOException {
		write("old", false);
		Files.createDirectories(out.resolve("overlay.tif/mine"));
		assertTrue(refusal(true).contains("folder named overlay.tif"));
		assertTrue(Files.exists(out.resolve("overlay.tif/mine")));
	}

	@Test
	void neverReplacesWhatIsNotAResult() throws IOException {
		Files.createDirectory(out);
		Files.writeString(out.resolve("thesis.txt"), "years of work");
		assertTrue(refusal(true).contains("not a result"));
		for (final String json : List.of("{\"program\": \"another\", \"options\": {}}",
			"{\"program\": \"KnotResolver\"}", "[]", "{\"program\": {}}", "{", "")) {
			Files.writeString(out.resolve(ParametersJson.FILE), json);
			assertTrue(refusal(true).contains("not a result"), json);
		}
		assertEquals(List.of(ParametersJson.FILE, "thesis.txt"), FileTrees.names(out));
	}

	@ParameterizedTest
	@EnumSource(ResultKind.class)
	void neverReplacesAResultOfAnotherKind(final ResultKind kind) throws IOException {
		write("old", false);
		if (kind == ResultKind.RESOLVED_MOVIE)
			return;
		final String refusal = assertThrows(RuntimeException.class,
			() -> ResultFolder.reserve(out, kind, true, List.of())).getMessage();
		assertTrue(refusal.contains("holds a resolved movie"), refusal);
		assertEquals("old", Files.readString(out.resolve(FramesCsv.FILE)));
	}

	@Test
	void inputIsNeverReplaced() throws IOException {
		write("old", false);
		final Path input = out.resolve(ContoursCsv.FILE);
		Files.writeString(input, "corrections");
		final Path link = Files.createLink(home.resolve("other name"), input);
		for (final Path named : List.of(input, link, out.resolve("../result/contours.csv")))
			assertTrue(refusal(true, named).contains("holds contours.csv, which is read"),
				named.toString());
		assertTrue(refusal(true, out).contains("is the folder that is read"));
		assertTrue(refusal(false, out).contains("is the folder that is read"));
		assertEquals("corrections", Files.readString(input));
		// An input that would not be replaced may lie there.
		final Path movie = Files.writeString(out.resolve("movie.tif"), "pixels");
		try (ResultFolder folder = ResultFolder.reserve(out, ResultKind.RESOLVED_MOVIE, true,
			List.of(movie))) {
			fill(folder, "new");
			folder.commit();
		}
		assertEquals("pixels", Files.readString(movie));
		assertEquals("new", Files.readString(out.resolve(FramesCsv.FILE)));
	}

	@Test
	void whatMakesItImpossibleIsSaidBeforeTheWork() throws IOException {
		final Path file = Files.writeString(home.resolve("file"), "x");
		out = file;
		assertTrue(refusal(true).contains("is a file"));
		out = file.resolve("result");
		assertTrue(refusal(true).contains("is a file"));
		out = home.resolve("long".repeat(70));
		assertTrue(refusal(false).contains("longer than"), refusal(false));
		out = Files.createSymbolicLink(home.resolve("link"), home.resolve("nowhere"));
		assertTrue(refusal(false).contains("the link"), refusal(false));
		out = out.resolve("result");
		assertTrue(refusal(false).contains("the link"), refusal(false));
		out = home.getRoot();
		assertTrue(refusal(false).contains("root"), refusal(false));
		assertEquals(List.of("file", "link"), FileTrees.names(home));
	}

	/** The kernel's folders say that they can be written to, and take no file. */
	@Test
	void folderThatTakesNoFileIsSaidBeforeTheWork() {
		assumeTrue(Files.isDirectory(Path.of("/proc/self")), "There is no /proc here.");
		out = Path.of("/proc/result");
		assertTrue(refusal(false).matches(".*(takes no new file|not writable); choose another.*"),
			refusal(false));
	}

	@Test
	void folderThatIsNotWritableIsSaidBeforeTheWork() throws IOException {
		final Path locked = Files.createDirectory(home.resolve("locked"));
		assumeTrue(locked.toFile().setWritable(false) && !Files.isWritable(locked),
			"This user may write everywhere.");
		out = locked.resolve("result");
		assertTrue(refusal(false).contains("not writable"), refusal(false));
		locked.toFile().setWritable(true);
	}

	@Test
	void linkToAFolderIsFollowed() throws IOException {
		final Path real = Files.createDirectory(home.resolve("real"));
		out = Files.createSymbolicLink(home.resolve("link"), real);
		write("old", false);
		write("new", true);
		assertTrue(Files.isSymbolicLink(out));
		assertEquals("new", Files.readString(real.resolve(FramesCsv.FILE)));
		assertEquals(List.of("link", "real"), FileTrees.names(home));
	}

	@Test
	void longNamesAreFine() throws IOException {
		out = home.resolve("é".repeat(120));
		write("old", false);
		write("new", true);
		assertEquals(1, FileTrees.names(home).size());
	}

	@Test
	void keepsTheEarlierResultIfTheNewOneFails() throws IOException {
		write("old", false);
		try (ResultFolder folder = reserve(true)) {
			fill(folder, "half");
		}
		assertEquals("old", Files.readString(out.resolve(FramesCsv.FILE)));
		assertEquals(List.of("result"), FileTrees.names(home));
	}

	@Test
	void secondRunIntoTheSameFolderIsRefused() throws IOException {
		try (ResultFolder first = reserve(false)) {
			assertTrue(refusal(false).contains("another run"), refusal(false));
			assertTrue(refusal(true).contains("another run"), refusal(true));
			fill(first, "first");
			first.commit();
		}
		write("second", true);
		assertEquals("second", Files.readString(out.resolve(FramesCsv.FILE)));
	}

	@Test
	void whatOnlyHasTheNameOfALockIsLeftAlone() throws IOException {
		final Path lock = Files.writeString(home.resolve(".result.lock"), "of another program");
		assertTrue(refusal(true).contains(lock.toString()), refusal(true));
		assertEquals("of another program", Files.readString(lock));
		final Path precious = Files.move(lock, home.resolve("precious"));
		Files.createSymbolicLink(lock, precious);
		assertTrue(refusal(true).contains(lock.toString()), refusal(true));
		assertEquals("of another program", Files.readString(precious));
	}

	@Test
	void ofManyRunsAtOnceOneWins() throws IOException {
		final AtomicInteger winners = new AtomicInteger();
		IntStream.range(0, 16).parallel().forEach(i -> {
			try (ResultFolder folder = reserve(false)) {
				fill(folder, "run " + i);
				folder.commit();
				winners.incrementAndGet();
			} catch (final IOException | UserException e) {
				assertFalse(e instanceof IOException, e.toString());
			}
		});
		assertEquals(1, winners.get());
		assertEquals(List.of("result"), FileTrees.names(home));
	}

	@Test
	void commitRefusesWhatHasAppearedMeanwhile() throws IOException {
		try (ResultFolder folder = reserve(false)) {
			fill(folder, "mine");
			Files.createDirectory(out);
			Files.writeString(out.resolve("yours.txt"), "yours");
			assertThrows(IOException.class, folder::commit);
		}
		assertEquals(List.of("yours.txt"), FileTrees.names(out));
		assertEquals(List.of("result"), FileTrees.names(home));
	}

	@Test
	void fileWithoutAnAgreedNameIsABug() throws IOException {
		try (ResultFolder folder = reserve(false)) {
			fill(folder, "x");
			Files.writeString(folder.path().resolve("surprise.txt"), "x");
			assertThrows(IllegalStateException.class, folder::commit);
		}
	}

	@Test
	void leftoversOfADeadRunAreCleared() throws IOException {
		final Path dead = Files.createDirectory(home.resolve(".result.partial-1-abc"));
		Files.writeString(dead.resolve("half.csv"), "x");
		Files.writeString(home.resolve(".result.lock"), "");
		final Path other = Files.createDirectory(home.resolve(".results.partial-1-abc"));
		final Path mine = Files.createDirectory(home.resolve(".result.partial-mine"));
		write("new", false);
		assertEquals(
			List.of(other.getFileName().toString(), mine.getFileName().toString(), "result")
				.stream().sorted().toList(),
			FileTrees.names(home));
	}

	/** A batch clears its folder while another run writes a result there. */
	@Test
	void nothingOfALiveRunIsCleared() throws IOException {
		final Path dead = Files.createDirectory(home.resolve(".gone.partial-1-abc"));
		try (ResultFolder alive = reserve(false)) {
			fill(alive, "new");
			Leftovers.clearAll(home);
			assertTrue(Files.exists(alive.path().resolve(FramesCsv.FILE)));
			alive.commit();
		}
		assertFalse(Files.exists(dead));
		assertEquals(List.of("result"), FileTrees.names(home));
	}

	@Test
	void earlierResultThatADeadRunMovedAwayComesBack() throws IOException {
		write("old", false);
		Files.move(out, home.resolve(".result.old-1-abc"));
		Files.createDirectory(home.resolve(".result.partial-1-abd"));
		assertTrue(refusal(false).contains("add force"));
		assertEquals("old", Files.readString(out.resolve(FramesCsv.FILE)));
		assertEquals(List.of("result"), FileTrees.names(home));
	}

	@Test
	void earlierResultThatADeadRunReplacedGoes() throws IOException {
		final Path wanted = out;
		write("new", false);
		out = home.resolve("other");
		write("old", false);
		Files.move(out, home.resolve(".result.old-1-abc"));
		out = wanted;
		assertTrue(refusal(false).contains("add force"));
		assertEquals("new", Files.readString(out.resolve(FramesCsv.FILE)));
		assertEquals(List.of("result"), FileTrees.names(home));
	}

	/** Stops after every step of a replacement among foreign files; the next run does the rest. */
	@Test
	void replacementThatADeadRunBeganIsFinished() throws IOException {
		for (int steps = 0; steps < 6; steps++) {
			out = Files.createDirectory(home.resolve("result" + steps));
			write("old", false);
			Files.writeString(out.resolve("mine.txt"), "mine");
			Files.writeString(out.resolve(SummaryCsv.FILE), "old");
			final Path commit = Files
				.createDirectory(home.resolve("." + out.getFileName() + ".commit-1-abc"));
			Files.writeString(commit.resolve(ParametersJson.FILE), RESOLVED);
			Files.writeString(commit.resolve(FramesCsv.FILE), "new");
			final Path list = Files.write(commit.resolve(".to-delete"),
				List.of(FramesCsv.FILE, ParametersJson.FILE, SummaryCsv.FILE));
			if (steps > 0)
				Files.delete(out.resolve(ParametersJson.FILE));
			if (steps > 1)
				Files.delete(out.resolve(FramesCsv.FILE));
			if (steps > 2)
				Files.delete(out.resolve(SummaryCsv.FILE));
			if (steps > 3)
				Files.delete(list);
			if (steps > 4)
				Files.move(commit.resolve(FramesCsv.FILE), out.resolve(FramesCsv.FILE));
			assertTrue(refusal(false).contains("add force"), "step " + steps);
			assertEquals("new", Files.readString(out.resolve(FramesCsv.FILE)), "step " + steps);
			assertEquals(List.of(FramesCsv.FILE, "mine.txt", ParametersJson.FILE),
				FileTrees.names(out), "step " + steps);
			assertFalse(Files.exists(commit), "step " + steps);
		}
	}

	private void write(final String text, final boolean force) throws IOException {
		try (ResultFolder folder = reserve(force)) {
			fill(folder, text);
			folder.commit();
		}
	}

	private ResultFolder reserve(final boolean force) throws IOException {
		return ResultFolder.reserve(out, ResultKind.RESOLVED_MOVIE, force, List.of());
	}

	private static void fill(final ResultFolder folder, final String text) throws IOException {
		Files.writeString(folder.path().resolve(ParametersJson.FILE), RESOLVED);
		Files.writeString(folder.path().resolve(FramesCsv.FILE), text);
	}

	private String refusal(final boolean force, final Path... inputs) {
		return assertThrows(UserException.class, () -> ResultFolder
			.reserve(out, ResultKind.RESOLVED_MOVIE, force, List.of(inputs)).close()).getMessage();
	}
}
