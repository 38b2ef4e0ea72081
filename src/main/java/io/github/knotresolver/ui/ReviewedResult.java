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
import java.util.TreeMap;

import ij.ImagePlus;
import ij.plugin.frame.Recorder;
import io.github.knotresolver.imagej.FolderSink;
import io.github.knotresolver.imagej.ImageSource;
import io.github.knotresolver.io.CorrectionsCsv;
import io.github.knotresolver.io.EarlierCorrections;
import io.github.knotresolver.io.FinishedTracks;
import io.github.knotresolver.io.ResultFolder;
import io.github.knotresolver.io.ResultKind;
import io.github.knotresolver.io.RunIdentity;
import io.github.knotresolver.model.Constraint;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.Tracks;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.options.RunOptions;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.run.ResolveRun;
import io.github.knotresolver.session.Engine;
import io.github.knotresolver.session.Session;
import io.github.knotresolver.ui.model.ReviewModel;
import io.github.knotresolver.ui.model.Solver;

/** A result that is reviewed and written: that of a finished folder, or one in memory. */
public final class ReviewedResult implements AutoCloseable {

	private static final String CORRECTIONS = "corrections";

	private final Map<String, String> given;
	private final ImageSource source;
	private final ReviewModel model;
	/** Of a live result, what it was made by; its image is needed as long as it is reviewed. */
	private final Optional<KeptSession> session;
	private Optional<Path> folder;
	/** What is in the file of corrections as far as it is known here. */
	private Optional<String> file;
	private List<Constraint> saved;

	private ReviewedResult(final Map<String, String> texts, final ImageSource source,
		final ReviewModel model, final Optional<Path> folder, final Optional<KeptSession> session)
		throws IOException {
		given = new TreeMap<>(texts);
		given.values().removeIf(text -> text == null || text.isBlank());
		given.keySet().removeAll(List.of(CORRECTIONS, "threads"));
		this.source = source;
		this.model = model;
		this.folder = folder;
		this.session = session;
		file = text();
		saved = model.said();
		session.ifPresent(KeptSession::holdPixels);
	}

	/**
	 * Reads movie, result and corrections of a folder, and begins to solve.
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
		final RunIdentity identity = identity(folder, absolute, progress);
		final ImageSource source = ImageSource.of(identity.movie());
		final RunOptions options = RunOptions.parse(identity.given());
		final Movie movie = source.read(options.input(), progress);
		final Solver solver = new Session(movie, options.settings(movie, List.of()))::solve;
		final List<Constraint> before = EarlierCorrections.of(absolute);
		return new ReviewedResult(identity.given(), source,
			FinishedTracks.read(absolute, movie, options.settings(movie, before))
				.map(t -> ReviewModel.finished(t, solver))
				.orElseGet(() -> new ReviewModel(movie, solver, before)),
			Optional.of(absolute), Optional.empty());
	}

	private static RunIdentity identity(final Path folder, final Path absolute,
		final Progress progress) throws IOException {
		if (ResultKind.of(absolute).filter(k -> k == ResultKind.RESOLVED_MOVIE).isEmpty())
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
		return identity;
	}

	/**
	 * @param live a result in memory
	 * @param image the image that was resolved
	 * @return its review; words can follow at once
	 * @throws UserException if the image was edited since, in one sentence
	 * @throws IOException if the files of its folder cannot be read
	 */
	public static ReviewedResult of(final LiveResult live, final ImagePlus image)
		throws IOException {
		live.session().requireSamePixels();
		return new ReviewedResult(live.texts(), ImageSource.of(image),
			ReviewModel.live(live.tracks(), live.session()),
			live.folder().map(f -> f.toAbsolutePath().normalize()), Optional.of(live.session()));
	}

	/** @return the folder, absolute; empty as long as the result was never written */
	public synchronized Optional<Path> folder() {
		return folder;
	}

	/**
	 * @param chosen where a result is written that never was: a new folder, or an empty one
	 * @throws UserException if there is a result already
	 */
	public synchronized void chooseFolder(final Path chosen) {
		if (folder.isPresent())
			return;
		if (ResultKind.of(chosen).isPresent())
			throw new UserException(
				"The folder " + chosen + " holds a result already; choose another one.");
		folder = Optional.of(chosen.toAbsolutePath().normalize());
	}

	/** @return what the result is called */
	public String name() {
		return folder().map(f -> f.getFileName().toString()).orElse(model.movie().name());
	}

	/** @return the movie's file, absolute; empty if it has none */
	public Optional<Path> file() {
		return source.file();
	}

	/** @return the channel that was resolved, from 1 */
	public int channel() {
		return RunOptions.parse(given).input().channel();
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
	 * files of the result. A run of the movie with these corrections gives the same files, to the
	 * byte.
	 *
	 * @param progress told how far it is; may cancel
	 * @throws UserException if the file of corrections was changed by others, the image was edited
	 *           since it was resolved, there is no result, or the folder cannot be used
	 * @throws IOException if the files cannot be written
	 * @throws InterruptedException if the thread is asked to stop
	 */
	public synchronized void save(final Progress progress)
		throws IOException, InterruptedException {
		final Path target = folder
			.orElseThrow(() -> new UserException("Choose the folder of the result first."));
		final Tracks tracks = model.atRest();
		session.ifPresent(KeptSession::requireSamePixels);
		final List<Constraint> said = tracks.settings().constraints();
		if (ResultKind.of(target).isPresent()) {
			writeCorrections(said);
			write(target, tracks, file.map(f -> corrections()), true, progress);
		} else
			writeNew(target, tracks, progress);
		saved = said;
		if (Recorder.record)
			Recorder.recordString(macroLine() + "\n");
	}

	/** The folder appears when it is complete, and what was said of it is put there. */
	private void writeNew(final Path target, final Tracks tracks, final Progress progress)
		throws IOException {
		final List<Constraint> said = tracks.settings().constraints();
		Files.createDirectories(target.getParent());
		final Path words = Files.createTempFile(target.getParent(), ".corrections", ".part");
		try {
			CorrectionsCsv.write(words, said);
			write(target, tracks, said.isEmpty() ? Optional.empty() : Optional.of(words), false,
				progress);
			if (!said.isEmpty())
				Files.move(words, corrections());
		} catch (final UserException e) {
			// Another folder may be chosen.
			folder = Optional.empty();
			throw e;
		} finally {
			Files.deleteIfExists(words);
		}
		file = text();
	}

	private void write(final Path target, final Tracks tracks, final Optional<Path> words,
		final boolean overwrite, final Progress progress) throws IOException {
		final Map<String, String> texts = new LinkedHashMap<>(given);
		words.ifPresent(w -> texts.put(CORRECTIONS, w.toString()));
		final ResolveRun run = ResolveRun.of(texts);
		final boolean plots = hasPlots();
		try (ResultFolder out = ResultFolder.reserve(target, ResultKind.RESOLVED_MOVIE, overwrite,
			run.files(source))) {
			run.read(source, progress).resolve(
				(again, settings, p) -> settings.equals(tracks.settings())
					? tracks
					: Engine.PIPELINE.resolve(again, settings, p),
				new FolderSink(out, source, plots), progress);
		}
	}

	private void writeCorrections(final List<Constraint> said) throws IOException {
		if (!text().equals(file))
			throw new UserException(corrections()
				+ " was changed by another program meanwhile; move it elsewhere and save again, or open the review anew.");
		if (said.isEmpty() && file.isEmpty())
			return;
		final Path partial = Files.createTempFile(corrections().getParent(), ".corrections",
			".part");
		try {
			CorrectionsCsv.write(partial, said);
			Files.move(partial, corrections(), StandardCopyOption.REPLACE_EXISTING);
		} finally {
			Files.deleteIfExists(partial);
		}
		file = text();
	}

	private Path corrections() {
		return folder.orElseThrow().resolve(CorrectionsCsv.FILE);
	}

	private Optional<String> text() throws IOException {
		return folder.isPresent() && Files.exists(corrections())
			? Optional.of(Files.readString(corrections(), StandardCharsets.ISO_8859_1))
			: Optional.empty();
	}

	/** A result that was never written gets them. */
	private boolean hasPlots() {
		final Path target = folder.orElseThrow();
		return ResultKind.of(target).isEmpty() || Files.exists(target.resolve("overlay.png"));
	}

	/** @return the macro's line that writes the same result again, also without a display */
	public synchronized String macroLine() {
		final StringBuilder line = new StringBuilder("run(\"Resolve Filament...\", \"")
			.append(file().map(f -> "movie=" + path(f))
				.orElseGet(() -> "image=[" + model.movie().name() + "]"));
		given.forEach(
			(key, value) -> line.append(' ').append(key).append('=').append(quoted(value)));
		if (file.isPresent())
			line.append(' ').append(CORRECTIONS).append('=').append(path(corrections()));
		return line.append(" out=").append(path(folder.orElseThrow()))
			.append(hasPlots() ? "" : " plots=false").append(" force\");").toString();
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
		session.ifPresent(KeptSession::releasePixels);
	}
}
