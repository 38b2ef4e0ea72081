package io.github.knotresolver.imagej;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Map;
import java.util.function.BiFunction;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import ij.IJ;
import ij.ImagePlus;
import ij.VirtualStack;
import ij.process.ImageProcessor;
import ij.process.ShortProcessor;
import io.github.knotresolver.model.Calibration;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.options.InputOptions;
import io.github.knotresolver.options.RunOptions;

class ImageMovieTest {

	@TempDir
	Path home;

	@ParameterizedTest
	@ValueSource(ints = {8, 16, 32})
	void everyBitDepthKeepsItsPixelsAndCalibration(final int bits) {
		final ImagePlus image = TestImages.movie(4, bits);
		final Movie movie = ImageMovie.of(
			ImageFile.open(TestImages.save(image, home.resolve("m.tif"))), InputOptions.DEFAULT);
		assertEquals(new Calibration(0.25, "µm", 2, "s"), movie.calibration());
		assertEquals("m.tif", movie.name());
		assertSamePixels(image, 0, movie);
	}

	@Test
	void oneChannelOfAHyperstackIsTaken() {
		final ImagePlus image = IJ.createHyperStack("two", 6, 5, 2, 1, 3, 16);
		for (int c = 1; c <= 2; c++)
			for (int t = 1; t <= 3; t++)
				image.getStack().getProcessor(image.getStackIndex(c, 1, t)).set(c, t, 100 * c + t);
		final Movie movie = ImageMovie.of(image, RunOptions.parse(Map.of("channel", "2")).input());
		assertEquals(3, movie.size());
		for (int t = 1; t <= 3; t++) {
			assertEquals(200 + t, movie.frames().getAt(2, t, t - 1).getRealDouble());
			assertEquals(0, movie.frames().getAt(1, t, t - 1).getRealDouble());
		}
	}

	@Test
	void virtualStackIsReadAsAnyOther() {
		assertVirtualStackIsRead(ShortProcessor::new);
	}

	/** As some readers do: one array for all frames. */
	@Test
	void virtualStackMayUseItsArrayAgain() {
		final ShortProcessor one = new ShortProcessor(7, 5);
		assertVirtualStackIsRead((width, height) -> {
			one.setValue(0);
			one.fill();
			return one;
		});
	}

	private static void assertVirtualStackIsRead(
		final BiFunction<Integer, Integer, ShortProcessor> blank) {
		final ImagePlus image = new ImagePlus("virtual", new VirtualStack(7, 5, 3) {

			@Override
			public ImageProcessor getProcessor(final int n) {
				final ShortProcessor ip = blank.apply(7, 5);
				ip.set(n, n, 1000 * n);
				return ip;
			}

			@Override
			public int getBitDepth() {
				return 16;
			}
		});
		image.setDimensions(1, 1, 3);
		final Movie movie = ImageMovie.of(image, InputOptions.DEFAULT);
		for (int n = 1; n <= 3; n++)
			assertEquals(1000 * n, movie.frames().getAt(n, n, n - 1).getRealDouble());
	}

	@Test
	void rgbIsRefusedWithAdvice() {
		final ImagePlus image = IJ.createHyperStack("rgb", 5, 5, 1, 1, 3, 24);
		image.getStack().getProcessor(2).set(1, 1, 0xff0000);
		assertRefused("convert it with Image > Type > 8-bit", image, InputOptions.DEFAULT);
	}

	@Test
	void uncalibratedImageGivesPixelsAndFrames() {
		final ImagePlus image = TestImages.movie(3, 8);
		image.setCalibration(new ij.measure.Calibration());
		image.getCalibration().fps = 7;
		assertEquals(Calibration.NONE, ImageMovie.of(image, InputOptions.DEFAULT).calibration());
	}

	@Test
	void pixelsThatAreNotSquareAreRefused() {
		final ImagePlus image = TestImages.movie(3, 8);
		image.getCalibration().pixelHeight = 0.5;
		assertRefused("must be square", image, InputOptions.DEFAULT);
	}

	@Test
	void zStackIsReadAsTimeOnlyIfTold() {
		final ImagePlus image = TestImages.movie(4, 8);
		image.setDimensions(1, 4, 1);
		assertRefused("Z-stack of 4 slices", image, InputOptions.DEFAULT);
		assertSamePixels(image, 0,
			ImageMovie.of(image, RunOptions.parse(Map.of("z_as_time", "true")).input()));
	}

	@Test
	void framesOfNothingAreRefusedOnlyIfAllAre() {
		final ImagePlus image = IJ.createHyperStack("flat", 5, 5, 1, 1, 3, 32);
		assertRefused("equal in every frame", image, InputOptions.DEFAULT);
		image.getStack().getProcessor(1).setf(2, 2, Float.NaN);
		assertRefused("equal in every frame", image, InputOptions.DEFAULT);
		image.getStack().getProcessor(3).setf(2, 2, 1);
		assertEquals(3, ImageMovie.of(image, InputOptions.DEFAULT).size());
	}

	/** Directories spread over the file, as other programs write them. */
	@Test
	void fileCutOffAnywhereIsRefused() throws IOException {
		final byte[] whole = pageByPage(5, 40);
		final Path file = home.resolve("pages.tif");
		Files.write(file, whole);
		assertEquals(5, ImageFile.open(file).getStackSize());
		for (int length = 9; length < whole.length; length += 7) {
			Files.write(file, Arrays.copyOf(whole, length));
			final String message = assertThrows(UserException.class, () -> ImageFile.open(file))
				.getMessage();
			assertTrue(message.contains("is cut off") || message.contains("not an image"),
				length + ": " + message);
		}
	}

	private static byte[] pageByPage(final int pages, final int size) {
		final int directory = 2 + 8 * 12 + 4, page = directory + size * size;
		final ByteBuffer b = ByteBuffer.allocate(8 + pages * page).order(ByteOrder.LITTLE_ENDIAN);
		b.put((byte) 'I').put((byte) 'I').putShort((short) 42).putInt(8);
		for (int i = 0; i < pages; i++) {
			final int start = b.position();
			b.putShort((short) 8);
			final int[][] entries = {{256, size}, {257, size}, {258, 8}, {259, 1}, {262, 1},
				{273, start + directory}, {278, size}, {279, size * size}};
			for (final int[] entry : entries)
				b.putShort((short) entry[0]).putShort((short) 4).putInt(1).putInt(entry[1]);
			b.putInt(i == pages - 1 ? 0 : start + page);
			for (int k = 0; k < size * size; k++)
				b.put((byte) (k * (i + 1)));
		}
		return b.array();
	}

	private static void assertRefused(final String sentence, final ImagePlus image,
		final InputOptions options) {
		final String message = assertThrows(UserException.class,
			() -> ImageMovie.of(image, options)).getMessage();
		assertTrue(message.contains(sentence), message);
	}

	private static void assertSamePixels(final ImagePlus image, final int channel,
		final Movie movie) {
		assertArrayEquals(new long[]{image.getWidth(), image.getHeight(), image.getStackSize()},
			movie.frames().dimensionsAsLongArray());
		for (int t = 0; t < movie.size(); t++)
			for (int y = 0; y < movie.height(); y++)
				for (int x = 0; x < movie.width(); x++)
					assertEquals(image.getStack().getProcessor(t + 1).getf(x, y),
						movie.frames().getAt(x, y, t).getRealDouble());
	}
}
