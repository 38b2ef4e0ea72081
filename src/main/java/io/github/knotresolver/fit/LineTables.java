
package io.github.knotresolver.fit;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;

import org.apache.commons.math3.special.Erf;

/**
 * A line that is ready to be drawn many times: its functions as tables, and the price of
 * what it does not explain. May be shared between threads.
 */
public final class LineTables {

	/** Curves of so many lines are kept: of a movie, and of those tried while it is learned. */
	private static final int KEPT = 16;

	/** Entries of a link's table, which is made anew for each length of links. */
	private static final int LINK_TABLE = 256;

	/** Making them takes as long as a fit. They are functions of their keys alone. */
	private static final Map<Key, Curves> KNOWN = Collections
		.synchronizedMap(new LinkedHashMap<>(2 * KEPT, 0.75f, true) {

			@Override
			protected boolean removeEldestEntry(final Map.Entry<Key, Curves> eldest) {
				return size() > KEPT;
			}
		});

	private final LineModel model;
	private final Robust robust;
	private final double reach;
	private final Curves curves;

	/** What tables depend on. */
	private record Key(LineModel.Kind kind, double sigma, double power, double reach) {
	}

	/** Functions of a line. */
	private record Curves(Table across, Table along) {

		static Curves of(final Key key) {
			final double sigma2 = key.sigma * key.sigma, reach = key.reach;
			if (key.kind != LineModel.Kind.SATURATING)
				return new Curves(new Table(reach * reach, d2 -> Math.exp(-d2 / (2 * sigma2))),
					new Table(reach, d -> 0.5 * Erf.erfc(d / Math.sqrt(2 * sigma2))));
			final double k = 1 / (2 * key.sigma * key.sigma), p = key.power;
			// Shifted by a thousandth, so that the price has no step where the band ends.
			final double rim = Math.exp(-Math.pow(k * reach * reach, p));
			return new Curves(new Table(reach * reach, d2 -> Math.exp(-Math.pow(k * d2, p)) - rim),
				new Table(reach * reach, d2 -> -p * k * Math.pow(Math.max(k * d2, 1e-9), p - 1)
					* Math.exp(-Math.pow(k * d2, p))));
		}
	}

	/**
	 * @param model the line
	 * @param robust price of a residual
	 */
	LineTables(final LineModel model, final Robust robust) {
		this.model = model;
		this.robust = robust;
		reach = model.kind() != LineModel.Kind.SATURATING
			? model.sigma()
				* (robust == Robust.TOGETHER ? FitTuning.SCENE_REACH : FitTuning.ADDITIVE_REACH)
			: model.reach();
		final Key key = new Key(model.kind(), model.sigma(), model.power(), reach);
		final Curves known = KNOWN.get(key);
		curves = known == null ? Curves.of(key) : known;
		if (known == null)
			KNOWN.put(key, curves);
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
		return model.kind() == LineModel.Kind.ADDITIVE
			? this
			: new LineTables(LineModel.uniform(LineModel.Kind.ADDITIVE, model.sigma(), 1), robust);
	}

	/**
	 * What a link gives to pixels beside it, as a share of what an infinite line does, of lines
	 * that add up.
	 *
	 * @param length of the link in pixels
	 * @return the share by the distance from the link's middle, along it
	 */
	Table link(final double length) {
		final double half = length / 2;
		return new Table(LINK_TABLE, reach + half, d -> beyond(d - half) - beyond(d + half));
	}

	/** Of lines that add up, the share of a Gaussian beyond a distance, which may be negative. */
	double beyond(final double distance) {
		return distance < 0 ? 1 - curves.along.at(-distance) : curves.along.at(distance);
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
		return curves.across;
	}

	/**
	 * Of a lens: the share of a Gaussian beyond a distance; saturating: the slope of
	 * {@link #across()}.
	 */
	Table along() {
		return curves.along;
	}
}
