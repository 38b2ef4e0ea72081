package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.List;

import io.github.knotresolver.fit.Fit;

/**
 * The different fits of one frame. Two fits whose nodes are less than a pixel
 * apart on average are one; the cheaper stays.
 */
final class FitPool {

	private final List<Fit> fits;

	FitPool() {
		this(List.of());
	}

	/**
	 * @param fits that are in it to begin with, however near to each other
	 */
	FitPool(final List<Fit> fits) {
		this.fits = new ArrayList<>(fits);
	}

	/**
	 * Adds a fit.
	 *
	 * @return the fit that now stands for it
	 */
	Fit add(final Fit fit) {
		for (int i = 0; i < fits.size(); i++)
			if (isSame(fits.get(i), fit)) {
				if (fit.energy() < fits.get(i).energy())
					fits.set(i, fit);
				return fits.get(i);
			}
		fits.add(fit);
		return fit;
	}

	/** @return whether two fits of a frame are one */
	static boolean isSame(final Fit one, final Fit other) {
		return one.chain().distance(other.chain()) < TrackTuning.SAME_FIT;
	}

	List<Fit> fits() {
		return List.copyOf(fits);
	}
}
