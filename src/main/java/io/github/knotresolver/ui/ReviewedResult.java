package io.github.knotresolver.ui;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

import ij.plugin.frame.Recorder;
import io.github.knotresolver.imagej.FolderSink;
import io.github.knotresolver.imagej.ImageSource;
import io.github.knotresolver.io.CorrectionsCsv;
import io.github.knotresolver.io.EarlierCorrections;
import io.github.knotresolver.io.ResultFolder;
import io.github.knotresolver.io.ResultKind;
import io.github.knotresolver.io.RunIdentity;
import io.github.knotresolver.model.Constraint;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.Tracks;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.options.RunOptions;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.run.Engine;
import io.github.knotresolver.run.ResolveRun;
import io.github.knotresolver.session.Session;
import io.github.knotresolver.ui.model.ReviewModel;

/** A finished result folder that is reviewed, and written again. */
public final class ReviewedResult implements AutoCloseable {

	private static final String CORRECTIONS = "corrections";

	private final Path folder;
	private final RunIdentity identity;
	private final ImageSource source;
	private final Movie movie;
	private final ReviewModel model;
	/** What is in the file of corrections as far as it is known here. */
	private Optional<String> file;
	private List<Constraint> saved;

	private ReviewedResult(final Path folder, final RunIdentity identity, final Progress progress)
		throws IOException {
		this.folder = folder;
		this.identity = identity;
		source = ImageSource.of(identity.movie());
		final RunOptions options = RunOptions.parse(identity.given());
		movie = source.read(options.input(), progress);
		file = text();
		final List<Constraint> before = EarlierCorrections.of(folder);
		model = new ReviewModel(movie,
			new Session(movie, options.settings(movie, List.of()))::solve, before);
		saved = model.said();
	}

	/**
	 * Reads movie and corrections of a result, and begins to solve.
	 *
	 * @param folder a folder that {@code resolve} wrote
	 * @param progress may cancel the reading
	 * @return the result, to be closed
	 * @throws UserException if it is none, or its movie is not as it was, in one sentence
	 * @throws IOException if its files cannot be read
	 */
	public static ReviewedResult open(final Path folder, final Progress progress)
		throws IOException {
		final Path absolute = folder.toAbsolutePath().normalize();
		if (ResultKind.of(absolute).filter(k -> k == ResultKind.RESOLUTION).isEmpty())
			throw new UserException("result " + folder
				+ " is no folder that 'resolve' wrote; name one that holds contours.csv and parameters.json.");
		final RunIdentity identity = RunIdentity.read(absolute)
			.orElseThrow(() -> new UserException("result " + folder
				+ " does not tell the file of its movie; resolve a movie that is saved as a file."));
		if (!Files.exists(identity.movie()))
			throw new UserException("The movie of result " + folder + " is not at "
				+ identity.movie() + " any more; put it back, or resolve it where it is.");
		if (!RunIdentity.of(identity.movie(), identity.given(), progress).sha256()
			.equals(identity.sha256()))
			throw new UserException("The movie " + identity.movie() + " is not the one of result "
				+ folder + " any more; resolve it again.");
		return new ReviewedResult(absolute, identity, progress);
	}

	/** @return the folder, absolute */
	public Path folder() {
		return folder;
	}

	/** @return the movie's file, absolute */
	public Path file() {
		return identity.movie();
	}

	/** @return the channel that was resolved, from 1 */
	public int channel() {
		return RunOptions.parse(identity.given()).input().channel();
	}

	/** @return what is shown and said */
	public ReviewModel model() {
		return model;
	}

	/** @return whether something was said since it was written last */
	public synchronized boolean isChanged() {
		return !model.said().equals(saved);
	}

	/**
	 * Waits for the answer to what was said last, and writes it: {@code corrections.csv}, and the
	 * files of the result. A run of the movie with these corrections gives the same contours, to the
	 * byte.
	 *
	 * @param progress told how far it is; may cancel
	 * @throws UserException if the file of corrections was changed by others, or there is no result
	 * @throws IOException if the files cannot be written
	 * @throws InterruptedException if the thread is asked to stop
	 */
	public synchronized void save(final Progress progress)
		throws IOException, InterruptedException {
		final Tracks tracks = model.atRest();
		final List<Constraint> said = tracks.settings().constraints();
		writeCorrections(said);
		final ResolveRun run = ResolveRun.of(texts());
		try (ResultFolder out = ResultFolder.reserve(folder, ResultKind.RESOLUTION, true,
			run.files(source))) {
			run.read(source, progress).resolve(
				(again, settings, p) -> settings.equals(tracks.settings())
					? tracks
					: Engine.PIPELINE.resolve(again, settings, p),
				new FolderSink(out, source, hasPlots()), progress);
		}
		saved = said;
		if (Recorder.record)
			Recorder.recordString(macroLine() + "\n");
	}

	private void writeCorrections(final List<Constraint> said) throws IOException {
		if (!text().equals(file))
			throw new UserException(corrections()
				+ " was changed by another program meanwhile; move it elsewhere and save again, or open the review anew.");
		if (said.isEmpty() && file.isEmpty())
			return;
		final Path partial = Files.createTempFile(folder, ".corrections", ".part");
		try {
			CorrectionsCsv.write(partial, said);
			Files.move(partial, corrections(), StandardCopyOption.REPLACE_EXISTING);
		} finally {
			Files.deleteIfExists(partial);
		}
		file = text();
	}

	private Path corrections() {
		return folder.resolve(CorrectionsCsv.FILE);
	}

	private Optional<String> text() throws IOException {
		return Files.exists(corrections())
			? Optional.of(Files.readString(corrections(), StandardCharsets.ISO_8859_1))
			: Optional.empty();
	}

	private boolean hasPlots() {
		return Files.exists(folder.resolve("overlay.png"));
	}

	/** The options of the run, by key. */
	private Map<String, String> texts() {
		final Map<String, String> texts = new LinkedHashMap<>(identity.given());
		if (file.isPresent())
			texts.put(CORRECTIONS, corrections().toString());
		return texts;
	}

	/** @return the macro's line that writes the same result again, also without a display */
	public String macroLine() {
		final StringBuilder line = new StringBuilder("run(\"Resolve Filament...\", \"movie=")
			.append(path(file()));
		texts().forEach((key, value) -> line.append(' ').append(key).append('=')
			.append(key.equals(CORRECTIONS) ? path(corrections()) : quoted(value)));
		return line.append(" out=").append(path(folder)).append(hasPlots() ? "" : " plots=false")
			.append(" force\");").toString();
	}

	private static String path(final Path path) {
		return "[" + Recorder.fixPath(path.toString()) + "]";
	}

	private static String quoted(final String value) {
		return value.matches("[\\w.,:-]+") ? value : "[" + value + "]";
	}

	/** Stops what is being worked out. */
	@Override
	public void close() {
		model.close();
	}
}
