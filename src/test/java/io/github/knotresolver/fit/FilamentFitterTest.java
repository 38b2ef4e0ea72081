
package io.github.knotresolver.fit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import io.github.knotresolver.geometry.Polyline;

class FilamentFitterTest {

	private static final int SIZE = 90;
	private static final int LINKS = 40;

	@ParameterizedTest
	@EnumSource
	void givesBackAKnownCurveFromACleanPicture(final LineModel.Kind kind) {
		final LineModel model = LineModel.uniform(kind, 1.6,
			kind == LineModel.Kind.ADDITIVE ? 1 : 1.5);
		final Chain truth = loop(0.42);
		final NormalizedFrame frame = picture(truth, model);
		final FilamentFitter fitter = new FilamentFitter(frame, model, LINKS,
			Optional.of(truth.start()), new FitSettings(1e-4, 3, 0, 60, 1e-9, false));
		final Fit fit = fitter.fit(loop(0.40), Optional.empty());
		assertTrue(fit.chain().distance(truth) < 0.02,
			kind + " is off by " + fit.chain().distance(truth) + " px");
	}

	@ParameterizedTest
	@EnumSource
	void findsTheLength(final LineModel.Kind kind) {
		final LineModel model = LineModel.uniform(kind, 1.6,
			kind == LineModel.Kind.ADDITIVE ? 1 : 1.5);
		final Chain truth = loop(0.2);
		final NormalizedFrame frame = picture(truth, model);
		final FilamentFitter fitter = new FilamentFitter(frame, model, LINKS, Optional.empty(),
			new FitSettings(1e-4, 0, 0, 100, 1e-10, true));
		final Polyline curve = truth.polyline();
		final Fit fit = fitter.fit(
			Chain.along(curve.head(108).reversed().head(100).reversed(), LINKS, 100),
			Optional.empty());
		assertEquals(truth.length(), fit.chain().length(), 0.05);
		assertTrue(fit.chain().distance(truth) < 0.05,
			kind + " is off by " + fit.chain().distance(truth) + " px");
	}

	@Test
	void givesUpWhatStaysTooDearAndNothingElse() {
		final LineModel model = LineModel.uniform(LineModel.Kind.ADDITIVE, 1.6, 1);
		final Chain truth = loop(0.42);
		final FilamentFitter fitter = new FilamentFitter(picture(truth, model), model, LINKS,
			Optional.of(truth.start()), FitSettings.DEFAULT);
		final Fit right = fitter.fit(loop(0.40), Optional.empty());
		final Fit same = fitter.fit(loop(0.40), Optional.empty(), right.energy());
		assertEquals(right.energy(), same.energy());
		assertEquals(right.iterations(), same.iterations());
		// Wound the other way it follows nothing of the loop, however long it is fitted.
		final Fit wrong = fitter.fit(loop(-0.40), Optional.empty());
		final Fit givenUp = fitter.fit(loop(-0.40), Optional.empty(), right.energy());
		assertTrue(wrong.energy() > right.energy() + 10, "the other way costs " + wrong.energy());
		assertTrue(givenUp.iterations() < wrong.iterations(),
			givenUp.iterations() + " of " + wrong.iterations() + " steps");
	}

	private static NormalizedFrame picture(final Chain chain, final LineModel model) {
		final double[] x = new double[LINKS + 1], y = new double[LINKS + 1];
		chain.nodes(x, y);
		final double[] picture = new double[SIZE * SIZE];
		ImageTerm.of(new NormalizedFrame(SIZE, SIZE, new double[SIZE * SIZE]), model, LINKS).draw(x,
			y, LINKS, new Patch(0, 0, SIZE, SIZE), picture);
		return new NormalizedFrame(SIZE, SIZE, picture);
	}

	/** A chain that runs straight and then winds with a given turn per link. */
	private static Chain loop(final double turn) {
		final double[] theta = new double[LINKS];
		for (int i = 0; i < LINKS; i++)
			theta[i] = 0.05 * i + (i < 20 ? 0 : (i - 20) * turn);
		return new Chain(20.3, 30.7, theta, 3);
	}
}
