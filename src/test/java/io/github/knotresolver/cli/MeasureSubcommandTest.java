package io.github.knotresolver.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;

import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import io.github.knotresolver.progress.Progress;

class MeasureSubcommandTest {

	private static final Path REAL = Path.of("../shared/data/real");

	@TempDir
	private Path folder;

	private final StringWriter err = new StringWriter();

	@Test
	void contoursBecomeTablesAndFigures() throws IOException {
		final Path out = folder.resolve("out");
		assertEquals(0, run(contours(12, "µm").toString(), "--out", out.toString(),
			"--frame-interval", "2", "--persistence-length", "5000"), err.toString());
		for (final String file : List.of("contours.csv", "frames.csv", "crossings.csv",
			"oscillations.csv", "waves.csv", "parameters.json", "contours.png",
			"tangent_angle_kymograph.tif", "curvature_kymograph.svg", "tip_angle_spectrum.png"))
			assertTrue(Files.size(out.resolve(file)) > 0, file);
		assertFalse(Files.exists(out.resolve("statsSummary.txt")));
		final List<String> frames = Files.readAllLines(out.resolve("frames.csv"));
		assertEquals(13, frames.size());
		assertTrue(frames.get(1).endsWith("µm,kT,s,1"), frames.get(1));
		final String[] second = frames.get(2).split(",");
		assertEquals(2, Double.parseDouble(second[1]));
		// A quarter of a circle of 40 px of 0.1 µm.
		assertEquals(2 * Math.PI, Double.parseDouble(second[2]), 0.01);
	}

	@Test
	void missingFramesHaveEmptyCells() throws IOException {
		final Path file = contours(6, "µm");
		Files.write(file,
			Files.readAllLines(file).stream().filter(l -> !l.startsWith("3,")).toList());
		final Path out = folder.resolve("out");
		assertEquals(0, run(file.toString(), "--out", out.toString(), "--no-plots"),
			err.toString());
		final String row = Files.readAllLines(out.resolve("frames.csv")).get(3);
		assertTrue(row.startsWith("3,2,,,,"), row);
		assertFalse(Files.exists(out.resolve("length.png")));
	}

	@Test
	void measurementsAreReplacedOnlyWhenForced() throws IOException {
		final String file = contours(4, "µm").toString(), out = folder.resolve("out").toString();
		assertEquals(0, run(file, "--out", out, "--no-plots"), err.toString());
		assertEquals(2, run(file, "--out", out, "--no-plots"));
		assertTrue(err.toString().contains("--force"), err.toString());
		assertEquals(0, run(file, "--out", out, "--no-plots", "--force"), err.toString());
	}

	/** What was measured can be measured again: smoothing has settled. */
	@Test
	void measurementsAreContoursAgain() throws IOException {
		final Path out = folder.resolve("out"), again = folder.resolve("again");
		assertEquals(0, run(contours(4, "µm").toString(), "--out", out.toString(), "--no-plots"));
		assertEquals(0, run(out.toString(), "--out", again.toString(), "--no-plots"),
			err.toString());
		final String[] a = Files.readAllLines(out.resolve("frames.csv")).get(2).split(","),
			b = Files.readAllLines(again.resolve("frames.csv")).get(2).split(",");
		assertEquals(Double.parseDouble(a[2]), Double.parseDouble(b[2]), 0.005);
	}

	@Test
	void oneFrameIsMeasuredWithoutSpectrum() throws IOException {
		final Path out = folder.resolve("out");
		assertEquals(0, run(contours(1, "µm").toString(), "--out", out.toString()), err.toString());
		assertTrue(Files.exists(out.resolve("length.png")));
		assertFalse(Files.exists(out.resolve("tip_angle_spectrum.png")));
	}

	@Test
	void spectraOfChosenQuantitiesAreGiven() throws IOException {
		final Path out = folder.resolve("out");
		assertEquals(0, run(contours(20, "µm", 0.1).toString(), "--out", out.toString(),
			"--spectra", "length,turning_number"), err.toString());
		assertTrue(Files.exists(out.resolve("length_spectrum.png")));
		assertFalse(Files.exists(out.resolve("tip_angle_spectrum.png")));
		final List<String> rows = Files.readAllLines(out.resolve("spectra.csv"));
		assertEquals("quantity,frequency,amplitude,frequency_unit,amplitude_unit,filament",
			rows.get(0));
		assertEquals(List.of("length", "turning_number"),
			rows.stream().skip(1).map(r -> r.substring(0, r.indexOf(','))).distinct().toList());
		assertTrue(Files.readString(out.resolve("oscillations.csv")).contains("length,"));
	}

	@ParameterizedTest
	@CsvSource(delimiter = '|', value = {"frame,index,x_px,y_px| has no contour", "| is empty",
		"1,2| has 2 columns, but needs three", "1,0,x| y must be a number",
		"frame,x,y| must have the columns frame,index,x_px,y_px",
		"1,1,1;1,2,2| None of the 1 frames has a contour of 3 points",
		"frame,index,x_px,y_px,x,y,unit;1,0,1,1,1,1,µm;1,1,2,2,2,2,nm| mixes the units"})
	void badInputIsRefusedInOneSentence(final String content, final String part)
		throws IOException {
		final Path file = folder.resolve("bad.csv");
		Files.writeString(file, content == null ? "" : content.replace(';', '\n'));
		assertEquals(2, run(file.toString(), "--out", folder.resolve("out").toString()));
		assertTrue(err.toString().contains(part), err.toString());
		assertEquals(1, err.toString().lines().count(), err.toString());
		assertFalse(Files.exists(folder.resolve("out")));
	}

	@Test
	void resultOfWhichAllFramesAreLostIsRefusedInOneSentence() throws IOException {
		final Path result = Files.createDirectory(folder.resolve("result"));
		Files.writeString(result.resolve("contours.csv"), "frame,index,x_px,y_px\n");
		Files.writeString(result.resolve("frames.csv"), "frame,status\n1,lost\n2,lost\n3,lost\n");
		assertEquals(2, run(result.toString(), "--out", folder.resolve("out").toString()));
		assertTrue(err.toString().contains("has no contour in any of 3 frames"), err.toString());
		assertTrue(err.toString().contains("resolve or correct"), err.toString());
		assertEquals(1, err.toString().lines().count(), err.toString());
		assertFalse(Files.exists(folder.resolve("out")));
	}

	@ParameterizedTest
	@CsvSource({"--smoothing-window,0", "--smoothing-order,9", "--persistence-length,-1",
		"--rigidity,abc", "--pixel-size,0", "--spectra,weight", "--frame-interval,none"})
	void wrongValuesAreRefused(final String option, final String value) throws IOException {
		assertEquals(2, run(contours(3, "µm").toString(), "--out", folder.resolve("out").toString(),
			option, value));
		assertEquals(1, err.toString().lines().count(), err.toString());
		assertFalse(Files.exists(folder.resolve("out")));
	}

	@ParameterizedTest
	@CsvSource({"dyn1, 0.00238, 0.00238095", "branchDemo, 0.00833, 0.00277778"})
	void originalsStatisticsAreReproduced(final String movie, final double frequency,
		final double bin) throws IOException {
		final Path data = REAL.resolve(movie + "_MTdata.csv");
		Assumptions.assumeTrue(Files.exists(data), "skipped: no " + data);
		final Path out = folder.resolve("out");
		assertEquals(0, run(data.toString(), "--out", out.toString(), "--no-plots", "--pixel-size",
			"0.106", "--frame-interval", "10", "--original-definitions"), err.toString());
		final List<String> theirs = Files.readAllLines(REAL.resolve(movie + "_statsSummary.txt"))
			.stream().filter(l -> !l.isBlank()).toList();
		final List<String> ours = Files.readAllLines(out.resolve("statsSummary.txt")).stream()
			.filter(l -> !l.isBlank()).toList();
		assertEquals(theirs.size(), ours.size());
		for (int i = 0; i < theirs.size(); i++) {
			final String[] a = theirs.get(i).split(","), b = ours.get(i).split(",");
			if (a.length != 5 || a[0].equals("Frame") || a[0].startsWith("Mean"))
				continue;
			assertEquals(Double.parseDouble(a[1]), Double.parseDouble(b[1]),
				0.01 * Double.parseDouble(a[1]), "length, line " + i);
			assertEquals(Double.parseDouble(a[4]), Double.parseDouble(b[4]),
				0.01 * Double.parseDouble(a[4]), "end to end, line " + i);
		}
		final String line = ours.stream().filter(l -> l.startsWith("Dominant")).findFirst()
			.orElseThrow();
		assertEquals(frequency, Double.parseDouble(line.split(": ")[1]), bin * 1.01);
	}

	/** Quarters of a circle of 40 px that turn; 0.1 of the unit a pixel. */
	private Path contours(final int frames, final String unit) throws IOException {
		return contours(frames, unit, 0);
	}

	/** Arcs of a circle that turn to and fro, and grow and shrink by a part of their length. */
	private Path contours(final int frames, final String unit, final double breathing)
		throws IOException {
		final StringBuilder text = new StringBuilder("frame,index,x_px,y_px,x,y,unit\n");
		for (int f = 1; f <= frames; f++)
			for (int i = 0; i <= 60; i++) {
				final double a = Math.PI / 2 * (1 + breathing * Math.cos(f)) * i / 60
					+ 0.2 * Math.sin(f);
				final double x = 100 + 40 * Math.cos(a), y = 100 + 40 * Math.sin(a);
				text.append(String.format(Locale.ROOT, "%d,%d,%.3f,%.3f,%.4f,%.4f,%s%n", f, i, x, y,
					x / 10, y / 10, unit));
			}
		return Files.writeString(folder.resolve("contours.csv"), text);
	}

	private int run(final String... args) {
		final String[] all = new String[args.length + 1];
		all[0] = "measure";
		System.arraycopy(args, 0, all, 1, args.length);
		return KnotResolverMain.run((movie, parameters, progress) -> {
			throw new IllegalStateException("Measuring resolves nothing.");
		}, Progress.NONE, new PrintWriter(new StringWriter()), new PrintWriter(err), all);
	}
}
