package io.github.knotresolver.imagej;

import java.util.AbstractList;
import java.util.LinkedHashMap;
import java.util.Map;

import ij.ImageStack;

/**
 * The pixels of planes of a virtual stack, read when they are asked for. Those asked for last
 * are kept, as many as take a part of Java's memory. Any number of threads may ask.
 */
final class VirtualPlanes extends AbstractList<Object> {

	/** The share of Java's memory for planes. */
	private static final double SHARE = 0.25;

	/** Planes that are kept at least. */
	private static final int FEWEST = 4;

	private final ImageStack stack;
	private final int[] indices;
	private final Map<Integer, Object> recent;

	/**
	 * @param stack a virtual stack
	 * @param indices the planes, from 1, as the stack counts them
	 * @param bits of a pixel
	 * @param memory Java's memory in bytes
	 */
	VirtualPlanes(final ImageStack stack, final int[] indices, final int bits, final long memory) {
		this.stack = stack;
		this.indices = indices.clone();
		final double plane = (double) stack.getWidth() * stack.getHeight() * bits / Byte.SIZE;
		final int most = (int) Math.max(FEWEST, SHARE * memory / plane);
		recent = new LinkedHashMap<>(16, 0.75f, true) {

			@Override
			protected boolean removeEldestEntry(final Map.Entry<Integer, Object> eldest) {
				return size() > most;
			}
		};
	}

	@Override
	public synchronized Object get(final int i) {
		final Object known = recent.get(i);
		if (known != null)
			return known;
		// Some virtual stacks give the same array again and again.
		final Object plane = stack.getProcessor(indices[i]).getPixelsCopy();
		recent.put(i, plane);
		return plane;
	}

	@Override
	public int size() {
		return indices.length;
	}
}
