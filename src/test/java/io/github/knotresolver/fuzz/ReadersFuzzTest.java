package io.github.knotresolver.fuzz;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.ShrinkingMode;
import net.jqwik.api.Tuple;

import io.github.knotresolver.imagej.form.MacroOptions;
import io.github.knotresolver.io.BatchSheet;
import io.github.knotresolver.io.ContourInput;
import io.github.knotresolver.io.ContoursCsv;
import io.github.knotresolver.io.CorrectionsCsv;
import io.github.knotresolver.io.ResolvedRun;
import io.github.knotresolver.io.TruthCsv;
import io.github.knotresolver.options.RunOptions;
import io.github.knotresolver.run.MeasureRun;

/** Every reader understands what it is given, or refuses it in a sentence, and soon. */
class ReadersFuzzTest extends Fuzzing {

	private static final String SEED = "20260101";

	private static final List<String> POINTS = List.of("frame", "index", "x_px", "y_px");

	@Provide
	Arbitrary<byte[]> contours() {
		return Drawings.table(POINTS,
			List.of("x", "y", "arc_length", "tangent_angle", "curvature", "unit", "filament"));
	}

	@Provide
	Arbitrary<byte[]> corrections() {
		return Drawings.table(List.of("filament", "frame", "kind", "index", "x_px", "y_px"),
			List.of("note"));
	}

	@Provide
	Arbitrary<byte[]> sheets() {
		final List<String> more = new ArrayList<>(RunOptions.KEYS);
		more.addAll(List.of("segThresh", "segIteration", "segContract", "segSmooth",
			"requiresManual", "IgnoreFrames", "useLogP", "logPk", "logPs", "InvertManual",
			"manualCheck", "Comment", "FILENAME"));
		return Drawings.table(List.of("FileName", "FolderPath"), more);
	}

	private static final Guard CONTOURS = new Guard("contours");

	@Property(seed = SEED, shrinking = ShrinkingMode.OFF)
	void contoursAreReadOrRefused(@ForAll("contours") final byte[] bytes) {
		final Path file = folder.write("contours.csv", bytes);
		CONTOURS.run(() -> Drawings.shown(bytes), () -> ContoursCsv.read(file));
	}

	private static final Guard CORRECTIONS = new Guard("corrections");

	@Property(seed = SEED, shrinking = ShrinkingMode.OFF)
	void correctionsAreReadOrRefused(@ForAll("corrections") final byte[] bytes) {
		final Path file = folder.write("corrections.csv", bytes);
		CORRECTIONS.run(() -> Drawings.shown(bytes),
			() -> CorrectionsCsv.of(RunOptions.parse(Map.of("corrections", file.toString()))));
	}

	private static final Guard TRUTH = new Guard("truth");

	@Property(seed = SEED, shrinking = ShrinkingMode.OFF)
	void truthIsReadOrRefused(@ForAll("contours") final byte[] bytes) {
		final Path file = folder.write("truth.csv", bytes);
		TRUTH.run(() -> Drawings.shown(bytes), () -> TruthCsv.read("truth", file));
	}

	private static final Guard SHEETS = new Guard("sheets");

	@Property(seed = SEED, shrinking = ShrinkingMode.OFF)
	void sheetsAreReadRowByRow(@ForAll("sheets") final byte[] bytes) {
		final Path file = folder.write("sheet.csv", bytes);
		final List<Runnable> rows = new ArrayList<>();
		SHEETS.run(() -> Drawings.shown(bytes),
			() -> BatchSheet.read(file).rows().forEach(r -> rows.add(r::options)));
		for (final Runnable row : rows)
			SHEETS.run(() -> Drawings.shown(bytes), row);
	}

	private static final String PARAMETERS = """
		{"program": "KnotResolver", "version": "0.1.0",
		"movie": {"name": "knot.tif", "width": 100, "height": 54, "frames": 24, "file": "/a/knot.tif"},
		"options": {"fixed_end": null, "region": "1,2,30,40", "threshold": "otsu", "iterations": 10,
		"contraction_bias": 0.4, "log_size": null, "candidates": "trails", "refine": true, "channel": 1,
		"frames": "1-4", "pixel_size": 0.106, "unit": "µm", "frame_interval": 5.0, "time_unit": "s"},
		"corrections": {}, "found": {"fixed_end": "28.662,24.693", "length": 15.0487, "resolved_frames": 24},
		"notes": ["Line model: additive line."]}
		""";

	@Provide
	Arbitrary<byte[]> parameters() {
		final String[] values = {"null", "true", "-1", "1e999", "0", "\"\"", "{}", "[]", "[[[[]]]]",
			"{\"a\": 1}", "\"1e308\"", "99999999999", "\"nm\"", "NaN", "'x'", "[1, 2]",
			"\"\\u0000\""};
		final Arbitrary<String> changed = Combinators
			.combine(Arbitraries.integers().between(0, 24), Arbitraries.of(values)).as((n, v) -> {
				final String[] parts = PARAMETERS.split("(?<=: )", -1);
				if (n == 0 || n >= parts.length)
					return PARAMETERS;
				parts[n] = parts[n].replaceFirst("^(\"[^\"]*\"|\\{[^}]*\\}|\\[[^\\]]*\\]|[^,}]*)",
					java.util.regex.Matcher.quoteReplacement(v));
				return String.join("", parts);
			});
		return Combinators
			.combine(
				Arbitraries.frequencyOf(Tuple.of(9, changed),
					Tuple.of(1, Arbitraries.of("[".repeat(9000), "{\"a\":".repeat(5000), "", "1"))),
				Drawings.edits())
			.as((text, edits) -> Drawings.damaged(text.getBytes(StandardCharsets.UTF_8), edits));
	}

	private static final Guard RESULTS = new Guard("results");

	@Property(seed = SEED, shrinking = ShrinkingMode.OFF)
	void resultsAreReadOrRefused(@ForAll("parameters") final byte[] json,
		@ForAll("contours") final byte[] contours) {
		folder.write("parameters.json", json);
		folder.write("contours.csv", contours);
		RESULTS.run(() -> Drawings.shown(json) + Drawings.shown(contours),
			() -> ContourInput.read(folder.path()));
		RESULTS.run(() -> Drawings.shown(json) + Drawings.shown(contours),
			() -> ResolvedRun.read(folder.path()));
	}

	@Provide
	Arbitrary<String> macros() {
		final List<String> keys = new ArrayList<>(RunOptions.KEYS);
		keys.addAll(List.of("movie", "force", "=", "[", "''", "&"));
		final Arbitrary<String> word = Combinators
			.combine(Arbitraries.of(keys),
				Arbitraries.of("=", "=", "=", "", "=[", "='", "= ", "=&"), Drawings.odd(),
				Arbitraries.of("", "", "]", "'", " ", "]]"))
			.as((key, equals, value, end) -> key + equals + value + end);
		return word.list().ofMaxSize(5).map(words -> String.join(" ", words));
	}

	private static final Guard MACROS = new Guard("macros");

	@Property(seed = SEED, shrinking = ShrinkingMode.OFF)
	void macroOptionsAreReadOrRefused(@ForAll("macros") final String options) {
		MACROS.run(() -> options, () -> {
			final Map<String, String> texts = new TreeMap<>();
			MacroOptions.parse(options, name -> name.length() > 2 ? null : "7").values()
				.forEach((key, value) -> {
					if (RunOptions.KEYS.contains(key))
						texts.put(key, value.orElse("true"));
				});
			RunOptions.parse(texts);
		});
	}

	@Provide
	Arbitrary<Map<String, String>> options() {
		final List<String> keys = new ArrayList<>(RunOptions.KEYS);
		keys.addAll(MeasureRun.KEYS);
		return Arbitraries.maps(Arbitraries.of(keys), Drawings.odd()).ofMaxSize(4);
	}

	private static final Guard OPTIONS = new Guard("options");

	@Property(seed = SEED, shrinking = ShrinkingMode.OFF)
	void optionsAreReadOrRefused(@ForAll("options") final Map<String, String> texts) {
		OPTIONS.run(texts::toString, () -> RunOptions.parse(texts));
		OPTIONS.run(texts::toString, () -> MeasureRun.parse(texts));
	}
}
