package io.github.knotresolver.imagej;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.util.List;
import java.util.stream.IntStream;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import io.github.knotresolver.model.FrameStatus;

/**
 * Colours that mean something are told apart by people with any colour vision. How dichromats see is
 * simulated after Machado, Oliveira and Fernandes 2009 (DOI 10.1109/TVCG.2009.113, severity 1);
 * distances are those of CIELAB, of which 2.3 is just noticeable (Mahy, Van Eycken and Oosterlinck 1994, DOI
 * 10.1002/col.5080190207).
 */
class PaletteTest {

	/** Some times what is just noticeable; where height or a mark says the same, less would do. */
	private static final double APART = 10;

	/** What each kind of cones' lack makes of linear red, green and blue. */
	enum Vision {
		USUAL(1, 0, 0, 0, 1, 0, 0, 0, 1), PROTANOPE(0.152286, 1.052583, -0.204868, 0.114503,
			0.786281, 0.099216, -0.003882, -0.048116, 1.051998), DEUTERANOPE(0.367322, 0.860646,
				-0.227968, 0.280085, 0.672501, 0.047413, -0.011820, 0.042940,
				0.968881), TRITANOPE(1.255528, -0.076749, -0.178779, -0.078411, 0.930809, 0.147602,
					0.004733, 0.691367, 0.303900);

		private final double[] matrix;

		Vision(final double... matrix) {
			this.matrix = matrix;
		}

		/** @return lightness, and two axes of colour */
		double[] lab(final Color colour) {
			final double[] rgb = {linear(colour.getRed()), linear(colour.getGreen()),
				linear(colour.getBlue())};
			final double[] seen = times(matrix, rgb);
			for (int i = 0; i < seen.length; i++)
				seen[i] = Math.min(1, Math.max(0, seen[i]));
			final double[] xyz = times(new double[]{0.4124564, 0.3575761, 0.1804375, 0.2126729,
				0.7151522, 0.0721750, 0.0193339, 0.1191920, 0.9503041}, seen);
			final double x = root(xyz[0] / 0.95047), y = root(xyz[1]), z = root(xyz[2] / 1.08883);
			return new double[]{116 * y - 16, 500 * (x - y), 200 * (y - z)};
		}

		private static double linear(final int value) {
			final double v = value / 255.0;
			return v <= 0.04045 ? v / 12.92 : Math.pow((v + 0.055) / 1.055, 2.4);
		}

		private static double root(final double t) {
			return t > 216.0 / 24389 ? Math.cbrt(t) : (24389.0 / 27 * t + 16) / 116;
		}

		private static double[] times(final double[] matrix, final double[] v) {
			return IntStream.range(0, 3)
				.mapToDouble(
					i -> matrix[3 * i] * v[0] + matrix[3 * i + 1] * v[1] + matrix[3 * i + 2] * v[2])
				.toArray();
		}
	}

	@ParameterizedTest
	@EnumSource
	void confidencesAreToldApart(final Vision vision) {
		assertApart(vision, List.of(Palette.ofConfidence(0.95), Palette.ofConfidence(0.7),
			Palette.ofConfidence(0.2), new Color(0x58, 0x58, 0x58)));
	}

	@ParameterizedTest
	@EnumSource
	void statesAreToldApart(final Vision vision) {
		assertApart(vision, List.of(Palette.of(FrameStatus.RESOLVED),
			Palette.of(FrameStatus.CORRECTED), Palette.of(FrameStatus.UNRESOLVED)));
	}

	@ParameterizedTest
	@EnumSource
	void eightFilamentsAreToldApart(final Vision vision) {
		assertApart(vision, IntStream.rangeClosed(1, 8).mapToObj(Palette::ofFilament).toList());
	}

	/** The fixed end is told from the tip, and the way between by its lightness from the middle on. */
	@ParameterizedTest
	@EnumSource
	void theWayAlongAFilamentIsSeen(final Vision vision) {
		assertApart(vision,
			IntStream.rangeClosed(0, 6).mapToObj(i -> Palette.along(i / 6.0)).toList());
		double before = vision.lab(Palette.along(0.4))[0];
		for (double at = 0.5; at <= 1; at += 0.1) {
			final double next = vision.lab(Palette.along(at))[0];
			assertTrue(next > before, vision + " at " + at + ": " + next + " after " + before);
			before = next;
		}
	}

	private static void assertApart(final Vision vision, final List<Color> colours) {
		for (final Color a : colours)
			for (final Color b : colours)
				if (!a.equals(b)) {
					final double[] one = vision.lab(a), other = vision.lab(b);
					final double apart = Math.hypot(one[0] - other[0],
						Math.hypot(one[1] - other[1], one[2] - other[2]));
					assertTrue(apart >= APART, vision + ": " + a + " and " + b + " are " + apart);
				}
	}
}
