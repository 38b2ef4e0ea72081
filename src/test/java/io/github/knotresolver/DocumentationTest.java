package io.github.knotresolver;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.io.RunOptions;

/** What the documents list is complete. */
class DocumentationTest {

	private static final Path DOCS = Path.of("docs");

	@Test
	void everyOptionIsExplained() throws IOException {
		final String text = Files.readString(DOCS.resolve("parameters.md"));
		final List<String> missing = RunOptions.KEYS.stream()
			.map(key -> "--" + key.replace('_', '-')).filter(o -> !text.contains("`" + o)).toList();
		assertEquals(List.of(), missing);
	}

	@Test
	void everyDependencyAndPluginIsJustified() throws IOException {
		final String text = Files.readString(DOCS.resolve("dependencies.md"));
		final String pom = Files.readString(Path.of("pom.xml"));
		final List<String> named = Pattern.compile("<artifactId>([^<]+)</artifactId>")
			.matcher(pom.substring(pom.indexOf("<dependencies>"))).results()
			.map((MatchResult m) -> m.group(1)).toList();
		assertFalse(named.isEmpty());
		assertEquals(List.of(), named.stream().filter(name -> !text.contains(name)).toList());
	}

	@Test
	void everyLinkAndScriptIsThere() throws IOException {
		final List<String> missing = new ArrayList<>();
		for (final Path file : documents()) {
			final String text = Files.readString(file);
			Pattern.compile("(?:\\]\\(|src=\")([^)\"#:]+)[)\"#]").matcher(text).results()
				.map(m -> m.group(1)).filter(link -> !Files.exists(folder(file).resolve(link)))
				.forEach(link -> missing.add(file + ": " + link));
			Pattern.compile("`(scripts/[\\w./-]+)").matcher(text).results().map(m -> m.group(1))
				.filter(script -> !Files.exists(Path.of(script)))
				.forEach(script -> missing.add(file + ": " + script));
		}
		assertEquals(List.of(), missing);
	}

	private static List<Path> documents() throws IOException {
		try (Stream<Path> top = Files.list(Path.of("")); Stream<Path> docs = Files.list(DOCS)) {
			return Stream.concat(top, docs).filter(f -> f.toString().endsWith(".md")).sorted()
				.toList();
		}
	}

	private static Path folder(final Path file) {
		return file.getParent() == null ? Path.of("") : file.getParent();
	}
}
