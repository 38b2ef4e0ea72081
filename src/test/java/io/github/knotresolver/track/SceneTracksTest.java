package io.github.knotresolver.track;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Random;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.LineModel;
import io.github.knotresolver.fit.LineTables;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.Settings.AnchorChoice;
import io.github.knotresolver.track.SceneSettler.Settled;

class SceneTracksTest {

	private static final int FRAMES = 4;

	private static Chain line(final double x, final double y, final double length) {
		return Chain.inScene(Polyline.of(List.of(new Point(x, y), new Point(x + length, y))),
			length);
	}

	private static Settled still(final Chain chain) {
		final double[] gap = new double[FRAMES];
		Arrays.fill(gap, 50);
		return new Settled(Collections.nCopies(FRAMES, chain), gap, 0.1);
	}

	/** A piece that goes on from the filament, one that is apart, and one that is a filament. */
	@ParameterizedTest
	@CsvSource({"62, 15, 1, true", "80, 15, 1, false", "62, 30, 2, false"})
	void aFilamentIsInPiecesIfOneThatIsTooShortStaysBesideIt(final double x, final double length,
		final int filaments, final boolean inPieces) {
		final LineTables tables = LineTables
			.together(LineModel.uniform(LineModel.Kind.ADDITIVE, 1.4, 1));
		final List<Chain> chains = List.of(line(10, 30, 50), line(x, 30, length));
		final List<FrameView> frames = new ArrayList<>();
		final Random random = new Random(5);
		for (int t = 0; t < FRAMES; t++)
			frames
				.add(DrawnFrames.lit(t + 1, DrawnFrames.light(110, tables, chains), 0.05, random));
		final boolean[][] clear = new boolean[2][FRAMES];
		for (final boolean[] c : clear)
			Arrays.fill(c, true);
		final SceneTracks tracks = SceneTracks.of(new SceneLine(tables, frames, 0.05),
			chains.stream().map(SceneTracksTest::still).toList(), clear, AnchorChoice.AUTO);
		assertEquals(filaments, tracks.filaments().size());
		assertEquals(inPieces, tracks.inPieces());
	}
}
