package io.github.knotresolver.fit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.Random;
import java.util.function.UnaryOperator;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import io.github.knotresolver.fit.FilamentEstimator.Sighting;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;

class FilamentEstimatorTest {

	private static final double LENGTH = 80;

	@ParameterizedTest
	@EnumSource(names = {"SATURATING", "ADDITIVE"})
	void learnsLineLengthAndFixedEnd(final LineModel.Kind kind) {
		final LineModel model = LineModel.uniform(kind, 1.7,
			kind == LineModel.Kind.ADDITIVE ? 1 : 1.6);
		final FilamentEstimate estimate = estimate(model);
		assertEquals(kind, estimate.model().kind());
		assertEquals(1.7, estimate.model().sigma(), 0.05);
		assertEquals(model.power(), estimate.model().power(), 0.15);
		assertEquals(LENGTH, estimate.length(), 0.005 * LENGTH);
		assertTrue(estimate.lengthError() < 0.01 * LENGTH, "error " + estimate.lengthError());
		assertEquals(0, estimate.fixedEnd().distanceTo(new Point(22.4, 55.3)), 0.4);
	}

	@Test
	void aDimTipIsStillTheTip() {
		final LineModel model = new LineModel(LineModel.Kind.ADDITIVE, 1.7, 1,
			new double[]{1, 1, 1, 1, 0.4});
		final FilamentEstimate estimate = estimate(model);
		final double[] brightness = estimate.model().brightness();
		assertTrue(brightness[brightness.length - 1] < 0.8,
			"the tip looks " + brightness[brightness.length - 1]);
		assertEquals(LENGTH, estimate.length(), 0.02 * LENGTH);
	}

	@Test
	void aFilamentThatFadesTowardsItsTipIsNotCutShort() {
		final double[] fading = {1, 0.9, 0.8, 0.7, 0.6, 0.5, 0.4, 0.3, 0.2};
		final FilamentEstimate estimate = estimate(
			new LineModel(LineModel.Kind.ADDITIVE, 1.7, 1, fading));
		final double[] brightness = estimate.model().brightness();
		assertTrue(brightness[brightness.length - 1] < 0.5,
			"the tip looks " + brightness[brightness.length - 1]);
		assertEquals(LENGTH, estimate.length(), 0.01 * LENGTH);
	}

	/** In one frame noise moves such a tip by a pixel. */
	@Test
	void allFramesTogetherSayHowLongAFilamentIsThatFades() {
		final double[] fading = {1, 0.9, 0.8, 0.7, 0.6, 0.5, 0.4, 0.3, 0.2};
		for (final boolean fromTip : new boolean[]{false, true}) {
			final LineModel model = new LineModel(LineModel.Kind.ADDITIVE, 1.7, 1, fading);
			final FilamentEstimate estimate = estimate(fromTip ? model.reversed() : model, 0.06,
				f -> f);
			final double[] brightness = estimate.model().brightness();
			assertEquals(LENGTH, estimate.length(), 0.007 * LENGTH);
			assertEquals(1.7, estimate.model().sigma(), 0.03);
			assertEquals(0.2,
				estimate.amplitude() * brightness[fromTip ? 0 : brightness.length - 1], 0.05);
		}
	}

	/** Like a worm: bright up to the last tenth at both ends, and there dimmer and dimmer. */
	@Test
	void endsThatTaperAreFollowedToTheirLight() {
		final double[] tapering = new double[21];
		Arrays.fill(tapering, 1);
		for (int i = 0; i < 3; i++)
			tapering[i] = tapering[20 - i] = 0.2 + 0.25 * i;
		final FilamentEstimate estimate = estimate(
			new LineModel(LineModel.Kind.ADDITIVE, 1.7, 1, tapering));
		assertEquals(LENGTH, estimate.length(), 0.035 * LENGTH);
		assertEquals(0, estimate.fixedEnd().distanceTo(new Point(22.4, 55.3)), 1.8);
	}

	/** Haze a fifth as bright as the filament, where its tip is, in all frames, and noise. */
	@Test
	void aFilamentIsNotLedOnIntoHaze() {
		final double[] hazy = new double[81];
		Arrays.fill(hazy, 1);
		Arrays.fill(hazy, 81 - 8, 81, 0.2);
		final FilamentEstimate estimate = estimate(
			new LineModel(LineModel.Kind.ADDITIVE, 1.7, 1, hazy), 0.2, f -> f);
		assertEquals(LENGTH - 8, estimate.length(), 0.03 * LENGTH);
		assertFalse(estimate.guessed());
	}

	/** The same haze, out of which the picture's border cuts a piece. */
	@Test
	void howLongAFilamentIsThatFadesAtTheBorderIsAGuess() {
		final double[] hazy = new double[81];
		Arrays.fill(hazy, 1);
		Arrays.fill(hazy, 0, 8, 0.2);
		final int left = 22;
		final FilamentEstimate estimate = estimate(
			new LineModel(LineModel.Kind.ADDITIVE, 1.7, 1, hazy), 0.2,
			f -> f.window(left, 0, f.width() - left, f.height()), new Point(-left, 0));
		assertTrue(estimate.guessed());
	}

	/**
	 * Noise half as strong as the filament, in a haze of clouds several lines wide: compared in units
	 * of its brightness, the line would be best that looks brightest.
	 */
	@Test
	void inNoiseAndHazeALineIsAsWideAsItIs() {
		final Random random = new Random(5);
		final FilamentEstimate estimate = estimate(LineModel.uniform(LineModel.Kind.ADDITIVE, 2, 1),
			0.5, frame -> {
				final double[] hazy = frame.pixels().clone();
				final double phase = 6 * random.nextDouble();
				for (int i = 0; i < hazy.length; i++)
					hazy[i] += 0.4 * Math.sin(i % frame.width() / 6.0 + phase)
						* Math.sin(i / frame.width() / 6.0 - phase);
				return new NormalizedFrame(frame.width(), frame.height(), hazy);
			});
		assertEquals(2, estimate.model().sigma(), 0.3);
		assertEquals(LENGTH, estimate.length(), 0.03 * LENGTH);
	}

	@Test
	void whatTheCameraCutsOffDoesNotShortenAFilament() {
		final double noise = 0.05, ceiling = 0.55;
		final FilamentEstimate estimate = estimate(
			LineModel.uniform(LineModel.Kind.ADDITIVE, 1.5, 1), noise, frame -> {
				final double[] cut = Arrays.stream(frame.pixels()).map(v -> Math.min(ceiling, v))
					.toArray(), height = new double[cut.length];
				Arrays.fill(height, ceiling - noise);
				return new NormalizedFrame(frame.width(), frame.height(), cut).withCeiling(height);
			});
		assertEquals(LineModel.Kind.ADDITIVE, estimate.model().kind());
		assertEquals(1, estimate.amplitude(), 0.15);
		assertEquals(LENGTH, estimate.length(), 0.005 * LENGTH);
	}

	/**
	 * A filament that is wound up in all frames: from its fixed end, in the middle of a ring, once
	 * around and on over itself for 14 px. Its skeleton has one junction only, and where a trail comes back
	 * to it, it ends; the cheapest goes the wrong way round.
	 */
	@Test
	void aFilamentThatLiesOnItselfInAllFramesIsFollowedToItsTip() {
		final LineModel model = LineModel.uniform(LineModel.Kind.ADDITIVE, 1.4, 1);
		final List<Sighting> sightings = new ArrayList<>();
		double length = 0;
		for (int t = 0; t < 8; t++) {
			final Polyline around = ring(0.5 * t, 2 * Math.PI + 14.0 / RING, 1),
				once = ring(0.5 * t, 2 * Math.PI - 0.1, 1),
				wrong = ring(0.5 * t, 2 * Math.PI - 0.1, -1);
			length = around.length();
			final NormalizedFrame frame = DrawnMovie
				.draw(List.of(Chain.along(around, 60, around.length())), List.of(), model, 0.05, t)
				.frame(0);
			sightings.add(new Sighting(frame, wrong, List.of(once)));
		}
		final FilamentEstimate estimate = FilamentEstimator.estimate(sightings,
			EnumSet.of(LineModel.Kind.ADDITIVE), FitSettings.ENDS_FREE, Workers.HERE, Progress.NONE)
			.orElseThrow();
		assertEquals(length, estimate.length(), 0.015 * length);
		assertEquals(0, estimate.fixedEnd().distanceTo(new Point(40, 40)), 0.8);
		assertEquals(1, estimate.model().brightness().length);
		assertEquals(1, estimate.amplitude(), 0.05);
	}

	private static final double RING = 12;

	/** From the middle out to a ring, and along it by an angle, this way or the other. */
	private static Polyline ring(final double turned, final double angle, final int way) {
		final List<Point> points = new ArrayList<>();
		for (double a = 0; a <= Math.PI; a += 0.1)
			points.add(place(turned - Math.PI + a, RING * Math.sin(a / 2)));
		for (double a = 0.1; a <= angle; a += 0.05)
			points.add(place(turned + way * a, RING));
		return Polyline.of(points);
	}

	private static Point place(final double angle, final double radius) {
		return new Point(40 + radius * Math.cos(angle), 40 + radius * Math.sin(angle));
	}

	private static FilamentEstimate estimate(final LineModel model) {
		return estimate(model, 0.05, f -> f);
	}

	/** From contours as skeletons give them: short at both ends, and jagged. */
	private static FilamentEstimate estimate(final LineModel model, final double noise,
		final UnaryOperator<NormalizedFrame> camera) {
		return estimate(model, noise, camera, new Point(0, 0));
	}

	/** @param shift of what the camera shows, in pixels */
	private static FilamentEstimate estimate(final LineModel model, final double noise,
		final UnaryOperator<NormalizedFrame> camera, final Point shift) {
		final DrawnMovie drawn = DrawnMovie.draw(DrawnMovie.waves(12, LENGTH, 0.7), List.of(),
			model, noise, 11);
		final Random random = new Random(5);
		final List<Sighting> sightings = new ArrayList<>();
		for (int t = 0; t < drawn.truth().size(); t++) {
			final Polyline middle = drawn.truth().get(t).head(LENGTH - 3).reversed()
				.head(LENGTH - 6).reversed().resampled(1);
			final double[] x = middle.xs(), y = middle.ys();
			for (int i = 0; i < x.length; i++) {
				x[i] += shift.x() + 0.3 * random.nextGaussian();
				y[i] += shift.y() + 0.3 * random.nextGaussian();
			}
			final Polyline jagged = Polyline.of(x, y);
			sightings.add(new Sighting(camera.apply(drawn.frame(t)), jagged.divided(12)));
		}
		try (Workers workers = new Workers(2)) {
			return FilamentEstimator
				.estimate(sightings, EnumSet.of(LineModel.Kind.SATURATING, LineModel.Kind.ADDITIVE),
					FitSettings.ENDS_FREE, workers, Progress.NONE)
				.orElseThrow();
		}
	}

	/** As of a filament that was followed through a gap onto a bead, one that tapers, and speckle. */
	@Test
	void aFilamentThatIsDarkBetweenBrightPiecesIsBroken() {
		assertTrue(BrightnessProfile.isBroken(new double[]{0.9, 0.5, 0.25, 0.3, 1.1, 1.3, 0.7}));
		assertTrue(BrightnessProfile.isBroken(new double[]{0.7, 1.3, 1.1, 0.3, 0.9}));
		assertFalse(BrightnessProfile.isBroken(new double[]{0.2, 0.4, 0.9, 1.2, 0.8, 0.3, 0.1}));
		assertFalse(BrightnessProfile.isBroken(new double[]{0.8, 1.3, 0.5, 1.2, 0.6, 1}));
		assertFalse(BrightnessProfile.isBroken(new double[]{1}));
	}

	/** As of curves that were led on into haze at the tip, of a dim tip, and of one that tapers. */
	@Test
	void whereAnEndFadesAtOnceTheFilamentEndsBeforeIt() {
		final double[] hazy = new double[51], dim = new double[51];
		for (int i = 0; i < hazy.length; i++) {
			hazy[i] = Math.min(1, 0.2 + 0.16 * (50 - i));
			dim[i] = 1 - 0.016 * i;
		}
		assertEquals(1.875, faded(hazy, 50).tip(), 1e-9);
		assertEquals(2.75, faded(hazy, 100).tip(), 1e-9);
		assertEquals(0, faded(hazy, 50).start());
		assertEquals(0, faded(dim, 50).tip());
		assertEquals(0, faded(new double[]{1}, 50).tip());
	}

	@Test
	void anEndThatIsFarBrighterIsABead() {
		assertTrue(BrightnessProfile.hasBrightEnd(new double[]{1.9, 1.3, 0.8, 1, 1}, 30));
		assertTrue(BrightnessProfile.hasBrightEnd(new double[]{1, 1, 1.7}, 30));
		assertFalse(BrightnessProfile.hasBrightEnd(new double[]{1.2, 1.9, 0.2}, 30));
	}

	/**
	 * As of curves that were led over a short gap to a spot beside the filament's end, of one that is
	 * brighter at its end, and of one that is dim in its middle.
	 */
	@Test
	void anEndThatIsBrighterThanADipBeforeItIsASpot() {
		final double[] spot = new double[101], bright = new double[101], dim = new double[101];
		for (int i = 0; i < spot.length; i++) {
			spot[i] = i < 4 ? 1.3 : i < 12 ? 0.7 : 1.05;
			bright[i] = i < 4 ? 1.3 : 1;
			dim[i] = 1.4 - 0.8 * Math.sin(Math.PI * i / 100);
		}
		assertTrue(BrightnessProfile.hasBrightEnd(spot, 100));
		assertFalse(BrightnessProfile.hasBrightEnd(bright, 100));
		assertFalse(BrightnessProfile.hasBrightEnd(dim, 100));
		final double[] turned = spot.clone();
		for (int i = 0; i < spot.length; i++)
			turned[i] = spot[100 - i];
		assertTrue(BrightnessProfile.hasBrightEnd(turned, 100));
		// So far apart in pixels they are no spot.
		assertFalse(BrightnessProfile.hasBrightEnd(spot, 400));
	}

	@Test
	void aLengthFromOneFrameInWhichItLiesOnItselfIsAGuess() {
		final LineModel model = LineModel.uniform(LineModel.Kind.ADDITIVE, 1.4, 1);
		final List<Sighting> one = new ArrayList<>(), two = new ArrayList<>();
		for (int t = 0; t < 2; t++) {
			final Polyline around = ring(0.5 * t, 2 * Math.PI + 14.0 / RING, 1);
			final NormalizedFrame frame = DrawnMovie
				.draw(List.of(Chain.along(around, 60, around.length())), List.of(), model, 0.05, t)
				.frame(0);
			two.add(new Sighting(frame, around, List.of(ring(0.5 * t, 2 * Math.PI - 0.1, 1))));
			if (t == 0)
				one.add(two.get(0));
		}
		assertTrue(guessed(one));
		assertFalse(guessed(two));
		assertFalse(guessed(List.of(new Sighting(one.get(0).frame(), one.get(0).contour()))));
	}

	private static boolean guessed(final List<Sighting> sightings) {
		return FilamentEstimator.estimate(sightings, EnumSet.of(LineModel.Kind.ADDITIVE),
			FitSettings.ENDS_FREE, Workers.HERE, Progress.NONE).orElseThrow().guessed();
	}

	private static FadedEnds faded(final double[] brightness, final double length) {
		return FadedEnds.of(new LineModel(LineModel.Kind.ADDITIVE, 1.7, 1, brightness), length);
	}
}
