package io.github.knotresolver.session;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import java.util.List;
import java.util.Locale;
import java.util.Map;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.fit.DrawnMovie;
import io.github.knotresolver.fit.LineModel;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.model.Settings;
import io.github.knotresolver.options.RunOptions;
import io.github.knotresolver.progress.Progress;

/**
 * The published method stays as it was: the contours of a drawn movie, with the decimals that
 * {@code contours.csv} has, are the same to the byte.
 */
class PublishedContoursTest {

	private static final String CONTOURS = "131bd8a6ee1257c43fe9c1dfdf3dbc39065b54fa9df45640c03c2d333f7e4698";

	@Test
	void contoursAreTheSameToTheByte() throws NoSuchAlgorithmException {
		final DrawnMovie drawn = DrawnMovie.draw(DrawnMovie.waves(10, 70, 1.6), List.of(),
			LineModel.uniform(LineModel.Kind.ADDITIVE, 1.6, 1), 0.06, 5);
		final Settings settings = RunOptions.parse(Map.of("candidates", "paper", "resolver",
			"paper", "refine", "no", "fixed_end", "22,55", "threads", "1"))
			.parameters(drawn.movie());
		final StringBuilder text = new StringBuilder();
		for (final Observation frame : new Session(drawn.movie(), settings)
			.solve(List.of(), Progress.NONE).only().frames())
			frame.contour().ifPresent(contour -> append(text, frame.frame(), contour));
		assertEquals(CONTOURS, HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256")
			.digest(text.toString().getBytes(StandardCharsets.UTF_8))));
	}

	private static void append(final StringBuilder text, final int frame, final Polyline contour) {
		for (int i = 0; i < contour.size(); i++)
			text.append(String
				.format(Locale.ROOT, "%d,%d,%.3f,%.3f%n", frame, i, contour.x(i), contour.y(i))
				.replace("\r", ""));
	}
}
