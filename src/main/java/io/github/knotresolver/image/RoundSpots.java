package io.github.knotresolver.image;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.progress.Cancellation;

/**
 * The light of round bright spots, beads and dirt, in a still picture: taken off one by one,
 * the brightest first, each as it is around its middle in most directions, less the light of
 * lines that run through it (after Högbom 1974, "CLEAN"). What is not brighter than lines
 * explain is left: the fixed end of a filament that turns around it is a still round spot, too.
 */
public final class RoundSpots {

	/** [share] What curves along by more than this part of what it curves across is no line's unevenness. */
	private static final double BEAD = 0.35;

	/** [line widths] The picture is blurred by so much to find spots: finely, and so that two that touch are one. */
	private static final double[] CALM = {0.7, 1.4};

	/** [share] What is wider than a spot has more than this part of its brightness where a spot ends. */
	private static final double HAZE = 0.2;

	/** How often spots are looked for: what is left of those that lie close shows when one is gone. */
	private static final int ROUNDS = 6;

	private final float[] rest;
	private final float[] light;
	private final int width;
	private final double sigma, strand;
	private final List<Point> taken = new ArrayList<>();

	private RoundSpots(final float[] still, final int width, final double sigma,
		final double strand) {
		rest = still.clone();
		light = new float[still.length];
		this.width = width;
		this.sigma = sigma;
		this.strand = strand;
	}

	/**
	 * What was found.
	 *
	 * @param light of the spots for every pixel, at least 0
	 * @param count how many spots
	 */
	public record Found(float[] light, int count) {
	}

	/**
	 * Looks for spots. O(pixels sigma + spots sigma²).
	 *
	 * @param still a picture above its background, lines bright, row by row
	 * @param width of a row
	 * @param sigma standard deviation of a line's profile in pixels
	 * @param strand brightness of a line above the background, above 0
	 * @return the spots
	 */
	public static Found in(final float[] still, final int width, final double sigma,
		final double strand) {
		final RoundSpots spots = new RoundSpots(still, width, sigma, strand);
		int before = -1;
		for (int round = 0; round < ROUNDS && spots.taken.size() > before; round++) {
			before = spots.taken.size();
			for (final double calm : CALM)
				spots.takeOff(calm);
		}
		final List<Point> middles = new ArrayList<>();
		for (final Point p : spots.taken)
			if (middles.stream().allMatch(m -> m.distanceTo(p) > ImageTuning.SPOT_SAME * sigma))
				middles.add(p);
		return new Found(spots.light, middles.size());
	}

	private record Peak(Point at, double height, double roundness) {
	}

	/** One round: every peak once. */
	private void takeOff(final double calm) {
		Cancellation.check();
		final List<Peak> peaks = peaks(calm);
		final List<Point> beads = peaks.stream().filter(p -> p.roundness > BEAD).map(Peak::at)
			.toList();
		for (final Peak peak : peaks) {
			Cancellation.check();
			takeOff(peak.at, beads);
		}
	}

	/** Local maxima that are not as long as lines, the brightest first. */
	private List<Peak> peaks(final double calm) {
		final Hessian h = Hessian.of(rest, width, calm * Math.max(1, sigma));
		final List<Peak> peaks = new ArrayList<>();
		for (int y = 0; y < h.height(); y++)
			for (int x = 0; x < width; x++) {
				final int at = y * width + x;
				if (h.smooth()[at] > ImageTuning.SPOT_LEFT * strand && isTop(h, x, y)) {
					final double mean = -(h.xx()[at] + h.yy()[at]) / 2,
						half = Math.hypot((h.xx()[at] - h.yy()[at]) / 2, h.xy()[at]);
					final double roundness = (mean - half) / (mean + half);
					if (mean > 0 && roundness > ImageTuning.SPOT_ROUND)
						peaks.add(new Peak(top(h, x, y), h.smooth()[at], roundness));
				}
			}
		peaks.sort(Comparator.comparingDouble(p -> -p.height));
		return peaks;
	}

	private static boolean isTop(final Hessian h, final int x, final int y) {
		final float here = h.smooth()[y * h.width() + x];
		for (int v = Math.max(0, y - 1); v <= Math.min(h.height() - 1, y + 1); v++)
			for (int u = Math.max(0, x - 1); u <= Math.min(h.width() - 1, x + 1); u++)
				if (h.smooth()[v * h.width() + u] > here)
					return false;
		return true;
	}

	/** The top between pixels, by parabolas. */
	private static Point top(final Hessian h, final int x, final int y) {
		final float[] v = h.smooth();
		final int w = h.width(), at = y * w + x;
		return new Point(x + (x > 0 && x < w - 1 ? offset(v[at - 1], v[at], v[at + 1]) : 0),
			y + (y > 0 && y < h.height() - 1 ? offset(v[at - w], v[at], v[at + w]) : 0));
	}

	private static double offset(final double before, final double here, final double after) {
		final double curvature = before - 2 * here + after;
		return curvature < 0 ? 0.5 * (before - after) / curvature : 0;
	}

	/** How bright a spot must be, in strands. */
	private double least(final Point spot) {
		final double nearest = taken.stream().mapToDouble(p -> p.distanceTo(spot) / sigma).min()
			.orElse(Double.POSITIVE_INFINITY);
		if (nearest > ImageTuning.SPOT_BESIDE)
			return ImageTuning.SPOT_BRIGHT;
		return nearest > ImageTuning.SPOT_SAME ? ImageTuning.SPOT_HIDDEN : ImageTuning.SPOT_LEFT;
	}

	private void takeOff(final Point spot, final List<Point> beads) {
		final SpotProfile seen = SpotProfile.of(rest, width, spot, sigma);
		final double least = least(spot) * strand;
		// Most peaks are noise, and without lines they are no brighter.
		if (seen.height() < least)
			return;
		final SpotProfile profile = seen.withoutLines(beads);
		if (profile.height() < least || profile.rim() > HAZE * profile.height())
			return;
		taken.add(spot);
		final int reach = (int) Math.ceil(profile.reach()), height = rest.length / width;
		final int cx = (int) Math.rint(spot.x()), cy = (int) Math.rint(spot.y());
		for (int y = Math.max(0, cy - reach); y <= Math.min(height - 1, cy + reach); y++)
			for (int x = Math.max(0, cx - reach); x <= Math.min(width - 1, cx + reach); x++) {
				final int at = y * width + x;
				final double distance = Math.hypot(x - spot.x(), y - spot.y());
				final float share = (float) Math.max(0, Math.min(rest[at], profile.at(distance)));
				rest[at] -= share;
				light[at] += share;
			}
	}
}
