package io.github.knotresolver.fit;

import java.util.List;

import io.github.knotresolver.image.GaussianBlur;

/**
 * What a chain leaves unexplained in its frame. The residual is blurred by the line's own
 * width, so that a piece of line stands out of the noise.
 *
 * @param unexplained length of line that is seen near the chain but not drawn, as a share of
 *          the chain's length, at least 0
 * @param invented length of line that is drawn but not seen, as a share of the chain's length,
 *          at least 0
 * @param pattern root mean square of the residual around the chain, in units of the frame's
 *          noise; about 1 if nothing but noise is left
 */
public record Residue(double unexplained, double invented, double pattern) {

	/** A line of a strand's brightness, blurred by its own width, is above half of its peak so far (sigmas). */
	private static final double WIDTH = 3.3;

	/**
	 * Looks at a chain in its frame. O(pixels) around it.
	 *
	 * @param frame the frame, a strand's brightness 1
	 * @param model what a line looks like
	 * @param chain the chain
	 * @return what is left
	 */
	public static Residue of(final NormalizedFrame frame, final LineModel model,
		final Chain chain) {
		final double sigma = Math.max(1, model.in(frame).sigma());
		final Patch patch = Patch.around(List.of(chain),
			Math.max(FitTuning.RESIDUE_NEAR, FitTuning.RESIDUE_AROUND)
				+ Math.ceil(GaussianBlur.REACH * sigma) + 1,
			frame);
		final NormalizedFrame part = patch.part(frame);
		final double[] picture = ChainPixels.draw(frame, model, chain, patch);
		final double noise = Math.max(FitTuning.RESIDUE_NOISE, frame.noise());
		final double[] pixels = part.pixels();
		final float[] residual = new float[picture.length];
		for (int i = 0; i < picture.length; i++)
			residual[i] = (float) Math.max(-FitTuning.RESIDUE_OUTLIER * 2, Math.min(
				FitTuning.RESIDUE_OUTLIER * 2, part.residual(i, pixels[i], picture[i], model)));
		final float[] blurred = GaussianBlur.blur(residual, patch.width(), sigma);
		final double threshold = Math.max(FitTuning.RESIDUE_SEEN,
			FitTuning.RESIDUE_NOISES * noise / (2 * Math.sqrt(Math.PI) * sigma));
		final boolean[] near = ChainPixels.of(patch, List.of(chain), FitTuning.RESIDUE_NEAR),
			around = ChainPixels.of(patch, List.of(chain), FitTuning.RESIDUE_AROUND);
		int more = 0, less = 0, count = 0;
		double sum = 0;
		for (int i = 0; i < picture.length; i++) {
			if (near[i] && blurred[i] > threshold)
				more++;
			if (near[i] && blurred[i] < -threshold)
				less++;
			if (around[i]) {
				final double r = Math.min(FitTuning.RESIDUE_OUTLIER, Math.abs(residual[i]));
				sum += r * r;
				count++;
			}
		}
		final double line = WIDTH * sigma * chain.length();
		return new Residue(more / line, less / line, Math.sqrt(sum / Math.max(1, count)) / noise);
	}
}
