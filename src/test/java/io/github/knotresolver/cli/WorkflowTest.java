package io.github.knotresolver.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.regex.Pattern;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import io.github.knotresolver.imagej.TestImages;

/** The workflow with the real Snakemake: a dry run, a run, and another one that finds all done. */
class WorkflowTest {

	private static final Path SCRIPT = Path.of("scripts", "workflow").toAbsolutePath();

	@TempDir
	Path home;

	@BeforeEach
	void findSnakemake() throws IOException, InterruptedException {
		assumeTrue(Files.isExecutable(Path.of("/bin/sh")), "This system has no POSIX shell.");
		assumeTrue(snakemake().matches("(?s)9\\..*|\\d\\d\\..*"),
			"Snakemake 9 was not found (pip install snakemake): the workflow is not run.");
		for (int i = 0; i < 3; i++)
			TestImages.save(TestImages.movie(3 + i, 8), home.resolve("it's " + i + ".tif"));
		Files.write(home.resolve("sheet.csv"), List.of("FileName,FolderPath", "it's 0.tif,.",
			"absent.tif,.", "it's 1.tif,.", "it's 2.tif,."));
		final Path program = home.resolve("knot resolver");
		Files.writeString(program,
			"#!/bin/sh\nexec '" + Path.of(System.getProperty("java.home"), "bin", "java")
				+ "' -XX:TieredStopAtLevel=1 -Djava.awt.headless=true -cp '"
				+ System.getProperty("java.class.path") + "' " + KnotResolverMain.class.getName()
				+ " \"$@\"\n");
		assertTrue(program.toFile().setExecutable(true));
	}

	private static String snakemake() throws IOException, InterruptedException {
		try {
			final Process process = new ProcessBuilder("snakemake", "--version")
				.redirectError(ProcessBuilder.Redirect.DISCARD).start();
			final String version = new String(process.getInputStream().readAllBytes());
			return process.waitFor() == 0 ? version : "";
		} catch (final IOException e) {
			return "";
		}
	}

	@Test
	void jobsMakeListPageAndTablesOfAllAndAreNotDoneTwice() throws Exception {
		final Path out = home.resolve("out");
		final String dry = run("--batch-size", "2", "--options", "--no-plots --no-refine",
			"--dry-run");
		assertTrue(dry.contains("This was a dry-run"), dry);
		assertFalse(Files.exists(out.resolve("batch.csv")));
		final String log = run("--batch-size", "2", "--options", "--no-plots --no-refine");
		final List<String> list = Files.readAllLines(out.resolve("batch.csv"));
		assertEquals(5, list.size(), log);
		assertTrue(list.get(1).contains(",finished,it's 0,"), list.get(1));
		assertTrue(list.get(2).contains(",failed,,") && list.get(2).contains("There is no file"),
			list.get(2));
		assertTrue(Files.readString(out.resolve("batch.html")).contains("3 of 4 movies"));
		assertTrue(Files.exists(out.resolve("batch-rows/1-2.csv")));
		assertTrue(Files.exists(out.resolve("batch-rows/3-4.csv")));
		final List<String> frames = Files.readAllLines(out.resolve("batch-frames.csv"));
		assertEquals(1 + 3 + 4 + 5, frames.size());
		assertTrue(frames.get(0).startsWith("movie,result,frame,status,"), frames.get(0));
		assertEquals(4, Files.readAllLines(out.resolve("batch-summary.csv")).size());
		final String again = run("--batch-size", "2", "--options", "--no-plots --no-refine");
		assertTrue(again.contains("Nothing to be done"), again);
	}

	@Test
	void containerRecipesCopyWhatIsThere() throws IOException {
		final List<String> missing = new ArrayList<>();
		for (final String recipe : List.of("workflow/Dockerfile", "workflow/knotresolver.def")) {
			// What a recipe copies: lines COPY of the one, the section %files of the other.
			final String text = Files.readString(Path.of(recipe))
				.replaceAll("(?s)^.*%files\n(.*?)\n\n.*$", "$1")
				.replaceAll("(?m)^COPY --from.*$", "");
			final var copies = Pattern.compile("(?m)^(?:COPY |    )([\\w./*-]+) \\S+$")
				.matcher(text).results().map(m -> m.group(1)).toList();
			assertTrue(copies.size() >= 4, recipe + ": " + copies);
			// What the build makes is not there before it.
			copies.stream()
				.filter(name -> !name.startsWith("target/") && !Files.exists(Path.of(name)))
				.forEach(name -> missing.add(recipe + ": " + name));
		}
		assertEquals(List.of(), missing);
	}

	/** @return what it printed */
	private String run(final String... options) throws IOException, InterruptedException {
		final List<String> command = new ArrayList<>(List.of("/bin/sh", SCRIPT.toString(),
			home.resolve("sheet.csv").toString(), "--out", home.resolve("out").toString()));
		command.addAll(List.of(options));
		final Path log = home.resolve("log.txt");
		final ProcessBuilder builder = new ProcessBuilder(command).redirectErrorStream(true)
			.redirectOutput(log.toFile());
		builder.environment().put("KNOTRESOLVER", home.resolve("knot resolver").toString());
		final Process process = builder.start();
		assertTrue(process.waitFor(300, TimeUnit.SECONDS), "the workflow does not end");
		final String text = Files.readString(log);
		assertEquals(0, process.exitValue(), text);
		return text;
	}
}
