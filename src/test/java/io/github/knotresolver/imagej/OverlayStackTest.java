package io.github.knotresolver.imagej;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

import net.imglib2.img.array.ArrayImgs;
import net.imglib2.view.Views;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import ij.IJ;
import ij.ImagePlus;
import ij.ImageStack;
import ij.VirtualStack;
import ij.process.ColorProcessor;
import ij.process.ImageProcessor;
import io.github.knotresolver.model.Anchor;
import io.github.knotresolver.model.Calibration;
import io.github.knotresolver.model.FilamentTrack;
import io.github.knotresolver.model.FrameStatus;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.model.Settings;
import io.github.knotresolver.model.Tracks;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.progress.Progress;

/** The overlay is written frame by frame, whatever its size. */
class OverlayStackTest {

	@TempDir
	Path folder;

	@Test
	void isReadBackWithItsFramesLabelsAndUnits() throws IOException {
		final Tracks tracks = tracks(12, 10, 3);
		final Path file = folder.resolve("overlay.tif");
		final ImagePlus overlay = OverlayRenderer.stack(tracks, Progress.NONE);
		OverlayStack.write(overlay, file);
		final ImagePlus read = IJ.openImage(file.toString());
		assertEquals(List.of(24, 20, 3, 24),
			List.of(read.getWidth(), read.getHeight(), read.getNFrames(), read.getBitDepth()));
		assertEquals("lost", read.getStack().getSliceLabel(2));
		assertEquals(0.05, read.getCalibration().pixelWidth, 1e-9);
		assertEquals(2, read.getCalibration().frameInterval, 1e-9);
		for (int n = 1; n <= 3; n++)
			assertEquals(0, difference(overlay, read, n), "frame " + n);
	}

	@Test
	void filmHasAllFramesAndRefusesOddSpeeds() throws IOException {
		final ImageStack stack = new ImageStack(32, 24);
		for (int i = 0; i < 5; i++)
			stack.addSlice(new ColorProcessor(32, 24));
		final Path file = folder.resolve("overlay.avi");
		OverlayStack.writeFilm(new ImagePlus("overlay", stack), file, 10);
		assertEquals(5, IJ.openImage(file.toString()).getStackSize());
		assertThrows(UserException.class,
			() -> OverlayStack.writeFilm(new ImagePlus("overlay", stack), file, 0));
	}

	/** More than any Java array holds, more than any memory that a test has. */
	@ParameterizedTest
	@CsvSource({"512,2731", "1024,683", "1024,1400"})
	void moreThanAnArrayHoldsIsWritten(final int edge, final int frames) throws IOException {
		final ColorProcessor frame = new ColorProcessor(edge, edge);
		final ImagePlus large = new ImagePlus("large", new VirtualStack(edge, edge, frames) {

			@Override
			public ImageProcessor getProcessor(final int n) {
				return frame;
			}
		});
		final long[] written = {0};
		OverlayStack.write(large, new OutputStream() {

			@Override
			public void write(final int b) {
				written[0]++;
			}

			@Override
			public void write(final byte[] bytes, final int from, final int count) {
				written[0] += count;
			}
		});
		assertTrue(written[0] >= 3L * edge * edge * frames, "" + written[0]);
	}

	private static int difference(final ImagePlus a, final ImagePlus b, final int slice) {
		final int[] x = (int[]) a.getStack().getPixels(slice),
			y = (int[]) b.getStack().getPixels(slice);
		return (int) IntStream.range(0, x.length)
			.filter(i -> (x[i] & 0xffffff) != (y[i] & 0xffffff)).count();
	}

	/** One grey frame, again and again. */
	private static Tracks tracks(final int width, final int height, final int frames) {
		final var frame = ArrayImgs.unsignedBytes(width, height);
		frame.forEach(p -> p.set(9));
		final var stack = Views.interval(Views.extendZero(Views.addDimension(frame, 0, 0)),
			new long[]{0, 0, 0}, new long[]{width - 1, height - 1, frames - 1});
		return new Tracks(new Movie("flat", stack, new Calibration(0.1, "µm", 2, "s")),
			Settings.DEFAULT,
			List.of(new FilamentTrack(1, Anchor.CLAMPED, Optional.empty(), 5, 0,
				IntStream.rangeClosed(1, frames)
					.mapToObj(t -> Observation.without(t, FrameStatus.LOST, "Gone.")).toList())),
			List.of());
	}
}
