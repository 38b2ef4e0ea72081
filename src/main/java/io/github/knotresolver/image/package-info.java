/**
 * A frame becomes a clean frame. The contrast is stretched to 0..1 with a few
 * pixels saturated at both ends, a 3x3 median takes the shot noise out, and, if
 * wanted, a Laplacian of Gaussian brings out ridges on an uneven background.
 * <p>
 * The steps are static functions on ImgLib2 images of any real type. None of
 * them changes its input, and all of them ignore pixels without a value (NaN).
 */

package io.github.knotresolver.image;
