package io.github.knotresolver.imagej;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDateTime;
import java.util.List;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;

import ij.gui.Roi;
import ij.io.RoiEncoder;

/**
 * {@code RoiSet.zip}, as ImageJ's ROI Manager reads and writes it. The same
 * ROIs give the same bytes.
 */
public final class RoiSetWriter {

	/** The file's name in a result folder. */
	public static final String FILE = "RoiSet.zip";

	/** The first moment that a zip file knows. */
	private static final LocalDateTime NO_TIME = LocalDateTime.of(1980, 1, 1, 0, 0);

	private RoiSetWriter() {
	}

	/**
	 * @param file the file to write
	 * @param rois ROIs with different names
	 * @throws IOException if a file cannot be written
	 */
	public static void write(final Path file, final List<Roi> rois) throws IOException {
		try (ZipOutputStream zip = new ZipOutputStream(Files.newOutputStream(file))) {
			for (final Roi roi : rois) {
				final ZipEntry entry = new ZipEntry(roi.getName() + ".roi");
				entry.setTimeLocal(NO_TIME);
				zip.putNextEntry(entry);
				zip.write(RoiEncoder.saveAsByteArray(roi));
				zip.closeEntry();
			}
		}
	}
}
