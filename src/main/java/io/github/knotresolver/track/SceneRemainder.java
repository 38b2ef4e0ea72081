
package io.github.knotresolver.track;

import java.util.List;

import net.imglib2.img.Img;
import net.imglib2.type.logic.BitType;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.LineTables;
import io.github.knotresolver.fit.NormalizedFrame;
import io.github.knotresolver.fit.Scene;
import io.github.knotresolver.graph.SkeletonGraph;
import io.github.knotresolver.image.Pixels;
import io.github.knotresolver.skeleton.Skeletonize;

/** What a frame shows besides some filaments that are known. */
final class SceneRemainder {

	private SceneRemainder() {
	}

	/**
	 * O(pixels).
	 *
	 * @param frame its light in strands
	 * @param line what a line looks like
	 * @param known the filaments that are known
	 * @return the frame with the light that they leave, its mask and its graph
	 */
	static FrameView of(final FrameView frame, final LineTables line, final List<Chain> known) {
		final Scene scene = new Scene(frame.light(), line, known);
		final NormalizedFrame left = scene.residual();
		final boolean[] shone = scene.drawnAbove(SceneTuning.KNOWN_SHINES);
		final boolean[] mask = Pixels.bits(frame.mask());
		for (int i = 0; i < mask.length; i++)
			if (shone[i])
				mask[i] = left.meanAround(i % left.width(),
					i / left.width()) > SceneTuning.REST_LEFT;
		final Img<BitType> rest = Pixels.mask(mask, left.width());
		return new FrameView(frame.frame(), left, rest, SkeletonGraph.of(Skeletonize.thin(rest)));
	}
}
