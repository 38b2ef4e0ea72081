package io.github.knotresolver.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.awt.GraphicsEnvironment;
import java.io.PrintWriter;
import java.io.StringWriter;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.session.Engine;

class ReviewSubcommandTest {

	@Test
	void withoutADisplayTheWayWithoutOneIsNamed() {
		assumeTrue(GraphicsEnvironment.isHeadless(), "There is a display.");
		final StringWriter err = new StringWriter();
		assertEquals(ExitStatus.USAGE, KnotResolverMain.run(Engine.PIPELINE, Progress.NONE,
			new PrintWriter(new StringWriter()), new PrintWriter(err), "review", "absent"));
		assertTrue(err.toString().startsWith("review needs a display"), err.toString());
		assertTrue(err.toString().contains("--corrections FILE"), err.toString());
		assertEquals(1, err.toString().lines().count());
	}
}
