package io.github.knotresolver.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.jar.JarEntry;
import java.util.jar.JarOutputStream;
import java.util.stream.Stream;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Every script of {@code scripts/examples}, each in a process of its own: one
 * movie, and a folder with one that is broken.
 */
class ExamplesTest {

	private static final Path EXAMPLES = Path.of("scripts", "examples").toAbsolutePath();

	@TempDir
	Path home;
	private Programs programs;
	private Path movies, movie, out;
	private String expected;

	@BeforeEach
	void makeMovies() throws Exception {
		programs = new Programs(home);
		movies = Files.createDirectories(home.resolve("my movies"));
		movie = movies.resolve("knot.tif");
		Files.copy(programs.sample(), movie);
		Files.writeString(movies.resolve("broken.tif"), "This is no image.");
		out = home.resolve("my results");
		final Path line = home.resolve("line");
		programs.knotresolver("resolve", movie.toString(), "--no-plots", "--out", line.toString());
		expected = Files.readString(line.resolve("contours.csv"));
	}

	@Test
	void imageJMacros() throws Exception {
		final Path one = home.resolve("one");
		assertResult(programs.macro(EXAMPLES.resolve("resolve-one.ijm"), movie + "," + one), one);
		final String said = programs.macro(EXAMPLES.resolve("resolve-folder.ijm"),
			movies + "," + out);
		assertResult(said, out.resolve("knot"));
		assertTrue(said.contains("broken.tif"), said);
	}

	@Test
	void groovy() throws Exception {
		assertResult(script("resolve_one.groovy", "movie=\"" + movie + "\",out=\"" + out + "\""),
			out);
		final Path all = home.resolve("all");
		final String said = script("resolve_folder.groovy",
			"input=\"" + movies + "\",out=\"" + all + "\"");
		assertResult(said, all.resolve("knot"));
		assertTrue(said.contains("broken.tif: " + movies.resolve("broken.tif")
			+ " is not an image that ImageJ can open"), said);
	}

	@Test
	void python() throws Exception {
		final String python = System.getenv().getOrDefault("KNOTRESOLVER_PYTHON", "python3");
		assumeTrue(hasScyjava(python),
			"The examples in Python need scyjava; name a Python that has it in KNOTRESOLVER_PYTHON.");
		final Map<String, String> fiji = Map.of("KNOTRESOLVER_JARS", fiji().toString(),
			"PYTHONDONTWRITEBYTECODE", "1", "JAVA_HOME", System.getProperty("java.home"));
		final String one = programs.run(fiji, List.of(python,
			EXAMPLES.resolve("resolve_one.py").toString(), movie.toString(), out.toString()));
		assertResult(one, out);
		assertTrue(one.contains("frame 24: "), one);
		final Path all = home.resolve("all");
		final String said = programs.run(fiji, List.of(python,
			EXAMPLES.resolve("resolve_folder.py").toString(), movies.toString(), all.toString()));
		assertResult(said, all.resolve("knot"));
		assertTrue(said.contains("knot.tif: 24 frames resolved")
			&& said.contains("broken.tif: " + movies.resolve("broken.tif")), said);
	}

	private void assertResult(final String said, final Path result) throws IOException {
		assertTrue(Files.exists(result.resolve("contours.csv")), said);
		assertEquals(expected, Files.readString(result.resolve("contours.csv")), said);
	}

	private String script(final String name, final String arguments) throws Exception {
		return programs.java(List.of("-Djava.awt.headless=true"), HeadlessRunMain.class.getName(),
			"--headless", "--run", EXAMPLES.resolve(name).toString(), arguments);
	}

	private boolean hasScyjava(final String python) throws InterruptedException {
		try {
			return programs.run(Map.of(), List.of(python, "-c", "import scyjava; print('there')"))
				.strip().endsWith("there");
		} catch (final IOException e) {
			return false;
		}
	}

	/** A folder as scripts/install-into-fiji leaves it. */
	private Path fiji() throws IOException {
		final Path folder = home.resolve("fiji");
		final Path plugins = Files.createDirectories(folder.resolve("plugins"));
		final Path jars = Files.createDirectories(folder.resolve("jars"));
		for (final String entry : System.getProperty("java.class.path").split(":"))
			if (entry.endsWith(".jar"))
				Files.copy(Path.of(entry), jars.resolve(Path.of(entry).getFileName()));
		pack(Path.of("target", "classes"), plugins.resolve("KnotResolver_-test.jar"));
		return folder;
	}

	private static void pack(final Path classes, final Path file) throws IOException {
		try (JarOutputStream jar = new JarOutputStream(Files.newOutputStream(file));
			Stream<Path> all = Files.walk(classes)) {
			for (final Path one : all.filter(Files::isRegularFile).sorted().toList()) {
				jar.putNextEntry(
					new JarEntry(classes.relativize(one).toString().replace('\\', '/')));
				Files.copy(one, jar);
				jar.closeEntry();
			}
		}
	}
}
