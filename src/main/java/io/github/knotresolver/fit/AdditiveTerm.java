
package io.github.knotresolver.fit;

import java.util.Arrays;

/**
 * The additive line model: a pixel sees the sum over all links of the line
 * integral of a Gaussian point spread function, which for one link is
 * exp(-n²/2σ²) (erf(t/√2σ) - erf((t-l)/√2σ)) / 2, with t along and n across the
 * link. An infinite straight line has the value 1 on its ridge. Where only the brightest
 * filament is seen, the sum is cut off at 1, and not seen where another one is brighter.
 */
final class AdditiveTerm implements ImageTerm {

	/** [px] Lengths that are the same multiple of this are the same: about a millionth. */
	private static final double SAME_LENGTH = 0x1p-20;

	private final DrawnPart part;
	private final boolean cutOff;
	private final double[] others;
	private final int width;
	private final double[] brightness;
	private final double reach;
	private final LineTables line;
	private final Table gauss;
	private final Robust robust;

	private final Strip strip = new Strip();

	// For each pixel of the part; as if nothing was drawn before a chain is looked at. Heads and
	// residuals are made for those who ask for more than the picture.
	private Patch patch;
	private NormalizedFrame frame;
	private double[] pixels, model, drawn, residuals;
	private int[] head, band;
	private int bandSize;

	/** Not kept as long as only prices are asked. */
	private final LinkShares shares;

	/** Light of a link, by the distance from its middle along it: of the length drawn last. */
	private Table box;
	private double boxLength = Double.NaN;

	/**
	 * @param frame the frame, less what is drawn already if all adds up
	 * @param line the line
	 * @param links number of links
	 * @param others of a line that is cut off, for every pixel the light of what is drawn already;
	 *          empty if that is nothing
	 */
	AdditiveTerm(final NormalizedFrame frame, final LineTables line, final int links,
		final double[] others) {
		part = new DrawnPart(frame);
		cutOff = line.model().kind() == LineModel.Kind.BRIGHTEST;
		this.others = others;
		width = frame.width();
		brightness = line.model().brightnessOfLinks(links);
		for (int i = 0; cutOff && i < links; i++)
			brightness[i] *= line.model().power();
		reach = line.reach();
		this.line = line;
		gauss = line.across();
		robust = line.robust();
		shares = new LinkShares(gauss, line.model().sigma() * line.model().sigma(), links);
	}

	private void look(final double[] x, final double[] y, final int links) {
		if (!part.grow(x, y, links, reach))
			return;
		patch = part.patch();
		strip.within(patch);
		frame = part.view();
		pixels = frame.pixels();
		model = new double[pixels.length];
		drawn = cutOff && others.length > 0
			? patch.cut(others, width)
			: new double[cutOff ? pixels.length : 0];
		head = new int[0];
		band = new int[pixels.length];
		residuals = new double[0];
	}

	@Override
	public double evaluate(final double[] x, final double[] y, final int links,
		final boolean keep) {
		accumulate(x, y, links, keep);
		if (!part.isSomewhere())
			return Double.NaN;
		if (residuals.length == 0)
			residuals = new double[pixels.length];
		double sum = 0;
		for (int b = 0; b < bandSize; b++) {
			final int at = band[b];
			final double dark = cutOff ? drawn[at] : 0;
			residuals[b] = cutOff
				? pixels[at] - Math.max(dark, Math.min(1, model[at]))
				: frame.residual(at, pixels[at], model[at]);
			sum += robust.price(residuals[b]) - robust.price(pixels[at] - dark);
		}
		return sum;
	}

	@Override
	public void linearize(final double[] x, final double[] y, final NodeSystem system) {
		system.clear();
		for (int b = 0; b < bandSize; b++) {
			final int at = band[b];
			if (cutOff ? model[at] > drawn[at] && model[at] < 1 : !frame.hides(at, model[at]))
				shares.addPixel(head[at], robust.weight(residuals[b]), residuals[b], system);
		}
	}

	@Override
	public boolean couplesFarNodes() {
		return true;
	}

	@Override
	public void draw(final double[] x, final double[] y, final int links, final Patch to,
		final double[] picture) {
		accumulate(x, y, links, false);
		Arrays.fill(picture, 0);
		for (int b = 0; b < bandSize; b++) {
			final int at = band[b], there = to.at(at, patch);
			if (there >= 0)
				picture[there] = cutOff ? Math.min(1, model[at]) : model[at];
		}
	}

	private void accumulate(final double[] x, final double[] y, final int links,
		final boolean keep) {
		clear();
		look(x, y, links);
		if (keep && part.isSomewhere() && head.length == 0) {
			head = new int[pixels.length];
			Arrays.fill(head, -1);
		}
		for (int i = 0; i < links && part.isSomewhere(); i++)
			if (keep || brightness[i] != 0)
				visitLink(i, x[i], y[i], x[i + 1], y[i + 1], keep);
	}

	/** Takes off what was drawn last. */
	private void clear() {
		for (int b = 0; b < bandSize; b++) {
			model[band[b]] = 0;
			if (head.length > 0)
				head[band[b]] = -1;
		}
		bandSize = 0;
		shares.clear();
	}

	private void visitLink(final int i, final double ax, final double ay, final double bx,
		final double by, final boolean keep) {
		final double l = Math.sqrt((bx - ax) * (bx - ax) + (by - ay) * (by - ay));
		final double ux = (bx - ax) / l, uy = (by - ay) / l, bright = brightness[i], half = l / 2;
		takeBox(l);
		if (keep)
			shares.begin(i, l, ux, uy);
		strip.lay(ax, ay, ux, uy, -reach, l + reach, reach);
		final int lastRow = strip.lastRow();
		for (int row = strip.firstRow(); row <= lastRow; row++) {
			final double py = row - ay;
			final int begin = (row - patch.top()) * patch.width() - patch.left();
			strip.cut(row);
			final int lastColumn = strip.lastColumn();
			if (keep)
				shares.reserve(patch.width());
			for (int column = strip.firstColumn(); column <= lastColumn; column++) {
				final double px = column - ax;
				final double t = px * ux + py * uy, n = px * -uy + py * ux;
				final double across = bright * gauss.at(n * n);
				final double value = across * box.at(Math.abs(t - half));
				if (value < FitTuning.DRAWN_DARK)
					continue;
				final int at = begin + column;
				if (model[at] == 0)
					band[bandSize++] = at;
				model[at] += value;
				if (keep)
					head[at] = shares.add(i, head[at], value, across, t, n);
			}
		}
	}

	/** All links of a chain are equally long, but for rounding. */
	private void takeBox(final double length) {
		final double rounded = Math.rint(length / SAME_LENGTH) * SAME_LENGTH;
		if (rounded != boxLength) {
			box = line.link(rounded);
			boxLength = rounded;
		}
	}
}
