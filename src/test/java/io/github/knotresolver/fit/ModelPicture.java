package io.github.knotresolver.fit;

/** The picture of a chain, for figures and tests of other rooms. */
public final class ModelPicture {

	private ModelPicture() {
	}

	/**
	 * @param width of the picture in pixels
	 * @param height of the picture in pixels
	 * @param model what a line looks like
	 * @param chain the filament
	 * @return the picture, background 0, a strand 1
	 */
	public static NormalizedFrame of(final int width, final int height, final LineModel model,
		final Chain chain) {
		final NormalizedFrame empty = new NormalizedFrame(width, height,
			new double[width * height]);
		return new NormalizedFrame(width, height, ChainPixels.draw(empty, model, chain));
	}
}
