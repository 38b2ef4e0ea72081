package io.github.knotresolver.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Stream;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.scijava.plugin.Plugin;

import io.github.knotresolver.imagej.form.Form;
import io.github.knotresolver.imagej.form.FormField;
import io.github.knotresolver.imagej.form.MacroOptions;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.options.RunOptions;

/** The keys, labels and ranges of every Command, and how macros fill them in. */
class FormTest {

	static Stream<KnotCommand> commands() {
		return Stream.of(new ResolveFilamentCommand(), new TuneSegmentationCommand(),
			new ReviewResultCommand(), new CorrectFrameCommand(), new MeasureContoursCommand(),
			new BatchCommand(), new SimulateMovieCommand(), new EvaluateCommand(),
			new SampleCommand(), new CiteCommand());
	}

	@ParameterizedTest
	@MethodSource("commands")
	void labelsStartWithTheKeyAndDefaultsAreAllowed(final KnotCommand command) {
		final Form form = Form.of(command);
		form.check();
		for (final FormField field : form.fields()) {
			assertTrue(field.key().matches("[a-z][a-z_]*"), field.key());
			assertTrue(
				field.label().toLowerCase(Locale.ROOT).startsWith(field.key().replace('_', ' ')),
				field.key() + ": " + field.label());
		}
		final Map<String, String> before = form.texts();
		form.fill(before);
		assertEquals(before, form.texts());
	}

	@Test
	void everyFieldOfResolveIsInOneGroup() {
		final List<String> grouped = Stream
			.concat(ResolveGroups.ALL.basic().stream(),
				ResolveGroups.ALL.advanced().stream().flatMap(g -> g.names().stream()))
			.sorted().toList();
		assertEquals(Form.of(new ResolveFilamentCommand()).fields().stream().map(FormField::name)
			.sorted().toList(), grouped);
	}

	@Test
	void menuHasEveryCommandUnderItsLabel() throws Exception {
		try (InputStream in = FormTest.class.getResourceAsStream("/plugins.config")) {
			final String menu = new String(in.readAllBytes(), StandardCharsets.UTF_8);
			commands().map(Object::getClass)
				.forEach(type -> assertTrue(
					menu.contains("\"" + type.getAnnotation(Plugin.class).label() + "\", "
						+ CommandPlugIn.class.getName() + "(\"" + type.getSimpleName() + "\")"),
					type.getName()));
			assertEquals(commands().count(),
				Pattern.compile("^[^#\\n]", Pattern.MULTILINE).matcher(menu).results().count());
		}
	}

	/** ImageJ's recorder looks for {@code force=} anywhere, and finds it in {@code stall_force=}. */
	@ParameterizedTest
	@MethodSource("commands")
	void noKeyIsTheEndOfAnother(final KnotCommand command) {
		final List<String> keys = Form.of(command).fields().stream().map(FormField::key).toList();
		for (final String key : keys)
			for (final String other : keys)
				assertTrue(key.equals(other) || !other.endsWith(key), key + " ends " + other);
		assertEquals(keys.size(), Set.copyOf(keys).size());
	}

	@Test
	void resolveHasTheNamesOfTheCommandLine() {
		final List<String> names = Form.of(new ResolveFilamentCommand()).fields().stream()
			.map(FormField::name).toList();
		assertTrue(names.containsAll(RunOptions.KEYS), names.toString());
	}

	@ParameterizedTest
	@CsvSource({"ignored, ignore_frames", "ignore_frames, ignore_frames"})
	void macrosMayUseTheNamesOfTheCommandLine(final String key, final String name) {
		final Form form = Form.of(new ResolveFilamentCommand());
		form.fill(MacroOptions.parse(key + "=3,4", n -> null));
		assertEquals("3,4", form.texts().get(name));
		assertEquals("", form.texts().get("frames"));
	}

	@Test
	void macroOptionsAreReadByWholeKeys() {
		final var values = MacroOptions
			.parse(" ignore_frames=3 refine out=[/my folder [a]/x] unit='µ m' empty= n=&n ",
				name -> name.equals("n") ? "7.0" : null)
			.values();
		assertEquals(Map.of("ignore_frames", Optional.of("3"), "refine", Optional.empty(), "out",
			Optional.of("/my folder [a]/x"), "unit", Optional.of("µ m"), "empty", Optional.of(""),
			"n", Optional.of("7.0")), values);
		assertFalse(values.containsKey("frames"));
	}

	@Test
	void flagsAloneMeanYesAndCanBeDenied() {
		final ResolveFilamentCommand command = new ResolveFilamentCommand();
		final Form form = Form.of(command);
		form.fill(MacroOptions.parse("force refine=false plots=true", n -> null));
		assertEquals("true", form.texts().get("force"));
		assertEquals("false", form.texts().get("refine"));
		assertEquals("true", form.texts().get("plots"));
		assertEquals("true", form.texts().get("overlay"));
	}

	@ParameterizedTest
	@CsvSource(delimiter = '|', value = {
		"iterations=1001 | iterations must be a whole number from 0 to 1000, but is '1001'.",
		"iterations=2.5 | iterations must be a whole number from 0 to 1000, but is '2.5'.",
		"contraction_bias=-2 | contraction_bias must be a number from -1 to 1, but is '-2'.",
		"channel=0 | channel must be a whole number from 1 on, but is '0'.",
		"refine=maybe | refine must be true or false, but is 'maybe'.",
		"length_model=soft | length_model must be auto or constant or free, but is 'soft'.",
		"image=[no such] | image must be the title of an open image, but is 'no such'.",
		"threshold | threshold needs a value, such as threshold=[otsu]; it must be text.",
		"ignored=3 ignore_frames=4 | The keys 'ignored' and 'ignore_frames' mean the same; name one of them.",
		"force force | The key 'force' is there twice; name it once.",
		"out=[/a | The value of out has no closing ']'; add it.",
		"threads=&n | threads is &n, but the macro has no variable of that name; define it before."})
	void wrongOptionsAreRefusedInOneSentence(final String options, final String sentence) {
		final Form form = Form.of(new ResolveFilamentCommand());
		assertEquals(sentence, assertThrows(UserException.class,
			() -> form.fill(MacroOptions.parse(options, n -> null))).getMessage());
	}
}
