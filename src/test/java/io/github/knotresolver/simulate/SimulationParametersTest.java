
package io.github.knotresolver.simulate;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.stream.Stream;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

class SimulationParametersTest {

	private static Arguments wrong(final Executable call, final String sentence) {
		return Arguments.of(sentence, call);
	}

	static Stream<Arguments> wrongValues() {
		return Stream.of( //
			wrong(() -> FilamentProperties.microtubule(0),
				"The filament length must be 1 to 200 µm, but is 0."), //
			wrong(() -> FilamentProperties.microtubule(Double.NaN),
				"The filament length must be 1 to 200 µm, but is NaN."), //
			wrong(() -> MotorProperties.dynein(-1),
				"The motor density must be 0 to 1000 motors per µm², but is -1."), //
			wrong(() -> new Schedule(300, 1_000_000, 0.005, 0),
				"The number of frames must be 2 to 10000, but is 1000000."), //
			wrong(() -> new Schedule(300, 120, 0, 0),
				"The time step must be 1.0E-5 to 0.1 s, but is 0."), //
			wrong(() -> new PaperRenderer(Double.NaN, 1),
				"The signal-to-noise ratio must be -30 to 100 dB, but is NaN."), //
			wrong(() -> new Optics(1.5, 100, -3, 2, 10, 0, 1, 0),
				"The background must be 0 to 1000000 photons, but is -3."));
	}

	@ParameterizedTest(name = "{0}")
	@MethodSource("wrongValues")
	void aWrongValueIsOneSentence(final String sentence, final Executable call) {
		assertEquals(sentence, assertThrows(IllegalArgumentException.class, call).getMessage());
	}

	@Test
	void aMicrotubuleOfItsShearLengthHasHalfItsStiffness() {
		assertEquals(3150, FilamentProperties.microtubule(21).persistenceLength(), 1e-9);
	}

	@Test
	void motorsStallAndLetGoUnderLoad() {
		final MotorProperties p = MotorProperties.dynein(1);
		assertEquals(0.1, p.speedUnder(0), 1e-12);
		assertEquals(0.05, p.speedUnder(-p.stallForce() / 2), 1e-12);
		assertEquals(0, p.speedUnder(-2 * p.stallForce()), 0);
		assertEquals(0.2, p.speedUnder(10 * p.stallForce()), 1e-12);
		assertEquals(p.unbindingRate() * Math.E, p.unbindingRateUnder(p.unbindingForce()), 1e-9);
	}
}
