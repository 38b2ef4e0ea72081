package io.github.knotresolver;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;

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
}
