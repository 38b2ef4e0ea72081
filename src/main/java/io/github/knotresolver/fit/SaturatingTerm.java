
package io.github.knotresolver.fit;

import java.util.Arrays;

/**
 * The saturating line model: a pixel sees the nearest point of the chain only.
 * By the envelope theorem the nearest point's own motion along its link does
 * not count, so that a pixel touches the two nodes of one link.
 */
final class SaturatingTerm implements ImageTerm {

	/**
	 * How much faster than sideways the light falls off beyond an end: the end is
	 * half an ellipse. 1 would be a round end; the dilation by a diamond of the
	 * published rendering has π/2, an end blurred by a point spread function more.
	 * Too round an end makes every length too short by the same amount.
	 */
	static final double END_SHARPNESS = Math.PI / 2;

	private static final double END_STRETCH = END_SHARPNESS * END_SHARPNESS - 1;

	private final DrawnPart part;
	private final int width;
	private final double reach;
	private final double[] brightness;
	private final Table profile;
	private final Table slope;
	private final Robust robust;
	private final double[] others;
	private final Strip strip = new Strip();

	// For each pixel of the part; distances are reset before a chain is looked at.
	private Patch patch;
	private double[] pixels, drawn, distance2, along, value;
	private int[] link, band;
	private int bandSize;

	private final int[] nodes = new int[2];
	private final double[] jacobian = new double[4];

	/**
	 * @param frame the frame
	 * @param line the line
	 * @param links number of links
	 * @param others for every pixel the light of what is drawn already, of which the
	 *          brighter is seen; empty if that is nothing
	 */
	SaturatingTerm(final NormalizedFrame frame, final LineTables line, final int links,
		final double[] others) {
		part = new DrawnPart(frame);
		width = frame.width();
		this.others = others;
		reach = line.reach();
		brightness = line.model().brightnessOfLinks(links);
		profile = line.across();
		slope = line.along();
		robust = line.robust();
	}

	private void look(final double[] x, final double[] y, final int links) {
		if (!part.grow(x, y, links, reach))
			return;
		patch = part.patch();
		strip.within(patch);
		pixels = part.view().pixels();
		final int size = pixels.length;
		drawn = others.length == 0 ? new double[size] : patch.cut(others, width);
		distance2 = new double[size];
		Arrays.fill(distance2, reach * reach);
		along = new double[size];
		value = new double[size];
		link = new int[size];
		band = new int[size];
	}

	@Override
	public double evaluate(final double[] x, final double[] y, final int links,
		final boolean keep) {
		findBand(x, y, links);
		if (!part.isSomewhere())
			return Double.NaN;
		double sum = 0;
		for (int b = 0; b < bandSize; b++) {
			final int at = band[b];
			value[at] = brightness[link[at]] * profile.at(distance2[at]);
			sum += robust.price(pixels[at] - Math.max(drawn[at], value[at]))
				- robust.price(pixels[at] - drawn[at]);
		}
		return sum;
	}

	@Override
	public void linearize(final double[] x, final double[] y, final NodeSystem system) {
		system.clear();
		for (int b = 0; b < bandSize; b++) {
			final int at = band[b];
			if (value[at] > drawn[at])
				addPixel(at, link[at], x, y, pixels[at] - value[at], system);
		}
	}

	private void addPixel(final int at, final int i, final double[] x, final double[] y,
		final double residual, final NodeSystem system) {
		final double t = along[at];
		final double dx = at % patch.width() + patch.left() - x[i] - t * (x[i + 1] - x[i]);
		final double dy = at / patch.width() + patch.top() - y[i] - t * (y[i + 1] - y[i]);
		final double k = -2 * brightness[i] * slope.at(distance2[at]);
		nodes[0] = i + 1;
		nodes[1] = i;
		// The nodes fall, and the system has two unknowns a node.
		final boolean end = t == 0 && i == 0 || t == 1 && 2 * i + 4 == system.size;
		if (end)
			slopeOfEnd(dx, dy, t == 0, x[i + 1] - x[i], y[i + 1] - y[i], k);
		else
			slopeOfLink(dx, dy, t, k);
		system.add(nodes, jacobian, 2, robust.weight(residual), residual);
	}

	/** Slopes by the nodes of the link on which the nearest point lies. */
	private void slopeOfLink(final double dx, final double dy, final double t, final double k) {
		jacobian[0] = k * dx * t;
		jacobian[1] = k * dy * t;
		jacobian[2] = k * dx * (1 - t);
		jacobian[3] = k * dy * (1 - t);
	}

	/** Slopes beyond an end: the end node moves the cap, both nodes turn it. */
	private void slopeOfEnd(final double dx, final double dy, final boolean first, final double lx,
		final double ly, final double k) {
		final double l2 = lx * lx + ly * ly;
		final double along = (dx * lx + dy * ly) / l2, across = (dy * lx - dx * ly) / l2;
		final double turn = k * END_STRETCH * along * across;
		final double ownX = k * (dx + END_STRETCH * along * lx);
		final double ownY = k * (dy + END_STRETCH * along * ly);
		jacobian[0] = (first ? 0 : ownX) + turn * ly;
		jacobian[1] = (first ? 0 : ownY) - turn * lx;
		jacobian[2] = (first ? ownX : 0) - turn * ly;
		jacobian[3] = (first ? ownY : 0) + turn * lx;
	}

	@Override
	public boolean couplesFarNodes() {
		return false;
	}

	@Override
	public void draw(final double[] x, final double[] y, final int links, final Patch to,
		final double[] picture) {
		findBand(x, y, links);
		Arrays.fill(picture, 0);
		for (int b = 0; b < bandSize; b++) {
			final int at = band[b], there = to.at(at, patch);
			if (there >= 0)
				picture[there] = brightness[link[at]] * profile.at(distance2[at]);
		}
	}

	/** Finds, for every pixel within reach, the nearest link and the place on it. */
	private void findBand(final double[] x, final double[] y, final int links) {
		for (int b = 0; b < bandSize; b++)
			distance2[band[b]] = reach * reach;
		bandSize = 0;
		look(x, y, links);
		for (int i = 0; i < links && part.isSomewhere(); i++)
			visitLink(i, links, x, y);
	}

	/**
	 * Pixels before or behind a link are nearest to one of its nodes. Of those only the
	 * ones in the wedge of a bend are visited, or beyond an end of the chain.
	 */
	private void visitLink(final int i, final int links, final double[] x, final double[] y) {
		final double ax = x[i], ay = y[i], bx = x[i + 1] - ax, by = y[i + 1] - ay;
		final double l = Math.sqrt(bx * bx + by * by), ux = bx / l, uy = by / l;
		final boolean isFirst = i == 0, isLast = i == links - 1;
		strip.lay(ax, ay, ux, uy, isFirst ? -reach : -wedge(x, y, i),
			l + (isLast ? reach : wedge(x, y, i + 1)), reach);
		final int lastRow = strip.lastRow();
		for (int row = strip.firstRow(); row <= lastRow; row++) {
			final double py = row - ay;
			final int begin = (row - patch.top()) * patch.width() - patch.left();
			strip.cut(row);
			final int lastColumn = strip.lastColumn();
			for (int column = strip.firstColumn(); column <= lastColumn; column++) {
				final double px = column - ax, free = px * ux + py * uy;
				final double s = Math.max(0, Math.min(l, free));
				final double dx = px - s * ux, dy = py - s * uy;
				final double beyond = (s == 0 ? isFirst : isLast) ? free - s : 0;
				visitPixel(begin + column, i, s / l,
					dx * dx + dy * dy + END_STRETCH * beyond * beyond);
			}
		}
	}

	private void visitPixel(final int at, final int i, final double t, final double d2) {
		if (d2 >= distance2[at])
			return;
		if (distance2[at] == reach * reach)
			band[bandSize++] = at;
		distance2[at] = d2;
		link[at] = i;
		along[at] = t;
	}

	/** How far the wedge at a node sticks out along the links that meet there. */
	private double wedge(final double[] x, final double[] y, final int node) {
		final double px = x[node] - x[node - 1], py = y[node] - y[node - 1];
		final double qx = x[node + 1] - x[node], qy = y[node + 1] - y[node];
		if (px * qx + py * qy <= 0)
			return reach;
		return reach * Math.abs(px * qy - py * qx)
			/ Math.sqrt((px * px + py * py) * (qx * qx + qy * qy)) + 1e-6;
	}
}
