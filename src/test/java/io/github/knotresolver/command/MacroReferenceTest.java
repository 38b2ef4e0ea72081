package io.github.knotresolver.command;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Collectors;

import org.junit.jupiter.api.Test;
import org.scijava.plugin.Plugin;

import io.github.knotresolver.imagej.form.Form;
import io.github.knotresolver.imagej.form.FormField;

/**
 * The macro reference of {@code docs/fiji.md} is what the Commands say. After a
 * change, {@code ./mvnw test -Dtest=MacroReferenceTest -Dknotresolver.write=true}
 * writes it anew.
 */
class MacroReferenceTest {

	private static final Path FILE = Path.of("docs", "fiji.md");
	private static final String MARK = "<!-- commands: written by a test from the Commands; do not edit below -->\n";

	@Test
	void referenceIsWhatTheCommandsSay() throws IOException {
		final String text = Files.readString(FILE);
		final String before = text.substring(0, text.indexOf(MARK) + MARK.length());
		final String expected = before
			+ FormTest.commands().filter(c -> !Form.of(c).fields().isEmpty())
				.map(MacroReferenceTest::section).collect(Collectors.joining());
		if (Boolean.getBoolean("knotresolver.write"))
			Files.writeString(FILE, expected);
		else
			assertEquals(expected, text, "Write the reference anew, as this test's Javadoc says.");
	}

	private static String section(final KnotCommand command) {
		return "\n## " + command.getClass().getAnnotation(Plugin.class).label()
			+ "\nAs a Command: `" + command.getClass().getName()
			+ "`.\n\n| key | in the dialog | default | allowed |\n|---|---|---|---|\n"
			+ Form.of(command).fields().stream().map(MacroReferenceTest::row)
				.collect(Collectors.joining());
	}

	private static String row(final FormField field) {
		return "| `" + field.key() + "` | " + field.label()
			+ (field.description().isEmpty() ? "" : ": " + field.description()) + " | "
			+ (field.text().isEmpty() ? "" : "`" + field.text() + "`") + " | " + field.allowed()
			+ " |\n";
	}
}
