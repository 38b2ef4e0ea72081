package io.github.knotresolver.fit;

import java.util.ArrayList;
import java.util.List;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;

/**
 * The light beyond an end of a chain and before it. A piece of line, a few widths long, is
 * laid straight on at the end, or bent to either side, and compared with what the chain
 * leaves unexplained there: least squares give the piece's brightness and how sure it is. A
 * piece that is bright belongs to the filament, and a last piece that is dark does not.
 *
 * @param frame the frame, a strand's brightness 1
 * @param model what a line looks like
 * @param noise standard deviation of a pixel's noise in strands' brightnesses, above 0
 */
public record EndLight(NormalizedFrame frame, LineModel model, double noise) {

	/** Headings that are tried, relative to the end's, in radians. */
	private static final double[] TURNS = {0, 0.3, -0.3, 0.6, -0.6, 0.9, -0.9};

	public EndLight {
		noise = Math.max(FitTuning.END_NOISE, noise);
	}

	/**
	 * The light of a piece.
	 *
	 * @param brightness relative to the end's; 0 where there is no filament
	 * @param sureness brightness in its standard errors; 0 where nothing can be seen
	 * @param angle heading of the piece in radians
	 */
	public record Piece(double brightness, double sureness, double angle) {

		/** @return whether the filament goes on here */
		public boolean isThere() {
			return sureness > FitTuning.PIECE_SURE && brightness > FitTuning.PIECE_BRIGHT;
		}

		/** @return whether there is anything to see here: the piece is in the frame, not hidden */
		public boolean isSeen() {
			return sureness != 0 || brightness != 0;
		}
	}

	/** @return length of a piece in pixels */
	public double piece() {
		return Math.max(3, FitTuning.PIECE * model.in(frame).sigma());
	}

	/**
	 * @param chain a chain
	 * @return the surest piece beyond its tip
	 */
	public Piece beyondTip(final Chain chain) {
		final Point tip = chain.tip();
		final double heading = chain.angle(Math.max(0, chain.links() - FitTuning.END_LINKS));
		Piece best = new Piece(0, 0, heading);
		final Window window = new Window(tip, chain);
		for (final double turn : TURNS) {
			final Piece piece = window.piece(tip, heading + turn);
			if (piece.sureness * Math.cos(turn / 2) > best.sureness)
				best = piece;
		}
		return best;
	}

	/**
	 * @param chain a chain
	 * @return the last piece of the chain as it is, its brightness relative to what is
	 *         expected; sureness 0 if it cannot be seen
	 */
	public Piece beforeTip(final Chain chain) {
		final double length = chain.length(), piece = Math.min(piece(), length / 4);
		final Chain shorter = chain.resized(length - piece);
		final Window window = new Window(shorter.tip(), shorter);
		return window.piece(shorter.tip(),
			chain.angle(Math.max(0, chain.links() - FitTuning.END_LINKS)));
	}

	/**
	 * @param chain a chain
	 * @return brightness of the brighter of the pieces beyond both ends, relative to the
	 *         ends' own; 0 if neither is sure
	 */
	public double beyond(final Chain chain) {
		final Piece tip = beyondTip(chain);
		final Piece start = new EndLight(frame, model.reversed(), noise)
			.beyondTip(chain.reversed());
		return Math.max(tip.sureness > FitTuning.PIECE_SURE ? tip.brightness : 0,
			start.sureness > FitTuning.PIECE_SURE ? start.brightness : 0);
	}

	/**
	 * A chain whose ends are both ends of light.
	 *
	 * @param chain a chain near the filament, whose ends may be too early or too late
	 * @return the chain, grown where the light goes on and cut where there is none
	 */
	public Chain settled(final Chain chain) {
		final EndLight back = new EndLight(frame, model.reversed(), noise);
		return back.settledTip(settledTip(chain).reversed()).reversed();
	}

	private Chain settledTip(final Chain chain) {
		Chain grown = chain;
		for (int i = 0; i < FitTuning.MOST_PIECES; i++) {
			final Piece piece = beyondTip(grown);
			if (!piece.isThere())
				break;
			grown = longer(grown, piece.angle, piece());
		}
		if (grown == chain)
			for (int i = 0; i < FitTuning.MOST_PIECES && grown.length() > 4 * piece(); i++) {
				final Piece last = beforeTip(grown);
				if (!last.isSeen() || last.brightness > FitTuning.PIECE_DARK)
					break;
				grown = grown.resized(grown.length() - piece());
			}
		return grown;
	}

	/**
	 * A chain with the light beyond its tip, in which that is as bright as its end.
	 *
	 * @param chain a chain
	 * @param beyond the piece beyond its tip
	 * @return the chain, longer by at most a piece
	 */
	Chain grown(final Chain chain, final Piece beyond) {
		return longer(chain, beyond.angle, Math.max(0, Math.min(1, beyond.brightness)) * piece());
	}

	private static Chain longer(final Chain chain, final double angle, final double by) {
		final Polyline nodes = chain.polyline();
		final List<Point> points = new ArrayList<>();
		for (int i = 0; i < nodes.size(); i++)
			points.add(nodes.point(i));
		final Point tip = nodes.last();
		points.add(new Point(tip.x() + by * Math.cos(angle), tip.y() + by * Math.sin(angle)));
		return Chain.along(Polyline.of(points), chain.links(), chain.length() + by);
	}

	/** The pixels around an end. */
	private final class Window {

		private final int left;
		private final int top;
		private final NormalizedFrame part;
		private final double[] drawn;
		private final double expected;

		Window(final Point end, final Chain chain) {
			final int reach = (int) Math.ceil(EndLight.this.piece() + model.in(frame).reach() + 1);
			left = inside(end.x() - reach, frame.width());
			top = inside(end.y() - reach, frame.height());
			final int right = inside(end.x() + reach, frame.width());
			final int bottom = inside(end.y() + reach, frame.height());
			part = frame.window(left, top, right - left + 1, bottom - top + 1);
			drawn = ChainPixels.draw(part, model, chain.shifted(-left, -top));
			final double[] brightness = model.brightnessOfLinks(chain.links());
			expected = brightness[brightness.length - 1];
		}

		private int inside(final double at, final int size) {
			return (int) Math.max(0, Math.min(size - 1, Math.rint(at)));
		}

		/** The light of a straight piece that begins at a place. */
		Piece piece(final Point from, final double angle) {
			final double length = EndLight.this.piece();
			final Polyline line = Polyline.of(List.of(new Point(from.x() - left, from.y() - top),
				new Point(from.x() - left + length * Math.cos(angle),
					from.y() - top + length * Math.sin(angle))));
			final double[] picture = ChainPixels.draw(part,
				LineModel.uniform(model.kind(), model.sigma(), model.power()),
				Chain.along(line, 2, length));
			final double[] pixels = part.pixels();
			final boolean additive = model.kind() == LineModel.Kind.ADDITIVE;
			double n = 0, own = 0, squares = 0, left = 0, product = 0;
			for (int i = 0; i < picture.length; i++) {
				final double o = additive ? picture[i] : Math.max(0, picture[i] - drawn[i]);
				// A pixel that was cut off below what is expected does not say how bright it is.
				if (picture[i] == 0 || additive && part.hides(i, drawn[i] + o * expected))
					continue;
				final double rest = pixels[i] - drawn[i];
				n++;
				own += o;
				squares += o * o;
				left += rest;
				product += o * rest;
			}
			if (squares < FitTuning.PIECE_SEEN * length * model.in(frame).sigma())
				return new Piece(0, 0, angle);
			// A piece is brighter than what is beside it; haze is not.
			final double light = product - own * left / n, norm = squares - own * own / n;
			return new Piece(light / norm / expected, light / (noise * Math.sqrt(norm)), angle);
		}
	}
}
