package io.github.knotresolver.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What the script says where there is no Java that will do. */
class ScriptsTest {

	private static final Path SCRIPT = Path.of("scripts", "knotresolver").toAbsolutePath();
	private static final List<String> TOOLS = List.of("sh", "sed", "head", "dirname", "readlink");

	@TempDir
	Path home;

	@BeforeEach
	void gatherTools() throws IOException {
		assumeTrue(Files.isExecutable(Path.of("/bin/sh")), "This system has no POSIX shell.");
		for (final String tool : TOOLS)
			for (final String folder : List.of("/bin", "/usr/bin"))
				if (Files.exists(Path.of(folder, tool)) && !Files.exists(home.resolve(tool)))
					program(tool, "exec " + Path.of(folder, tool) + " \"$@\"");
	}

	@Test
	void missingJavaIsSaidInOneLine() throws IOException, InterruptedException {
		assertRefused("Java was not found; install a JDK 17 or newer, or set JAVA_HOME.");
	}

	@Test
	void oldJavaIsSaidInOneLine() throws IOException, InterruptedException {
		fakeJava("openjdk version \"11.0.2\" 2019-01-15");
		assertRefused("Java 17 or newer is needed, but java is version 11");
	}

	@Test
	void veryOldJavaIsSaidInOneLine() throws IOException, InterruptedException {
		fakeJava("java version \"1.8.0_292\"");
		assertRefused("Java 17 or newer is needed, but java is version 1;");
	}

	private void fakeJava(final String version) throws IOException {
		program("java", "echo '" + version + "' >&2");
	}

	private void program(final String name, final String line) throws IOException {
		final Path file = Files.writeString(home.resolve(name), "#!/bin/sh\n" + line + "\n");
		assertTrue(file.toFile().setExecutable(true));
	}

	private void assertRefused(final String sentence) throws IOException, InterruptedException {
		final Path err = home.resolve("err.txt"), out = home.resolve("out.txt");
		final ProcessBuilder builder = new ProcessBuilder("/bin/sh", SCRIPT.toString(), "--version")
			.directory(home.toFile()).redirectError(err.toFile()).redirectOutput(out.toFile());
		builder.environment().put("PATH", home.toString());
		builder.environment().remove("JAVA_HOME");
		assertEquals(1, builder.start().waitFor());
		final List<String> lines = Files.readAllLines(err);
		assertEquals(1, lines.size(), lines.toString());
		assertTrue(lines.get(0).startsWith(sentence), lines.get(0));
		assertEquals("", Files.readString(out));
	}
}
