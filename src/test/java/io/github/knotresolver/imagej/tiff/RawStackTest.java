package io.github.knotresolver.imagej.tiff;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Random;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import ij.IJ;
import ij.ImagePlus;
import ij.io.FileSaver;
import ij.process.ImageProcessor;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.progress.Progress;

/** A movie that stays in its file is the movie that was read. */
class RawStackTest {

	private static final long NO_MEMORY = 1, MUCH = 1L << 40;

	@TempDir
	Path home;

	@ParameterizedTest
	@CsvSource({"8,1,7,false", "16,1,7,false", "32,1,7,false", "16,3,4,false", "16,1,7,true",
		"32,2,3,true"})
	void readsWhatImageJReads(final int bits, final int channels, final int frames,
		final boolean intel) throws IOException {
		final Path file = movie(bits, channels, frames, intel);
		final ImagePlus lazy = TiffImage.open(file, Progress.NONE, NO_MEMORY);
		final ImagePlus read = TiffImage.open(file, Progress.NONE, MUCH);
		assertTrue(lazy.getStack().isVirtual());
		assertFalse(read.getStack().isVirtual());
		assertArrayEquals(read.getDimensions(), lazy.getDimensions());
		assertEquals(read.getBitDepth(), lazy.getBitDepth());
		assertEquals(read.getTitle(), lazy.getTitle());
		assertEquals(read.getCalibration().pixelWidth, lazy.getCalibration().pixelWidth);
		assertEquals(read.getCalibration().getUnit(), lazy.getCalibration().getUnit());
		assertEquals(read.getCalibration().frameInterval, lazy.getCalibration().frameInterval);
		assertArrayEquals(read.getCalibration().getCoefficients(),
			lazy.getCalibration().getCoefficients());
		assertEquals(read.getOriginalFileInfo().description,
			lazy.getOriginalFileInfo().description);
		// Backwards, so that the place of each is found by itself.
		for (int n = read.getStackSize(); n > 0; n--)
			assertArrayEquals(values(read.getStack().getProcessor(n)),
				values(lazy.getStack().getProcessor(n)), "frame " + n);
	}

	@Test
	void fileThatIsGoneIsToldAndNotTakenForDark() throws IOException {
		final Path file = movie(16, 1, 3, false);
		final ImagePlus lazy = TiffImage.open(file, Progress.NONE, NO_MEMORY);
		Files.delete(file);
		final String told = assertThrows(UserException.class, () -> lazy.getStack().getProcessor(2))
			.getMessage();
		assertTrue(told.startsWith("Frame 2 of " + file + " cannot be read"), told);
	}

	@Test
	void fileThatWasCutIsTold() throws IOException {
		final Path file = movie(16, 1, 3, false);
		final ImagePlus lazy = TiffImage.open(file, Progress.NONE, NO_MEMORY);
		Files.write(file, Arrays.copyOf(Files.readAllBytes(file), 3000));
		assertThrows(UserException.class, () -> lazy.getStack().getProcessor(3));
	}

	private Path movie(final int bits, final int channels, final int frames, final boolean intel)
		throws IOException {
		final ImagePlus image = IJ.createHyperStack("movie", 31, 22, channels, 1, frames, bits);
		final Random random = new Random(bits + frames);
		for (int n = 1; n <= image.getStackSize(); n++) {
			final ImageProcessor ip = image.getStack().getProcessor(n);
			for (int i = 0; i < ip.getPixelCount(); i++)
				ip.setf(i, random.nextInt(bits == 8 ? 256 : 65536));
		}
		image.getCalibration().pixelWidth = image.getCalibration().pixelHeight = 0.11;
		image.getCalibration().setUnit("micron");
		image.getCalibration().frameInterval = 0.5;
		final Path file = home.resolve("movie.tif");
		final boolean before = ij.Prefs.intelByteOrder;
		ij.Prefs.intelByteOrder = intel;
		try {
			assertTrue(new FileSaver(image).saveAsTiff(file.toString()));
		} finally {
			ij.Prefs.intelByteOrder = before;
		}
		return file;
	}

	private static float[] values(final ImageProcessor ip) {
		final float[] values = new float[ip.getPixelCount()];
		for (int i = 0; i < values.length; i++)
			values[i] = ip.getf(i);
		return values;
	}
}
