package io.github.knotresolver.evaluate.like;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

import org.apache.commons.math3.stat.descriptive.rank.Median;

import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.Movie;

/**
 * What is compared between the user's movie and the simulated ones, measured
 * alike in both: in the user's along its resolved contours, in the simulated ones
 * along the true ones.
 *
 * @param values by quantity with its unit, in the order of a table
 */
public record LikeTraits(Map<String, Double> values) {

	public LikeTraits {
		values = Collections.unmodifiableMap(new LinkedHashMap<>(values));
	}

	static LikeTraits of(final Movie movie, final List<Optional<Polyline>> contours,
		final Appearance look, final Motion motion) {
		final double size = movie.calibration().pixelSize();
		final String unit = movie.calibration().unit();
		final Map<String, Double> t = new LinkedHashMap<>();
		t.put("frames", (double) movie.size());
		t.put("frame interval [" + movie.calibration().timeUnit() + "]",
			movie.calibration().frameInterval());
		t.put("pixel size [" + unit + "]", size);
		t.put("length [" + unit + "]", size * new Median().evaluate(
			contours.stream().flatMap(Optional::stream).mapToDouble(Polyline::length).toArray()));
		t.put("line width [px]", look.width());
		t.put("background [grey]", look.background());
		t.put("peak over background [grey]", look.peak());
		t.put("noise [grey]", look.noise());
		t.put("noise on the line [grey]", look.noiseOnLine());
		t.put("peak over noise", look.noise() > 0 ? look.peak() / look.noise() : Double.NaN);
		t.put("step of the tip [px]", motion.tipStep());
		t.put("step of the contour [px]", motion.contourStep());
		t.put("frames in which it meets itself [%]", 100 * motion.knotted());
		t.put("end to end over length", motion.extension());
		t.put("  at its straightest", motion.straightest());
		t.put("turning along it [turns]", motion.turning());
		return new LikeTraits(t);
	}
}
