package io.github.knotresolver.imagej;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTimeout;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;
import java.util.function.Consumer;
import java.util.zip.DeflaterOutputStream;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import ij.ImagePlus;
import io.github.knotresolver.model.Calibration;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.options.RunOptions;
import io.github.knotresolver.progress.Progress;

/** Kinds of TIFF that ImageJ alone does not read, or reads wrong. */
class TiffKindsTest {

	private static final Path FAULTS = Path.of("../shared/data/faults");
	private static final int W = 30, H = 20, FRAMES = 3;

	@TempDir
	Path home;

	/** The sample of pixel (x, y) in frame t. */
	private static int sample(final int x, final int y, final int t) {
		return (3 * x + 5 * y + 40 * t) % 100;
	}

	private interface Sample {

		void put(ByteBuffer out, int value);
	}

	private static byte[] pixels(final int t, final int bytes, final Sample sample) {
		final ByteBuffer out = ByteBuffer.allocate(W * H * bytes).order(ByteOrder.LITTLE_ENDIAN);
		for (int y = 0; y < H; y++)
			for (int x = 0; x < W; x++)
				sample.put(out, sample(x, y, t));
		return out.array();
	}

	private Path file(final boolean big, final int bits, final Sample sample,
		final Consumer<TreeMap<Integer, long[]>> more) throws IOException {
		final TiffBuilder tiff = new TiffBuilder(big);
		for (int t = 0; t < FRAMES; t++)
			more.accept(tiff.page(W, H, bits, pixels(t, bits / 8, sample)));
		return tiff.write(home.resolve("movie.tif"));
	}

	private static void assertRead(final Path file, final int shift) {
		final Movie movie = asTime(file);
		assertEquals(FRAMES, movie.size());
		for (int t = 0; t < FRAMES; t++)
			for (int y = 0; y < H; y++)
				for (int x = 0; x < W; x++)
					assertEquals(sample(x, y, t) + shift,
						movie.frames().getAt(x, y, t).getRealDouble(), x + "," + y + "," + t);
	}

	private static Movie asTime(final Path file) {
		return ImageMovie.of(ImageFile.open(file),
			RunOptions.parse(Map.of("z_as_time", "true")).input());
	}

	private static String refusal(final Path file) {
		return assertTimeout(Duration.ofSeconds(2),
			() -> assertThrows(UserException.class, () -> ImageFile.open(file)).getMessage());
	}

	private static Consumer<TreeMap<Integer, long[]>> tag(final int tag, final long... value) {
		return tags -> tags.put(tag, value);
	}

	@ParameterizedTest
	@ValueSource(booleans = {false, true})
	void numbersOfAllKinds(final boolean big) throws IOException {
		final Sample one = (out, v) -> out.put((byte) v), two = (out, v) -> out.putShort((short) v),
			four = (out, v) -> out.putInt(v);
		assertRead(file(big, 8, one, tag(TiffBuilder.FORMAT, 1)), 0);
		assertRead(file(big, 8, (out, v) -> out.put((byte) (v - 50)), tag(TiffBuilder.FORMAT, 2)),
			78);
		assertRead(file(big, 16, two, tag(TiffBuilder.FORMAT, 1)), 0);
		assertRead(file(big, 16, two, tag(TiffBuilder.FORMAT, 2)), 32768);
		assertRead(file(big, 32, four, tag(TiffBuilder.FORMAT, 1)), 0);
		assertRead(file(big, 32, (out, v) -> out.putInt(v - 50), tag(TiffBuilder.FORMAT, 2)), -50);
		assertRead(file(big, 32, (out, v) -> out.putFloat(v), tag(TiffBuilder.FORMAT, 3)), 0);
		assertRead(file(big, 64, (out, v) -> out.putDouble(v), tag(TiffBuilder.FORMAT, 3)), 0);
	}

	@Test
	void tiles() throws IOException {
		final int edge = 16;
		final TiffBuilder tiff = new TiffBuilder(false);
		for (int t = 0; t < FRAMES; t++) {
			final List<byte[]> tiles = new ArrayList<>();
			for (int top = 0; top < H; top += edge)
				for (int left = 0; left < W; left += edge) {
					final byte[] tile = new byte[edge * edge];
					for (int k = 0; k < tile.length; k++)
						tile[k] = (byte) sample(left + k % edge, top + k / edge, t);
					tiles.add(tile);
				}
			tiff.tiled(W, H, 8, edge, tiles);
		}
		assertRead(tiff.write(home.resolve("tiles.tif")), 0);
	}

	@Test
	void deflateWithAndWithoutDifferences() throws IOException {
		assertRead(deflated(false, 0), 0);
		assertRead(deflated(true, 0), 0);
	}

	/** Floating-point numbers: bytes of equal weight together, then differences. */
	@Test
	void predictorOfFloatingPointNumbers() throws IOException {
		final TiffBuilder tiff = new TiffBuilder(false);
		for (int t = 0; t < FRAMES; t++) {
			final byte[] all = new byte[4 * W * H];
			for (int y = 0; y < H; y++) {
				final int row = 4 * W * y;
				for (int x = 0; x < W; x++) {
					final int bits = Float.floatToIntBits(sample(x, y, t));
					for (int b = 0; b < 4; b++)
						all[row + b * W + x] = (byte) (bits >> 24 - 8 * b);
				}
				for (int k = 4 * W - 1; k > 0; k--)
					all[row + k] -= all[row + k - 1];
			}
			final TreeMap<Integer, long[]> tags = tiff.page(W, H, 32, deflate(all));
			tags.put(TiffBuilder.COMPRESSION, new long[]{8});
			tags.put(TiffBuilder.PREDICTOR, new long[]{3});
			tags.put(TiffBuilder.FORMAT, new long[]{3});
		}
		assertRead(tiff.write(home.resolve("p3.tif")), 0);
	}

	private Path deflated(final boolean differences, final int missing) throws IOException {
		final TiffBuilder tiff = new TiffBuilder(false);
		for (int t = 0; t < FRAMES; t++) {
			final byte[] pixels = pixels(t, 1, (out, v) -> out.put((byte) v));
			if (differences)
				for (int k = pixels.length - 1; k > 0; k--)
					pixels[k] -= k % W == 0 ? 0 : pixels[k - 1];
			final byte[] strip = deflate(pixels);
			final TreeMap<Integer, long[]> tags = tiff.page(W, H, 8,
				Arrays.copyOf(strip, strip.length - missing));
			tags.put(TiffBuilder.COMPRESSION, new long[]{8});
			tags.put(TiffBuilder.PREDICTOR, new long[]{differences ? 2 : 1});
		}
		return tiff.write(home.resolve("deflate.tif"));
	}

	private static byte[] deflate(final byte[] bytes) throws IOException {
		final ByteArrayOutputStream out = new ByteArrayOutputStream();
		try (DeflaterOutputStream deflater = new DeflaterOutputStream(out)) {
			deflater.write(bytes);
		}
		return out.toByteArray();
	}

	@Test
	void stripThatIsCutShortIsRefused() throws IOException {
		for (final int missing : new int[]{6, 20, 100}) {
			final String message = refusal(deflated(false, missing));
			assertTrue(message.contains("is damaged: the pixels of image 1"), message);
		}
	}

	/** A type that nobody knows, and a count beyond the file: ImageJ would read on for ever. */
	@ParameterizedTest
	@ValueSource(ints = {279, 50838, 320, 270, 65535})
	void countBeyondTheFileIsRefused(final int tag) throws IOException {
		final TiffBuilder tiff = new TiffBuilder(false);
		for (int t = 0; t < FRAMES; t++)
			tiff.page(W, H, 8, pixels(t, 1, (out, v) -> out.put((byte) v))).put(tag,
				new long[]{9, 9});
		final Path file = tiff.write(home.resolve("count.tif"));
		final ByteBuffer bytes = ByteBuffer.wrap(Files.readAllBytes(file))
			.order(ByteOrder.LITTLE_ENDIAN);
		for (int i = 0; i < bytes.limit() - 12; i++)
			if (bytes.getShort(i) == (short) tag && bytes.getInt(i + 4) == 2)
				bytes.putShort(i + 2, (short) 0x1700).putInt(i + 4, 0x10401);
		Files.write(file, bytes.array());
		assertTrue(refusal(file).contains("is cut off"), refusal(file));
	}

	@ParameterizedTest
	@ValueSource(ints = {0, 1, 2})
	void listThatRunsInACircleIsRefused(final int back) throws IOException {
		final TiffBuilder tiff = new TiffBuilder(false).inACircle(back);
		for (int t = 0; t < FRAMES; t++)
			tiff.page(W, H, 8, pixels(t, 1, (out, v) -> out.put((byte) v)));
		final String message = refusal(tiff.write(home.resolve("circle.tif")));
		assertTrue(message.contains("list of images runs in a circle"), message);
	}

	/** Palettes are sorted by how often a colour comes, not by its grey value. */
	@Test
	void numbersOfAPaletteBecomeItsGreyValues() throws IOException {
		final long[] map = new long[768];
		for (int i = 0; i < 256; i++)
			map[i] = map[256 + i] = map[512 + i] = 257L * (255 - i);
		final Path file = file(false, 8, (out, v) -> out.put((byte) (255 - v)), tags -> {
			tags.put(TiffBuilder.PHOTOMETRIC, new long[]{3});
			tags.put(TiffBuilder.COLOUR_MAP, map);
		});
		assertRead(file, 0);
		final String few = refusal(file(false, 8, (out, v) -> out.put((byte) v), tags -> {
			tags.put(TiffBuilder.PHOTOMETRIC, new long[]{3});
			tags.put(TiffBuilder.COLOUR_MAP, new long[30]);
		}));
		assertTrue(few.contains("its palette has 10 colours, not one for each of its 256"), few);
		map[3] = 5;
		final String message = refusal(file(false, 8, (out, v) -> out.put((byte) v), tags -> {
			tags.put(TiffBuilder.PHOTOMETRIC, new long[]{3});
			tags.put(TiffBuilder.COLOUR_MAP, map);
		}));
		assertTrue(message.contains("palette of colours"), message);
	}

	@Test
	void thumbnailsAreNoFramesAndOtherSizesAreNamed() throws IOException {
		final Path file = withSmallPages(1);
		assertRead(file, 0);
		final String message = refusal(withSmallPages(0));
		assertTrue(message.contains("image 2 is 5 x 4 of 8 bit, the first 30 x 20"), message);
	}

	private Path withSmallPages(final int subfileType) throws IOException {
		final TiffBuilder tiff = new TiffBuilder(false);
		for (int t = 0; t < FRAMES; t++) {
			tiff.page(W, H, 8, pixels(t, 1, (out, v) -> out.put((byte) v)));
			tiff.page(5, 4, 8, new byte[20]).put(TiffBuilder.SUBFILE_TYPE, new long[]{subfileType});
		}
		return tiff.write(home.resolve("small.tif"));
	}

	@ParameterizedTest
	@CsvSource(delimiter = '|', value = {"259|50000|is compressed with Zstandard",
		"259|34925|is compressed with LZMA", "259|34712|is compressed with JPEG 2000",
		"259|4711|is compressed with method 4711", "339|6|holds complex numbers",
		"258|64|holds whole numbers of 64 bit"})
	void reasonIsTheTrueOne(final int tag, final long value, final String reason)
		throws IOException {
		final String message = refusal(
			file(false, 64, (out, v) -> out.putLong(v), tag(tag, value)));
		assertTrue(message.contains(reason), message);
	}

	@Test
	void channelsInPlaceOfFramesAreSaidAndReadIfTold() throws IOException {
		final Path file = described("ImageJ=1.54p\nimages=3\nchannels=3\nhyperstack=true\n");
		final String message = assertThrows(UserException.class,
			() -> ImageMovie.of(ImageFile.open(file), RunOptions.parse(Map.of()).input()))
			.getMessage();
		assertTrue(
			message.contains("3 channels and one frame") && message.contains("add z_as_time"),
			message);
		assertRead(file, 0);
	}

	/** A file that says nothing of its images, or nothing that is known. */
	@ParameterizedTest
	@ValueSource(strings = {"", "made by a camera", "ImageJ=1.54p\nimages=3\n",
		"{'shape': [3, 20, 30]}", "{'shape': [3, 20, 30], 'axes': 'QYX'}"})
	void imagesOfWhichNothingIsToldAreFrames(final String description) throws IOException {
		final ImageSource source = ImageSource.of(described(description.replace('\'', '"')));
		assertEquals(FRAMES, source.read(RunOptions.parse(Map.of()).input(), Progress.NONE).size());
		assertEquals(List.of(
			"'described.tif' does not say what its 3 images are; they are read as frames, in their order."),
			source.notes());
	}

	@ParameterizedTest
	@ValueSource(strings = {"ImageJ=1.54p\nimages=3\nslices=3\n",
		"{'shape': [3, 20, 30], 'axes': 'ZYX'}"})
	void slicesThatAreToldAreNoFrames(final String description) throws IOException {
		final ImageSource source = ImageSource.of(described(description.replace('\'', '"')));
		final String message = assertThrows(UserException.class,
			() -> source.read(RunOptions.parse(Map.of()).input(), Progress.NONE)).getMessage();
		assertTrue(message.contains("is a Z-stack of 3 slices"), message);
		assertRead(home.resolve("described.tif"), 0);
	}

	private Path described(final String description) throws IOException {
		final TiffBuilder tiff = new TiffBuilder(false).described(description);
		for (int t = 0; t < FRAMES; t++)
			tiff.page(W, H, 8, pixels(t, 1, (out, v) -> out.put((byte) v)));
		return tiff.write(home.resolve("described.tif"));
	}

	@Test
	void framesThatAreMissingAreMissed() throws IOException {
		final String message = refusal(described("ImageJ=1.54p\nimages=40\nframes=40\n"));
		assertTrue(message.contains("tells of 40 images, but holds 3"), message);
		final ImagePlus image = TestImages.movie(4, 8);
		final Path file = TestImages.save(image, home.resolve("movie.tif"));
		final ImagePlus opened = ImageFile.open(file);
		opened.getStack().deleteLastSlice();
		opened.setStack(opened.getStack());
		opened.setDimensions(1, 1, 3);
		opened.changes = false;
		final String shown = assertThrows(UserException.class,
			() -> ImageMovie.of(opened, RunOptions.parse(Map.of()).input())).getMessage();
		assertTrue(shown.contains("has 3 of the 4 frames of its file"), shown);
	}

	@Test
	void movieLargerThanTheMemoryIsRefusedBeforeItIsRead() throws IOException {
		final TiffBuilder tiff = new TiffBuilder(false);
		final byte[] strip = deflate(new byte[100]);
		for (int t = 0; t < 1000; t++)
			tiff.page(30_000, 30_000, 8, strip).put(TiffBuilder.COMPRESSION, new long[]{8});
		final String message = refusal(tiff.write(home.resolve("huge.tif")));
		assertTrue(message.contains("not enough memory") && message.contains("858307 MB"), message);
	}

	@ParameterizedTest
	@CsvSource({"XYCZT,1,1,3,''", "XYZTC,1,1,3,''", "XYTZC,3,1,1,''", "XYCZT,1,3,1,''",
		"XYCZT,1,1,3,<TiffData FirstT='2' IFD='0'/><TiffData FirstT='0' IFD='1'/><TiffData FirstT='1' IFD='2'/>"})
	void omeTellsAxesAndUnits(final String order, final int c, final int z, final int t,
		final String data) throws IOException {
		final Path file = described(ome(order, c, z, t, data));
		final ImagePlus image = ImageFile.open(file);
		assertEquals(List.of(c, z, t),
			List.of(image.getNChannels(), image.getNSlices(), image.getNFrames()));
		assertEquals(new Calibration(0.106, "µm", 0.25, "s"), ImageCalibration.of(image));
		if (data.isEmpty())
			return;
		for (int k = 0; k < FRAMES; k++)
			assertEquals(sample(1, 1, (k + 1) % 3), image.getStack().getProcessor(k + 1).get(1, 1));
	}

	private static String ome(final String order, final int c, final int z, final int t,
		final String data) {
		return "<?xml version='1.0' encoding='UTF-8'?><OME xmlns='http://www.openmicroscopy.org/Schemas/OME/2016-06'>"
			+ "<Image ID='Image:0'><Pixels ID='Pixels:0' Type='uint8' SizeX='30' SizeY='20' DimensionOrder='"
			+ order + "' SizeC='" + c + "' SizeZ='" + z + "' SizeT='" + t
			+ "' PhysicalSizeX='106' PhysicalSizeY='106' PhysicalSizeXUnit='nm' TimeIncrement='250' TimeIncrementUnit='ms'>"
				.replace("'106'", "'0.106'").replace("'nm'", "'\u00b5m'")
			+ data + "</Pixels></Image></OME>";
	}

	/** Each pixel of channel c and frame t has the value 10 t + c. */
	@Test
	void planesOfChannelsAreTakenApart() throws IOException {
		final TiffBuilder tiff = new TiffBuilder(true).described(ome("XYTCZ", 2, 1, 3, ""));
		for (int c = 0; c < 2; c++)
			for (int t = 0; t < FRAMES; t++) {
				final byte[] plane = new byte[W * H];
				Arrays.fill(plane, (byte) (10 * t + c));
				plane[0] = 99;
				tiff.page(W, H, 8, plane);
			}
		final Movie second = ImageMovie.of(ImageFile.open(tiff.write(home.resolve("ct.ome.tif"))),
			RunOptions.parse(Map.of("channel", "2")).input());
		for (int t = 0; t < FRAMES; t++)
			assertEquals(10 * t + 1, second.frames().getAt(2, 2, t).getRealDouble());
	}

	@ParameterizedTest
	@CsvSource(delimiter = '|', value = {
		"XYCZT|1|1|9||has 3 planes, but its OME metadata tell of 1 channels, 1 slices and 9 frames",
		"XY|1|1|3||without the order of its axes", "XYCZT|1|1|3|<broken|cannot be read"})
	void omeThatDoesNotFitIsRefused(final String order, final int c, final int z, final int t,
		final String data, final String reason) throws IOException {
		final String message = refusal(described(ome(order, c, z, t, data == null ? "" : data)));
		assertTrue(message.contains(reason), message);
	}

	/** What is outside of the file is not read, whatever its XML says. */
	@Test
	void entitiesAreNotFollowed() throws IOException {
		final Path secret = Files.writeString(home.resolve("secret.txt"), "XYCZT");
		final String xml = ome("&x;", 1, 1, 3, "").replace("<OME",
			"<!DOCTYPE OME [<!ENTITY x SYSTEM '" + secret.toUri() + "'>]><OME");
		final String message = refusal(described(xml));
		assertTrue(message.contains("OME metadata that cannot be read"), message);
	}

	/** One byte changed, anywhere: an image or a sentence, soon. */
	@Test
	void damagedFilesAreReadOrRefused() throws IOException {
		final byte[] whole = Files.readAllBytes(deflated(true, 0));
		final Path file = home.resolve("damaged.tif");
		for (long seed = 0; seed < 400; seed++) {
			final Random random = new Random(seed);
			final byte[] bytes = whole.clone();
			for (int k = random.nextInt(3); k >= 0; k--)
				bytes[random.nextInt(bytes.length)] = (byte) random.nextInt(256);
			Files.write(file, bytes);
			assertTimeout(Duration.ofSeconds(5), () -> {
				try {
					ImageFile.open(file);
				} catch (final UserException e) {
					assertTrue(e.getMessage().contains("damaged.tif"), e.getMessage());
				}
			}, "seed " + seed);
		}
	}

	@ParameterizedTest
	@ValueSource(strings = {"f64.tif", "tiled.tif", "big.tif", "i8.tif", "int32.tif", "palette.tif",
		"ome.ome.tif", "as-channels.tif"})
	void kindsOfOthersAreRead(final String name) {
		final Path file = FAULTS.resolve(name);
		assumeTrue(Files.exists(file), "There is no " + file + " beside the checkout.");
		final boolean channels = name.equals("int32.tif") || name.equals("as-channels.tif");
		final Movie movie = channels
			? asTime(file)
			: ImageMovie.of(ImageFile.open(file), RunOptions.parse(Map.of()).input());
		assertEquals(name.equals("int32.tif") ? 4 : 24, movie.size());
	}

	@ParameterizedTest
	@CsvSource(delimiter = '|', value = {"c-zstd.tif|compressed with Zstandard",
		"loop_ifd.tif|runs in a circle", "truncated-deflate.tif|the pixels of image 2 end"})
	void damagedFilesOfOthersAreRefused(final String name, final String reason) {
		final Path file = FAULTS.resolve(name);
		assumeTrue(Files.exists(file), "There is no " + file + " beside the checkout.");
		final String message = refusal(file);
		assertTrue(message.contains(reason), message);
	}
}
