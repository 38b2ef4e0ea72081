package io.github.knotresolver.imagej.plot;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;

import org.jfree.chart.JFreeChart;
import org.jfree.chart.plot.XYPlot;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import ij.gui.Plot;
import ij.measure.ResultsTable;
import io.github.knotresolver.evaluate.Evaluation;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.progress.Progress;

class ScoreFiguresTest {

	@TempDir
	private Path folder;

	@BeforeAll
	static void needNoDisplay() {
		System.setProperty("java.awt.headless", "true");
	}

	/** Thirty frames of a rod, found up to 0.2 px of noise; frame 7 is missing, frame 20 is far off. */
	private static Evaluation evaluation() {
		final Random random = new Random(3);
		final SortedMap<Integer, Polyline> truth = new TreeMap<>(), found = new TreeMap<>();
		for (int frame = 1; frame <= 30; frame++) {
			final double[] x = new double[80], y = new double[80], ny = new double[80];
			for (int i = 0; i < 80; i++) {
				x[i] = i;
				ny[i] = 0.2 * random.nextGaussian() + (frame == 20 ? 25 : 0);
			}
			truth.put(frame, Polyline.of(x, y));
			if (frame != 7)
				found.put(frame, Polyline.of(x, ny));
		}
		return Evaluation.of(truth, found, Progress.NONE);
	}

	@Test
	void chartsShowEveryFrameAndTheFit() {
		final Evaluation e = evaluation();
		final var charts = ScoreFigures.charts(List.of(e.frames()), e.positionErrors());
		assertEquals(Set.of("position_error", "dice", "frechet"), charts.keySet());
		final XYPlot histogram = charts.get("position_error").getXYPlot();
		assertEquals(2, histogram.getDatasetCount(), "bars and the Gaussian");
		assertTrue(histogram.getDomainAxis().getUpperBound() <= 2, "far frames do not squash it");
		final JFreeChart frechet = charts.get("frechet");
		assertEquals(30, frechet.getXYPlot().getDataset().getItemCount(0));
		assertEquals(null, frechet.getXYPlot().getDataset().getY(0, 6), "a gap");
		assertTrue(frechet.getXYPlot().getRangeAxis().getUpperBound() > 25);
		assertEquals(0, charts.get("dice").getXYPlot().getDataset().getYValue(0, 6));
	}

	@Test
	void noContourAtAllLeavesOutTheHistogram() {
		final SortedMap<Integer, Polyline> truth = new TreeMap<>();
		truth.put(1, Polyline.of(new double[]{0, 9}, new double[]{0, 0}));
		final Evaluation e = Evaluation.of(truth, new TreeMap<>(), Progress.NONE);
		assertEquals(Set.of("dice", "frechet"),
			ScoreFigures.charts(List.of(e.frames()), e.positionErrors()).keySet());
	}

	@Test
	void filesAreTheSameInAnyLocale() throws IOException {
		final Evaluation e = evaluation();
		ScoreFigures.write(folder, "a-", List.of(e.frames()), e.positionErrors(), Progress.NONE);
		final Locale before = Locale.getDefault();
		Locale.setDefault(Locale.forLanguageTag("ar-EG-u-nu-arab"));
		try {
			ScoreFigures.write(folder, "b-", List.of(e.frames()), e.positionErrors(),
				Progress.NONE);
		} finally {
			Locale.setDefault(before);
		}
		for (final String name : List.of("position_error", "dice", "frechet")) {
			final String svg = Files.readString(folder.resolve("a-" + name + ".svg"));
			assertEquals(svg, Files.readString(folder.resolve("b-" + name + ".svg")), name);
			assertTrue(Files.size(folder.resolve("a-" + name + ".png")) > 1000);
		}
		assertTrue(
			Files.readString(folder.resolve("a-position_error.svg")).contains("% beyond) [px]"),
			"what is not shown is told");
	}

	@Test
	void ticksOfTheHistogramHaveRoom() {
		for (double most = 1; most < 400; most *= 1.3) {
			final double ticks = most / ScoreFigures.Range.tick(most);
			assertTrue(ticks >= 4 && ticks <= 12, most + " px: " + ticks);
		}
	}

	@Test
	void livePlotsAndTableHoldTheScores() {
		final Evaluation e = evaluation();
		final Plot errors = ScorePlots.positionErrors(e.positionErrors());
		assertEquals(2, errors.getPlotObjectDesignations().length, "bars and the Gaussian");
		final Plot frechet = ScorePlots.frechet(e.frames());
		assertEquals(30, frechet.getXValues().length);
		assertTrue(Float.isNaN(frechet.getYValues()[6]));
		assertEquals(30, ScorePlots.dice(e.frames()).getYValues().length);
		final ResultsTable table = ScorePlots.table(e.frames());
		assertEquals(30, table.size());
		assertEquals(e.frames().get(2).score().frechet(),
			table.getValue("Frechet distance [px]", 2), 1e-9);
		assertTrue(Double.isNaN(table.getValue("Frechet distance [px]", 6)));
		assertFalse(Double.isNaN(table.getValue("Dice", 6)));
	}
}
