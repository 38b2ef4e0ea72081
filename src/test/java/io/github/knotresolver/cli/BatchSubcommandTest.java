package io.github.knotresolver.cli;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Stream;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import io.github.knotresolver.imagej.TestImages;
import io.github.knotresolver.progress.CancelledException;
import io.github.knotresolver.progress.Progress;

/** A sheet or a folder of movies on the command line. */
class BatchSubcommandTest {

	@TempDir
	Path home;
	private Path out;
	private final AtomicInteger resolved = new AtomicInteger();
	private final StringWriter stdout = new StringWriter(), stderr = new StringWriter();

	@BeforeEach
	void saveMovies() throws IOException {
		out = home.resolve("out");
		Files.createDirectories(home.resolve("in/more"));
		TestImages.save(TestImages.movie(4, 8), home.resolve("in/a.tif"));
		TestImages.save(TestImages.movie(4, 16), home.resolve("in/b.tif"));
		TestImages.save(TestImages.movie(5, 8), home.resolve("in/more/a.tif"));
	}

	@Test
	void oneBadRowIsReportedTheRestGoOnAndFinishedRowsAreSkipped() throws IOException {
		final Path sheet = sheet("FileName,FolderPath,segThresh,remark", "a.tif,in,0.4,x",
			"b.tif,in,1.5,", "absent.tif,in,,", "a.tif,in/more,,");
		assertEquals(1, run(sheet, "--no-plots"));
		assertEquals(2, resolved.get());
		assertTrue(Files.exists(out.resolve("a/contours.csv")));
		assertTrue(Files.exists(out.resolve("a-2/contours.csv")));
		assertFalse(Files.exists(out.resolve("b")));
		assertTrue(stderr.toString().contains("b.tif: failed. threshold must be"),
			stderr.toString());
		assertTrue(stderr.toString().contains("absent.tif: failed. There is no file"),
			stderr.toString());
		assertTrue(stderr.toString().contains("Columns that mean nothing here: remark."));
		assertTrue(stdout.toString().contains("2 of 4 movies have a result."), stdout.toString());
		final List<String> list = Files.readAllLines(out.resolve("batch.csv"));
		assertEquals("line,movie,status,result,message", list.get(0));
		assertTrue(list.get(1).startsWith("2,") && list.get(1).contains(",finished,a,"));
		assertTrue(list.get(2).contains(",failed,,"), list.get(2));

		assertEquals(1, run(sheet, "--no-plots"));
		assertEquals(2, resolved.get());
		assertTrue(stdout.toString().contains(
			"a.tif: skipped. The same movie was resolved with these options before, in folder a-2;"),
			stdout.toString());
		assertEquals(1, run(sheet, "--no-plots", "--force"));
		assertEquals(4, resolved.get());
	}

	@Test
	void folderIsResolvedWithTheOptionsOfTheCommandLine() throws IOException {
		assertEquals(0, run(home.resolve("in"), "--no-plots", "--threshold", "0.3"));
		assertEquals(2, resolved.get());
		assertTrue(
			Files.readString(out.resolve("b/parameters.json")).contains("\"threshold\": 0.3"));
	}

	@Test
	void rowsOwnOptionsGoOverTheCommandLines() throws IOException {
		assertEquals(0, run(sheet("FileName,FolderPath,threshold", "a.tif,in,0.6", "b.tif,in,"),
			"--no-plots", "--threshold", "0.3"));
		assertTrue(
			Files.readString(out.resolve("a/parameters.json")).contains("\"threshold\": 0.6"));
		assertTrue(
			Files.readString(out.resolve("b/parameters.json")).contains("\"threshold\": 0.3"));
	}

	@Test
	void wrongUsageIsStatusTwo() throws IOException {
		assertEquals(2, run(home.resolve("absent.csv")));
		assertEquals(2, run(sheet("Name,Place", "a.tif,in")));
		assertEquals(2, run(Files.createDirectory(home.resolve("empty"))));
		assertTrue(stderr.toString().contains("has no movie"), stderr.toString());
		assertEquals(2, run(home.resolve("in"), "--threshold", "2"));
		out = Files.writeString(home.resolve("file"), "x");
		assertEquals(2, run(home.resolve("in")));
		assertEquals(0, resolved.get());
	}

	@Test
	void oddNameOfCorrectionsSpoilsItsRowOnly() throws IOException {
		assertEquals(1,
			run(sheet("FileName,FolderPath,corrections", "a.tif,in,x\0y", "b.tif,in,")));
		assertEquals(List.of("", "b"), results());
		assertTrue(stderr.toString().contains("corrections must be the name of a file, but is"),
			stderr.toString());
	}

	/** A row that hits a bug says so and names the log; the others go on. */
	@Test
	void bugInOneRowLeavesASentenceAndTheRestGoesOn() throws IOException {
		final Path sheet = sheet("FileName,FolderPath", "a.tif,in", "b.tif,in", "a.tif,in/more");
		final RuntimeException[] bugs = {new IllegalArgumentException("index 7\nof 5"),
			new NullPointerException()};
		assertEquals(1, KnotResolverMain.run((movie, parameters, p) -> {
			if (movie.size() == 4)
				throw bugs[movie.name().startsWith("a") ? 0 : 1];
			return TestImages.resolve(movie, parameters, p);
		}, Progress.NONE, new PrintWriter(stdout), new PrintWriter(stderr), "batch",
			sheet.toString(), "--out", out.toString(), "--no-plots"));
		assertEquals(List.of("", "", "a-2"), results());
		final List<String> list = Files.readAllLines(out.resolve("batch.csv"));
		assertTrue(list.get(1).contains("This is a bug in KnotResolver")
			&& list.get(1).contains("IllegalArgumentException: index 7 of 5"), list.get(1));
		for (int row = 1; row <= 2; row++) {
			final Path log = Path.of(list.get(row).replaceFirst(".*attach (.*?), which.*", "$1"));
			assertTrue(Files.readString(log).contains(bugs[row - 1].getClass().getName()));
		}
		assertEquals(List.of("a-2", "batch.csv", "batch.html"), names(out));
	}

	@Test
	void cancelKeepsWhatIsFinished() throws IOException {
		// One at a time, so that the second has not begun when the first has ended.
		final Progress progress = new Progress() {

			@Override
			public void report(final String stage, final double fraction) {
			}

			@Override
			public boolean isCancelled() {
				return resolved.get() == 2;
			}
		};
		assertEquals(130, run(progress, home.resolve("in"), "--no-plots", "--movies", "1"));
		assertTrue(Files.exists(out.resolve("a/contours.csv")));
		assertFalse(Files.exists(out.resolve("b")));
		assertEquals(2, Files.readAllLines(out.resolve("batch.csv")).size());
	}

	@Test
	void rowIsKnownAgainByItsMovieAndNotByItsPlace() throws IOException {
		assertEquals(0, run(sheet("FileName,FolderPath", "a.tif,in", "a.tif,in/more")));
		assertEquals(2, resolved.get());
		assertEquals(List.of("a", "a-2"), results());
		assertEquals(0, run(sheet("FileName,FolderPath", "a.tif,in/more", "a.tif,in")));
		assertEquals(2, resolved.get());
		assertEquals(List.of("a-2", "a"), results());
		// Another movie of the same name gets a folder of its own.
		Files.createDirectory(home.resolve("in/third"));
		TestImages.save(TestImages.movie(6, 8), home.resolve("in/third/a.tif"));
		assertEquals(0, run(sheet("FileName,FolderPath", "a.tif,in/third")));
		assertEquals(List.of("a-3"), results());
		assertEquals(0,
			run(sheet("FileName,FolderPath", "a.tif,in/third", "a.tif,in", "a.tif,in/more")));
		assertEquals(List.of("a-3", "a", "a-2"), results());
		assertEquals(3, resolved.get());
	}

	@Test
	void otherContentsOrOptionsAreAnotherRun() throws IOException {
		final Path sheet = sheet("FileName,FolderPath", "a.tif,in");
		assertEquals(0, run(sheet));
		assertEquals(0, run(sheet, "--threads", "1", "--iterations", "10", "--threshold", "OTSU"));
		assertEquals(1, resolved.get());
		assertEquals(1, run(sheet, "--threshold", "0.3"));
		assertTrue(stderr.toString().contains("already holds a result"), stderr.toString());
		assertFalse(Files.readString(out.resolve("a/parameters.json")).contains("0.3"));
		assertEquals(0, run(sheet, "--threshold", "0.3", "--force"));
		assertTrue(Files.readString(out.resolve("a/parameters.json")).contains("0.3"));
		assertEquals(2, resolved.get());
		TestImages.save(TestImages.movie(6, 8), home.resolve("in/a.tif"));
		assertEquals(1, run(sheet, "--threshold", "0.3"));
		assertEquals(0, run(sheet, "--threshold", "0.3", "--force"));
		assertEquals(7, Files.readAllLines(out.resolve("a/frames.csv")).size());
		assertEquals(List.of("a"), results());
	}

	@Test
	void oddNamesStayInTheFolderAndStopNothing() throws IOException {
		for (final String name : List.of("..tif", "...tif", ".tif", "batch.csv.tif", "A.tif"))
			Files.copy(home.resolve("in/a.tif"), home.resolve("in").resolve(name));
		final Path sheet = sheet("FileName,FolderPath", "..tif,in", "...tif,in", ".tif,in",
			"batch.csv.tif,in", "a.tif,in", "A.tif,in", "a\0.tif,in", "/,in", ",in", "..,in");
		assertEquals(1, run(sheet, "--no-plots"));
		assertEquals(
			List.of("movie", "movie-2", "movie-3", "batch.csv-2", "a", "A-2", "", "", "", ""),
			results());
		assertEquals(List.of("in", "out", "sheet.csv"), names(home));
		assertEquals(List.of("A-2", "a", "batch.csv", "batch.csv-2", "batch.html", "movie",
			"movie-2", "movie-3"), names(out));
		assertTrue(stderr.toString().contains("cannot be the name of a file"), stderr.toString());
		assertFalse((Files.readString(out.resolve("batch.csv")) + stderr).contains("\0"));
		assertEquals(1, run(sheet, "--no-plots"));
		assertEquals(6, resolved.get());
	}

	@Test
	void sheetAndForeignListAreNeverOverwritten() throws IOException {
		out = Files.createDirectory(home.resolve("out"));
		final Path sheet = Files.write(out.resolve("batch.csv"),
			List.of("FileName,FolderPath", "a.tif,../in"));
		for (final String[] options : new String[][]{{}, {"--force"}}) {
			assertEquals(2, run(sheet, options));
			assertEquals(2, run(home.resolve("in"), options));
		}
		assertTrue(stderr.toString().contains("holds batch.csv, which is read"));
		assertTrue(stderr.toString().contains("is not a list of this program"));
		assertEquals(2, Files.readAllLines(sheet).size());
		assertEquals(List.of("batch.csv"), names(out));
	}

	@Test
	void foreignPageIsNeverOverwrittenAndOursIs() throws IOException {
		Files.createDirectory(out);
		final Path page = Files.writeString(out.resolve("batch.html"), "<html>mine</html>");
		assertEquals(2, run(home.resolve("in"), "--force"));
		assertTrue(stderr.toString().contains("holds a batch.html that is not"), stderr.toString());
		assertEquals("<html>mine</html>", Files.readString(page));
		Files.delete(page);
		assertEquals(0, run(home.resolve("in")));
		final String first = Files.readString(page);
		assertEquals(0, run(home.resolve("in")));
		assertTrue(Files.readString(page).contains("skipped"));
		assertFalse(first.contains("skipped"));
		assertEquals(2, run(home.resolve("in"), "--movies", "0"));
		assertTrue(stderr.toString().contains("--movies must be at least 1"), stderr.toString());
	}

	@Test
	void partsOfASheetTogetherMakeWhatOneProcessMakes() throws IOException {
		final Path sheet = sheet("FileName,FolderPath", "a.tif,in/more", "absent.tif,in",
			"b.tif,in", "a.tif,in");
		assertEquals(1, run(sheet, "--no-plots"));
		final Path whole = Files.move(out, home.resolve("whole"));
		resolved.set(0);
		assertEquals(0, run(sheet, "--no-plots", "--rows", "3-4"));
		assertEquals(2, resolved.get());
		assertEquals(List.of("a-2", "b", "batch-rows"), names(out));
		assertEquals(List.of("3-4.csv"), names(out.resolve("batch-rows")));
		assertEquals(1, run(sheet, "--no-plots", "--rows", "1-2"));
		assertEquals(0, run(sheet, "--no-plots", "--rows", "4"));
		assertEquals(3, resolved.get());
		assertEquals(1, run(sheet, "--collect"));
		assertEquals(3, resolved.get());
		for (final String name : List.of("a/contours.csv", "a-2/contours.csv", "b/frames.csv",
			"a-2/parameters.json"))
			assertEquals(-1, Files.mismatch(whole.resolve(name), out.resolve(name)), name);
		// The list of 4-4 came after that of 3-4, and says that it had nothing to do.
		final String list = Files.readString(out.resolve("batch.csv"))
			.replaceAll("4,(.*),skipped,a-2,.*", "4,$1,finished,a-2,");
		assertEquals(5, list.lines().count());
		assertTrue(list.contains("There is no file"), list);
		assertTrue(Files.readString(out.resolve("batch.html")).contains("3 of 4 movies"));
		assertEquals(2, run(sheet, "--rows", "4-5"));
		assertTrue(stderr.toString().contains("--rows must be from 1 to 4"), stderr.toString());
		assertEquals(2, run(sheet, "--rows", "0"));
		assertEquals(2, run(sheet, "--rows", "1", "--collect"));
	}

	@Test
	void collectSaysWhatIsMissingAndPlanReadsNoPixels() throws IOException {
		final Path sheet = sheet("FileName,FolderPath", "a.tif,in", "b.tif,in");
		assertEquals(0, run(sheet, "--plan"));
		assertFalse(Files.exists(out));
		final List<String> plan = stdout.toString().lines().toList();
		assertEquals("row,megabytes,movie", plan.get(0));
		assertTrue(plan.get(1).matches("1,65,\".*a.tif\""), plan.get(1));
		assertEquals(1, run(sheet, "--collect"));
		assertTrue(stderr.toString().contains("a.tif: failed. There is no result"),
			stderr.toString());
		assertEquals(0, resolved.get());
	}

	@Test
	void movieInsideAResultFolderIsNotReplaced() throws IOException {
		assertEquals(0, run(sheet("FileName,FolderPath", "a.tif,in")));
		final byte[] overlay = Files.readAllBytes(out.resolve("a/overlay.tif"));
		assertEquals(1,
			run(sheet("FileName,FolderPath", "a.tif,in", "overlay.tif,out/a"), "--force"));
		assertTrue(stderr.toString().contains("holds overlay.tif, which is read"),
			stderr.toString());
		assertArrayEquals(overlay, Files.readAllBytes(out.resolve("a/overlay.tif")));
	}

	@Test
	void leftoversOfADeadBatchAreCleared() throws IOException {
		final Path dead = Files.createDirectories(out.resolve(".gone.partial-1-abc"));
		Files.writeString(dead.resolve("half.csv"), "x");
		assertEquals(0, run(sheet("FileName,FolderPath", "a.tif,in")));
		assertEquals(List.of("a", "batch.csv", "batch.html"), names(out));
	}

	/** The result column of the list. */
	private List<String> results() throws IOException {
		final List<String> lines = Files.readAllLines(out.resolve("batch.csv"));
		return lines.subList(1, lines.size()).stream()
			.map(l -> l.replaceFirst(".*,(finished|skipped|failed),([^,]*),.*", "$2")).toList();
	}

	private static List<String> names(final Path folder) throws IOException {
		try (Stream<Path> files = Files.list(folder)) {
			return files.map(f -> f.getFileName().toString()).sorted().toList();
		}
	}

	private Path sheet(final String... lines) throws IOException {
		return Files.write(home.resolve("sheet.csv"), List.of(lines));
	}

	private int run(final Path input, final String... options) {
		return run(Progress.NONE, input, options);
	}

	private int run(final Progress progress, final Path input, final String... options) {
		final List<String> args = new ArrayList<>(
			List.of("batch", input.toString(), "--out", out.toString()));
		args.addAll(List.of(options));
		return KnotResolverMain.run((movie, parameters, p) -> {
			if (p.isCancelled())
				throw new CancelledException();
			resolved.incrementAndGet();
			p.checkCancelled();
			return TestImages.resolve(movie, parameters, p);
		}, progress, new PrintWriter(stdout), new PrintWriter(stderr), args.toArray(String[]::new));
	}
}
