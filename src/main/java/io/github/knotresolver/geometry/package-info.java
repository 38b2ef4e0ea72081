/**
 * Points, polylines with their arc length, crossings, calibration: what every room speaks of. All in
 * pixels, origin top-left, an integer is a pixel centre.
 */
package io.github.knotresolver.geometry;
