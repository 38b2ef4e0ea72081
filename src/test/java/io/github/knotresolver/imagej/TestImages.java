package io.github.knotresolver.imagej;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

import ij.IJ;
import ij.ImagePlus;
import ij.io.FileSaver;
import ij.process.ImageProcessor;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.Anchor;
import io.github.knotresolver.model.FilamentTrack;
import io.github.knotresolver.model.FrameStatus;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.model.Settings;
import io.github.knotresolver.model.Tracks;
import io.github.knotresolver.progress.Progress;

/** Movies of a filament with a loop, and an engine that knows where it is. */
public final class TestImages {

	public static final int WIDTH = 80, HEIGHT = 60;

	private TestImages() {
	}

	/** A clamped filament that curls up more from frame to frame. */
	public static Polyline contour(final int index, final int frames) {
		final int n = 100;
		final double[] x = new double[n + 1], y = new double[n + 1];
		final double turn = 2 * Math.PI * (0.4 + 0.8 * index / frames) / n;
		x[0] = 12;
		y[0] = 30;
		for (int i = 1; i <= n; i++) {
			x[i] = x[i - 1] + 0.8 * Math.cos(turn * i);
			y[i] = y[i - 1] + 0.8 * Math.sin(turn * i);
		}
		return Polyline.of(x, y);
	}

	/** A time series of that filament, calibrated. */
	public static ImagePlus movie(final int frames, final int bits) {
		final ImagePlus image = IJ.createHyperStack("movie", WIDTH, HEIGHT, 1, 1, frames, bits);
		for (int t = 0; t < frames; t++) {
			final ImageProcessor ip = image.getStack().getProcessor(t + 1);
			final Polyline contour = contour(t, frames);
			for (int i = 0; i < contour.size(); i++)
				ip.putPixelValue((int) Math.rint(contour.x(i)), (int) Math.rint(contour.y(i)), 200);
		}
		image.getCalibration().pixelWidth = image.getCalibration().pixelHeight = 0.25;
		image.getCalibration().setUnit("micron");
		image.getCalibration().frameInterval = 2;
		return image;
	}

	public static Path save(final ImagePlus image, final Path file) {
		if (!new FileSaver(image).saveAsTiff(file.toString()))
			throw new IllegalStateException("Not saved: " + file);
		return file;
	}

	/** Knows the filament of {@link #movie}; loses it in frame 2. */
	public static Tracks resolve(final Movie movie, final Settings parameters,
		final Progress progress) {
		progress.checkCancelled();
		return new Tracks(movie, parameters,
			List.of(new FilamentTrack(1, Anchor.CLAMPED, Optional.of(new Point(12, 30)), 80, 0.1,
				IntStream.range(0, movie.size()).mapToObj(i -> frame(i, movie.size())).toList())),
			List.of("A note."));
	}

	/** Contours that are known, one a frame. */
	public static Tracks tracks(final Movie movie, final Settings settings,
		final List<Polyline> contours) {
		final List<Observation> frames = IntStream.range(0, contours.size())
			.mapToObj(i -> new Observation(i + 1, FrameStatus.RESOLVED, "",
				Optional.of(contours.get(i)), 1, 1, 0.5, 0.99))
			.toList();
		return new Tracks(
			movie, settings, List.of(new FilamentTrack(1, Anchor.CLAMPED,
				Optional.of(contours.get(0).first()), contours.get(0).length(), 0, frames)),
			List.of());
	}

	private static Observation frame(final int i, final int frames) {
		return i == 1
			? Observation.without(2, FrameStatus.LOST, "The filament, it seems, is \"gone\".")
			: new Observation(i + 1, FrameStatus.RESOLVED, "", Optional.of(contour(i, frames)), 1,
				4, 0.5, 0.99);
	}
}
