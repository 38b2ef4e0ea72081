package io.github.knotresolver.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Macros without a display, in a process of their own, with ImageJ patched as
 * Fiji does it; and the same by SciJava's {@code --headless --run} and on the
 * command line.
 */
class MacroTest {

	@TempDir
	Path home;
	private Programs programs;

	@BeforeEach
	void start() {
		programs = new Programs(home);
	}

	@Test
	void macroCommandAndCommandLineGiveTheSameContours() throws Exception {
		final Path macro = out("macro"), hidden = out("hidden"), command = out("command"),
			line = out("line"), file = out("file");
		final String log = programs.macros("run(\"Knotted Filament\");",
			"run(\"Resolve Filament...\", \"threads=1 plots=false out=[" + macro + "]\");",
			"setBatchMode(true); run(\"Knotted Filament\");",
			"n = 1; run(\"Resolve Filament...\", \"threads=&n plots=false out='" + hidden
				+ "'\");");
		assertTrue(Files.exists(macro.resolve("contours.csv")), log);
		final String run = programs.java(List.of("-Djava.awt.headless=true"),
			"io.github.knotresolver.command.HeadlessRunMain", "--headless", "--run",
			ResolveFilamentCommand.class.getName(), "movie=\"" + programs.sample() + "\",out=\""
				+ command + "\",plots=\"false\",threads=\"2\"");
		assertTrue(Files.exists(command.resolve("contours.csv")), run);
		assertFalse(run.contains("unsupported output"), run);
		programs.knotresolver("resolve", "--sample", "--no-plots", "--out", line.toString());
		programs.knotresolver("resolve", programs.sample().toString(), "--no-plots", "--out",
			file.toString());
		final String expected = Files.readString(line.resolve("contours.csv"));
		for (final Path other : List.of(macro, hidden, command, file))
			assertEquals(expected, Files.readString(other.resolve("contours.csv")),
				other.toString());
	}

	@Test
	void wrongMacroEndsWithOneSentenceAndWritesNothing() throws Exception {
		assertStops("threshold must be a number from 0 to 1", "threshold=1.5");
		assertStops("iterations must be a whole number from 0 to 1000, but is 'abc'",
			"iterations=abc");
		assertStops(
			"There is no key 'treshold'; the keys are image, movie, fixed_end, region, threshold",
			"treshold=0.4");
		assertStops("resolver must be movie or paper, but is 'best'", "resolver=best");
	}

	@Test
	void withoutADisplayTheFramesAreTheResults() throws Exception {
		final Path table = home.resolve("results.csv");
		String log = programs.macros("run(\"Knotted Filament\");",
			"run(\"Resolve Filament...\", \"frames=1-3\");",
			"print(\"rows \" + nResults + \" \" + getResultString(\"status\", 1) + \" \" + Overlay.size);",
			"run(\"Resolve Filament...\", \"frames=1-4\");",
			"saveAs(\"Results\", \"" + table + "\");");
		assertTrue(log.contains("rows 24 resolved 48"), log);
		assertTrue(Files.readString(table).contains("length"), log);
		log = programs.macros("run(\"Knotted Filament\");", "setResult(\"mine\", 0, 7);",
			"run(\"Resolve Filament...\", \"frames=1-3\");",
			"print(\"kept \" + getResult(\"mine\", 0));");
		assertTrue(log.contains("The Results table holds rows of others") && log.contains("kept 7"),
			log);
	}

	@Test
	void zStackIsRefusedWithAdviceAndReadIfTold() throws Exception {
		final String log = programs.macros("run(\"Knotted Filament\");",
			"run(\"Properties...\", \"channels=1 slices=24 frames=1\");",
			"run(\"Resolve Filament...\", \"frames=1-3 z_as_time\");",
			"print(\"told \" + Overlay.size);", "run(\"Resolve Filament...\", \"frames=1-3\");");
		assertTrue(log.contains("told 48"), log);
		assertTrue(log.contains("is a Z-stack of 24 slices, not a time series")
			&& log.contains("add z_as_time, or swap") && !log.contains("--z-as-time"), log);
	}

	@Test
	void everyCommandRunsByItsClass() throws Exception {
		final Path movie = home.resolve("movie"), scores = home.resolve("scores.csv"),
			measured = home.resolve("measured"), batch = home.resolve("batch");
		command(SimulateMovieCommand.class,
			"length=\"8\",duration=\"10\",frames=\"4\",out=\"" + movie + "\"");
		final Path truth = movie.resolve("contours.csv");
		String log = command(EvaluateCommand.class,
			"truth=\"" + truth + "\",result=\"" + truth + "\",out=\"" + scores + "\"");
		assertTrue(Files.exists(scores), log);
		log = command(MeasureContoursCommand.class,
			"result=\"" + truth + "\",out=\"" + measured + "\",plots=\"false\"");
		assertTrue(Files.isDirectory(measured), log);
		log = command(BatchCommand.class,
			"input=\"" + movie + "\",out=\"" + batch + "\",plots=\"false\"");
		assertTrue(Files.exists(batch.resolve("movie/contours.csv")), log);
		assertTrue(command(CiteCommand.class, "").contains("btae538"));
		assertFalse(command(SampleCommand.class, "").contains("ERROR"));
	}

	/** SciJava has nothing to add to what a Command shows itself. */
	private String command(final Class<?> type, final String inputs) throws Exception {
		final String log = run(type, inputs);
		assertFalse(log.contains("unsupported output"), log);
		return log;
	}

	private String run(final Class<?> type, final String inputs) throws Exception {
		return programs.java(List.of("-Djava.awt.headless=true"), HeadlessRunMain.class.getName(),
			"--headless", "--run", type.getName(), inputs);
	}

	/** The original tool's contours, measured by macro and on the command line. */
	@Test
	void originalContoursAreMeasuredAlike() throws Exception {
		final Path data = Files.writeString(home.resolve("MTdata.csv"), originalContours());
		final Path macro = out("measured"), line = out("line");
		final String log = programs.macros("run(\"Measure Contours...\", \"result=[" + data
			+ "] pixel_size=0.1 frame_interval=2 plots=false out=[" + macro + "]\");");
		programs.knotresolver("measure", data.toString(), "--pixel-size", "0.1", "--frame-interval",
			"2", "--no-plots", "--out", line.toString());
		assertTrue(Files.exists(macro.resolve("frames.csv")), log);
		for (final String file : List.of("frames.csv", "contours.csv", "oscillations.csv"))
			assertEquals(Files.readString(line.resolve(file)),
				Files.readString(macro.resolve(file)), file);
		// 60 pixels of 0.1 µm.
		assertEquals(6, Double.parseDouble(
			Files.readAllLines(macro.resolve("frames.csv")).get(1).split(",")[2]), 1e-3);
	}

	/** Straight lines of 61 points in ten frames. */
	private static String originalContours() {
		final StringBuilder text = new StringBuilder();
		for (int frame = 1; frame <= 10; frame++)
			for (int i = 0; i <= 60; i++)
				text.append(frame).append(',').append(10 + i).append(',').append(20 + frame)
					.append('\n');
		return text.toString();
	}

	@Test
	void measuringNothingEndsWithOneSentence() throws Exception {
		final Path csv = home.resolve("bad.csv");
		assertMeasuringStops("There is no polyline in the ROI Manager", "");
		Files.writeString(csv, "frame,index,x_px,y_px\n");
		assertMeasuringStops("has no contour", "result=[" + csv + "]");
		final Path lost = Files.createDirectory(home.resolve("lost"));
		Files.copy(csv, lost.resolve("contours.csv"));
		Files.writeString(lost.resolve("frames.csv"), "frame,status\n1,lost\n2,lost\n");
		assertMeasuringStops("has no contour in any of 2 frames", "result=[" + lost + "]");
		Files.writeString(csv, "1,1,1\n1,2,2\n");
		assertMeasuringStops("None of the 1 frames has a contour of 3 points or more",
			"result=[" + csv + "]");
		Files.writeString(csv, "frame,index,x_px,y_px,x,y,unit\n1,0,1,1,1,1,µm\n1,1,2,2,2,2,nm\n");
		assertMeasuringStops("mixes the units", "result=[" + csv + "]");
	}

	private void assertMeasuringStops(final String sentence, final String option) throws Exception {
		assertAborts(sentence, "", "Measure Contours...", option);
	}

	private void assertStops(final String sentence, final String option) throws Exception {
		assertAborts(sentence, "run(\"Knotted Filament\");", "Resolve Filament...", option);
	}

	private void assertAborts(final String sentence, final String before, final String command,
		final String option) throws Exception {
		final Path after = home.resolve("after.txt"), out = out("none");
		final String log = programs.macros(before,
			"run(\"" + command + "\", \"" + option + " out=[" + out + "]\");",
			"File.saveString(\"on\", \"" + after + "\");");
		assertTrue(log.contains(sentence), log);
		assertFalse(log.contains("\tat "), log);
		assertFalse(Files.exists(out), log);
		assertFalse(Files.exists(after), "The macro went on after: " + log);
	}

	private Path out(final String name) {
		return home.resolve(name + " folder");
	}
}
