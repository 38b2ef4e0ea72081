package io.github.knotresolver.options;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Map;
import java.util.TreeMap;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import io.github.knotresolver.model.Calibration;
import io.github.knotresolver.model.UserException;

class CalibrationChoiceTest {

	@ParameterizedTest
	@ValueSource(strings = {"µm", "\u03bcm", "Âµm", "Î¼m", "\\u00B5m", "um", "um.", "UM", "micron",
		"microns", "Micron", "micrometer", "micrometers", "micrometre", "micrometres", "µm.",
		" \u00a0µm\u2009", "\ufffdm", "??m", "µ"})
	void everySpellingOfMicrometres(final String unit) {
		assertEquals("µm", UnitText.length(unit));
	}

	@ParameterizedTest
	@CsvSource(delimiter = '|', value = {"sec|s", "Seconds|s", "s.|s", "''|s", "msec|ms",
		"milliseconds|ms", "ms|ms", "µs|µs", "usec|µs", "min|min", "mins|min", "Minutes|min",
		"hr|h", "hours|h", "frames|frame", "weeks|weeks"})
	void unitsOfTime(final String unit, final String expected) {
		assertEquals(expected, UnitText.time(unit));
	}

	@ParameterizedTest
	@CsvSource({"5000,ms,5", "100,ms,0.1", "0.5,min,30", "0.001,h,3.6", "5,s,5", "2e6,µs,2"})
	void timesAreInSeconds(final double interval, final String unit, final double seconds) {
		assertEquals(new Calibration(0.1, "µm", seconds, "s"),
			over(new Calibration(0.1, "µm", interval, unit)));
	}

	@ParameterizedTest
	@CsvSource(delimiter = '|', value = {
		"0.106|nm|pixel_size=0.106|but not in which unit, and the image's own is nm",
		"0.01|inch|pixel_size=0.106|the image's own is inch",
		"0.01388|inch||which is no microscope's; tell pixel_size and unit",
		"0.00847|cm||which is no microscope's", "3|furlong||which is no microscope's",
		"1|pixel|unit=µm|the pixels' size is known in pixel only; tell pixel_size",
		"3|furlong|unit=µm|known in furlong only", "1|pixel|pixel_size=1e308|from 0.1 nm to 1 mm",
		"1|pixel|pixel_size=2 unit=px|in which a pixel is 1",
		"0.1|µm|frame_interval=1e300|to a year"})
	void unitsThatAreMissingOrDoNotFitAreRefused(final double size, final String unit,
		final String told, final String sentence) {
		final Calibration image = new Calibration(size, unit, 5, "s");
		final String message = assertThrows(UserException.class,
			() -> over(image, told == null ? new String[0] : told.split(" "))).getMessage();
		assertTrue(message.contains(sentence), message);
		assertFalse(message.contains("14.99"), message);
	}

	@Test
	void whatIsToldGoesOverTheImage() {
		final Calibration none = Calibration.NONE;
		assertEquals(new Calibration(0.106, "µm", 1, "frame"), over(none, "pixel_size=0.106"));
		final Calibration nm = new Calibration(106, "nm", 1, "frame");
		assertEquals(nm, over(nm));
		assertEquals(new Calibration(0.106, "µm", 1, "frame"), over(nm, "unit=um"));
		assertEquals(new Calibration(53, "nm", 1, "frame"), over(nm, "pixel_size=53", "unit=nm"));
		assertEquals(none, over(new Calibration(0.01, "inch", 1, "frame"), "unit=pixel"));
		assertEquals(new Calibration(0.2, "µm", 1, "frame"),
			over(new Calibration(0.01, "inch", 1, "frame"), "unit=µm", "pixel_size=0.2"));
	}

	@Test
	void timeThatIsNoneIsRefusedUnlessSecondsAreTold() {
		final Calibration image = new Calibration(0.1, "µm", 3, "fortnights");
		final String message = assertThrows(UserException.class, () -> over(image)).getMessage();
		assertTrue(message.contains("3 fortnights apart"), message);
		assertEquals(new Calibration(0.1, "µm", 2, "s"), over(image, "frame_interval=2"));
	}

	private static Calibration over(final Calibration image, final String... told) {
		final Map<String, String> texts = new TreeMap<>();
		for (final String pair : told)
			texts.put(pair.split("=")[0], pair.split("=")[1]);
		return RunOptions.parse(texts).input().over(image);
	}
}
