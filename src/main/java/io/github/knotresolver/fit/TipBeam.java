
package io.github.knotresolver.fit;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;

/**
 * Grows the last links of a chain anew, link by link, along the light that is left: a beam
 * search over headings. For ends that have turned so much that a fit does not find them.
 *
 * What a tip explains is Σ 2 I m - m² over the pixels, m its picture. A line whose light adds
 * up is the Gaussian of its points, so that Σ I m is the blurred light summed along the tip,
 * and Σ m² a Gaussian of distances within it: no pixel is visited twice, whatever is tried.
 */
final class TipBeam {

	/** A link stands for two points, each in the middle of its half. */
	private static final double[] POINTS = {0.25, 0.75};

	private final NormalizedFrame light;
	private final LineTables line;
	private final double bend;
	private final double h;
	private final double area;

	/** Light around the tip, blurred as the line is, and where that part begins. */
	private NormalizedFrame blurred;
	private double left;
	private double top;

	/** A tip in the making: its nodes, its headings, what it explains. */
	private record Tip(double[] x, double[] y, double[] theta, double gain) {
		Tip longer(final double heading, final double h, final double more) {
			final int n = theta.length;
			final double[] nextX = Arrays.copyOf(x, n + 1), nextY = Arrays.copyOf(y, n + 1);
			final double[] nextTheta = Arrays.copyOf(theta, n + 1);
			nextX[n] = x[n - 1] + h * Math.cos(heading);
			nextY[n] = y[n - 1] + h * Math.sin(heading);
			nextTheta[n] = heading;
			return new Tip(nextX, nextY, nextTheta, more);
		}
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
		area = Math.sqrt(2 * Math.PI) * this.line.model().sigma();
	}

	/**
	 * O(links²) and the pixels around the tip.
	 *
	 * @param chain the chain
	 * @param links how many of its last links grow anew, fewer than it has
	 * @return chains with other tips, the best first
	 */
	List<Chain> grown(final Chain chain, final int links) {
		final int kept = chain.links() - links;
		final double[] x = new double[chain.links() + 1], y = new double[chain.links() + 1];
		chain.nodes(x, y);
		if (!look(x, y, kept, links * h + line.reach() + 2))
			return List.of();
		List<Tip> tips = List.of(new Tip(new double[]{x[kept]}, new double[]{y[kept]},
			new double[]{chain.angle(kept - 1)}, 0));
		for (int i = 0; i < links; i++)
			tips = longer(tips);
		return tips.stream().limit(FitTuning.BEAM_GIVEN)
			.map(t -> chain.withTail(Arrays.copyOfRange(t.theta, 1, t.theta.length))).toList();
	}

	/** Cuts out what is around a node, takes off what the chain has before it, and blurs it. */
	private boolean look(final double[] x, final double[] y, final int kept, final double far) {
		final int x0 = (int) Math.max(0, Math.floor(x[kept] - far));
		final int y0 = (int) Math.max(0, Math.floor(y[kept] - far));
		final int x1 = (int) Math.min(light.width() - 1, Math.ceil(x[kept] + far));
		final int y1 = (int) Math.min(light.height() - 1, Math.ceil(y[kept] + far));
		if (x1 < x0 || y1 < y0)
			return false;
		left = x0;
		top = y0;
		final NormalizedFrame part = light.window(x0, y0, x1 - x0 + 1, y1 - y0 + 1);
		for (int i = 0; i < kept; i++)
			takeOff(part, x[i] - x0, y[i] - y0, x[i + 1] - x0, y[i + 1] - y0);
		blurred = part.blurred(line.model().sigma());
		return true;
	}

	private void takeOff(final NormalizedFrame part, final double ax, final double ay,
		final double bx, final double by) {
		final double reach = line.reach(), ux = (bx - ax) / h, uy = (by - ay) / h;
		final int top = (int) Math.max(0, Math.ceil(Math.min(ay, by) - reach));
		final int bottom = (int) Math.min(part.height() - 1, Math.floor(Math.max(ay, by) + reach));
		final int first = (int) Math.max(0, Math.ceil(Math.min(ax, bx) - reach));
		final int last = (int) Math.min(part.width() - 1, Math.floor(Math.max(ax, bx) + reach));
		for (int row = top; row <= bottom; row++)
			for (int c = first; c <= last; c++) {
				final double t = (c - ax) * ux + (row - ay) * uy;
				final double n = (row - ay) * ux - (c - ax) * uy;
				part.pixels()[row * part.width() + c] -= line.across().at(n * n)
					* (line.beyond(-t) - line.beyond(h - t));
			}
	}

	private List<Tip> longer(final List<Tip> tips) {
		final List<Link> all = new ArrayList<>();
		for (final Tip tip : tips)
			for (int a = 0; a < FitTuning.HEADINGS; a++) {
				final double turn = (a - FitTuning.HEADINGS / 2) * FitTuning.HEADING_STEP;
				final double heading = tip.theta[tip.theta.length - 1] + turn;
				all.add(new Link(tip, heading, tip.gain + gain(tip, heading) - bend * turn * turn));
			}
		all.sort(Comparator.comparingDouble(Link::gain).reversed());
		return all.stream().limit(FitTuning.BEAM).map(l -> l.tip.longer(l.heading, h, l.gain))
			.toList();
	}

	/** What one more link explains, with all that its tip has already. */
	private double gain(final Tip tip, final double heading) {
		final int n = tip.theta.length;
		final double ux = h * Math.cos(heading), uy = h * Math.sin(heading);
		double seen = 0, shared = 0;
		for (final double share : POINTS) {
			final double px = tip.x[n - 1] + share * ux, py = tip.y[n - 1] + share * uy;
			seen += at(px, py);
			for (int i = 0; i + 1 < n; i++)
				for (final double other : POINTS)
					shared += 2 * overlap(px - tip.x[i] - other * (tip.x[i + 1] - tip.x[i]),
						py - tip.y[i] - other * (tip.y[i + 1] - tip.y[i]));
			for (final double other : POINTS)
				shared += overlap((share - other) * ux, (share - other) * uy);
		}
		return area * h * seen - 0.125 * h * h * shared;
	}

	/** exp(-d² / 4σ²) */
	private double overlap(final double dx, final double dy) {
		return line.across().at(0.5 * (dx * dx + dy * dy));
	}

	private double at(final double x, final double y) {
		final double cx = x - left, cy = y - top;
		final int c = (int) Math.floor(cx), r = (int) Math.floor(cy);
		if (c < 0 || r < 0 || c >= blurred.width() - 1 || r >= blurred.height() - 1)
			return 0;
		final double fx = cx - c, fy = cy - r;
		final double[] p = blurred.pixels();
		final int i = r * blurred.width() + c;
		return (1 - fy) * ((1 - fx) * p[i] + fx * p[i + 1])
			+ fy * ((1 - fx) * p[i + blurred.width()] + fx * p[i + blurred.width() + 1]);
	}
}
