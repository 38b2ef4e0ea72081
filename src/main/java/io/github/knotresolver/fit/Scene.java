
package io.github.knotresolver.fit;

import java.util.ArrayList;
import java.util.List;

/**
 * All filaments of a frame, drawn together: the sum of their light where it adds up, the
 * brightest where it saturates. One chain can be taken out of the picture and put back; the
 * picture is then exactly what it was, bit by bit. Not for several threads at a time.
 */
public final class Scene {

	/** Values are multiples of this: their sums are exact, whatever the order. */
	private static final double GRAIN = 0x1p-30;

	/** Where less is drawn (in strands) there is no chain. */
	private static final double DRAWN = 0.1;

	private final NormalizedFrame light;
	private final LineTables line;
	private final double[] picture;
	private final List<Drawn> members = new ArrayList<>();

	/** A chain and its own picture, and whether that is drawn now. */
	private record Drawn(Chain chain, Patch patch, double[] values, boolean shown) {

		Drawn shown(final boolean now) {
			return new Drawn(chain, patch, values, now);
		}
	}

	/**
	 * @param light the frame, 0 the background and 1 a strand
	 * @param line what a line looks like
	 */
	public Scene(final NormalizedFrame light, final LineTables line) {
		this.light = light;
		this.line = line;
		picture = new double[light.width() * light.height()];
	}

	/**
	 * @param light the frame, 0 the background and 1 a strand
	 * @param line what a line looks like
	 * @param chains the filaments
	 */
	public Scene(final NormalizedFrame light, final LineTables line, final List<Chain> chains) {
		this(light, line);
		chains.forEach(this::add);
	}

	/** @return the frame */
	public NormalizedFrame light() {
		return light;
	}

	/** @return what a line looks like */
	public LineTables line() {
		return line;
	}

	/** @return how many chains there are */
	public int size() {
		return members.size();
	}

	/**
	 * @param k 0 to {@code size() - 1}
	 * @return a chain, whether it is drawn now or not
	 */
	public Chain chain(final int k) {
		return members.get(k).chain;
	}

	/** @return all chains, in order */
	public List<Chain> chains() {
		return members.stream().map(Drawn::chain).toList();
	}

	/**
	 * Draws one more chain. O(length).
	 *
	 * @param chain the chain
	 */
	public void add(final Chain chain) {
		members.add(null);
		put(members.size() - 1, chain);
	}

	/**
	 * Takes a chain out of the picture; it keeps its number. O(length), and where light
	 * saturates O(length) of the chains around, too.
	 *
	 * @param k the chain's number
	 */
	public void take(final int k) {
		final Drawn drawn = members.get(k);
		if (!drawn.shown)
			return;
		members.set(k, drawn.shown(false));
		final boolean additive = isAdditive();
		for (int row = 0, i = 0; row < drawn.patch.height(); row++) {
			int at = (drawn.patch.top() + row) * light.width() + drawn.patch.left();
			for (int c = 0; c < drawn.patch.width(); c++, i++, at++)
				picture[at] = additive ? picture[at] - drawn.values[i] : 0;
		}
		if (!additive)
			for (final Drawn other : members)
				if (other != null && other.shown && other.patch.meets(drawn.patch))
					draw(other);
	}

	/**
	 * Puts a chain in the place of one that was taken. O(length), and less if it is the same.
	 *
	 * @param k the chain's number
	 * @param chain its new shape
	 */
	public void put(final int k, final Chain chain) {
		if (members.get(k) != null)
			take(k);
		members.set(k,
			members.get(k) != null && members.get(k).chain == chain
				? members.get(k).shown(true)
				: drawn(chain));
		draw(members.get(k));
	}

	private Drawn drawn(final Chain chain) {
		final Patch patch = Patch.around(List.of(chain), line.reach() + 1, light);
		final double[] values = new double[patch.width() * patch.height()];
		final Chain here = chain.shifted(-patch.left(), -patch.top());
		final double[] x = new double[chain.links() + 1], y = new double[chain.links() + 1];
		here.nodes(x, y);
		final NormalizedFrame dark = new NormalizedFrame(patch.width(), patch.height(), values);
		ImageTerm.of(dark, line, chain.links(), new double[0]).draw(x, y, chain.links(),
			Patch.of(dark), values);
		for (int i = 0; i < values.length; i++)
			values[i] = Math.rint(values[i] / GRAIN) * GRAIN;
		return new Drawn(chain, patch, values, true);
	}

	private void draw(final Drawn drawn) {
		final boolean additive = isAdditive();
		for (int row = 0, i = 0; row < drawn.patch.height(); row++) {
			int at = (drawn.patch.top() + row) * light.width() + drawn.patch.left();
			for (int c = 0; c < drawn.patch.width(); c++, i++, at++)
				picture[at] = additive
					? picture[at] + drawn.values[i]
					: Math.max(picture[at], drawn.values[i]);
		}
	}

	private boolean isAdditive() {
		return line.model().kind() == LineModel.Kind.ADDITIVE;
	}

	/**
	 * @param k a chain's number
	 * @param other another's
	 * @return whether they are so near that one's light may fall on the other
	 */
	public boolean mayTouch(final int k, final int other) {
		final Drawn a = members.get(k), b = members.get(other);
		return a.patch.meets(b.patch) && a.chain.comesNear(b.chain, 2 * line.reach());
	}

	/**
	 * What is seen around some chains, less what is drawn now: there they can be fitted.
	 *
	 * @param starts chains that are going to be looked at, at least one, all with as many
	 *          links
	 * @return the surroundings
	 */
	public SceneWindow window(final List<Chain> starts) {
		return new SceneWindow(this,
			Patch.around(starts, line.reach() + FitTuning.WINDOW_ROOM, light),
			starts.get(0).links());
	}

	/**
	 * How much light is missing or too much somewhere: the mean of 3 x 3 pixels.
	 *
	 * @param x column in pixels
	 * @param y row in pixels
	 * @return light less picture; 0 outside of the frame
	 */
	public double mismatch(final int x, final int y) {
		final double[] pixels = light.pixels();
		double sum = 0;
		int count = 0;
		for (int row = Math.max(0, y - 1); row <= Math.min(light.height() - 1, y + 1); row++)
			for (int c = Math.max(0, x - 1); c <= Math.min(light.width() - 1, x + 1); c++) {
				final int at = row * light.width() + c;
				sum += light.residual(at, pixels[at], picture[at], line.model());
				count++;
			}
		return count == 0 ? 0 : sum / count;
	}

	/**
	 * @param chain a chain
	 * @param strands how much light may be missing or too much
	 * @return whether it is more at one of its nodes
	 */
	public boolean isOff(final Chain chain, final double strands) {
		final double[] x = new double[chain.links() + 1], y = new double[chain.links() + 1];
		chain.nodes(x, y);
		for (int i = 0; i < x.length; i++)
			if (Math.abs(mismatch((int) Math.rint(x[i]), (int) Math.rint(y[i]))) > strands)
				return true;
		return false;
	}

	/**
	 * @param others pixels to set, too
	 * @return for every pixel whether it is one of those, or a chain is drawn there
	 */
	public boolean[] near(final boolean[] others) {
		final boolean[] near = drawnAbove(DRAWN);
		for (int i = 0; i < near.length; i++)
			near[i] |= others[i];
		return near;
	}

	/**
	 * @param brightness in strands
	 * @return for every pixel whether more is drawn there
	 */
	public boolean[] drawnAbove(final double brightness) {
		final boolean[] drawn = new boolean[picture.length];
		for (int i = 0; i < drawn.length; i++)
			drawn[i] = picture[i] > brightness;
		return drawn;
	}

	/** @return what the chains leave of the frame: light less picture */
	public NormalizedFrame residual() {
		final double[] left = light.pixels().clone();
		for (int i = 0; i < left.length; i++)
			left[i] -= picture[i];
		return new NormalizedFrame(light.width(), light.height(), left);
	}

	/** @return what is drawn now, in strands, row by row; not to be changed */
	public double[] picture() {
		return picture;
	}
}
