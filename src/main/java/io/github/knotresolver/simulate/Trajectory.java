package io.github.knotresolver.simulate;

import java.util.List;

import io.github.knotresolver.geometry.Polyline;

/**
 * What a simulation gives.
 *
 * @param curves one curve a frame in µm, the clamped end first, at the origin
 * @param frameInterval time between frames in s
 */
public record Trajectory(List<Polyline> curves, double frameInterval) {

	public Trajectory {
		curves = List.copyOf(curves);
	}
}
