
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

	/** Those of about 30 links. */
	private static final int FEWEST_ENTRIES = 1 << 12;

	private final DrawnPart part;
	private final boolean cutOff;
	private final double[] others;
	private final int width;
	private final double[] brightness;
	private final double sigma2;
	private final double reach;
	private final Table gauss;
	private final Table error;
	private final double density;
	private final Robust robust;

	private final Strip strip = new Strip();

	// For each pixel of the part; as if nothing was drawn whenever a chain has been looked at.
	private Patch patch;
	private NormalizedFrame frame;
	private double[] pixels, model, drawn;
	private int[] head, band;
	private int bandSize;

	// One entry for each pair of a pixel and a link in reach; none as long as only prices are asked.
	private int[] next = new int[0];
	private int[] link = new int[0];
	private double[] slope = new double[0];
	private int entries;

	private int[] nodes = new int[64];
	private double[] jacobian = new double[128];

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
		sigma2 = line.model().sigma() * line.model().sigma();
		reach = line.reach();
		gauss = line.across();
		error = line.along();
		density = 1 / Math.sqrt(2 * Math.PI * sigma2);
		robust = line.robust();
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
		head = new int[pixels.length];
		Arrays.fill(head, -1);
		band = new int[pixels.length];
	}

	@Override
	public double evaluate(final double[] x, final double[] y, final int links,
		final NodeSystem system) {
		accumulate(x, y, links, system != null);
		if (!part.isSomewhere())
			return Double.NaN;
		if (system != null)
			system.clear();
		double sum = 0;
		for (int b = 0; b < bandSize; b++) {
			final int at = band[b];
			final double dark = cutOff ? drawn[at] : 0;
			final double residual = cutOff
				? pixels[at] - Math.max(dark, Math.min(1, model[at]))
				: frame.residual(at, pixels[at], model[at]);
			sum += robust.price(residual) - robust.price(pixels[at] - dark);
			if (system != null
				&& (cutOff ? model[at] > dark && model[at] < 1 : !frame.hides(at, model[at])))
				addPixel(at, residual, system);
			model[at] = 0;
			head[at] = -1;
		}
		return sum;
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
			model[at] = 0;
			head[at] = -1;
		}
	}

	/** Collects a pixel's entries, joining those of neighbouring links. */
	private void addPixel(final int at, final double residual, final NodeSystem system) {
		int count = 0;
		for (int e = head[at]; e >= 0; e = next[e]) {
			if (count + 2 > nodes.length) {
				nodes = Arrays.copyOf(nodes, 2 * nodes.length);
				jacobian = Arrays.copyOf(jacobian, 2 * jacobian.length);
			}
			// The list runs from the last link to the first.
			if (count == 0 || nodes[count - 1] != link[e] + 1) {
				nodes[count] = link[e] + 1;
				jacobian[2 * count] = 0;
				jacobian[2 * count + 1] = 0;
				count++;
			}
			jacobian[2 * count - 2] += slope[4 * e + 2];
			jacobian[2 * count - 1] += slope[4 * e + 3];
			nodes[count] = link[e];
			jacobian[2 * count] = slope[4 * e];
			jacobian[2 * count + 1] = slope[4 * e + 1];
			count++;
		}
		system.add(nodes, jacobian, count, robust.weight(residual), residual);
	}

	private void accumulate(final double[] x, final double[] y, final int links,
		final boolean slopes) {
		bandSize = 0;
		entries = 0;
		look(x, y, links);
		for (int i = 0; i < links && part.isSomewhere(); i++)
			visitLink(i, x[i], y[i], x[i + 1], y[i + 1], slopes);
	}

	private void visitLink(final int i, final double ax, final double ay, final double bx,
		final double by, final boolean slopes) {
		final double l = Math.sqrt((bx - ax) * (bx - ax) + (by - ay) * (by - ay));
		final double ux = (bx - ax) / l, uy = (by - ay) / l;
		strip.lay(ax, ay, ux, uy, -reach, l + reach, reach);
		final int lastRow = strip.lastRow();
		for (int row = strip.firstRow(); row <= lastRow; row++) {
			final double py = row - ay;
			final int begin = (row - patch.top()) * patch.width() - patch.left();
			strip.cut(row);
			final int lastColumn = strip.lastColumn();
			for (int column = strip.firstColumn(); column <= lastColumn; column++) {
				final double px = column - ax;
				final double t = px * ux + py * uy, n = px * -uy + py * ux;
				final double across = brightness[i] * gauss.at(n * n);
				final double value = across * (cumulative(t) - cumulative(t - l));
				if (value < FitTuning.DRAWN_DARK)
					continue;
				final int at = begin + column;
				if (head[at] == -1 && model[at] == 0)
					band[bandSize++] = at;
				model[at] += value;
				if (slopes)
					addEntry(at, i, value, across, t, n, l, ux, uy);
			}
		}
	}

	/** Share of a Gaussian below t. */
	private double cumulative(final double t) {
		return t < 0 ? error.at(-t) : 1 - error.at(t);
	}

	private void addEntry(final int at, final int i, final double value, final double across,
		final double t, final double n, final double l, final double ux, final double uy) {
		if (entries == next.length)
			grow();
		next[entries] = head[at];
		link[entries] = i;
		head[at] = entries;
		final double begin = across * density * gauss.at(t * t);
		final double end = across * density * gauss.at((t - l) * (t - l));
		final double shift = value * n / sigma2, turn = (begin - end) * n / l;
		final double startAcross = shift * (1 - t / l) - turn, endAcross = shift * t / l + turn;
		final int s = 4 * entries;
		slope[s] = startAcross * -uy - begin * ux;
		slope[s + 1] = startAcross * ux - begin * uy;
		slope[s + 2] = endAcross * -uy + end * ux;
		slope[s + 3] = endAcross * ux + end * uy;
		entries++;
	}

	private void grow() {
		final int size = Math.max(FEWEST_ENTRIES, 2 * next.length);
		next = Arrays.copyOf(next, size);
		link = Arrays.copyOf(link, size);
		slope = Arrays.copyOf(slope, 4 * size);
	}
}
