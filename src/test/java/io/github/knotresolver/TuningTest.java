package io.github.knotresolver;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

import org.junit.jupiter.api.Test;

/** Every number by which a room is tuned says its unit and its reason, and is in the table. */
class TuningTest {

	private static final Pattern CONSTANT = Pattern.compile(
		"/\\*\\*((?:(?!\\*/).)*)\\*/\\s*(?:public )?static final (?:int|double) (\\w+) = ([^;]+);",
		Pattern.DOTALL);
	private static final Pattern TEXT = Pattern.compile("\\[[^\\]]+\\] .+ Why: .+\\.");

	@Test
	void everyConstantSaysItsUnitAndItsReason() throws IOException {
		final List<String> mute = new ArrayList<>();
		int constants = 0;
		for (final String source : sources()) {
			final Matcher constant = CONSTANT.matcher(source);
			int found = 0;
			while (constant.find()) {
				found++;
				if (!TEXT.matcher(text(constant.group(1))).matches())
					mute.add(constant.group(2));
			}
			assertEquals(source.split("static final ", -1).length - 1, found,
				"constants without a comment of their own");
			constants += found;
		}
		assertEquals(List.of(), mute, "write '[unit] What it is. Why: reason.'");
		assertTrue(constants > 50, constants + " constants");
	}

	@Test
	void tableHasEveryConstantWithItsValue() throws IOException {
		final String table = Files.readString(Path.of("docs", "constants.md"));
		final List<String> missing = new ArrayList<>();
		for (final String source : sources()) {
			final Matcher constant = CONSTANT.matcher(source);
			while (constant.find()) {
				final String value = constant.group(3).replaceAll("\\s+", " ");
				if (!table.contains("| `" + constant.group(2) + "` | " + value + " |"))
					missing.add(constant.group(2));
			}
		}
		assertEquals(List.of(), missing, "write the table again: scripts/ablation --table");
	}

	private static String text(final String comment) {
		return comment.replaceAll("\n\\s*\\*", " ").replaceAll("\\s+", " ").trim();
	}

	private static List<String> sources() throws IOException {
		try (Stream<Path> files = Files.walk(Path.of("src", "main", "java"))) {
			final List<String> sources = new ArrayList<>();
			for (final Path file : files
				.filter(f -> f.getFileName().toString().endsWith("Tuning.java")).sorted().toList())
				sources.add(Files.readString(file));
			return sources;
		}
	}
}
