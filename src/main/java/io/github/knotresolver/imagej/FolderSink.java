package io.github.knotresolver.imagej;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.List;

import ij.ImagePlus;
import io.github.knotresolver.imagej.plot.Figures;
import io.github.knotresolver.imagej.plot.Pictures;
import io.github.knotresolver.io.ContoursCsv;
import io.github.knotresolver.io.FilamentsCsv;
import io.github.knotresolver.io.FramesCsv;
import io.github.knotresolver.io.OriginalFiles;
import io.github.knotresolver.io.ParametersJson;
import io.github.knotresolver.io.ResultFolder;
import io.github.knotresolver.io.SummaryCsv;
import io.github.knotresolver.measure.MeasuredFilament;
import io.github.knotresolver.measure.MeasuredTracks;
import io.github.knotresolver.model.FilamentTrack;
import io.github.knotresolver.model.Tracks;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;
import io.github.knotresolver.run.FinishedRun;
import io.github.knotresolver.run.ResultSink;

/**
 * All files of a result in a folder: a complete one or nothing. Tables come
 * first; a picture that cannot be drawn is left out, with a note.
 */
public final class FolderSink implements ResultSink {

	/** Speed of the film. */
	private static final double FRAMES_PER_SECOND = 8;

	private final ResultFolder folder;
	private final ImageSource source;
	private final boolean plots;

	/**
	 * @param folder the reserved folder; committed at the end
	 * @param source where the movie came from; makes ROIs for its image
	 * @param plots whether plots and projections are written as well; tables, ROIs,
	 *          overlay, montage and kymographs always are
	 */
	public FolderSink(final ResultFolder folder, final ImageSource source, final boolean plots) {
		this.folder = folder;
		this.source = source;
		this.plots = plots;
	}

	@Override
	public List<String> write(final FinishedRun outcome, final Progress progress)
		throws IOException {
		final MeasuredTracks result = outcome.result();
		progress.report("Writing tables", 0);
		writeTables(outcome);
		progress.checkCancelled();
		RoiConverter.writeSet(file(RoiConverter.SET_FILE), source.rois().rois(result.tracks()));
		progress.report("Drawing", 0);
		final Pictures pictures = new Pictures(folder.path());
		together(() -> writeOverlay(result.tracks(), pictures, progress),
			() -> writeFigures(result, pictures, progress));
		progress.checkCancelled();
		ParametersJson.write(file(ParametersJson.FILE), result.tracks(), outcome.input(),
			outcome.identity(), pictures.notes());
		folder.commit();
		return pictures.notes();
	}

	/** Does independent work at the same time, as far as there are threads. */
	private static void together(final Task... tasks) throws IOException {
		try {
			Workers.present().map(tasks.length, i -> {
				tasks[i].run();
				return i;
			});
		} catch (final UncheckedIOException e) {
			throw e.getCause();
		}
	}

	private Path file(final String name) {
		return folder.path().resolve(name);
	}

	private void writeTables(final FinishedRun outcome) throws IOException {
		final MeasuredTracks result = outcome.result();
		ContoursCsv.write(file(ContoursCsv.FILE), result);
		FramesCsv.write(file(FramesCsv.FILE), result);
		FilamentsCsv.write(file(FilamentsCsv.FILE), result);
		SummaryCsv.write(file(SummaryCsv.FILE), result, outcome.input());
		for (final MeasuredFilament filament : result.filaments()) {
			final String suffix = MeasuredFilament.suffix(filament.track().id());
			OriginalFiles.writeContours(file(OriginalFiles.CONTOURS.replace(".", suffix + ".")),
				filament);
			OriginalFiles.writeStatistics(file(OriginalFiles.STATISTICS.replace(".", suffix + ".")),
				filament, result);
		}
	}

	private void writeOverlay(final Tracks tracks, final Pictures pictures, final Progress progress)
		throws IOException {
		pictures.draw("overlay.tif",
			file -> OverlayStack.write(OverlayRenderer.stack(tracks, progress), file));
		if (plots)
			pictures.draw("overlay.avi", file -> {
				final ImagePlus overlay = OverlayRenderer.stack(tracks, progress);
				OverlayStack.writeFilm(overlay, file, FRAMES_PER_SECOND);
			});
		progress.checkCancelled();
		pictures.drawPng("montage.png", () -> Montage.of(tracks));
		if (!plots)
			return;
		pictures.drawPng("overlay.png", () -> OverlayRenderer.projection(tracks));
		if (tracks.filaments().size() > 1)
			for (final FilamentTrack filament : tracks.filaments()) {
				progress.checkCancelled();
				pictures.drawPng("montage-" + MeasuredFilament.number(filament.id()) + ".png",
					() -> Montage.of(tracks, List.of(filament)));
			}
	}

	private void writeFigures(final MeasuredTracks result, final Pictures pictures,
		final Progress progress) throws IOException {
		for (final MeasuredFilament filament : result.filaments()) {
			if (filament.measurements().isEmpty())
				continue;
			final String suffix = MeasuredFilament.suffix(filament.track().id());
			if (plots)
				Figures.write(pictures, suffix, filament.measurements().get(), progress);
			else
				Figures.writeKymographs(pictures, suffix, filament.measurements().get());
		}
	}

	/** Work that may fail on the disk. */
	@FunctionalInterface
	private interface Task {

		void write() throws IOException;

		default void run() {
			try {
				write();
			} catch (final IOException e) {
				throw new UncheckedIOException(e);
			}
		}
	}
}
