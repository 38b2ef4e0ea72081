package io.github.knotresolver.image;

import java.util.Arrays;
import java.util.List;

import io.github.knotresolver.geometry.Point;

/**
 * How bright a round spot is at a distance from its middle: as it is in most directions, so
 * that lines and other spots beside it do not count, and falling outwards.
 */
final class SpotProfile {

	/** [px] Distance between the radii that are looked at. */
	private static final double STEP = 0.5;

	/** [line widths] No spot reaches farther. */
	private static final double REACH = 6;

	/** [share] A spot ends at this part of its brightness. */
	private static final double END = 0.03;

	/** [line widths] Lines that run through are looked for so far out, as far as the spot allows. */
	private static final double NEAREST_RING = 3, FARTHEST_RING = 5;

	/** [line widths] ... and in two more rings so far beyond, which a spot beside it does not reach. */
	private static final double BETWEEN_RINGS = 1.5;

	private static final int DIRECTIONS = 96;

	/** A line may have turned by so many directions from one ring to the next. */
	private static final int TURN = 4;

	/** [line widths] Another spot within the first is no line ... */
	private static final double OTHERS = 8;

	/** [line widths] ... and covers so much to both sides. */
	private static final double WIDTH_OF_OTHERS = 2.5;

	/** [px] What is nearer than this is the spot itself. */
	private static final double ITSELF = 1.5;

	/** [share] The profile is a quantile, so that pixels may be somewhat brighter. */
	private static final double MORE = 1.1;

	private final float[] pixels;
	private final int width;
	private final Point middle;
	private final double sigma;
	private final double[] profile;

	private SpotProfile(final float[] pixels, final int width, final Point middle,
		final double sigma, final double[] profile) {
		this.pixels = pixels;
		this.width = width;
		this.middle = middle;
		this.sigma = sigma;
		this.profile = profile;
	}

	/**
	 * @param pixels a picture, background 0, row by row
	 * @param width of a row
	 * @param middle of a spot
	 * @param sigma of a line
	 */
	static SpotProfile of(final float[] pixels, final int width, final Point middle,
		final double sigma) {
		final SpotProfile spot = new SpotProfile(pixels, width, middle, sigma,
			new double[(int) (REACH * sigma / STEP) + 2]);
		double least = Double.POSITIVE_INFINITY;
		for (int k = 0; k < spot.profile.length; k++) {
			final double radius = k * STEP;
			final int directions = Math.max(8, (int) Math.ceil(4 * Math.PI * radius));
			least = Math.max(0, Math.min(least, inMost(spot.ring(radius, directions))));
			spot.profile[k] = least;
		}
		return spot;
	}

	/** The brightness in the directions; NaN outside the picture. */
	private double[] ring(final double radius, final int directions) {
		final double[] ring = new double[directions];
		final int height = pixels.length / width;
		for (int i = 0; i < directions; i++) {
			final double angle = 2 * Math.PI * i / directions;
			final double x = middle.x() + radius * Math.cos(angle),
				y = middle.y() + radius * Math.sin(angle);
			ring[i] = x < -0.5 || y < -0.5 || x > width - 0.5 || y > height - 0.5
				? Double.NaN
				: Pixels.between(pixels, width, x, y);
		}
		return ring;
	}

	private static double inMost(final double[] ring) {
		final double[] inside = Arrays.stream(ring).filter(Double::isFinite).sorted().toArray();
		return inside.length == 0
			? 0
			: inside[(int) (ImageTuning.SPOT_ALONE * (inside.length - 1))];
	}

	/**
	 * @param spots middles of spots, which are no lines
	 * @return the profile less what lines that run through it add
	 */
	SpotProfile withoutLines(final List<Point> spots) {
		final double lines = lines(spots);
		final double[] less = new double[profile.length];
		for (int k = 0; k < less.length; k++) {
			final double d = k * STEP / sigma;
			less[k] = Math.max(0, profile[k] - lines * Math.exp(-d * d / 2));
			if (k > 0)
				less[k] = Math.min(less[k], less[k - 1]);
		}
		return new SpotProfile(pixels, width, middle, sigma, less);
	}

	/** Brightness of the lines that run through the middle: half of the arms that go out. */
	private double lines(final List<Point> spots) {
		final double radius = Math.min(FARTHEST_RING * sigma,
			Math.max(NEAREST_RING * sigma, reach()));
		final double[] arms = above(ring(radius, DIRECTIONS));
		for (int k = 1; k <= 2; k++) {
			final double[] beyond = above(ring(radius + k * BETWEEN_RINGS * sigma, DIRECTIONS));
			for (int i = 0; i < DIRECTIONS; i++)
				arms[i] = Math.min(arms[i], most(beyond, i));
		}
		for (final Point spot : spots)
			leaveOut(spot, arms);
		return Arrays.stream(arms).sum() * radius * 2 * Math.PI / DIRECTIONS
			/ (sigma * Math.sqrt(2 * Math.PI)) / 2;
	}

	private static double[] above(final double[] ring) {
		final double most = inMost(ring);
		return Arrays.stream(ring).map(v -> v > most ? v - most : 0).toArray();
	}

	private static double most(final double[] ring, final int direction) {
		double most = 0;
		for (int k = -TURN; k <= TURN; k++)
			most = Math.max(most, ring[Math.floorMod(direction + k, DIRECTIONS)]);
		return most;
	}

	private void leaveOut(final Point spot, final double[] arms) {
		final double distance = spot.distanceTo(middle);
		if (distance < ITSELF || distance > OTHERS * sigma)
			return;
		final double towards = Math.atan2(spot.y() - middle.y(), spot.x() - middle.x());
		for (int i = 0; i < arms.length; i++) {
			final double off = Math.IEEEremainder(2 * Math.PI * i / arms.length - towards,
				2 * Math.PI);
			if (Math.abs(off) < WIDTH_OF_OTHERS * sigma / distance)
				arms[i] = 0;
		}
	}

	/** @return how bright the middle is */
	double height() {
		return profile[0];
	}

	/** @return how bright it is as far out as spots reach */
	double rim() {
		return profile[profile.length - 1];
	}

	/** @return the distance in pixels at which it has faded */
	double reach() {
		int k = 0;
		while (k < profile.length - 1 && profile[k] > END * profile[0])
			k++;
		return k * STEP;
	}

	/** @return the most that a pixel at a distance from the middle has of its light */
	double at(final double distance) {
		final double k = distance / STEP;
		if (k >= profile.length - 1)
			return 0;
		final int below = (int) k;
		return MORE * (profile[below] + (k - below) * (profile[below + 1] - profile[below]));
	}
}
