package io.github.knotresolver.fit;

import java.util.List;

/** The pixels around a chain, and the chain's picture in them. */
final class ChainPixels {

	private ChainPixels() {
	}

	/**
	 * @param frame the frame
	 * @param chain a chain in it
	 * @param radius in pixels
	 * @return for every pixel whether it is within the radius of a node
	 */
	static boolean[] of(final NormalizedFrame frame, final Chain chain, final double radius) {
		return of(frame, List.of(chain), radius);
	}

	/**
	 * @param frame the frame
	 * @param chains chains in it
	 * @param radius in pixels
	 * @return for every pixel whether it is within the radius of a node of any
	 */
	static boolean[] of(final NormalizedFrame frame, final List<Chain> chains,
		final double radius) {
		final boolean[] near = new boolean[frame.width() * frame.height()];
		chains.forEach(c -> mark(frame, c, radius, near));
		return near;
	}

	private static void mark(final NormalizedFrame frame, final Chain chain, final double radius,
		final boolean[] near) {
		final double[] x = new double[chain.links() + 1], y = new double[chain.links() + 1];
		chain.nodes(x, y);
		for (int i = 0; i < x.length; i++) {
			final int left = Math.max(0, (int) Math.ceil(x[i] - radius));
			final int right = Math.min(frame.width() - 1, (int) Math.floor(x[i] + radius));
			final int top = Math.max(0, (int) Math.ceil(y[i] - radius));
			final int bottom = Math.min(frame.height() - 1, (int) Math.floor(y[i] + radius));
			for (int row = top; row <= bottom; row++)
				for (int column = left; column <= right; column++)
					if (Math.hypot(column - x[i], row - y[i]) <= radius)
						near[row * frame.width() + column] = true;
		}
	}

	/** The picture of chains, background 0. */
	static double[] draw(final NormalizedFrame frame, final LineModel model,
		final List<Chain> chains) {
		return chains.size() == 1
			? draw(frame, model, chains.get(0))
			: new Scene(frame, new LineTables(model, Robust.TOGETHER), chains).picture();
	}

	/** The picture of a chain, background 0. */
	static double[] draw(final NormalizedFrame frame, final LineModel model, final Chain chain) {
		final double[] x = new double[chain.links() + 1], y = new double[chain.links() + 1];
		chain.nodes(x, y);
		final double[] picture = new double[frame.width() * frame.height()];
		ImageTerm.of(frame, model, chain.links()).draw(x, y, chain.links(), picture);
		return picture;
	}
}
