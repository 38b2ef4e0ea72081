
package io.github.knotresolver.track;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.Set;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.LineModel;
import io.github.knotresolver.fit.LineModel.Kind;
import io.github.knotresolver.fit.LineTables;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.Settings.AnchorChoice;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;
import io.github.knotresolver.track.SceneTracks.Filament;

class SceneResolverTest {

	private static final int SIZE = 120, FRAMES = 15;
	private static final double NOISE = 0.05, STRAND = 80;
	private static final LineTables LINE = LineTables
		.together(LineModel.uniform(Kind.ADDITIVE, 1.4, 1));

	private static FrameView frame(final int t, final List<Chain> chains, final Random random) {
		return DrawnFrames.lit(t + 1, DrawnFrames.light(SIZE, LINE, chains), NOISE, random)
			.scaled(1 / STRAND);
	}

	private static SceneTracks resolve(final List<List<Chain>> chains) {
		final Random random = new Random(5);
		final List<FrameView> frames = new ArrayList<>();
		for (int t = 0; t < chains.size(); t++)
			frames.add(frame(t, chains.get(t), random));
		return new SceneResolver(frames, Set.of(Kind.ADDITIVE), Workers.HERE, Progress.NONE)
			.resolve(AnchorChoice.AUTO).orElseThrow();
	}

	/** A straight filament, from a place in a direction. */
	private static Chain rod(final double x, final double y, final double angle,
		final double length) {
		return Chain.inScene(Polyline.of(new double[]{x, x + length * Math.cos(angle)},
			new double[]{y, y + length * Math.sin(angle)}), length);
	}

	/** A bent filament whose first point stays. */
	private static Chain beating(final double phase) {
		final double[] x = new double[60], y = new double[60];
		x[0] = 25;
		y[0] = 100;
		for (int i = 1; i < x.length; i++) {
			final double angle = -0.6 + 0.7 * Math.sin(phase + i * 0.04);
			x[i] = x[i - 1] + Math.cos(angle);
			y[i] = y[i - 1] + Math.sin(angle);
		}
		return Chain.inScene(Polyline.of(x, y), 59);
	}

	private static double distance(final Polyline contour, final Chain truth) {
		return SceneSeed.oneWay(contour, truth.polyline());
	}

	@Test
	void filamentsThatCrossKeepTheirIdentitiesAndRunTheWayTheyGlide() {
		final List<List<Chain>> movie = new ArrayList<>();
		for (int t = 0; t < FRAMES; t++)
			movie.add(
				List.of(rod(10 + 2.5 * t, 60, 0, 55), rod(60 + 1.4 * t, 95 - 2 * t, -0.96, 40)));
		final SceneTracks tracks = resolve(movie);
		assertEquals(2, tracks.filaments().size());
		for (final Filament f : tracks.filaments()) {
			assertFalse(f.clamped());
			final int which = f.length() > 47 ? 0 : 1;
			assertEquals(which == 0 ? 55 : 40, f.length(), 1);
			for (int t = 0; t < FRAMES; t++) {
				final double off = distance(f.frames().get(t).contour().orElseThrow(),
					movie.get(t).get(which));
				assertTrue(off < 1, "filament " + which + ", frame " + (t + 1) + ": " + off);
				assertTrue(f.frames().get(t).confidence() > 0.5);
			}
		}
	}

	@Test
	void aClampedFilamentAndAGliderAreToldApart() {
		final List<List<Chain>> movie = new ArrayList<>();
		for (int t = 0; t < FRAMES; t++)
			movie.add(List.of(beating(0.5 * t), rod(100 - 2 * t, 20 + t, 2.68, 35)));
		final SceneTracks tracks = resolve(movie);
		assertEquals(2, tracks.filaments().size());
		for (final Filament f : tracks.filaments()) {
			assertEquals(f.length() > 47, f.clamped());
			for (int t = 0; t < FRAMES; t++)
				assertTrue(distance(f.frames().get(t).contour().orElseThrow(),
					movie.get(t).get(f.clamped() ? 0 : 1)) < 1, "frame " + (t + 1));
		}
	}

	@Test
	void oneFilamentIsOneAndLeftToWhatIsMadeForItWhereItMayBeClamped() {
		final Random random = new Random(5);
		final List<FrameView> frames = new ArrayList<>();
		for (int t = 0; t < FRAMES; t++)
			frames.add(frame(t, List.of(beating(0.5 * t)), random));
		final SceneResolver resolver = new SceneResolver(frames, Set.of(Kind.ADDITIVE),
			Workers.HERE, Progress.NONE);
		assertTrue(resolver.resolve(AnchorChoice.AUTO).isEmpty());
		final SceneTracks free = resolver.resolve(AnchorChoice.FREE).orElseThrow();
		assertEquals(1, free.filaments().size());
		assertEquals(59, free.filaments().get(0).length(), 1);
	}

	@Test
	void aFreeFilamentUnderAPointIsFollowedAsOneOfAllAndAHeldOneIsLeftToWhatIsMadeForIt() {
		final Random random = new Random(5);
		final List<FrameView> frames = new ArrayList<>();
		final List<Chain> gliders = new ArrayList<>();
		for (int t = 0; t < FRAMES; t++) {
			gliders.add(rod(100 - 2.6 * t, 20 + 1.3 * t, 2.68, 35));
			frames.add(frame(t, List.of(beating(0.5 * t), gliders.get(t)), random));
		}
		final SceneResolver resolver = new SceneResolver(frames, Set.of(Kind.ADDITIVE),
			Workers.HERE, Progress.NONE);
		final SceneTracks glider = resolver
			.freeUnder(gliders.get(0).polyline().point(4), AnchorChoice.AUTO).orElseThrow();
		assertEquals(1, glider.filaments().size());
		assertFalse(glider.filaments().get(0).clamped());
		for (int t = 0; t < FRAMES; t++)
			assertTrue(distance(glider.filaments().get(0).frames().get(t).contour().orElseThrow(),
				gliders.get(t)) < 1, "frame " + (t + 1));
		assertTrue(glider.notes().get(0).contains("held nowhere"), glider.notes().toString());
		assertTrue(resolver.freeUnder(new Point(25, 100), AnchorChoice.AUTO).isEmpty());
		assertTrue(resolver.freeUnder(new Point(5, 5), AnchorChoice.AUTO).isEmpty());
	}
}
