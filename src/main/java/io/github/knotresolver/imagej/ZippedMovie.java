package io.github.knotresolver.imagej;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.zip.ZipEntry;
import java.util.zip.ZipException;
import java.util.zip.ZipFile;

import ij.ImagePlus;
import io.github.knotresolver.imagej.tiff.TiffImage;
import io.github.knotresolver.imagej.tiff.TiffStructure;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.progress.Progress;

/** A TIFF in a zip file, as ImageJ's {@code File > Save As > ZIP} writes it. */
final class ZippedMovie {

	private static final int BUFFER = 1 << 16;

	private ZippedMovie() {
	}

	/**
	 * @param file a zip file
	 * @param progress may cancel
	 * @return the movie in it
	 * @throws UserException if there is not just one TIFF in it, or it is damaged
	 * @throws IOException if it cannot be read
	 */
	static ImagePlus open(final Path file, final Progress progress) throws IOException {
		final Path tiff = Files.createTempFile("knotresolver", ".tif");
		try (ZipFile zip = new ZipFile(file.toFile())) {
			unpack(zip, only(file, zip), tiff, progress);
			if (!TiffStructure.isTiff(tiff))
				throw new UserException(
					file + " holds a file that is no TIFF; save the movie as a TIFF stack.");
			final ImagePlus image = TiffImage.open(tiff, progress);
			image.setTitle(file.getFileName().toString());
			return image;
		} catch (final ZipException e) {
			throw new UserException(
				file + " is damaged (" + e.getMessage() + "); copy the file again from its source.",
				e);
		} catch (final UserException e) {
			throw new UserException(e.getMessage().replace(tiff.toString(), file.toString()), e);
		} finally {
			Files.deleteIfExists(tiff);
		}
	}

	private static ZipEntry only(final Path file, final ZipFile zip) {
		final List<? extends ZipEntry> tiffs = zip.stream()
			.filter(e -> e.getName().toLowerCase(Locale.ROOT).matches(".*\\.tiff?")).toList();
		if (tiffs.size() != 1)
			throw new UserException(file + " holds " + tiffs.size()
				+ " TIFF files, but a movie is one; unpack it and name the movie.");
		return tiffs.get(0);
	}

	private static void unpack(final ZipFile zip, final ZipEntry entry, final Path target,
		final Progress progress) throws IOException {
		final long most = Runtime.getRuntime().maxMemory();
		try (InputStream in = zip.getInputStream(entry);
			OutputStream out = Files.newOutputStream(target)) {
			final byte[] buffer = new byte[BUFFER];
			long written = 0;
			for (int n = in.read(buffer); n >= 0; n = in.read(buffer)) {
				progress.checkCancelled();
				written += n;
				if (written > most)
					throw new UserException(
						"There is not enough memory for " + target + "; give Java more.");
				out.write(buffer, 0, n);
			}
		}
	}
}
