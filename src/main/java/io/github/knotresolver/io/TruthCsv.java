
package io.github.knotresolver.io;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.SortedMap;
import java.util.stream.Stream;

import org.apache.commons.csv.CSVPrinter;

import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.UserException;

/**
 * Contours in pixels and nothing else: {@code frame,index,x_px,y_px}, the
 * columns that {@link ContoursCsv#read} needs.
 */
public final class TruthCsv {

	private TruthCsv() {
	}

	/**
	 * Reads contours that are to be compared.
	 *
	 * @param key the option that named the file
	 * @param file the file, or a folder with a {@code contours.csv}
	 * @return the contours in pixels, by 1-based frame
	 * @throws UserException if it is not such a file; the sentence
	 *           begins with the key
	 */
	public static SortedMap<Integer, Polyline> read(final String key, final Path file) {
		try {
			return ContoursCsv
				.read(Files.isDirectory(file) ? file.resolve(ContoursCsv.FILE) : file);
		} catch (final UserException e) {
			throw new UserException(key + " cannot be used: " + e.getMessage(), e);
		}
	}

	/**
	 * Reads contours of any number of filaments that are to be compared.
	 *
	 * @param key the option that named the file
	 * @param file the file, or a folder with a {@code contours.csv}
	 * @return the contours in pixels, by the filament's number and the 1-based frame
	 * @throws UserException if it is not such a file; the sentence
	 *           begins with the key
	 */
	public static SortedMap<Integer, SortedMap<Integer, Polyline>> readFilaments(final String key,
		final Path file) {
		try {
			return ContoursCsv
				.readFilaments(Files.isDirectory(file) ? file.resolve(ContoursCsv.FILE) : file);
		} catch (final UserException e) {
			throw new UserException(key + " cannot be used: " + e.getMessage(), e);
		}
	}

	/**
	 * @param given what users name: files, or folders with a {@code contours.csv}
	 * @return all files that are read
	 */
	public static List<Path> files(final Path... given) {
		return Stream.of(given).flatMap(p -> Stream.of(p, p.resolve(ContoursCsv.FILE))).toList();
	}

	/**
	 * @param file the file to write
	 * @param contours one contour a frame, the first frame first
	 * @throws IOException if a file cannot be written
	 */
	public static void write(final Path file, final List<Polyline> contours) throws IOException {
		try (CSVPrinter csv = CsvFile.create(file, "frame", "index", "x_px", "y_px")) {
			for (int t = 0; t < contours.size(); t++)
				for (int i = 0; i < contours.get(t).size(); i++)
					csv.printRecord(t + 1, i, NumberText.pixels(contours.get(t).x(i)),
						NumberText.pixels(contours.get(t).y(i)));
		}
	}
}
