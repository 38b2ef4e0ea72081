package io.github.knotresolver.imagej;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.awt.image.IndexColorModel;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.concurrent.CountDownLatch;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;

import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageTypeSpecifier;
import javax.imageio.ImageWriter;
import javax.imageio.metadata.IIOMetadata;
import javax.imageio.metadata.IIOMetadataNode;
import javax.imageio.stream.ImageOutputStream;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import ij.ImagePlus;
import ij.io.FileSaver;
import ij.plugin.GifWriter;
import ij.plugin.filter.AVI_Writer;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.options.InputOptions;
import io.github.knotresolver.progress.CancelledException;
import io.github.knotresolver.progress.Progress;

/** Films, and folders with one image a frame, as dragging them onto ImageJ opens them. */
class ImageFolderTest {

	private static final int FRAMES = 11;

	@TempDir
	Path home;

	private final ImagePlus image = TestImages.movie(FRAMES, 8);

	/** Names whose order as text is not that of their numbers. */
	private Path folder(final String ending, final boolean rgb) {
		for (int t = 1; t <= FRAMES; t++) {
			final var ip = image.getStack().getProcessor(t);
			final FileSaver saver = new FileSaver(
				new ImagePlus("frame", rgb ? ip.convertToRGB() : ip));
			final String name = home.resolve("t" + t + "." + ending).toString();
			assertTrue(switch (ending) {
				case "png" -> saver.saveAsPng(name);
				case "jpg" -> saver.saveAsJpeg(name);
				default -> saver.saveAsTiff(name);
			});
		}
		return home;
	}

	@ParameterizedTest
	@ValueSource(strings = {"png", "png rgb", "jpg", "tif"})
	void folderIsAMovieInTheOrderOfItsNumbers(final String kind) throws IOException {
		final Path folder = folder(kind.split(" ")[0], kind.endsWith("rgb"));
		Files.writeString(folder.resolve("notes.txt"), "not an image");
		assertMovie(ImageFile.open(folder), kind.equals("jpg") ? 60 : 0);
		assertEquals(folder.toRealPath(),
			ImageFile.of(ImageFile.open(folder)).orElseThrow().toRealPath());
	}

	@ParameterizedTest
	@ValueSource(ints = {AVI_Writer.NO_COMPRESSION, AVI_Writer.JPEG_COMPRESSION,
		AVI_Writer.PNG_COMPRESSION})
	void aviIsATimeSeries(final int compression) throws IOException {
		final Path file = home.resolve("m.avi");
		new AVI_Writer().writeImage(image, file.toString(), compression, 95);
		assertMovie(ImageFile.open(file), compression == AVI_Writer.JPEG_COMPRESSION ? 80 : 0);
	}

	@Test
	void zipHoldsOneTiff() throws IOException {
		final Path file = home.resolve("m.zip");
		assertTrue(new FileSaver(image).saveAsZip(file.toString()));
		final ImagePlus opened = ImageFile.open(file);
		assertMovie(opened, 0);
		assertEquals("m.zip", opened.getTitle());
		assertEquals(file.toRealPath(), ImageFile.of(opened).orElseThrow().toRealPath());
		final byte[] whole = Files.readAllBytes(file);
		whole[whole.length / 2] ^= 0x55;
		Files.write(file, whole);
		assertTrue(refusal(file).contains(file + " is damaged"), refusal(file));
		try (ZipOutputStream zip = new ZipOutputStream(Files.newOutputStream(file))) {
			zip.putNextEntry(new ZipEntry("notes.txt"));
		}
		assertTrue(refusal(file).contains("holds 0 TIFF files"), refusal(file));
	}

	/** ImageJ's reader gives back the frames before the cut. */
	@Test
	void aviThatIsCutOffIsRefused() throws IOException {
		final Path file = home.resolve("m.avi");
		new AVI_Writer().writeImage(image, file.toString(), AVI_Writer.NO_COMPRESSION, 0);
		final byte[] whole = Files.readAllBytes(file);
		for (final double part : new double[]{0.98, 0.7, 0.4, 0.05}) {
			Files.write(file, Arrays.copyOf(whole, (int) (part * whole.length)));
			final String message = refusal(file);
			assertTrue(message.contains("cannot be read to its end"), message);
		}
	}

	@Test
	void gifThatIsCutOffIsRefused() throws IOException {
		final Path file = home.resolve("m.gif");
		GifWriter.save(image, file.toString());
		final byte[] whole = Files.readAllBytes(file);
		for (final double part : new double[]{0.98, 0.7, 0.4, 0.05}) {
			Files.write(file, Arrays.copyOf(whole, (int) (part * whole.length)));
			final String message = refusal(file);
			assertTrue(message.contains("is damaged"), message);
		}
	}

	@Test
	void gifIsATimeSeries() {
		final Path file = home.resolve("m.gif");
		GifWriter.save(image, file.toString());
		assertMovie(ImageFile.open(file), 0);
	}

	/** Each frame holds only a part, with a palette of its own, as many programs write them. */
	@Test
	void gifOfWhatChangedIsPutTogether() throws IOException {
		final Path file = home.resolve("m.gif");
		final ImageWriter writer = ImageIO.getImageWritersByFormatName("gif").next();
		try (ImageOutputStream out = ImageIO.createImageOutputStream(file.toFile())) {
			writer.setOutput(out);
			writer.prepareWriteSequence(null);
			for (int t = 1; t <= FRAMES; t++)
				writePart(writer, t, t == 1 ? 0 : 7);
			writer.endWriteSequence();
		}
		for (int t = 2; t <= FRAMES; t++)
			for (int y = 0; y < image.getHeight(); y++)
				for (int x = 0; x < 7; x++)
					image.getStack().getProcessor(t).set(x, y,
						image.getStack().getProcessor(1).get(x, y));
		assertMovie(ImageFile.open(file), 0);
	}

	/** The columns from the left one on, in a palette that is turned by the frame's number. */
	private void writePart(final ImageWriter writer, final int t, final int left)
		throws IOException {
		final byte[] turned = new byte[256];
		for (int i = 0; i < 256; i++)
			turned[i] = (byte) (i + 31 * t);
		final BufferedImage part = new BufferedImage(image.getWidth() - left, image.getHeight(),
			BufferedImage.TYPE_BYTE_INDEXED, new IndexColorModel(8, 256, turned, turned, turned));
		for (int y = 0; y < image.getHeight(); y++)
			for (int x = left; x < image.getWidth(); x++)
				part.getRaster().setSample(x - left, y, 0,
					image.getStack().getProcessor(t).get(x, y) - 31 * t & 0xff);
		final IIOMetadata metadata = writer.getDefaultImageMetadata(new ImageTypeSpecifier(part),
			null);
		final IIOMetadataNode root = (IIOMetadataNode) metadata
			.getAsTree("javax_imageio_gif_image_1.0");
		((IIOMetadataNode) root.getElementsByTagName("ImageDescriptor").item(0))
			.setAttribute("imageLeftPosition", "" + left);
		metadata.setFromTree("javax_imageio_gif_image_1.0", root);
		writer.writeToSequence(new IIOImage(part, null, metadata), null);
	}

	private void assertMovie(final ImagePlus opened, final double tolerance) {
		final Movie movie = ImageMovie.of(opened, InputOptions.DEFAULT);
		assertEquals(FRAMES, movie.size());
		for (int t = 0; t < FRAMES; t++)
			for (int y = 0; y < image.getHeight(); y++)
				for (int x = 0; x < image.getWidth(); x++)
					assertEquals(image.getStack().getProcessor(t + 1).get(x, y),
						movie.frames().getAt(x, y, t).getRealDouble(), tolerance,
						x + "," + y + "," + t);
	}

	/** As other programs write them: numbers of a palette in any order. */
	@Test
	void numbersOfAPaletteBecomeGreyValues() throws IOException {
		final byte[] down = new byte[256];
		for (int i = 0; i < 256; i++)
			down[i] = (byte) (255 - i);
		for (int t = 1; t <= FRAMES; t++) {
			final BufferedImage picture = new BufferedImage(image.getWidth(), image.getHeight(),
				BufferedImage.TYPE_BYTE_INDEXED, new IndexColorModel(8, 256, down, down, down));
			for (int y = 0; y < image.getHeight(); y++)
				for (int x = 0; x < image.getWidth(); x++)
					picture.getRaster().setSample(x, y, 0,
						255 - image.getStack().getProcessor(t).get(x, y));
			ImageIO.write(picture, "png", home.resolve("t" + t + ".png").toFile());
		}
		assertMovie(ImageFile.open(home), 0);
	}

	/** Readers fill up what is missing. */
	@ParameterizedTest
	@ValueSource(strings = {"png", "jpg", "pgm", "bmp"})
	void pictureThatIsCutOffIsRefused(final String ending) throws IOException {
		final Path file = home.resolve("t1." + ending);
		final FileSaver saver = new FileSaver(new ImagePlus("frame", image.getProcessor()));
		assertTrue(switch (ending) {
			case "png" -> saver.saveAsPng(file.toString());
			case "jpg" -> saver.saveAsJpeg(file.toString());
			case "pgm" -> saver.saveAsPgm(file.toString());
			default -> saver.saveAsBmp(file.toString());
		});
		final byte[] whole = Files.readAllBytes(file);
		assertEquals(image.getWidth(), ImageFile.open(file).getWidth());
		for (final double part : new double[]{0.9, 0.7, 0.4}) {
			Files.write(file, Arrays.copyOf(whole, (int) (part * whole.length)));
			final String message = refusal(file);
			assertTrue(message.contains("damaged") || message.contains("cut off"), message);
		}
	}

	@Test
	void frameThatDoesNotFitIsNamed() {
		final Path folder = folder("png", false);
		new FileSaver(new ImagePlus("other", image.getProcessor().resize(10)))
			.saveAsPng(folder.resolve("t5.png").toString());
		final String message = refusal(folder);
		assertTrue(message.contains("t5.png is 10 x 7 of 8 bit, the first 80 x 60"), message);
	}

	@Test
	void colourAndEmptyFoldersAreRefused() throws IOException {
		assertTrue(
			refusal(Files.createDirectory(home.resolve("empty"))).contains("without images"));
		final Path folder = folder("png", true);
		final var ip = image.getProcessor().convertToRGB();
		ip.set(3, 3, 0xff0000);
		new FileSaver(new ImagePlus("red", ip)).saveAsPng(folder.resolve("t3.png").toString());
		final String message = refusal(folder);
		assertTrue(message.contains("t3.png is 80 x 60 of 24 bit"), message);
	}

	private static String refusal(final Path path) {
		return assertThrows(UserException.class, () -> ImageFile.open(path)).getMessage();
	}

	/** Whatever a reader does with a file, a person can stop it. */
	@Test
	void readerThatDoesNotEndIsLeft() {
		final CountDownLatch started = new CountDownLatch(1);
		final Progress cancelled = new Progress() {

			@Override
			public void report(final String stage, final double fraction) {
			}

			@Override
			public boolean isCancelled() {
				return started.getCount() == 0;
			}
		};
		assertThrows(CancelledException.class, () -> QuietImageJ.call(() -> {
			started.countDown();
			while (!Thread.currentThread().isInterrupted())
				Thread.onSpinWait();
			return null;
		}, cancelled));
	}
}
