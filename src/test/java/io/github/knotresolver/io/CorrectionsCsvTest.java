package io.github.knotresolver.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.Constraint;
import io.github.knotresolver.model.Constraint.Kind;
import io.github.knotresolver.model.UserException;

class CorrectionsCsvTest {

	@TempDir
	Path home;

	@Test
	void everyKindIsReadBack() throws IOException {
		final List<Constraint> all = List.of(new Constraint(2, 7, Kind.THROUGH, line(5, 6, 7, 8)),
			new Constraint(1, 3, Kind.CONTOUR, line(1, 2, 3.5, 4, 9, 9)),
			new Constraint(1, 3, Kind.NOT, line(1, 2, 8, 2)),
			new Constraint(1, 3, Kind.NOT, line(1, 2, 8, 3, 9, 5)),
			new Constraint(1, 4, Kind.TIP, line(12.25, 3.125)));
		final Path file = home.resolve("c.csv");
		CorrectionsCsv.write(file, all);
		assertEquals(Constraint.sorted(all), CorrectionsCsv.read(file));
		assertEquals("filament,frame,kind,index,x_px,y_px\n1,3,contour,0,1.000,2.000",
			Files.readString(file).substring(0, 61));
	}

	@Test
	void aFileOfFourColumnsHoldsContoursOfTheFirstFilament() throws IOException {
		final Path file = Files.writeString(home.resolve("c.csv"),
			"frame,index,x_px,y_px\n2,1,3,4\n2,0,1,2\n");
		assertEquals(List.of(new Constraint(1, 2, Kind.CONTOUR, line(1, 2, 3, 4))),
			CorrectionsCsv.read(file));
	}

	@ParameterizedTest
	@CsvSource(delimiter = '|', value = {"frame,x,y;1,2,3|columns frame,index,x_px,y_px",
		"frame,index,x_px,y_px;1,0,2|line 2, has 3 columns",
		"frame,index,x_px,y_px;1,0,2,b|line 2: y_px must be a number",
		"frame,index,x_px,y_px;0,0,2,3|line 2: frame must be a whole number from 1",
		"frame,index,x_px,y_px;1,0,2,3;1,0,4,5|line 3: frame 1 has two points with index 0",
		"frame,index,x_px,y_px;1,0,2,3|correction of frame 1 needs at least two points",
		"frame,kind,index,x_px,y_px;1,near,0,2,3|line 2: kind must be contour or through or tip or not",
		"frame,kind,index,x_px,y_px;1,tip,0,2,3;1,tip,1,4,5|tip in frame 1 must be one point",
		"filament,frame,index,x_px,y_px;0,1,0,2,3|line 2: filament must be a whole number from 1"})
	void whatIsWrongIsRefusedWithItsLine(final String text, final String sentence)
		throws IOException {
		final Path file = Files.writeString(home.resolve("c.csv"), text.replace(';', '\n'));
		final String message = assertThrows(UserException.class, () -> CorrectionsCsv.read(file))
			.getMessage();
		assertTrue(message.contains(sentence), message);
	}

	private static Polyline line(final double... xy) {
		final double[] x = new double[xy.length / 2], y = new double[xy.length / 2];
		for (int i = 0; i < x.length; i++) {
			x[i] = xy[2 * i];
			y[i] = xy[2 * i + 1];
		}
		return Polyline.of(x, y);
	}
}
