
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

	private static final double[] NOT_YET = {};

	private final NormalizedFrame light;
	private final LineTables line;
	private final double[] picture;
	private final List<Member> members = new ArrayList<>();

	/**
	 * A chain.
	 *
	 * @param patch where its light falls
	 * @param values its own picture; empty as long as nobody has asked
	 * @param isShown whether it is one of the scene now
	 * @param isDrawn whether it is in the picture already
	 */
	private record Member(Chain chain, Patch patch, double[] values, boolean isShown,
		boolean isDrawn) {

		Member shown() {
			return new Member(chain, patch, values, true, false);
		}

		Member hidden() {
			return new Member(chain, patch, values, false, false);
		}

		Member drawn(final double[] own) {
			return new Member(chain, patch, own, true, true);
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
		return members.stream().map(Member::chain).toList();
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
		final Member member = members.get(k);
		members.set(k, member.hidden());
		if (!member.isDrawn)
			return;
		final boolean additive = isAdditive();
		for (int row = 0, i = 0; row < member.patch.height(); row++) {
			int at = (member.patch.top() + row) * light.width() + member.patch.left();
			for (int c = 0; c < member.patch.width(); c++, i++, at++)
				picture[at] = additive ? picture[at] - member.values[i] : 0;
		}
		if (!additive)
			for (final Member other : members)
				if (other != null && other.isDrawn && other.patch.meets(member.patch))
					draw(other);
	}

	/**
	 * Puts a chain in the place of one that was taken. It is drawn when somebody looks where it is:
	 * O(length) then, once as long as it is the same.
	 *
	 * @param k the chain's number
	 * @param chain its new shape
	 */
	public void put(final int k, final Chain chain) {
		final Member before = members.get(k);
		if (before != null)
			take(k);
		members.set(k,
			before != null && before.chain == chain
				? before.shown()
				: new Member(chain, Patch.around(List.of(chain), line.reach() + 1, light), NOT_YET,
					true, false));
	}

	/** Draws what is still to be drawn and falls into a part of the frame. */
	private void drawIn(final Patch part) {
		for (int k = 0; k < members.size(); k++) {
			final Member member = members.get(k);
			if (!member.isShown || member.isDrawn || !member.patch.meets(part))
				continue;
			members.set(k, member.drawn(member.values.length > 0 ? member.values : own(member)));
			draw(members.get(k));
		}
	}

	private double[] own(final Member member) {
		final Chain chain = member.chain;
		final Patch patch = member.patch;
		final double[] values = new double[patch.width() * patch.height()];
		final Chain here = chain.shifted(-patch.left(), -patch.top());
		final double[] x = new double[chain.links() + 1], y = new double[chain.links() + 1];
		here.nodes(x, y);
		final NormalizedFrame dark = new NormalizedFrame(patch.width(), patch.height(), values);
		ImageTerm.of(dark, line, chain.links(), new double[0]).draw(x, y, chain.links(),
			Patch.of(dark), values);
		for (int i = 0; i < values.length; i++)
			values[i] = Math.rint(values[i] / GRAIN) * GRAIN;
		return values;
	}

	private void draw(final Member member) {
		final boolean additive = isAdditive();
		for (int row = 0, i = 0; row < member.patch.height(); row++) {
			int at = (member.patch.top() + row) * light.width() + member.patch.left();
			for (int c = 0; c < member.patch.width(); c++, i++, at++)
				picture[at] = additive
					? picture[at] + member.values[i]
					: Math.max(picture[at], member.values[i]);
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
		final Member a = members.get(k), b = members.get(other);
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
		drawIn(new Patch(x - 1, y - 1, 3, 3));
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
		final double[] all = picture();
		final boolean[] drawn = new boolean[all.length];
		for (int i = 0; i < drawn.length; i++)
			drawn[i] = all[i] > brightness;
		return drawn;
	}

	/** @return what the chains leave of the frame: light less picture */
	public NormalizedFrame residual() {
		final double[] left = light.pixels().clone(), drawn = picture();
		for (int i = 0; i < left.length; i++)
			left[i] -= drawn[i];
		return new NormalizedFrame(light.width(), light.height(), left);
	}

	/** @return what is drawn now, in strands, row by row; not to be changed */
	public double[] picture() {
		drawIn(Patch.of(light));
		return picture;
	}

	/** What is drawn now in a part of the frame, row by row. */
	double[] picture(final Patch part) {
		drawIn(part);
		return part.cut(picture, light.width());
	}
}
