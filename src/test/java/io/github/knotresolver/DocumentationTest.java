package io.github.knotresolver;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.options.Option;
import io.github.knotresolver.options.Option.Section;
import io.github.knotresolver.options.ResolveOptions;

/** What the documents list is complete. */
class DocumentationTest {

	private static final Path DOCS = Path.of("docs");

	/** One row an option, in the section that is its own: name, what it is, default, range. */
	@Test
	void tablesOfOptionsSayWhatTheListOfOptionsSays() throws IOException {
		final String text = Files.readString(DOCS.resolve("parameters.md"));
		final List<String> wrong = new ArrayList<>();
		for (final Option option : ResolveOptions.ALL) {
			final String values = option.values().isEmpty()
				? ""
				: " " + option.values().replace("|", "\\|");
			final String start = "| `" + option.name() + values + "` | " + option.help();
			final List<String> rows = section(text, option.section()).lines()
				.filter(row -> row.startsWith(start)).toList();
			final String[] cells = rows.size() == 1
				? rows.get(0).split("(?<!\\\\)\\|", -1)
				: new String[5];
			if (rows.size() != 1 || !cells[3].strip().startsWith(option.byDefault())
				|| !cells[4].strip().startsWith(option.range()))
				wrong.add(start + " | " + option.byDefault() + " | " + option.range() + " |");
		}
		assertEquals(List.of(), wrong, "rows that parameters.md should have");
	}

	private static String section(final String text, final Section section) {
		final int start = text.indexOf("## " + section.heading() + "\n");
		assertTrue(start >= 0, section.heading());
		final int end = text.indexOf("\n## ", start);
		return text.substring(start, end < 0 ? text.length() : end);
	}

	@Test
	void noRowOfTheTablesNamesAnOptionThatIsNotThere() throws IOException {
		final String text = Files.readString(DOCS.resolve("parameters.md"));
		final Set<String> known = new TreeSet<>(Set.of("--out", "--force", "--plots", "--sample"));
		ResolveOptions.ALL.forEach(option -> known.add(option.name()));
		assertEquals(List.of(), Pattern.compile("(?m)^\\| `(--[a-z-]+)").matcher(text).results()
			.map(m -> m.group(1)).filter(name -> !known.contains(name)).toList());
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
