package io.github.knotresolver.imagej.tiff;

import java.awt.image.Raster;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;

import javax.imageio.IIOException;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;

import com.twelvemonkeys.imageio.plugins.tiff.TIFFImageReaderSpi;
import com.twelvemonkeys.imageio.stream.BufferedFileImageInputStreamSpi;

import ij.ImageStack;
import ij.process.ByteProcessor;
import ij.process.FloatProcessor;
import ij.process.ImageProcessor;
import ij.process.ShortProcessor;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.progress.Progress;

/**
 * The pixels of a TIFF, read by TwelveMonkeys ImageIO: tiles, compressions, BigTIFF.
 * Samples up to 8 bit become 8 bit, up to 16 bit 16 bit, all others 32-bit
 * floating point. Signed ones are shifted to start at 0, as ImageJ does; numbers of a
 * palette become its grey values.
 */
final class TiffPixels {

	private static final int BYTE = 8, SHORT = 16, TOP_BYTE = 8;

	private final Path path;
	private final TiffPage page;
	private final byte[] palette;

	/**
	 * @param path the file
	 * @param page any of its frames, which all are of one kind
	 * @throws UserException if its palette has colours, or too few numbers
	 */
	TiffPixels(final Path path, final TiffPage page) {
		this.path = path;
		this.page = page;
		this.palette = page.photometric() == TiffPage.PALETTE
			&& !page.description().startsWith("ImageJ=") ? greys() : null;
	}

	private byte[] greys() {
		final long[] map = page.values(TiffPage.COLOUR_MAP);
		final int n = map.length / 3;
		if (n < 1L << page.bits())
			throw TiffStructure.damaged(path, "its palette has " + n
				+ " colours, not one for each of its " + (1L << page.bits()) + " numbers");
		final byte[] greys = new byte[n];
		for (int i = 0; i < n; i++) {
			if (map[i] != map[n + i] || map[i] != map[2 * n + i])
				throw new UserException(path
					+ " has a palette of colours, so its numbers are no intensities; save it as grey values (in ImageJ: Image > Type > RGB Color, then 8-bit).");
			greys[i] = (byte) (map[i] >> TOP_BYTE);
		}
		return greys;
	}

	/**
	 * @param frames indices of the images to read
	 * @param progress may cancel
	 * @return one plane for each image and sample, samples of an image in a row
	 * @throws UserException if an image is damaged, or its kind is not read
	 * @throws IOException if the file cannot be read
	 */
	ImageStack read(final List<Integer> frames, final Progress progress) throws IOException {
		final ImageStack stack = new ImageStack((int) page.width(), (int) page.height());
		final ImageReader reader = new TIFFImageReaderSpi().createReaderInstance(null);
		try (ImageInputStream in = new BufferedFileImageInputStreamSpi()
			.createInputStreamInstance(path.toFile(), false, null)) {
			reader.setInput(in);
			for (final int i : frames) {
				progress.checkCancelled();
				progress.report("Reading", (double) stack.size() / frames.size());
				add(raster(reader, i), stack);
			}
			return stack;
		} finally {
			reader.dispose();
		}
	}

	private Raster raster(final ImageReader reader, final int i) throws IOException {
		try {
			return reader.canReadRaster() ? reader.readRaster(i, null) : reader.read(i).getRaster();
		} catch (final IIOException e) {
			throw new UserException(path + " is of a kind that is not read here: " + e.getMessage()
				+ "; save it as a TIFF stack without compression.", e);
		} catch (final IOException | RuntimeException e) {
			throw TiffStructure.damaged(path, "the pixels of image " + (i + 1)
				+ " end or change their kind before they are complete");
		}
	}

	private void add(final Raster raster, final ImageStack stack) {
		final boolean colour = page.photometric() == TiffPage.RGB && page.bits() == BYTE
			&& raster.getNumBands() == 3;
		if (colour) {
			requireGrey(raster);
			stack.addSlice(plane(raster, 0));
			return;
		}
		for (int band = 0; band < raster.getNumBands(); band++)
			stack.addSlice(plane(raster, band));
	}

	private void requireGrey(final Raster raster) {
		final int[] row = new int[3 * raster.getWidth()];
		for (int y = 0; y < raster.getHeight(); y++) {
			raster.getPixels(0, y, raster.getWidth(), 1, row);
			for (int x = 0; x < row.length; x += 3)
				if (row[x] != row[x + 1] || row[x] != row[x + 2])
					throw new UserException(path
						+ " is an RGB image, but intensities are needed; convert it with Image > Type > 8-bit, or take one channel with Image > Color > Split Channels.");
		}
	}

	private ImageProcessor plane(final Raster raster, final int band) {
		final int w = raster.getWidth(), h = raster.getHeight();
		if (page.format() == TiffPage.FLOAT || page.bits() > SHORT)
			return floats(raster, band, w, h);
		final ImageProcessor ip = page.bits() <= BYTE
			? new ByteProcessor(w, h)
			: new ShortProcessor(w, h);
		final int[] row = new int[w];
		for (int y = 0; y < h; y++) {
			raster.getSamples(0, y, w, 1, band, row);
			for (int x = 0; x < w; x++)
				ip.set(x, y, unsigned(row[x]));
		}
		return ip;
	}

	private int unsigned(final int sample) {
		if (palette != null)
			return palette[sample & (1 << page.bits()) - 1] & 0xff;
		if (page.format() != TiffPage.SIGNED)
			return page.bits() == 1 ? 0xff * (sample & 1) : sample;
		return page.bits() <= BYTE ? (byte) sample + 128 : (short) sample + 32768;
	}

	private FloatProcessor floats(final Raster raster, final int band, final int w, final int h) {
		final float[] pixels = new float[w * h];
		if (page.format() == TiffPage.FLOAT) {
			raster.getSamples(0, 0, w, h, band, pixels);
			return new FloatProcessor(w, h, pixels);
		}
		final int[] row = new int[w];
		for (int y = 0; y < h; y++) {
			raster.getSamples(0, y, w, 1, band, row);
			for (int x = 0; x < w; x++)
				pixels[y * w + x] = page.format() == TiffPage.SIGNED
					? row[x]
					: Integer.toUnsignedLong(row[x]);
		}
		return new FloatProcessor(w, h, pixels);
	}
}
