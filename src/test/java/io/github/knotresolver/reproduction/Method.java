package io.github.knotresolver.reproduction;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.Settings;
import io.github.knotresolver.options.RunOptions;

/** What is compared: options of the pipeline, as a user would give them. */
public enum Method {

	/** Otsu's threshold and the skeleton of what is above it. */
	THRESHOLD("threshold only", Map.of("segmentation", "threshold")),

	/** One frame's outline is the next one's start. */
	ACTIVE_CONTOUR("active contour only", Map.of("segmentation", "active-contour")),

	/** The published method from end to end, its start told as its user clicks it. */
	PUBLISHED("published", Map.of("refine", "no")),

	/** Our defaults; nothing is told. */
	OURS("ours", Map.of());

	/** Those that give an ordered contour. */
	public static final List<Method> RESOLVING = List.of(PUBLISHED, OURS);

	private final String label;
	private final Map<String, String> options;

	Method(final String label, final Map<String, String> options) {
		this.label = label;
		this.options = options;
	}

	/** @return the name in tables and figures */
	public String label() {
		return label;
	}

	/** @return whether it gives an ordered contour, not only a skeleton */
	boolean resolves() {
		return RESOLVING.contains(this);
	}

	/** @return the pipeline's parameters */
	Settings parameters(final Movie movie, final Point clampedEnd) {
		final Map<String, String> texts = new TreeMap<>(options);
		if (this != OURS)
			texts.putAll(Map.of("candidates", "paper", "resolver", "paper"));
		if (this == PUBLISHED)
			texts.put("fixed_end", clampedEnd.toString());
		return RunOptions.parse(texts).parameters(movie);
	}
}
