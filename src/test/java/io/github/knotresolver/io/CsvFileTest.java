package io.github.knotresolver.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.zip.GZIPInputStream;

import org.apache.commons.csv.CSVPrinter;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.progress.Cancellation;
import io.github.knotresolver.progress.CancelledException;
import io.github.knotresolver.progress.Progress;

/** Tables as spreadsheets of all countries write them. */
class CsvFileTest {

	private static final Path FAULTS = Path.of("../shared/data/faults");
	private static final List<Point> POINTS = List.of(new Point(10.5, 20), new Point(11, 20.25),
		new Point(12, 21));

	private static final int ROWS = 20_000;

	@TempDir
	Path home;

	@ParameterizedTest
	@ValueSource(strings = {"1,11.5,21\n1,12,21.25\n1,13,22\n", "1;11.5;21\n1;12;21.25\n1;13;22",
		"1;11,5;21\r\n1;12;21,25\r\n1;13;22\r\n", "1\t11,5\t21\n1\t12\t21,25\n1\t13\t22\n",
		"sep=;\n1;11,5;21\n1;12;21,25\n1;13;22\n",
		"\"sep=,\"\r\n1,\"11,5\",21\n1,12,\"21,25\"\n1,13,22\n",
		"1.0e+00,1.15e+01,2.1E1\n1.0e+00,1.2e1,2.125e1\n1.0e+00,1.3e1,2.2e1\n",
		"\u00a01,\u20091.15e1\u202f,21\n1, 12,\u300021.25\n\u200b1,13,22\n\n",
		"\uFEFF1,11.5,21\n1,12,21.25\n1,13,22\n"})
	void pointsAreReadHoweverTheyAreWritten(final String text) throws IOException {
		for (final Charset charset : new Charset[]{StandardCharsets.UTF_8,
			StandardCharsets.UTF_16LE, StandardCharsets.UTF_16BE, StandardCharsets.UTF_16})
			assertPoints(Files.write(home.resolve("MTdata.csv"), text.getBytes(charset)));
		assertPoints(Files.write(home.resolve("MTdata.csv"),
			text.replaceAll("[\u2000-\uffff]", "").getBytes(Charset.forName("windows-1252"))));
	}

	private static void assertPoints(final Path file) {
		final var contour = ContourInput.read(file).contours().get(0).orElseThrow();
		assertEquals(POINTS.size(), contour.size());
		for (int i = 0; i < contour.size(); i++)
			assertEquals(POINTS.get(i), contour.point(i));
	}

	@Test
	void contoursWithSemicolonsHaveTheirUnitAndPixelSize() throws IOException {
		final Path file = Files.write(home.resolve("c.csv"),
			"frame;index;x_px;y_px;x;y;unit\n1;0;10,5;20;1,05;2;µm\n1;1;11;20,25;1,1;2,025;µm\n"
				.getBytes(Charset.forName("windows-1252")));
		final ContourInput input = ContourInput.read(file);
		assertEquals("µm", input.calibration().unit());
		assertEquals(0.1, input.calibration().pixelSize(), 1e-12);
		assertEquals(new Point(10.5, 20), input.contours().get(0).orElseThrow().first());
	}

	@ParameterizedTest
	@CsvSource(delimiter = '|', value = {
		"1,2,3;1,\"2\"x,3|damaged after line 1: a quotation mark is missing or stands inside",
		"1,2,3;1,\"2,3|damaged after line 1", "1,2,3;1,1.234.5,3|line 2: x must be a number",
		"1,2,1e308|line 1: y must be from -100000 to 100000 pixels, but is '1e308'"})
	void causeIsNamedWithItsLine(final String text, final String sentence) throws IOException {
		final Path file = Files.writeString(home.resolve("t.csv"), text.replace(';', '\n'));
		final String message = assertThrows(UserException.class, () -> ContourInput.read(file))
			.getMessage();
		assertTrue(message.contains(sentence), message);
	}

	@Test
	void picturesAreNoText() throws IOException {
		final Path file = Files.write(home.resolve("t.csv"),
			new byte[]{'I', 'I', 42, 0, 8, 0, 0, 0, 0, 0, 1});
		final String message = assertThrows(UserException.class, () -> ContourInput.read(file))
			.getMessage();
		assertTrue(message.contains("no text") || message.contains("must have"), message);
	}

	@Test
	void sheetsOfOtherCountriesAreRead() throws IOException {
		final String text = "sep=;\r\nFileName;FolderPath;segThresh;contraction_bias;frames\r\n"
			+ "m\u00fcller.tif;;0,3;-0,25;1-3,5\r\n";
		final Path file = Files.write(home.resolve("s.csv"),
			text.getBytes(Charset.forName("windows-1252")));
		final BatchRow row = BatchSheet.read(file).rows().get(0);
		assertEquals(3, row.line());
		assertEquals("0.3", row.texts().get("threshold"));
		assertEquals("-0.25", row.texts().get("contraction_bias"));
		assertEquals("1-3,5", row.texts().get("frames"));
		assertEquals("m\u00fcller.tif", row.name());
	}

	@Test
	void nameThatNoFileCanHaveSpoilsItsRowOnly() throws IOException {
		final Path file = Files.writeString(home.resolve("s.csv"),
			"FileName,FolderPath\na\0b.tif,.\nc.tif,.\n");
		final List<BatchRow> rows = BatchSheet.read(file).rows();
		assertEquals(2, rows.size());
		final String message = assertThrows(UserException.class, rows.get(0)::file).getMessage();
		assertTrue(message.contains("cannot be the name of a file"), message);
		rows.get(1).file();
		assertEquals("c.tif", rows.get(1).name());
	}

	@ParameterizedTest
	@ValueSource(strings = {"mt-exp.csv.gz", "mt-semi.csv"})
	void tablesOfTheOriginalAreRead(final String name) throws IOException {
		final Path file = FAULTS.resolve(name);
		assumeTrue(Files.exists(file), "There is no " + file + " beside the checkout.");
		Path table = file;
		if (name.endsWith(".gz"))
			try (InputStream in = new GZIPInputStream(Files.newInputStream(file))) {
				table = home.resolve("MTdata.csv");
				Files.write(table, in.readAllBytes());
			}
		assertTrue(ContourInput.read(table).contours().stream().anyMatch(c -> c.isPresent()));
	}

	/** Tables of long movies have millions of rows. */
	@Test
	void readingAndWritingEndWhenTheUserAsksToStop() throws IOException {
		final Path file = home.resolve("long.csv");
		assertEquals(ROWS, written(file, Integer.MAX_VALUE));
		final int[] questions = {0};
		assertEquals(ROWS + 1, Cancellation
			.during(stoppedAt(Integer.MAX_VALUE, questions), () -> CsvFile.read(file)).size());
		assertTrue(questions[0] > ROWS, "asked " + questions[0] + " times");
		assertThrows(CancelledException.class,
			() -> Cancellation.during(stoppedAt(50, new int[1]), () -> CsvFile.read(file)));
		assertThrows(CancelledException.class, () -> written(home.resolve("other.csv"), 3));
	}

	private static int written(final Path file, final int questions) throws IOException {
		return Cancellation.during(stoppedAt(questions, new int[1]), () -> {
			int row = 0;
			try (CSVPrinter csv = CsvFile.create(file, "frame", "index")) {
				for (; row < ROWS; row++)
					csv.printRecord(row, 7);
			}
			return row;
		});
	}

	private static Progress stoppedAt(final int most, final int[] questions) {
		return new Progress() {

			@Override
			public void report(final String stage, final double fraction) {
			}

			@Override
			public boolean isCancelled() {
				return ++questions[0] > most;
			}
		};
	}
}
