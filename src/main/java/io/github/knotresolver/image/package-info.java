/**
 * A frame becomes evidence of lines: how wide and of which sign they are in the movie, how strong the
 * ridge at each pixel is above its noise, what is background, hot pixel or spot
 * ({@link io.github.knotresolver.image.FrameEvidence}). For the way by thresholds it becomes a clean
 * frame instead: the contrast is stretched to 0..1 with a few pixels saturated at both ends, a 3x3
 * median takes the shot noise out, and, if wanted, a Laplacian of Gaussian brings out ridges on an
 * uneven background.
 * <p>
 * The steps are functions of ImgLib2 images or of arrays of pixels. None of them changes its input,
 * and all of them ignore pixels without a value (NaN).
 */

package io.github.knotresolver.image;
