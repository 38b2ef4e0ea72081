
package io.github.knotresolver.simulate;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * Motors at random places on an endless surface, made where the filament comes.
 * Every square has its own random numbers, so that a motor's place does not
 * depend on the filament's way.
 */
final class MotorField {

	/** Edge of a square in µm. */
	private static final double SQUARE = 0.5;

	private record Square(int column, int row) {
	}

	private final Map<Square, List<Motor>> squares = new HashMap<>();
	private final double meanPerSquare;
	private final long seed;

	MotorField(final double density, final long seed) {
		meanPerSquare = density * SQUARE * SQUARE;
		this.seed = seed;
	}

	/**
	 * The motors in the squares that lie within reach of the filament, in the
	 * order in which the filament meets them.
	 *
	 * @param chain the filament
	 * @param reach distance in µm
	 * @return motors, each once
	 */
	List<Motor> near(final SimulatedChain chain, final double reach) {
		final Set<Square> seen = new HashSet<>();
		final List<Motor> found = new ArrayList<>();
		final double around = reach + chain.link / 2;
		for (int i = 0; i < chain.nodes(); i++)
			for (int row = index(chain.y[i] - around); row <= index(chain.y[i] + around); row++)
				for (int column = index(chain.x[i] - around); column <= index(
					chain.x[i] + around); column++) {
					final Square square = new Square(column, row);
					if (seen.add(square))
						addNear(chain, square, reach, found);
				}
		return found;
	}

	private void addNear(final SimulatedChain chain, final Square square, final double reach,
		final List<Motor> found) {
		for (final Motor m : squares.computeIfAbsent(square, this::populate))
			if (!Double.isNaN(chain.nearest(m.x, m.y, reach)))
				found.add(m);
	}

	private List<Motor> populate(final Square square) {
		final Noise noise = new Noise(
			seed ^ (square.column * 0x9E3779B97F4A7C15L + square.row * 0xC2B2AE3D27D4EB4FL));
		final int count = (int) Math.rint(noise.poisson(meanPerSquare));
		final List<Motor> motors = new ArrayList<>(count);
		for (int i = 0; i < count; i++)
			motors.add(new Motor((square.column + noise.uniform()) * SQUARE,
				(square.row + noise.uniform()) * SQUARE));
		return motors;
	}

	private static int index(final double coordinate) {
		return (int) Math.floor(coordinate / SQUARE);
	}
}
