package io.github.knotresolver.imagej;

import java.awt.image.BufferedImage;
import java.util.Arrays;

import net.imglib2.RandomAccess;
import net.imglib2.img.array.ArrayImg;
import net.imglib2.img.array.ArrayImgs;
import net.imglib2.img.basictypeaccess.array.DoubleArray;
import net.imglib2.type.numeric.RealType;
import net.imglib2.type.numeric.real.DoubleType;

import ij.ImagePlus;
import io.github.knotresolver.image.Contrast;
import io.github.knotresolver.model.Calibration;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.Tracks;
import io.github.knotresolver.progress.Progress;

/**
 * The movie with its contours drawn in: frame by frame as an RGB stack, and all
 * contours over the movie's brightest intensities as one picture. Colour runs
 * along the length; the fixed end has a ring.
 */
public final class OverlayRenderer {

	/** Small images are enlarged, so that a line covers less of the filament. */
	private static final int SMALL = 320, PICTURE = 1200, BRIGHTEST = 170, BACKDROP = 90;
	private static final double LARGEST_SCALE = 6, LINE = 1.5, RING = 4, FAINT = 0.7;

	private OverlayRenderer() {
	}

	/**
	 * @param tracks a result
	 * @param progress asked before every frame is drawn
	 * @return an RGB stack of all frames, calibrated, each drawn when it is asked for;
	 *         images below 320 pixels at twice their size
	 */
	public static ImagePlus stack(final Tracks tracks, final Progress progress) {
		final Movie movie = tracks.movie();
		final int scale = Math.max(movie.width(), movie.height()) < SMALL ? 2 : 1;
		final FramePainter painter = new FramePainter(Contrast.of(movie, BRIGHTEST),
			Viewport.whole(movie, scale));
		final OverlayStack stack = new OverlayStack(tracks, scale,
			new ContourPainter(tracks, tracks.filaments(), painter, LINE, RING), progress);
		final ImagePlus image = new ImagePlus(movie.name() + "-overlay", stack);
		image.setDimensions(1, 1, movie.size());
		image.setCalibration(calibration(movie.calibration(), scale));
		return image;
	}

	/**
	 * @param tracks a result
	 * @return all contours over the brightest intensity of each pixel
	 */
	public static BufferedImage projection(final Tracks tracks) {
		final Movie movie = tracks.movie();
		final Viewport part = Viewport.aroundContours(movie, tracks.filaments());
		final double scale = Math.min(LARGEST_SCALE,
			(double) PICTURE / Math.max(part.width(), part.height()));
		final FramePainter painter = new FramePainter(Contrast.of(movie, BACKDROP),
			part.scaled(scale));
		final BufferedImage picture = painter.paint(brightest(movie));
		new ContourPainter(tracks, tracks.filaments(), painter, LINE, 2 * RING).drawAll(picture,
			FAINT);
		return picture;
	}

	private static ArrayImg<DoubleType, DoubleArray> brightest(final Movie movie) {
		final double[] most = new double[movie.width() * movie.height()];
		Arrays.fill(most, Double.NEGATIVE_INFINITY);
		final RandomAccess<? extends RealType<?>> pixel = movie.frames().randomAccess();
		for (int t = 0; t < movie.size(); t++)
			for (int i = 0; i < most.length; i++)
				most[i] = Math.max(most[i], pixel
					.setPositionAndGet(i % movie.width(), i / movie.width(), t).getRealDouble());
		return ArrayImgs.doubles(most, movie.width(), movie.height());
	}

	private static ij.measure.Calibration calibration(final Calibration c, final int scale) {
		final ij.measure.Calibration calibration = new ij.measure.Calibration();
		calibration.pixelWidth = calibration.pixelHeight = c.pixelSize() / scale;
		calibration.setUnit(c.unit());
		if (c.hasTimeUnit()) {
			calibration.frameInterval = c.frameInterval();
			calibration.setTimeUnit(c.timeUnit());
		}
		return calibration;
	}
}
