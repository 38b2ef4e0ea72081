
package io.github.knotresolver.fit;

/**
 * How badly the picture of a chain explains a frame. An implementation keeps
 * scratch memory: one thread at a time.
 */
interface ImageTerm {

	/**
	 * The sum of the robust prices of all pixels of the frame, with the chain
	 * drawn into it, minus the same sum without any chain: negative if the chain
	 * explains light. Only the band around the chain is visited: O(length).
	 *
	 * @param x columns of the nodes in pixels
	 * @param y rows of the nodes
	 * @param links number of links
	 * @param keep whether the normal equations may be asked for
	 * @return the change of the price
	 */
	double evaluate(double[] x, double[] y, int links, boolean keep);

	/**
	 * The normal equations of the chain that was evaluated last: most of a fit's last chains are
	 * priced only. Only if they were to be kept, and once.
	 *
	 * @param x columns of its nodes in pixels
	 * @param y rows of its nodes
	 * @param system receives them
	 */
	void linearize(double[] x, double[] y, NodeSystem system);

	/**
	 * Draws the chain as the model sees it.
	 *
	 * @param x columns of the nodes in pixels
	 * @param y rows of the nodes
	 * @param links number of links
	 * @param patch the part of the frame that is drawn
	 * @param picture of that part, receives the model's value of every pixel of the band; other
	 *          pixels are set to 0
	 */
	void draw(double[] x, double[] y, int links, Patch patch, double[] picture);

	/** @return whether a pixel may depend on more than one link */
	boolean couplesFarNodes();

	/**
	 * @param frame the frame
	 * @param model what a line looks like in a frame in focus
	 * @param links number of links of the chains to come
	 * @return the term for the model's kind
	 */
	static ImageTerm of(final NormalizedFrame frame, final LineModel model, final int links) {
		return of(frame, new LineTables(model.in(frame), Robust.ALONE), links, new double[0]);
	}

	/**
	 * @param frame the frame; of lines that add up, less what is drawn already
	 * @param line the line
	 * @param links number of links of the chains to come
	 * @param others of lines that saturate, for every pixel the light of what is drawn already;
	 *          empty if that is nothing
	 * @return the term for the line's kind
	 */
	static ImageTerm of(final NormalizedFrame frame, final LineTables line, final int links,
		final double[] others) {
		return switch (line.model().kind()) {
			case SATURATING -> new SaturatingTerm(frame, line, links, others);
			case BRIGHTEST, ADDITIVE -> new AdditiveTerm(frame, line, links, others);
		};
	}
}
