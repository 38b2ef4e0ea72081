package io.github.knotresolver.mask;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

import net.imglib2.img.Img;
import net.imglib2.type.logic.BitType;

import org.junit.jupiter.api.Test;

import ij.IJ;
import ij.ImagePlus;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.image.FrameCleaner;
import io.github.knotresolver.image.Pixels;
import io.github.knotresolver.mask.ConnectedComponents.MaskObject;
import io.github.knotresolver.model.Cleaning;
import io.github.knotresolver.model.Segmentation;
import io.github.knotresolver.skeleton.Skeletonize;

/** What was seen in the pictures, kept as figures. */
class RealMoviesTest {

	private static final Path DATA = Path.of("..", "shared", "data", "real");

	@Test
	void knottedNoisyMovieKeepsItsLoopAndItsDimEnd() {
		final List<Img<BitType>> masks = filament("branchDemo.tif", new Point(66, 43),
			new LocalThreshold());
		for (int t = 0; t < masks.size(); t++) {
			final MaskObject object = ConnectedComponents.of(masks.get(t)).objects().get(0);
			assertTrue(object.maxX() >= 63, "dim end lost in frame " + (t + 1) + ": " + object);
			assertTrue(object.pixels() < 330, "glow in frame " + (t + 1));
		}
		assertTrue(
			masks.stream().mapToInt(mask -> ConnectedComponents.of(mask).objects().get(0).maxX())
				.average().orElseThrow() > 67.5,
			"dim end short on average");
		for (int t = 0; t < 7; t++)
			assertEquals(1, holes(masks.get(t)), "loop of frame " + (t + 1));
	}

	@Test
	void brightMovieIsFollowedThroughKnotsAndOverlap() {
		for (final Thresholder thresholder : List.of(new OtsuThreshold(), new LocalThreshold())) {
			final List<Img<BitType>> masks = filament("dyn1.tif", new Point(47, 90), thresholder);
			for (int t = 0; t < masks.size(); t++) {
				final Img<BitType> line = Skeletonize.thin(masks.get(t));
				final int length = ConnectedComponents.of(line).objects().get(0).pixels();
				assertTrue(length > 100 && length < 200,
					"frame " + (t + 1) + " skeleton of " + length + " pixels");
			}
		}
	}

	private static List<Img<BitType>> filament(final String name, final Point point,
		final Thresholder thresholder) {
		final Path file = DATA.resolve(name);
		assumeTrue(Files.exists(file), "Not here: " + file);
		final ImagePlus movie = IJ.openImage(file.toString());
		final FilamentSegmenter segmenter = new FilamentSegmenter(Segmentation.DEFAULT,
			thresholder);
		final FrameCleaner cleaner = new FrameCleaner(Cleaning.DEFAULT);
		final List<Img<BitType>> all = new ArrayList<>();
		for (int t = 1; t <= movie.getStackSize(); t++) {
			final float[] pixels = (float[]) movie.getStack().getProcessor(t)
				.convertToFloatProcessor().getPixels();
			all.add(segmenter.segment(cleaner.clean(Pixels.image(pixels, movie.getWidth()))));
		}
		final List<Optional<Img<BitType>>> found = ObjectFollower.followClamped(all, point, 6);
		assertEquals(0, found.stream().filter(Optional::isEmpty).count(), "lost frames");
		return found.stream().map(Optional::orElseThrow).toList();
	}

	private static int holes(final Img<BitType> mask) {
		final boolean[] background = Pixels.bits(mask);
		for (int i = 0; i < background.length; i++)
			background[i] = !background[i];
		return (int) ConnectedComponents.label(background, Pixels.width(mask), false).objects()
			.stream().filter(part -> !part.touchesBorder()).count();
	}
}
