
package io.github.knotresolver.options;

import static org.junit.jupiter.api.Assertions.assertAll;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.TreeSet;

import net.imglib2.img.array.ArrayImgs;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.io.CorrectionsCsv;
import io.github.knotresolver.model.Calibration;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.Region;
import io.github.knotresolver.model.Settings;
import io.github.knotresolver.model.Settings.CandidateMethod;
import io.github.knotresolver.model.Settings.LengthModel;
import io.github.knotresolver.model.Settings.ResolverMethod;
import io.github.knotresolver.model.UserException;

class RunOptionsTest {

	private static final Movie MOVIE = new Movie("m", ArrayImgs.unsignedBytes(20, 10, 50),
		new Calibration(0.5, "µm", 2, "s"));

	@TempDir
	Path home;

	@Test
	void nothingGivenIsTheDefault() {
		assertEquals(Settings.DEFAULT,
			RunOptions.parse(Map.of("threshold", " ", "length", "")).parameters(MOVIE));
		assertEquals(InputOptions.DEFAULT, RunOptions.parse(Map.of()).input());
	}

	@Test
	void everyKeyIsRead() throws IOException {
		final Path corrections = Files.writeString(home.resolve("c.csv"),
			"frame,index,x_px,y_px\n3,0,1,2\n3,1,4,2\n");
		final RunOptions options = RunOptions.parse(Map.ofEntries(Map.entry("fixed_end", "3, 4.5"),
			Map.entry("threshold", "0.3"), Map.entry("iterations", "7"),
			Map.entry("contraction_bias", "-0.5"), Map.entry("smooth_factor", "1"),
			Map.entry("log_size", "9"), Map.entry("log_sigma", "1.5"),
			Map.entry("candidates", "paper"), Map.entry("resolver", "PAPER"),
			Map.entry("length", "6"), Map.entry("length_model", "free"),
			Map.entry("refine", "false"), Map.entry("channel", "2"), Map.entry("z_as_time", "true"),
			Map.entry("frames", "1-4,9"), Map.entry("ignore_frames", "[2 3]"),
			Map.entry("corrections", corrections.toString()), Map.entry("pixel_size", "0.2"),
			Map.entry("frame_interval", "3"), Map.entry("unit", "micron"),
			Map.entry("threads", "3")));
		final Settings p = options.settings(MOVIE, CorrectionsCsv.of(options));
		assertThrows(IllegalStateException.class, () -> options.parameters(MOVIE));
		assertEquals(Optional.of(new Point(3, 4.5)), p.fixedEnd());
		assertEquals(OptionalDouble.of(0.3), p.segmentation().threshold());
		assertEquals(7, p.segmentation().iterations());
		assertEquals(-0.5, p.segmentation().contractionBias());
		assertEquals(1, p.segmentation().smoothFactor());
		assertEquals(9, p.cleaning().logSize());
		assertEquals(1.5, p.cleaning().logSigma());
		assertEquals(CandidateMethod.PAPER, p.candidates());
		assertEquals(ResolverMethod.PAPER, p.resolver());
		assertEquals(12, p.length().getAsDouble(), 1e-12);
		assertEquals(LengthModel.FREE, p.lengthModel());
		assertEquals(false, p.refine());
		assertEquals(List.of(1, 2, 3, 4, 9), List.copyOf(p.frames()));
		assertEquals(List.of(2, 3), List.copyOf(p.ignoreFrames()));
		assertEquals(3, p.corrections().get(3).length());
		assertEquals(3, p.threads());
		assertEquals(new InputOptions(2, true, OptionalDouble.of(0.2), OptionalDouble.of(3),
			Optional.of("µm")), options.input());
	}

	@Test
	void regionIsReadAndMustLieInTheMovie() {
		final RunOptions options = RunOptions.parse(Map.of("region", "2, 3,20,15"));
		final Movie large = new Movie("l", ArrayImgs.floats(40, 40, 3), Calibration.NONE);
		final Region region = options.parameters(large).region().orElseThrow();
		assertEquals(new Region(2, 3, 20, 15), region);
		assertEquals("2,3,20,15", region.toString());
		assertTrue(assertThrows(UserException.class, () -> options.parameters(MOVIE)).getMessage()
			.startsWith("The region 2,3,20,15 (x,y,width,height) reaches outside of 'm'"));
		for (final String wrong : List.of("2,3,20", "2,3,20,1.5", "-2,3,20,15", "a,b,c,d"))
			assertEquals(
				"region must be X,Y,WIDTH,HEIGHT in whole pixels, such as 10,0,120,80, but is '"
					+ wrong + "'.",
				assertThrows(UserException.class, () -> RunOptions.parse(Map.of("region", wrong)))
					.getMessage());
	}

	@ParameterizedTest
	@CsvSource(delimiter = '|', value = {
		"threshold|1.5|threshold must be a number from 0 to 1, or otsu, but is '1.5'.",
		"threshold|half|threshold must be a number from 0 to 1, or otsu, but is 'half'.",
		"threshold|NaN|threshold must be a number from 0 to 1, or otsu, but is 'NaN'.",
		"iterations|2.5|iterations must be a whole number, but is '2.5'.",
		"iterations|-1|iterations must be from 0 to 1000, but is -1.",
		"contraction_bias|2|contraction_bias must be from -1 to 1, but is 2.",
		"smooth_factor|a|smooth_factor must be a number, but is 'a'.",
		"log_size|9|log_size and log_sigma go together, but only log_size was given.",
		"candidates|all|candidates must be paper or trails, but is 'all'.",
		"length|0|length must be above 0, but is '0'.",
		"length_model|elastic|length_model must be auto or constant or free, but is 'elastic'.",
		"refine|maybe|refine must be true or false, but is 'maybe'.",
		"channel|0|channel must be a whole number from 1 on, but is '0'.",
		"frames|0-3|frames must be frames counted from 1, such as 1-40,45, but is '0-3'.",
		"ignore_frames|7-3|ignore_frames must be frames counted from 1, such as 1-40,45, but is '7-3'.",
		"frames|1-9999999|frames must be frames of a movie, from 1 to 1000000, but is '1-9999999'.",
		"frames|99999999999|frames must be frames counted from 1, such as 1-40,45, but is '99999999999'.",
		"fixed_end|12|fixed_end must be X,Y in pixels, such as 46,90.5, but is '12'.",
		"fixed_end|1,2,3|fixed_end must be X,Y in pixels, such as 46,90.5, but is '1,2,3'.",
		"fixed_end|20,3|fixed_end must lie inside the image of 20 x 10 pixels, but is 20.0,3.0.",
		"frames|48-51|frames names frame 51, but the movie has 50 frames.",
		"pixel_size|-1|pixel_size must be above 0, but is '-1'.",
		"pixel_size|1e999|pixel_size must be a number, but is '1e999'.",
		"threads|0|threads must be a whole number from 1 on, but is '0'."})
	void refusalsNameKeyValueAndWhatWasExpected(final String key, final String text,
		final String sentence) {
		assertEquals(sentence, assertThrows(UserException.class,
			() -> RunOptions.parse(Map.of(key, text)).parameters(MOVIE)).getMessage());
	}

	@Test
	void unknownKeysAreNamed() {
		final String message = assertThrows(UserException.class,
			() -> RunOptions.parse(Map.of("treshold", "1"))).getMessage();
		assertTrue(message.contains("'treshold'") && message.contains("threshold"), message);
	}

	@Test
	void whatIsWrittenIsReadBack() {
		final Map<String, String> texts = Map.ofEntries(Map.entry("fixed_end", "3.0,4.5"),
			Map.entry("region", "1,1,12,8"), Map.entry("threshold", "0.3"),
			Map.entry("iterations", "7"), Map.entry("contraction_bias", "-0.5"),
			Map.entry("smooth_factor", "1.0"), Map.entry("segmentation", "active_contour"),
			Map.entry("log_size", "9"), Map.entry("log_sigma", "1.5"),
			Map.entry("candidates", "paper"), Map.entry("resolver", "paper"),
			Map.entry("length", "6.0"), Map.entry("length_model", "free"),
			Map.entry("refine", "false"), Map.entry("channel", "2"), Map.entry("z_as_time", "true"),
			Map.entry("frames", "1-4,9"), Map.entry("ignore_frames", "2-3"));
		final RunOptions options = RunOptions.parse(texts);
		final Map<String, Object> values = RunOptions.values(options.parameters(MOVIE),
			options.input(), MOVIE.calibration());
		texts.forEach((key, text) -> assertEquals(text, String.valueOf(values.get(key)), key));
		assertEquals(MOVIE.calibration().pixelSize(), values.get("pixel_size"));
		assertEquals(MOVIE.calibration().frameInterval(), values.get("frame_interval"));
		final Set<String> unwritten = new TreeSet<>(RunOptions.KEYS);
		unwritten.removeAll(values.keySet());
		assertEquals(Set.of("corrections", "threads"), unwritten);
	}

	@Test
	void everyOptionSaysWhatItIs() {
		for (final Option option : ResolveOptions.ALL)
			assertAll(option.key(),
				() -> assertTrue(option.key().matches("[a-z]+(_[a-z]+)*"), "key"),
				() -> assertTrue(option.help().matches("[A-Z].*[^.]"), "help"),
				() -> assertFalse(option.byDefault().isEmpty(), "default"),
				() -> assertEquals(option.kind() == Option.Kind.FLAG, option.values().isEmpty(),
					"values"),
				() -> assertEquals(option.kind() == Option.Kind.CHOICE,
					option.choices().contains(option.byDefault()), "choices"));
	}

	@Test
	void toldCalibrationGoesOverTheImages() {
		final InputOptions told = RunOptions.parse(Map.of("pixel_size", "0.2")).input();
		assertEquals(new Calibration(0.2, "µm", 1, "frame"), told.over(Calibration.NONE));
		final InputOptions interval = RunOptions.parse(Map.of("frame_interval", "3", "unit", "um"))
			.input();
		assertEquals(new Calibration(0.005, "µm", 3, "s"),
			interval.over(new Calibration(5, "nm", 2, "min")));
	}

	@ParameterizedTest
	@CsvSource(delimiter = '|', value = {"1-40,45|1-40,45", "[1 5 7]|1,5,7", "1;5;7|1,5,7",
		"3,2,1,5|1-3,5", "2 - 4|2-4", "[]|''"})
	void framesAreReadAsPeopleWriteThem(final String text, final String formatted) {
		assertEquals(formatted, FrameSelection.format(FrameSelection.parse("frames", text)));
		assertEquals(FrameSelection.parse("frames", text),
			FrameSelection.parse("frames", formatted));
	}

	@Test
	void noFramesAreNoText() {
		assertEquals("", FrameSelection.format(new TreeSet<>()));
	}
}
