
package io.github.knotresolver.fit;

import java.util.List;
import java.util.function.ToDoubleFunction;

import io.github.knotresolver.progress.Progress;

/**
 * Learns from frames with known curves what a line looks like: width and
 * profile by a simplex search, brightness and background by linear least
 * squares inside it.
 */
public final class LineEstimator {

	/** Rounds in which it is settled which of the pixels that were cut off are too bright. */
	private static final int CLIPPED_ROUNDS = 6;

	private LineEstimator() {
	}

	/**
	 * A frame and the curves in it.
	 *
	 * @param frame the frame
	 * @param chains the curves, at least one
	 * @param around the pixels that are looked at
	 */
	public record Example(NormalizedFrame frame, List<Chain> chains, Around around) {

		/**
		 * @param frame the frame
		 * @param chain its only curve
		 */
		public Example(final NormalizedFrame frame, final Chain chain) {
			this(frame, List.of(chain));
		}

		/**
		 * @param frame the frame
		 * @param chains all its curves
		 */
		public Example(final NormalizedFrame frame, final List<Chain> chains) {
			this(frame, chains, Around.of(frame, chains));
		}

		/** @return the first curve */
		Chain chain() {
			return chains.get(0);
		}
	}

	/**
	 * What is around curves.
	 *
	 * @param patch where it is in the frame
	 * @param part its pixels
	 * @param near for each of them whether it is looked at
	 */
	record Around(Patch patch, NormalizedFrame part, boolean[] near) {

		static Around of(final NormalizedFrame frame, final List<Chain> chains) {
			final Patch patch = Patch.around(chains, FitTuning.LINE_RADIUS, frame);
			return new Around(patch, patch.part(frame),
				ChainPixels.of(patch, chains, FitTuning.LINE_RADIUS));
		}
	}

	/**
	 * What was learned.
	 *
	 * @param model the line
	 * @param amplitude brightness of a strand above the background, in the units
	 *          of the examples
	 * @param background of the neighbourhood of the curves, in the same units
	 * @param residual mean squared residual of the neighbourhood, in units of the
	 *          amplitude squared
	 * @param noise what of it is the frames' noise, which no line explains
	 * @param unexplained the residual as a share of the variance of the neighbourhood's pixels, by
	 *          which lines of different amplitudes can be compared
	 */
	public record LineEstimate(LineModel model, double amplitude, double background,
		double residual, double noise, double unexplained) {

		/**
		 * By which lines are compared. Where pixels were cut off, amplitudes differ so much that
		 * residuals in their unit do not tell; elsewhere that unit keeps a line whose brightness
		 * falls along it as narrow as it is.
		 *
		 * @param examples to which the line was fitted
		 * @return the lower, the better
		 */
		public double misfit(final List<Example> examples) {
			return isClipped(examples) ? unexplained : residual;
		}

		/**
		 * The same with the noise taken off, which is the less in that unit, the brighter the line is
		 * taken for.
		 */
		double misfitBesidesNoise(final List<Example> examples) {
			return isClipped(examples) ? unexplained : residual - noise;
		}

		/** @return whether what was learned is brighter than its background, and no wider than lines are */
		public boolean isLine() {
			return amplitude > 0 && model.sigma() < FitTuning.WIDEST_LINE;
		}

		/** @return whether the line differs from its background at all */
		boolean isVisible() {
			return Double.isFinite(amplitude) && amplitude != 0;
		}

		/** As long as nothing is known of the amplitude, all pixels that were cut off are. */
		private boolean isHidden(final NormalizedFrame frame, final int at, final double pixel,
			final double picture) {
			return Double.isNaN(residual)
				? frame.isClipped() && pixel > frame.ceiling()[at]
				: frame.hides(at, amplitude * picture + background);
		}

		/** An example's frame, a strand's brightness 1. */
		NormalizedFrame scaled(final Example example) {
			return example.frame.rescaled(background, amplitude);
		}

		LineEstimate withModel(final LineModel other) {
			return new LineEstimate(other, amplitude, background, residual, noise, unexplained);
		}
	}

	/**
	 * The line of a given kind that explains the examples best.
	 *
	 * @param examples at least one
	 * @param kind how strands add up
	 * @param sigma where to begin, in pixels
	 * @param misfit of a line, the lower, the better
	 * @param progress may cancel
	 * @return the estimate; the best that was seen if the search does not settle, without an
	 *         amplitude if the examples show no line at all
	 */
	public static LineEstimate estimate(final List<Example> examples, final LineModel.Kind kind,
		final double sigma, final ToDoubleFunction<LineEstimate> misfit, final Progress progress) {
		final boolean additive = kind == LineModel.Kind.ADDITIVE;
		final double[] guess = additive ? new double[]{sigma} : new double[]{sigma, 1.5};
		final double[] spread = additive ? new double[]{0.3} : new double[]{0.3, 0.4};
		final double[] best = new SimplexSearch(1e-4, 1e-6, FitTuning.SEARCH_STEPS, progress)
			.lowest(p -> misfit.applyAsDouble(fit(examples, model(kind, p))) + outside(kind, p),
				guess, spread);
		return fit(examples, model(kind, best));
	}

	/**
	 * The same line as wide as it explains the examples best, now that its brightness along the
	 * filament is known: taken for even, one that fades looks narrower or wider than it is.
	 *
	 * @param examples at least one
	 * @param line one that adds up, and its brightness along the filament
	 * @param progress may cancel
	 * @return as bright as it was; its residuals are those of the even line
	 */
	static LineEstimate withWidth(final List<Example> examples, final LineEstimate line,
		final Progress progress) {
		final double known = line.model().sigma();
		final double sigma = new SimplexSearch(1e-4, 1e-6, FitTuning.SEARCH_STEPS, progress)
			.lowest(p -> fit(examples, line.model().withSigma(width(p[0]))).unexplained()
				+ Math.abs(p[0] - width(p[0])), new double[]{known}, new double[]{0.1})[0];
		return line.withModel(line.model().withSigma(width(sigma)));
	}

	private static double width(final double sigma) {
		return clamp(sigma, FitTuning.SMALLEST_WIDTH, FitTuning.LARGEST_WIDTH);
	}

	private static LineModel model(final LineModel.Kind kind, final double[] p) {
		return LineModel.uniform(kind, width(p[0]),
			p.length > 1 ? clamp(p[1], lowest(kind), FitTuning.LARGEST_POWER) : 1);
	}

	/** What is cut off is no darker than where. */
	private static double lowest(final LineModel.Kind kind) {
		return kind == LineModel.Kind.BRIGHTEST ? 1 : FitTuning.SMALLEST_POWER;
	}

	private static double outside(final LineModel.Kind kind, final double[] p) {
		double off = Math
			.abs(p[0] - clamp(p[0], FitTuning.SMALLEST_WIDTH, FitTuning.LARGEST_WIDTH));
		if (p.length > 1)
			off += Math.abs(p[1] - clamp(p[1], lowest(kind), FitTuning.LARGEST_POWER));
		return off;
	}

	private static double clamp(final double value, final double low, final double high) {
		return Math.max(low, Math.min(high, value));
	}

	/**
	 * Brightness and background of a given line.
	 *
	 * @param examples at least one
	 * @param model the line
	 * @return the estimate
	 */
	public static LineEstimate fit(final List<Example> examples, final LineModel model) {
		final List<double[]> pictures = examples.stream()
			.map(e -> ChainPixels.draw(e.frame(), model, e.chains(), e.around().patch())).toList();
		// Where the line as it is known is cut off, pixels do not say how bright it is.
		LineEstimate line = fit(examples, pictures,
			new LineEstimate(model, 1, 0, Double.NaN, Double.NaN, Double.NaN));
		if (model.kind() == LineModel.Kind.ADDITIVE && isClipped(examples))
			for (int round = 0; round < CLIPPED_ROUNDS && line.isVisible(); round++)
				line = fit(examples, pictures, line);
		return line;
	}

	/** @return whether pixels of any example's frame were cut off */
	static boolean isClipped(final List<Example> examples) {
		return examples.stream().anyMatch(e -> e.frame.isClipped());
	}

	private static LineEstimate fit(final List<Example> examples, final List<double[]> pictures,
		final LineEstimate known) {
		final boolean believes = known.model.kind() != LineModel.Kind.ADDITIVE;
		double all = 0, sumAll = 0, squareAll = 0, n = 0, sumM = 0, sumI = 0, sumMM = 0, sumMI = 0,
			sumII = 0, noise = 0;
		for (int k = 0; k < pictures.size(); k++) {
			final Around around = examples.get(k).around;
			final double[] pixels = around.part.pixels();
			final double[] picture = pictures.get(k);
			final double noisy = examples.get(k).frame.noise() * examples.get(k).frame.noise();
			for (int i = 0; i < picture.length; i++)
				if (around.near[i]) {
					all++;
					sumAll += pixels[i];
					squareAll += pixels[i] * pixels[i];
					if (!believes && known.isHidden(around.part, i, pixels[i], picture[i]))
						continue;
					n++;
					noise += noisy;
					sumM += picture[i];
					sumI += pixels[i];
					sumMM += picture[i] * picture[i];
					sumMI += picture[i] * pixels[i];
					sumII += pixels[i] * pixels[i];
				}
		}
		final double covariance = sumMI - sumM * sumI / n, variance = sumMM - sumM * sumM / n;
		final double amplitude = covariance / variance;
		final double rest = sumII - sumI * sumI / n - amplitude * covariance;
		return new LineEstimate(known.model, amplitude, (sumI - amplitude * sumM) / n,
			rest / all / (amplitude * amplitude), noise / all / (amplitude * amplitude),
			rest / (squareAll - sumAll * sumAll / all));
	}
}
