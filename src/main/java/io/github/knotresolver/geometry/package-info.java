/**
 * Points, polylines with their arc length, crossings, medians: what every room counts with. All in
 * pixels, origin top-left, an integer is a pixel centre.
 */
package io.github.knotresolver.geometry;
