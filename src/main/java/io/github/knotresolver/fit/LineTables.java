
package io.github.knotresolver.fit;

import org.apache.commons.math3.special.Erf;

/**
 * A line that is ready to be drawn many times: its functions as tables, and the price of
 * what it does not explain. May be shared between threads.
 */
public final class LineTables {

	private final LineModel model;
	private final Robust robust;
	private final double reach;
	private final Table across;
	private final Table along;
	private final LineTables additive;

	/**
	 * @param model the line
	 * @param robust price of a residual
	 */
	LineTables(final LineModel model, final Robust robust) {
		this.model = model;
		this.robust = robust;
		final double sigma2 = model.sigma() * model.sigma();
		additive = model.kind() == LineModel.Kind.ADDITIVE
			? this
			: new LineTables(LineModel.uniform(LineModel.Kind.ADDITIVE, model.sigma(), 1), robust);
		if (model.kind() == LineModel.Kind.ADDITIVE) {
			reach = model.sigma() * (robust == Robust.TOGETHER ? FitTuning.SCENE_REACH : FitTuning.ADDITIVE_REACH);
			across = new Table(reach * reach, d2 -> Math.exp(-d2 / (2 * sigma2)));
			along = new Table(reach, d -> 0.5 * Erf.erfc(d / Math.sqrt(2 * sigma2)));
		} else {
			reach = model.reach();
			final double k = 1 / (2 * model.sigma() * model.sigma());
			final double p = model.power();
			// Shifted by a thousandth, so that the price has no step where the band ends.
			final double rim = Math.exp(-Math.pow(k * reach * reach, p));
			across = new Table(reach * reach, d2 -> Math.exp(-Math.pow(k * d2, p)) - rim);
			along = new Table(reach * reach, d2 -> -p * k * Math.pow(Math.max(k * d2, 1e-9), p - 1)
				* Math.exp(-Math.pow(k * d2, p)));
		}
	}

	/**
	 * @param model a line
	 * @return the line as it is drawn where all filaments of a scene are
	 */
	public static LineTables together(final LineModel model) {
		return new LineTables(model, Robust.TOGETHER);
	}

	/** @return the line */
	public LineModel model() {
		return model;
	}

	/** A line as wide whose light adds up. */
	LineTables additive() {
		return additive;
	}

	Robust robust() {
		return robust;
	}

	/** Distance from a link beyond which it is dark, in pixels. */
	double reach() {
		return reach;
	}

	/** Brightness by the squared distance from the line. */
	Table across() {
		return across;
	}

	/**
	 * Additive: the share of a Gaussian beyond a distance; saturating: the slope of
	 * {@link #across()}.
	 */
	Table along() {
		return along;
	}
}
