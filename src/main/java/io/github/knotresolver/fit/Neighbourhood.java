package io.github.knotresolver.fit;

/** The pixels around a chain, and the chain's picture in them. */
final class Neighbourhood {

	private Neighbourhood() {
	}

	/**
	 * @param frame the frame
	 * @param chain a chain in it
	 * @param radius in pixels
	 * @return for every pixel whether it is within the radius of a node
	 */
	static boolean[] of(final NormalizedFrame frame, final Chain chain, final double radius) {
		final double[] x = new double[chain.links() + 1], y = new double[chain.links() + 1];
		chain.nodes(x, y);
		final boolean[] near = new boolean[frame.pixels().length];
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
		return near;
	}

	/** The picture of a chain, background 0. */
	static double[] draw(final NormalizedFrame frame, final LineModel model, final Chain chain) {
		final double[] x = new double[chain.links() + 1], y = new double[chain.links() + 1];
		chain.nodes(x, y);
		final double[] picture = new double[frame.pixels().length];
		ImageTerm.of(frame, model, chain.links()).draw(x, y, chain.links(), picture);
		return picture;
	}
}
