
package io.github.knotresolver.simulate;

/** How many bits a simulated picture's pixel has. */
public enum BitDepth {

	/** 0 to 255. */
	EIGHT(255, 1),

	/** 0 to 65535; grey values of the published rendering times 100. */
	SIXTEEN(65535, 100);

	private final int maximum;
	private final double scale;

	BitDepth(final int maximum, final double scale) {
		this.maximum = maximum;
		this.scale = scale;
	}

	/** @return the largest grey value */
	public int maximum() {
		return maximum;
	}

	/** @return factor on the grey values of the published rendering */
	double scale() {
		return scale;
	}

	/** @return the grey value, rounded and clipped to the range */
	int quantized(final double value) {
		return (int) Math.rint(Math.max(0, Math.min(maximum, value)));
	}
}
