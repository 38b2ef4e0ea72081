package io.github.knotresolver.fit;

/**
 * How well a fitted chain agrees with its frame, in figures that can be compared between
 * frames.
 *
 * @param misfit robust price of the pixels around the chain, per pixel of length
 * @param dark share of the chain, 0..1, that runs where there is hardly any light
 */
public record FitQuality(double misfit, double dark) {

	/** Pixels within this distance count as around the chain. */
	private static final double RADIUS = 7;

	/** Light below this share of a strand's is hardly any. */
	private static final double DARK = 0.35;

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
		final double[] picture = Neighbourhood.draw(frame, model, chain);
		final boolean[] near = Neighbourhood.of(frame, chain, RADIUS);
		double sum = 0;
		for (int i = 0; i < picture.length; i++)
			if (near[i])
				sum += Robust.price(frame.pixels()[i] - picture[i]);
		return new FitQuality(sum / chain.length(), dark(frame, model, chain));
	}

	private static double dark(final NormalizedFrame frame, final LineModel model,
		final Chain chain) {
		final double[] x = new double[chain.links() + 1], y = new double[chain.links() + 1];
		chain.nodes(x, y);
		final double[] brightness = model.brightnessOfLinks(chain.links());
		int dark = 0;
		for (int i = 0; i < chain.links(); i++)
			if (mean(frame, 0.5 * (x[i] + x[i + 1]), 0.5 * (y[i] + y[i + 1])) < DARK
				* brightness[i])
				dark++;
		return (double) dark / chain.links();
	}

	/** Mean of 3 x 3 pixels; outside the frame nothing is known, so it counts as bright. */
	private static double mean(final NormalizedFrame frame, final double x, final double y) {
		final int column = (int) Math.rint(x), row = (int) Math.rint(y);
		double sum = 0;
		for (int r = row - 1; r <= row + 1; r++)
			for (int c = column - 1; c <= column + 1; c++)
				sum += r < 0 || c < 0 || r >= frame.height() || c >= frame.width()
					? 1
					: frame.pixels()[r * frame.width() + c];
		return sum / 9;
	}
}
