package io.github.knotresolver.imagej;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

import ij.ImagePlus;
import ij.io.FileSaver;
import io.github.knotresolver.imagej.plot.AnimatedOverlay;
import io.github.knotresolver.imagej.plot.Figures;
import io.github.knotresolver.io.ContoursCsv;
import io.github.knotresolver.io.FramesCsv;
import io.github.knotresolver.io.MeasuredTracks;
import io.github.knotresolver.io.OriginalFiles;
import io.github.knotresolver.io.ParametersJson;
import io.github.knotresolver.io.ResultFolder;
import io.github.knotresolver.io.RunIdentity;
import io.github.knotresolver.io.SummaryCsv;
import io.github.knotresolver.measure.MovieMeasurements;
import io.github.knotresolver.model.Tracks;
import io.github.knotresolver.options.InputOptions;
import io.github.knotresolver.progress.Progress;

/** Writes all files of a result. */
public final class ResultWriter {

	/** Speed of the film. */
	private static final double FRAMES_PER_SECOND = 8;

	private final MeasuredTracks result;
	private final Tracks tracks;
	private final InputOptions input;
	private final RoiConverter rois;
	private final Optional<RunIdentity> identity;

	/**
	 * @param result a measured result
	 * @param input how its movie was taken from the image
	 * @param rois makes ROIs for that image
	 * @param identity what the result was made from; empty if the image has no file
	 */
	public ResultWriter(final MeasuredTracks result, final InputOptions input,
		final RoiConverter rois, final Optional<RunIdentity> identity) {
		this.result = result;
		this.tracks = result.tracks();
		this.input = input;
		this.rois = rois;
		this.identity = identity;
	}

	/**
	 * Writes a complete folder or nothing.
	 *
	 * @param folder the reserved folder; committed here
	 * @param plots whether plots and projections are written as well; tables, ROIs,
	 *          overlay, montage and kymographs always are
	 * @param progress may cancel; nothing is left then
	 * @throws IOException if the disk says no
	 */
	public void write(final ResultFolder folder, final boolean plots, final Progress progress)
		throws IOException {
		progress.report("Writing tables", 0);
		writeTables(folder.path());
		progress.checkCancelled();
		RoiSetWriter.write(folder.path().resolve(RoiSetWriter.FILE), rois.rois(tracks));
		progress.report("Drawing", 0);
		writePictures(folder.path(), plots, progress);
		progress.checkCancelled();
		folder.commit();
	}

	private void writeTables(final Path folder) throws IOException {
		ContoursCsv.write(folder.resolve(ContoursCsv.FILE), result);
		FramesCsv.write(folder.resolve(FramesCsv.FILE), result);
		SummaryCsv.write(folder.resolve(SummaryCsv.FILE), result, input);
		ParametersJson.write(folder.resolve(ParametersJson.FILE), tracks, input,
			identity, List.of());
		OriginalFiles.writeContours(folder.resolve(OriginalFiles.CONTOURS), result);
		OriginalFiles.writeStatistics(folder.resolve(OriginalFiles.STATISTICS), result);
	}

	private void writePictures(final Path folder, final boolean plots, final Progress progress)
		throws IOException {
		Together.run(() -> writeOverlay(folder, plots, progress),
			() -> writeFigures(folder, plots, progress));
	}

	private void writeOverlay(final Path folder, final boolean plots, final Progress progress)
		throws IOException {
		final ImagePlus overlay = OverlayRenderer.stack(tracks);
		Files.write(folder.resolve("overlay.tif"), new FileSaver(overlay).serialize());
		if (plots)
			AnimatedOverlay.write(folder.resolve("overlay.avi"), overlay, FRAMES_PER_SECOND);
		progress.checkCancelled();
		PngFile.write(folder.resolve("montage.png"), Montage.of(tracks));
		progress.checkCancelled();
		if (plots)
			PngFile.write(folder.resolve("overlay.png"), OverlayRenderer.projection(tracks));
	}

	private void writeFigures(final Path folder, final boolean plots, final Progress progress)
		throws IOException {
		if (result.measurements().isEmpty())
			return;
		final MovieMeasurements measurements = result.measurements().get();
		if (plots)
			Figures.writeAll(folder, measurements, progress);
		else
			Figures.writeKymographs(folder, measurements);
	}
}
