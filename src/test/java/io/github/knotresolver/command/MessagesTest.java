package io.github.knotresolver.command;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;

import org.junit.jupiter.api.Test;

/** What is said to macros, too, speaks of keys; only the command line says {@code --force}. */
class MessagesTest {

	private static final Path SOURCES = Path.of("src", "main", "java", "io", "github",
		"knotresolver");
	private static final Pattern OPTION = Pattern.compile("\"[^\"]*(?<![\\w-])--[a-z][^\"]*\"");

	@Test
	void noMessageOutsideTheCommandLineNamesItsOptions() throws IOException {
		try (Stream<Path> files = Files.walk(SOURCES)) {
			final List<String> found = files
				.filter(
					f -> f.toString().endsWith(".java") && !f.startsWith(SOURCES.resolve("cli")))
				.flatMap(MessagesTest::options).toList();
			assertEquals(List.of(), found);
		}
	}

	private static Stream<String> options(final Path file) {
		try {
			return Files.readAllLines(file).stream().filter(l -> OPTION.matcher(l).find())
				.map(l -> file + ": " + l.strip());
		} catch (final IOException e) {
			throw new UncheckedIOException(e);
		}
	}
}
