
package io.github.knotresolver.simulate;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.stream.Stream;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

import io.github.knotresolver.model.UserException;

class SimulationParametersTest {

	private static Arguments wrong(final Executable call, final String sentence) {
		return Arguments.of(sentence, call);
	}

	static Stream<Arguments> wrongValues() {
		return Stream.of( //
			wrong(() -> FilamentProperties.microtubule(0),
				"length must be 1 to 200 µm, but is 0; choose a value in that range."), //
			wrong(() -> FilamentProperties.microtubule(Double.NaN),
				"length must be 1 to 200 µm, but is NaN; choose a value in that range."), //
			wrong(() -> MotorProperties.dynein(-1),
				"density must be 0 to 1000 motors per µm², but is -1; choose a value in that range."), //
			wrong(() -> new Schedule(300, 1_000_000, 0.005, 0),
				"frames must be 2 to 10000, but is 1000000; choose a value in that range."), //
			wrong(() -> new Schedule(300, 120, 0, 0),
				"time_step must be 0.00001 to 0.1 s, but is 0; choose a value in that range."), //
			wrong(() -> new PaperRenderer(Double.NaN, 1),
				"snr must be -30 to 100 dB, but is NaN; choose a value in that range."), //
			wrong(() -> new Optics(1.5, 100, -3, 2, 10, 0, 1, 0),
				"background must be 0 to 1000000 photons, but is -3; choose a value in that range."));
	}

	@ParameterizedTest(name = "{0}")
	@MethodSource("wrongValues")
	void aWrongValueIsOneSentence(final String sentence, final Executable call) {
		assertEquals(sentence, assertThrows(UserException.class, call).getMessage());
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
