
package io.github.knotresolver.fit;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;

/**
 * Grows the last links of a chain anew, link by link, along the light that is left: a beam
 * search over headings. For ends that have turned so much that a fit does not find them.
 */
final class TipBeam {

	private final NormalizedFrame light;
	private final LineTables line;
	private final double bend;
	private final double h;

	/** A tip in the making: its end, its headings, what it explains, and the light that is left. */
	private record Tip(double x, double y, double[] theta, double gain, double[] left) {
	}

	/** One more link. */
	private record Link(Tip tip, double heading, double gain) {
	}

	/**
	 * @param light the frame, less what is drawn already
	 * @param line the line
	 * @param stiffness price of bending
	 * @param h length of a link in pixels
	 */
	TipBeam(final NormalizedFrame light, final LineTables line, final double stiffness,
		final double h) {
		this.light = light;
		this.line = line.additive();
		bend = FitTuning.BEAM_TURN * stiffness / h;
		this.h = h;
	}

	/**
	 * @param chain the chain
	 * @param links how many of its last links grow anew, fewer than it has
	 * @return chains with other tips, the best first
	 */
	List<Chain> grown(final Chain chain, final int links) {
		final int kept = chain.links() - links;
		final double[] x = new double[chain.links() + 1], y = new double[chain.links() + 1];
		chain.nodes(x, y);
		final double[] left = light.pixels().clone();
		for (int i = 0; i < kept; i++)
			visit(left, x[i], y[i], chain.angle(i), true);
		List<Tip> tips = List
			.of(new Tip(x[kept], y[kept], new double[]{chain.angle(kept - 1)}, 0, left));
		for (int i = 0; i < links; i++)
			tips = longer(tips);
		return tips.stream().limit(FitTuning.BEAM_GIVEN)
			.map(t -> chain.withTail(Arrays.copyOfRange(t.theta, 1, t.theta.length))).toList();
	}

	private List<Tip> longer(final List<Tip> tips) {
		final List<Link> all = new ArrayList<>();
		for (final Tip tip : tips)
			for (int a = 0; a < FitTuning.HEADINGS; a++) {
				final double turn = (a - FitTuning.HEADINGS / 2) * FitTuning.HEADING_STEP;
				final double heading = tip.theta[tip.theta.length - 1] + turn;
				all.add(new Link(tip, heading,
					tip.gain + visit(tip.left, tip.x, tip.y, heading, false) - bend * turn * turn));
			}
		all.sort(Comparator.comparingDouble(Link::gain).reversed());
		return all.stream().limit(FitTuning.BEAM).map(this::drawn).toList();
	}

	private Tip drawn(final Link link) {
		final Tip tip = link.tip;
		final double[] theta = Arrays.copyOf(tip.theta, tip.theta.length + 1);
		theta[tip.theta.length] = link.heading;
		final double[] left = tip.left.clone();
		visit(left, tip.x, tip.y, link.heading, true);
		return new Tip(tip.x + h * Math.cos(link.heading), tip.y + h * Math.sin(link.heading),
			theta, link.gain, left);
	}

	/** The light that a link explains, Σ 2 I m - m²; takes it off the picture if asked to. */
	private double visit(final double[] picture, final double x, final double y,
		final double heading, final boolean takes) {
		final double ux = Math.cos(heading), uy = Math.sin(heading), reach = line.reach();
		final int top = (int) Math.ceil(Math.min(y, y + h * uy) - reach);
		final int bottom = (int) Math.floor(Math.max(y, y + h * uy) + reach);
		final int first = (int) Math.ceil(Math.min(x, x + h * ux) - reach);
		final int last = (int) Math.floor(Math.max(x, x + h * ux) + reach);
		double gain = 0;
		for (int row = Math.max(0, top); row <= Math.min(light.height() - 1, bottom); row++)
			for (int c = Math.max(0, first); c <= Math.min(light.width() - 1, last); c++) {
				final double t = (c - x) * ux + (row - y) * uy, n = (row - y) * ux - (c - x) * uy;
				final double value = line.across().at(n * n) * (below(t) - below(t - h));
				final int at = row * light.width() + c;
				gain += 2 * picture[at] * value - value * value;
				if (takes)
					picture[at] -= value;
			}
		return gain;
	}

	private double below(final double t) {
		return t < 0 ? line.along().at(-t) : 1 - line.along().at(t);
	}
}
