
package io.github.knotresolver.measure;

/** Turns that angles leave open. */
final class Angles {

	private Angles() {
	}

	/** @return {@code angle} plus whole turns, as near to {@code to} as can be */
	static double nearest(final double angle, final double to) {
		return angle + 2 * Math.PI * Math.rint((to - angle) / (2 * Math.PI));
	}
}
