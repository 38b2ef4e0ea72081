package io.github.knotresolver.run;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;

import io.github.knotresolver.io.CorrectionsCsv;
import io.github.knotresolver.io.RunIdentity;
import io.github.knotresolver.measure.MeasuredTracks;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.Settings;
import io.github.knotresolver.model.Tracks;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.options.RunOptions;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;
import io.github.knotresolver.session.Engine;
import io.github.knotresolver.session.FrameChoice;

/**
 * The use case: options and a movie are read, the movie is resolved, the result
 * measured and written. In two steps, since what is wrong with the input is
 * another thing than what goes wrong with the work:
 *
 * <pre>
 * ResolveRun run = ResolveRun.of(options);
 * run.read(source, progress).resolve(Engine.PIPELINE, sink, progress);
 * </pre>
 */
public final class ResolveRun {

	private final Map<String, String> texts;
	private final RunOptions options;

	private ResolveRun(final Map<String, String> texts) {
		this.texts = Map.copyOf(texts);
		this.options = RunOptions.parse(texts);
	}

	/**
	 * @param texts the options that were given, by key
	 * @return a run with these options
	 * @throws UserException if one is not allowed, in one sentence
	 */
	public static ResolveRun of(final Map<String, String> texts) {
		return new ResolveRun(texts);
	}

	/**
	 * @param source where the movie comes from
	 * @return all files that the run reads
	 */
	public List<Path> files(final MovieSource source) {
		return RunIdentity.files(source.file(), texts);
	}

	/**
	 * Reads all input.
	 *
	 * @param source where the movie comes from
	 * @param progress may cancel
	 * @return the work, to be done
	 * @throws UserException if the input cannot be used, in one sentence
	 */
	public Work read(final MovieSource source, final Progress progress) {
		final Movie movie = source.read(options.input(), progress);
		final Settings settings = options.settings(movie, CorrectionsCsv.of(options));
		return new Work(movie, settings, source);
	}

	/** A run whose input is fine. */
	public final class Work {

		private final Movie movie;
		private final Settings settings;
		private final Optional<Path> file;
		private final List<String> notes;

		private Work(final Movie movie, final Settings settings, final MovieSource source) {
			this.movie = movie;
			this.settings = settings;
			this.file = source.file();
			this.notes = source.notes();
		}

		/** @return how many frames are resolved */
		public int frames() {
			return new FrameChoice(movie, settings).frames().size();
		}

		/**
		 * Resolves, measures and writes.
		 *
		 * @param engine what resolves the movie
		 * @param sink where the result goes
		 * @param progress told how far it is; may cancel
		 * @return what came of it
		 * @throws UserException if there is no result, in one sentence
		 * @throws IOException if the result cannot be written
		 */
		public FinishedRun resolve(final Engine engine, final ResultSink sink,
			final Progress progress) throws IOException {
			final Optional<RunIdentity> identity = sink == ResultSink.NONE
				? Optional.empty()
				: RunIdentity.of(file, texts, progress);
			final Tracks tracks = engine.resolve(movie, settings, progress).noted(notes);
			try (Workers workers = new Workers(settings.threads())) {
				return workers.during(() -> {
					final MeasuredTracks result = MeasuredTracks.of(tracks, progress);
					final List<String> leftOut = sink.write(
						new FinishedRun(result, options.input(), identity, List.of()), progress);
					return new FinishedRun(result, options.input(), identity, leftOut);
				});
			}
		}
	}
}
