package io.github.knotresolver.ui;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import ij.ImagePlus;
import io.github.knotresolver.imagej.FolderSink;
import io.github.knotresolver.imagej.ImageFile;
import io.github.knotresolver.imagej.ImageSource;
import io.github.knotresolver.imagej.SampleMovie;
import io.github.knotresolver.imagej.TestImages;
import io.github.knotresolver.io.CorrectionsCsv;
import io.github.knotresolver.io.ResultFolder;
import io.github.knotresolver.io.ResultKind;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.run.ResolveRun;
import io.github.knotresolver.run.ResultSink;
import io.github.knotresolver.session.Engine;

/** What a review reads from a result folder and writes into it, without a window. */
class ReviewedResultTest {

	@TempDir
	Path home;
	private Path movie, result;

	@BeforeEach
	void resolve() throws IOException {
		movie = TestImages.save(SampleMovie.open(), home.resolve("movie.tif"));
		result = home.resolve("a result");
		run(Map.of(), result);
	}

	private void run(final Map<String, String> more, final Path out) throws IOException {
		final Map<String, String> texts = new HashMap<>(Map.of("frames", "1-5", "threads", "2"));
		texts.putAll(more);
		final ImageSource source = ImageSource.of(movie);
		final ResolveRun run = ResolveRun.of(texts);
		try (ResultFolder folder = ResultFolder.reserve(out, ResultKind.RESOLVED_MOVIE, false,
			run.files(source))) {
			run.read(source, Progress.NONE).resolve(Engine.PIPELINE,
				new FolderSink(folder, source, false), Progress.NONE);
		}
	}

	@Test
	void whatIsSavedIsWhatARunWithTheFileGives() throws Exception {
		final byte[] before = Files.readAllBytes(result.resolve("contours.csv"));
		try (ReviewedResult review = ReviewedResult.open(result, Progress.NONE)) {
			review.save(Progress.NONE);
			assertFalse(Files.exists(result.resolve(CorrectionsCsv.FILE)));
			assertArrayEquals(before, Files.readAllBytes(result.resolve("contours.csv")));
			review.model().goTo(3);
			review.model().refuse();
			assertTrue(review.isChanged());
			review.save(Progress.NONE);
			assertFalse(review.isChanged());
			assertEquals(review.model().said(),
				CorrectionsCsv.read(result.resolve(CorrectionsCsv.FILE)));
			assertEquals("run(\"Resolve Filament...\", \"movie=[" + movie
				+ "] frames=1-5 corrections=[" + result.resolve(CorrectionsCsv.FILE) + "] out=["
				+ result + "] plots=false force\");", review.macroLine());
		}
		final Path again = home.resolve("again");
		run(Map.of("corrections", result.resolve(CorrectionsCsv.FILE).toString()), again);
		for (final String file : List.of("contours.csv", "frames.csv", "filaments.csv",
			"summary.csv", "RoiSet.zip"))
			assertEquals(-1, Files.mismatch(result.resolve(file), again.resolve(file)), file);
		try (ReviewedResult review = ReviewedResult.open(again, Progress.NONE)) {
			// Without the file, what the run was told is known from its parameters.
			assertEquals(CorrectionsCsv.read(result.resolve(CorrectionsCsv.FILE)),
				review.model().said().stream().map(CorrectionsCsv::asWritten).toList());
			review.model().atRest();
			review.model().goTo(3);
			review.model().withdraw();
			review.save(Progress.NONE);
		}
		assertArrayEquals(before, Files.readAllBytes(again.resolve("contours.csv")));
	}

	@Test
	void checkedFramesAreKeptForTomorrowAndByAHeadlessRun() throws Exception {
		try (ReviewedResult review = ReviewedResult.open(result, Progress.NONE)) {
			// What the folder holds is seen at once.
			assertEquals(5, review.model().tracks().orElseThrow().resolved());
			review.model().atRest();
			review.model().goTo(2);
			review.model().accept();
			assertTrue(review.isChanged());
			review.save(Progress.NONE);
		}
		final List<String> frames = Files.readAllLines(result.resolve("frames.csv"));
		for (int frame = 1; frame <= 5; frame++)
			assertTrue(frames.get(frame).endsWith(frame == 2 ? ",1" : ",0"), frames.get(frame));
		final Path again = home.resolve("again");
		run(Map.of("corrections", result.resolve(CorrectionsCsv.FILE).toString()), again);
		for (final String file : List.of("contours.csv", "frames.csv", "filaments.csv"))
			assertEquals(-1, Files.mismatch(result.resolve(file), again.resolve(file)), file);
		try (ReviewedResult tomorrow = ReviewedResult.open(result, Progress.NONE)) {
			assertTrue(tomorrow.model().isChecked(2));
			tomorrow.model().atRest();
			assertTrue(tomorrow.model().isChecked(2));
			assertFalse(tomorrow.model().isChecked(3));
		}
	}

	@Test
	void aResultInMemoryIsReviewedAtOnceAndWrittenToANewFolder() throws Exception {
		final ImagePlus image = ImageFile.open(movie);
		final LiveResult live = live(image, Map.of("frames", "1-5", "threads", "2", "region", ""));
		final Path fresh = home.resolve("new/fresh");
		try (ReviewedResult review = ReviewedResult.of(live, image)) {
			assertTrue(review.model().isReady());
			review.model().goTo(3);
			review.model().refuse();
			assertThrows(UserException.class, () -> review.save(Progress.NONE));
			assertThrows(UserException.class, () -> review.chooseFolder(result));
			review.chooseFolder(fresh);
			review.save(Progress.NONE);
			assertEquals(
				"run(\"Resolve Filament...\", \"movie=[" + movie + "] frames=1-5 corrections=["
					+ fresh.resolve(CorrectionsCsv.FILE) + "] out=[" + fresh + "] force\");",
				review.macroLine());
			review.model().goTo(4);
			review.model().accept();
			review.save(Progress.NONE);
		}
		final Path again = home.resolve("again");
		run(Map.of("corrections", fresh.resolve(CorrectionsCsv.FILE).toString()), again);
		for (final String file : List.of("contours.csv", "frames.csv", "filaments.csv",
			"summary.csv", "RoiSet.zip"))
			assertEquals(-1, Files.mismatch(fresh.resolve(file), again.resolve(file)), file);
	}

	@Test
	void pixelsThatWereEditedSinceAreNoticedUntilTheyAreAsBefore() throws Exception {
		final ImagePlus image = ImageFile.open(movie);
		final LiveResult live = live(image, Map.of("frames", "1-5", "threads", "2"));
		final Path fresh = home.resolve("fresh");
		try (ReviewedResult review = ReviewedResult.of(live, image)) {
			review.chooseFolder(fresh);
			final var pixels = image.getStack().getProcessor(4);
			final int before = pixels.get(7, 9);
			pixels.set(7, 9, before + 1);
			review.model().goTo(3);
			review.model().refuse();
			assertEquals(live.tracks(), review.model().atRest());
			final String said = review.model().problem().orElseThrow();
			assertTrue(said.contains("were changed since it was resolved"), said);
			assertEquals(List.of(), review.model().said());
			assertEquals(said,
				assertThrows(UserException.class, () -> review.save(Progress.NONE)).getMessage());
			assertFalse(Files.exists(fresh));
			assertEquals(said,
				assertThrows(UserException.class, () -> ReviewedResult.of(live, image))
					.getMessage());
			pixels.set(7, 9, before);
			review.model().refuse();
			review.model().atRest();
			assertEquals(Optional.empty(), review.model().problem());
			assertEquals(1, review.model().said().size());
		}
	}

	@Test
	void correctionsCanBeSavedWhenTheImageWasClosedMeanwhile() throws Exception {
		final ImagePlus image = ImageFile.open(movie);
		final LiveResult live = live(image, Map.of("frames", "1-5", "threads", "2"));
		final Path fresh = home.resolve("fresh");
		try (ReviewedResult review = ReviewedResult.of(live, image)) {
			review.chooseFolder(fresh);
			review.model().goTo(3);
			review.model().refuse();
			review.model().atRest();
			// What ImageJ does when the window is closed.
			image.flush();
			review.save(Progress.NONE);
			assertFalse(review.isChanged());
			assertEquals(1, CorrectionsCsv.read(fresh.resolve(CorrectionsCsv.FILE)).size());
		}
		image.flush();
		assertNull(image.getProcessor(), "the pixels go with the review");
	}

	@Test
	void whatOthersWroteMeanwhileStays() throws Exception {
		try (ReviewedResult review = ReviewedResult.open(result, Progress.NONE)) {
			review.model().atRest();
			review.model().goTo(2);
			review.model().refuse();
			final String theirs = "frame,index,x_px,y_px\n";
			Files.writeString(result.resolve(CorrectionsCsv.FILE), theirs);
			assertTrue(assertThrows(UserException.class, () -> review.save(Progress.NONE))
				.getMessage().contains("changed by another program"));
			assertEquals(theirs, Files.readString(result.resolve(CorrectionsCsv.FILE)));
			assertTrue(review.isChanged());
		}
	}

	@Test
	void whatCannotBeReviewedIsRefusedInOneSentence() throws Exception {
		refused(home, "is no folder that 'resolve' wrote");
		Files.move(movie, home.resolve("elsewhere.tif"));
		refused(result, "is not at " + movie);
		Files.writeString(movie, "another");
		refused(result, "is not the one of result");
	}

	private void refused(final Path folder, final String words) {
		final String sentence = assertThrows(UserException.class,
			() -> ReviewedResult.open(folder, Progress.NONE)).getMessage();
		assertTrue(sentence.contains(words), sentence);
	}

	/** What a run has just found in an image. */
	private static LiveResult live(final ImagePlus image, final Map<String, String> texts)
		throws IOException {
		final KeptSession session = new KeptSession(image);
		return new LiveResult(
			ResolveRun.of(texts).read(ImageSource.of(image), Progress.NONE)
				.resolve(session, ResultSink.NONE, Progress.NONE).result().tracks(),
			session, texts, Optional.empty());
	}
}
