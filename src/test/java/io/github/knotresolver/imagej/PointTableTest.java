package io.github.knotresolver.imagej;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;

import org.junit.jupiter.api.Test;

import ij.measure.ResultsTable;

class PointTableTest {

	private static final double[] SPECIAL = {0, -0.0, 1, -1, 0.5, 1.5, 2.5, -0.5, 0.0005, 0.0015,
		-0.0005, 0.0625, -1e-9, 123456.7895, 1e9, -1e12, 1e300, Double.NaN,
		Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY, Double.MIN_VALUE};

	@Test
	void linesAreImageJsOwnToTheLastDigit() {
		final long seed = 7;
		final Random random = new Random(seed);
		final double[] values = new double[5000];
		for (int i = 0; i < values.length; i++)
			values[i] = i < SPECIAL.length
				? SPECIAL[i]
				: random.nextGaussian() * Math.pow(10, random.nextInt(9) - 4);
		final PointTable table = new PointTable(IntStream.range(0, 10)
			.mapToObj(d -> new PointTable.Column("d" + d, d, values)).toList());
		final ResultsTable oracle = table.table();
		final List<String> lines = table.lines();
		assertEquals(values.length, lines.size());
		for (int row = 0; row < values.length; row++)
			assertEquals(oracle.getRowAsString(row), lines.get(row),
				"row " + row + " of seed " + seed);
	}

	@Test
	void aTableWithoutRowsIsEmpty() {
		final PointTable table = new PointTable(
			List.of(new PointTable.Column("frame", 0, new double[0])));
		assertEquals(0, table.table().size());
		assertEquals(List.of(), table.lines());
	}
}
