package io.github.knotresolver.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import ij.IJ;
import ij.ImagePlus;
import ij.io.FileSaver;

/** With too little memory ImageJ opens the first frames of a movie and says nothing. */
class LittleMemoryTest {

	private static final int FRAMES = 160, SIZE = 512;

	@TempDir
	Path home;

	@Test
	void allFramesOrNone() throws Exception {
		final Path file = home.resolve("movie.tif");
		final ImagePlus image = IJ.createHyperStack("movie", SIZE, SIZE, 1, 1, FRAMES, 8);
		new Random(1).nextBytes((byte[]) image.getStack().getPixels(7));
		assertTrue(new FileSaver(image).saveAsTiff(file.toString()));
		assertTrue(Files.size(file) > FRAMES * SIZE * SIZE);
		final List<String> said = new ArrayList<>();
		for (final int megabytes : new int[]{30, 44, 46, 300}) {
			final String log = new Programs(home).java(
				List.of("-Djava.awt.headless=true", "-Xmx" + megabytes + "m"),
				"io.github.knotresolver.imagej.OpenMain", file.toString());
			final String last = log.strip().substring(log.strip().lastIndexOf('\n') + 1);
			said.add(megabytes + " MB: " + last);
			assertTrue(
				last.equals("frames: " + FRAMES)
					|| last.startsWith("refused: There is not enough memory for "),
				said.toString());
		}
		assertTrue(said.get(0).contains("refused"), said.toString());
		assertEquals("300 MB: frames: " + FRAMES, said.get(3));
	}
}
