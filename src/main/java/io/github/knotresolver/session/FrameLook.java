package io.github.knotresolver.session;

import java.util.List;
import java.util.OptionalDouble;

import net.imglib2.img.Img;
import net.imglib2.type.logic.BitType;

import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.Polarity;

/**
 * What one frame shows by itself. All of it is in the movie's pixels.
 *
 * @param frame 1-based number of the frame
 * @param mask all objects, of the frame's size; not to be changed
 * @param skeleton their middle lines, one pixel wide, likewise
 * @param objects number of separate objects of the mask
 * @param area pixels of the mask
 * @param contours the courses that the skeleton's graph suggests, the longest first, not fitted; of
 *          one filament from its fixed end on, where that is told
 * @param hiddenEnds how many of their ends lie on a strand instead of in the open
 * @param polarity bright or dark
 * @param width usual full width at half maximum of the movie's lines in pixels; empty if thresholds
 *          made the mask
 */
public record FrameLook(int frame, Img<BitType> mask, Img<BitType> skeleton, int objects, int area,
	List<Polyline> contours, int hiddenEnds, Polarity polarity, OptionalDouble width) {

	public FrameLook {
		contours = List.copyOf(contours);
	}
}
