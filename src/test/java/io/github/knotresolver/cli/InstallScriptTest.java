package io.github.knotresolver.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * {@code scripts/install-into-fiji} on a folder that looks like a Fiji, from a
 * checkout that looks built.
 */
class InstallScriptTest {

	private static final String JAR = "KnotResolver_-1.2.3.jar";

	@TempDir
	Path home;
	private Path fiji;

	@BeforeEach
	void makeFolders() throws IOException {
		assumeTrue(Files.isExecutable(Path.of("/bin/sh")), "This system has no POSIX shell.");
		final Path scripts = Files.createDirectories(home.resolve("checkout/scripts"));
		Files.copy(Path.of("scripts", "install-into-fiji"), scripts.resolve("install-into-fiji"));
		final Path built = Files.writeString(scripts.resolve("knotresolver"), "#!/bin/sh\n");
		assertTrue(built.toFile().setExecutable(true));
		final Path lib = Files.createDirectories(home.resolve("checkout/target/lib"));
		for (final String jar : List.of("../" + JAR, "../KnotResolver_-1.2.3-sources.jar",
			"../KnotResolver_-1.2.3-tests.jar", "ij-1.54p.jar", "commons-csv-1.14.1.jar",
			"gson-2.10.1.jar", "jgrapht-core-1.5.2.jar"))
			Files.writeString(lib.resolve(jar), jar);
		fiji = home.resolve("My Fiji");
		Files.createDirectories(fiji.resolve("plugins"));
		Files.createDirectories(fiji.resolve("jars"));
	}

	@Test
	void pluginAndMissingLibrariesAreCopiedAndWhatIsThereIsLeft() throws Exception {
		Files.writeString(fiji.resolve("plugins/KnotResolver_-1.0.0.jar"), "earlier");
		Files.writeString(fiji.resolve("plugins/Other_-1.0.0.jar"), "other");
		Files.writeString(fiji.resolve("jars/gson-2.10.1.jar"), "Fiji's");
		Files.writeString(fiji.resolve("jars/gson-extras-1.0.jar"), "Fiji's");
		Files.writeString(fiji.resolve("jars/jgrapht-core-1.4.0.jar"), "Fiji's");
		final String said = install(0, fiji);
		assertEquals(List.of(JAR, "Other_-1.0.0.jar"), names("plugins"));
		assertEquals(List.of("commons-csv-1.14.1.jar", "gson-2.10.1.jar", "gson-extras-1.0.jar",
			"ij-1.54p.jar", "jgrapht-core-1.4.0.jar"), names("jars"));
		assertEquals("Fiji's", Files.readString(fiji.resolve("jars/gson-2.10.1.jar")));
		assertTrue(
			said.contains(
				"kept: jars/jgrapht-core-1.4.0.jar (made and tested with jgrapht-core-1.5.2.jar)"),
			said);
	}

	@Test
	void plainImageJKeepsItsOwnIj() throws Exception {
		Files.writeString(fiji.resolve("ij.jar"), "ImageJ");
		install(0, fiji);
		assertFalse(names("jars").contains("ij-1.54p.jar"));
	}

	@Test
	void secondRunChangesNothing() throws Exception {
		install(0, fiji);
		final List<String> plugins = names("plugins"), jars = names("jars");
		install(0, fiji);
		assertEquals(plugins, names("plugins"));
		assertEquals(jars, names("jars"));
	}

	@Test
	void wrongFolderIsRefusedInOneSentence() throws Exception {
		assertEquals("Name the folder of Fiji: scripts/install-into-fiji DIR", install(2));
		final Path absent = home.resolve("absent");
		assertTrue(install(2, absent).startsWith("There is no folder " + absent));
		final Path empty = Files.createDirectory(home.resolve("empty"));
		assertTrue(install(2, empty).contains("is not the folder of a Fiji or ImageJ"));
		Files.createDirectories(empty.resolve("Fiji.app/plugins"));
		assertTrue(install(2, empty).contains("but " + empty.resolve("Fiji.app") + " is"));
		assertFalse(Files.exists(absent) || Files.exists(empty.resolve("plugins")));
	}

	private String install(final int status, final Path... folder) throws Exception {
		final Path log = home.resolve("log.txt");
		final List<String> command = Stream.concat(
			Stream.of("/bin/sh", home.resolve("checkout/scripts/install-into-fiji").toString()),
			Stream.of(folder).map(Path::toString)).toList();
		final Process process = new ProcessBuilder(command).redirectErrorStream(true)
			.redirectOutput(log.toFile()).start();
		final int ended = process.waitFor();
		final String said = Files.readString(log).strip();
		assertEquals(status, ended, said);
		assertTrue(status == 0 || said.lines().count() == 1, said);
		return said;
	}

	private List<String> names(final String part) throws IOException {
		try (Stream<Path> files = Files.list(fiji.resolve(part))) {
			return files.map(f -> f.getFileName().toString()).sorted().toList();
		}
	}
}
