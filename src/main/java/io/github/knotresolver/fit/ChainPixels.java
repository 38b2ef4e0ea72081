package io.github.knotresolver.fit;

import java.util.List;

/** The pixels around a chain, and the chain's picture in them. */
final class ChainPixels {

	private ChainPixels() {
	}

	/**
	 * @param patch a part of a frame
	 * @param chains chains in the frame
	 * @param radius in pixels
	 * @return for every pixel of the part whether it is within the radius of a node of any
	 */
	static boolean[] of(final Patch patch, final List<Chain> chains, final double radius) {
		final boolean[] near = new boolean[patch.width() * patch.height()];
		chains.forEach(c -> mark(patch, c, radius, near));
		return near;
	}

	private static void mark(final Patch patch, final Chain chain, final double radius,
		final boolean[] near) {
		final double[] x = new double[chain.links() + 1], y = new double[chain.links() + 1];
		chain.nodes(x, y);
		final int lastColumn = patch.left() + patch.width() - 1,
			lastRow = patch.top() + patch.height() - 1;
		for (int i = 0; i < x.length; i++) {
			final int left = Math.max(patch.left(), (int) Math.ceil(x[i] - radius));
			final int right = Math.min(lastColumn, (int) Math.floor(x[i] + radius));
			final int top = Math.max(patch.top(), (int) Math.ceil(y[i] - radius));
			final int bottom = Math.min(lastRow, (int) Math.floor(y[i] + radius));
			for (int row = top; row <= bottom; row++)
				for (int column = left; column <= right; column++)
					if (Math.hypot(column - x[i], row - y[i]) <= radius)
						near[(row - patch.top()) * patch.width() + column - patch.left()] = true;
		}
	}

	/** The picture of chains in a part of the frame, background 0. */
	static double[] draw(final NormalizedFrame frame, final LineModel model,
		final List<Chain> chains, final Patch patch) {
		return chains.size() == 1
			? draw(frame, model, chains.get(0), patch)
			: patch.cut(new Scene(frame, new LineTables(model, Robust.TOGETHER), chains).picture(),
				frame.width());
	}

	/** The picture of a chain, background 0. */
	static double[] draw(final NormalizedFrame frame, final LineModel model, final Chain chain) {
		return draw(frame, model, chain, Patch.of(frame));
	}

	/** The picture of a chain in a part of the frame, background 0. */
	static double[] draw(final NormalizedFrame frame, final LineModel model, final Chain chain,
		final Patch patch) {
		final double[] x = new double[chain.links() + 1], y = new double[chain.links() + 1];
		chain.nodes(x, y);
		final double[] picture = new double[patch.width() * patch.height()];
		ImageTerm.of(frame, model, chain.links()).draw(x, y, chain.links(), patch, picture);
		return picture;
	}
}
