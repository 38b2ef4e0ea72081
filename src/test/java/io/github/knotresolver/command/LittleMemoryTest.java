package io.github.knotresolver.command;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import ij.IJ;
import ij.ImagePlus;
import ij.io.FileSaver;
import ij.process.ImageProcessor;

/**
 * With too little memory ImageJ opens the first frames of a movie and says nothing. Here a movie
 * may be larger than memory: it stays in its file.
 */
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
		assertEquals("30 MB: frames: " + FRAMES, said.get(0));
		assertEquals("300 MB: frames: " + FRAMES, said.get(3));
	}

	@Test
	void movieLargerThanMemoryGivesTheSameBytes() throws Exception {
		final Path file = home.resolve("large.tif");
		final int frames = 420, size = 256;
		final long bytes = Movies.write(file, size, frames);
		assertTrue(bytes > 50 << 20);
		final String few = IntStream.iterate(1, t -> t <= frames, t -> t + 30)
			.mapToObj(Integer::toString).collect(Collectors.joining(","));
		final List<byte[]> contours = new ArrayList<>();
		for (final String[] run : new String[][]{{"48", "1"}, {"512", "2"}}) {
			final Path out = home.resolve("out" + run[0]);
			final String log = new Programs(home).java(
				List.of("-Djava.awt.headless=true", "-Xmx" + run[0] + "m"),
				"io.github.knotresolver.cli.KnotResolverMain", "resolve", file.toString(), "--out",
				out.toString(), "--frames", few, "--no-plots", "--threads", run[1]);
			assertTrue(Files.exists(out.resolve("contours.csv")), log);
			contours.add(Files.readAllBytes(out.resolve("contours.csv")));
		}
		assertTrue(contours.get(0).length > 10_000);
		assertArrayEquals(contours.get(0), contours.get(1));
	}

	@Test
	void frameThatDoesNotFitIsToldBeforeTheWork() throws Exception {
		final Path file = home.resolve("wide.tif");
		Movies.write(file, 2000, 2);
		final String log = new Programs(home).java(List.of("-Djava.awt.headless=true", "-Xmx80m"),
			"io.github.knotresolver.cli.KnotResolverMain", "resolve", file.toString(), "--out",
			home.resolve("none").toString(), "--threads", "1");
		assertTrue(log.contains(
			"There is not enough memory for frames of 2000 x 2000 pixels: they need 367 MB, and Java has "),
			log);
		assertTrue(Files.notExists(home.resolve("none").resolve("contours.csv")));
	}

	/** Movies of an arc that bends, written frame by frame. */
	private static final class Movies {

		/** Returns the size of the file. */
		static long write(final Path file, final int size, final int frames) throws Exception {
			final ImagePlus image = IJ.createHyperStack("movie", size, size, 1, 1, frames, 16);
			final Random random = new Random(5);
			for (int t = 0; t < frames; t++)
				draw(image.getStack().getProcessor(t + 1), 0.6 * t / frames, random);
			assertTrue(new FileSaver(image).saveAsTiff(file.toString()));
			return Files.size(file);
		}

		private static void draw(final ImageProcessor ip, final double bend, final Random random) {
			for (int i = 0; i < ip.getPixelCount(); i++)
				ip.set(i, 100 + random.nextInt(12));
			double x = 60, y = 120;
			for (int i = 0; i < 480; i++) {
				x += 0.25 * Math.cos(bend * i / 240);
				y += 0.25 * Math.sin(bend * i / 240);
				light(ip, x, y);
			}
		}

		private static void light(final ImageProcessor ip, final double x, final double y) {
			for (int v = (int) y - 4; v <= y + 5; v++)
				for (int u = (int) x - 4; u <= x + 5; u++) {
					final double d2 = (u - x) * (u - x) + (v - y) * (v - y);
					ip.set(u, v, ip.get(u, v) + (int) Math.rint(40 * Math.exp(-d2 / 4.5)));
				}
		}
	}
}
