package io.github.knotresolver.fit;

import java.util.List;

/**
 * How well a fitted chain agrees with its frame, in figures that can be compared between
 * frames.
 *
 * @param misfit robust price of the pixels around the chain, per pixel of length
 * @param dark share of the chain inside the frame, 0..1, that runs where there is hardly any
 *            light
 */
public record FitQuality(double misfit, double dark) {

	/**
	 * Looks at a chain in its frame. O(length).
	 *
	 * @param frame the frame
	 * @param model what a line looks like
	 * @param chain the chain
	 * @return its quality
	 */
	public static FitQuality of(final NormalizedFrame frame, final LineModel model,
		final Chain chain) {
		final Patch patch = Patch.around(List.of(chain), FitTuning.QUALITY_RADIUS, frame);
		final NormalizedFrame part = patch.part(frame);
		final double[] picture = ChainPixels.draw(frame, model, chain, patch);
		final boolean[] near = ChainPixels.of(patch, List.of(chain), FitTuning.QUALITY_RADIUS);
		final double[] pixels = part.pixels();
		double sum = 0;
		for (int i = 0; i < picture.length; i++)
			if (near[i])
				sum += Robust.ALONE.price(part.residual(i, pixels[i], picture[i], model));
		return new FitQuality(sum / chain.length(), dark(frame, model, chain));
	}

	private static double dark(final NormalizedFrame frame, final LineModel model,
		final Chain chain) {
		final double[] x = new double[chain.links() + 1], y = new double[chain.links() + 1];
		chain.nodes(x, y);
		final double[] brightness = model.brightnessOfLinks(chain.links());
		int inside = 0, bright = 0;
		for (int i = 0; i < chain.links(); i++) {
			final double middleX = 0.5 * (x[i] + x[i + 1]), middleY = 0.5 * (y[i] + y[i + 1]);
			if (middleX < 0 || middleY < 0 || middleX > frame.width() - 1
				|| middleY > frame.height() - 1)
				continue;
			inside++;
			if (frame.meanAround(middleX, middleY) >= FitTuning.DARK_STRAND * brightness[i]
				|| frame.isClipped(middleX, middleY))
				bright++;
		}
		return inside == 0 ? 1 : 1 - (double) bright / inside;
	}
}
