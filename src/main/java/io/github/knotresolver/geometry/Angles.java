package io.github.knotresolver.geometry;

/** Turns that angles leave open. */
public final class Angles {

	private Angles() {
	}

	/**
	 * @param angle in radians
	 * @param to another one
	 * @return {@code angle} plus whole turns, as near to {@code to} as can be
	 */
	public static double nearest(final double angle, final double to) {
		return angle + 2 * Math.PI * Math.rint((to - angle) / (2 * Math.PI));
	}
}
