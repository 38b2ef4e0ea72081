package io.github.knotresolver.mask;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.function.DoubleBinaryOperator;

import net.imglib2.img.Img;
import net.imglib2.type.logic.BitType;
import net.imglib2.type.numeric.real.FloatType;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import io.github.knotresolver.CancelledProgress;
import io.github.knotresolver.image.FrameCleaner;
import io.github.knotresolver.image.Pixels;
import io.github.knotresolver.mask.ConnectedComponents.MaskObject;
import io.github.knotresolver.model.Cleaning;
import io.github.knotresolver.model.Polarity;
import io.github.knotresolver.model.Segmentation;
import io.github.knotresolver.model.Segmentation.Steps;
import io.github.knotresolver.progress.CancelledException;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.skeleton.SkeletonNodes;
import io.github.knotresolver.skeleton.Skeletonize;

/** Pictures of known shape, with blur and noise, become the right masks. */
class FilamentSegmenterTest {

	private static final int WIDTH = 90;
	private static final int HEIGHT = 70;

	private final FilamentSegmenter published = new FilamentSegmenter(Segmentation.DEFAULT);
	private final FilamentSegmenter ours = new FilamentSegmenter(Segmentation.DEFAULT,
		new LocalThreshold());

	@Test
	void straightFilamentIsOneObjectOfItsLength() {
		for (final FilamentSegmenter segmenter : List.of(published, ours)) {
			final Picture picture = new Picture();
			picture.line(20, 35, 70, 35, 1);
			final List<MaskObject> objects = objects(segmenter, picture);
			assertEquals(1, objects.size());
			assertEquals(51, objects.get(0).maxX() - objects.get(0).minX() + 1, 4);
		}
	}

	@Test
	void dimEndIsKeptByOurThreshold() {
		final Picture picture = new Picture();
		picture.line(10, 35, 60, 35, 1);
		picture.line(60, 35, 80, 35, 0.45);
		assertTrue(objects(ours, picture).get(0).maxX() >= 77);
		assertTrue(objects(published, picture).get(0).maxX() < 77, "the case is too easy");
	}

	@Test
	void glowInALoopIsNotFilamentToOurThreshold() {
		final Picture picture = new Picture();
		picture.ring(45, 35, 7, 1);
		picture.disc(45, 35, 9, 0.45);
		assertEquals(1, holes(ours.segment(picture.clean(1))));
		assertEquals(0, holes(published.segment(picture.clean(1))), "the case is too easy");
	}

	@Test
	void tipOnTheFilamentClosesALoop() {
		final Picture picture = new Picture();
		picture.line(10, 50, 80, 50, 1);
		picture.line(80, 50, 80, 20, 1);
		picture.line(80, 20, 40, 20, 1);
		picture.line(40, 20, 40, 50, 1);
		final Img<BitType> mask = ours.segment(picture.clean(2));
		assertEquals(1, ConnectedComponents.of(mask).objects().size());
		assertEquals(1, holes(mask));
		assertEquals(1, ends(mask));
	}

	@Test
	void debrisMakesNoLoopAndNoSecondObject() {
		final Picture picture = new Picture();
		picture.line(10, 35, 80, 35, 1);
		picture.disc(45, 31, 4, 1);
		final Img<BitType> mask = ours.segment(picture.clean(3));
		assertEquals(1, ConnectedComponents.of(mask).objects().size());
		assertEquals(0, holes(mask));
	}

	@Test
	void brightCrossingDoesNotHideSingleStrands() {
		final Picture picture = new Picture();
		picture.line(10, 35, 80, 35, 0.5);
		picture.line(45, 10, 45, 60, 0.5);
		picture.disc(45, 35, 3, 1);
		for (final FilamentSegmenter segmenter : List.of(published, ours)) {
			final Img<BitType> mask = segmenter.segment(picture.clean(4));
			assertEquals(1, ConnectedComponents.of(mask).objects().size());
			final MaskObject object = ConnectedComponents.of(mask).objects().get(0);
			assertTrue(object.minX() <= 12 && object.maxX() >= 78, "" + object);
			assertTrue(object.minY() <= 12 && object.maxY() >= 58, "" + object);
		}
	}

	@Test
	void filamentMayLeaveTheFrame() {
		final Picture picture = new Picture();
		picture.line(0, 35, 60, 35, 1);
		final MaskObject object = objects(ours, picture).get(0);
		assertTrue(object.touchesBorder());
		assertEquals(60, object.maxX(), 3);
	}

	@Test
	void givenThresholdIsUsedAsItIs() {
		final Img<FloatType> frame = Pixels.image(new float[]{0.3f, 0.5f, 0.7f, 0.5f}, 2);
		final FilamentSegmenter only = new FilamentSegmenter(
			new Segmentation(Steps.BOTH, Polarity.AUTO, OptionalDouble.of(0.6), 0, 0, 0),
			new LocalThreshold());
		assertEquals(0, ConnectedComponents.of(only.segment(frame)).objects().size(), "a speck");
		assertArrayEquals(new boolean[]{false, false, true, false},
			Pixels.bits(FixedThreshold.above(frame, 0.6)));
		assertThrows(IllegalArgumentException.class, () -> new FixedThreshold(1.5));
	}

	@ParameterizedTest
	@CsvSource({"BOTH,0", "THRESHOLD,10"})
	void withoutContourTheThresholdsMaskStays(final Steps steps, final int iterations) {
		final Picture picture = new Picture();
		picture.line(20, 35, 70, 35, 1);
		final Img<FloatType> frame = picture.clean(5);
		final Segmentation none = new Segmentation(steps, Polarity.AUTO, OptionalDouble.empty(),
			iterations, 0.4, 0.2);
		assertArrayEquals(
			Pixels.bits(MaskRepair.fillPinHoles(
				MaskRepair.removeSpecks(FixedThreshold.above(frame, OtsuThreshold.of(frame)),
					FilamentSegmenter.SPECK),
				FilamentSegmenter.PIN_HOLE)),
			Pixels.bits(new FilamentSegmenter(none).segment(frame)));
	}

	@Test
	void constantFramesHaveNoObjects() {
		final Img<FloatType> frame = Pixels.image(new float[600], 30);
		assertTrue(ConnectedComponents.of(published.segment(frame)).objects().isEmpty());
		assertTrue(ConnectedComponents.of(ours.segment(frame)).objects().isEmpty());
	}

	@Test
	void contourAloneFollowsSlowMotionAndLosesFast() {
		final List<Img<FloatType>> slow = List.of(lineAt(20), lineAt(21), lineAt(22));
		final List<Img<BitType>> masks = published.segmentByContourAlone(slow, Progress.NONE);
		final MaskObject last = ConnectedComponents.of(masks.get(2)).objects().get(0);
		assertEquals(22, (last.minY() + last.maxY()) / 2.0, 0.6);
		final List<Img<FloatType>> fast = List.of(lineAt(20), lineAt(50));
		final Img<BitType> lost = published.segmentByContourAlone(fast, Progress.NONE).get(1);
		final boolean[] truth = Pixels.bits(published.segment(lineAt(50)));
		final boolean[] contour = Pixels.bits(lost);
		for (int i = 0; i < truth.length; i++)
			assertTrue(!(truth[i] && contour[i]), "found the line although it jumped");
	}

	@Test
	void cancellingStopsTheContours() {
		final Progress cancelled = new CancelledProgress();
		assertThrows(CancelledException.class,
			() -> published.segmentByContourAlone(List.of(lineAt(20)), cancelled));
	}

	private static Img<FloatType> lineAt(final int y) {
		final Picture picture = new Picture();
		picture.line(20, y, 70, y, 1);
		return picture.clean(y);
	}

	private static List<MaskObject> objects(final FilamentSegmenter segmenter,
		final Picture picture) {
		return ConnectedComponents.of(segmenter.segment(picture.clean(1))).objects();
	}

	private static int ends(final Img<BitType> mask) {
		final boolean[] ends = Pixels.bits(SkeletonNodes.ends(Skeletonize.thin(mask)));
		int count = 0;
		for (final boolean end : ends)
			if (end)
				count++;
		return count;
	}

	private static int holes(final Img<BitType> mask) {
		final boolean[] background = Pixels.bits(mask);
		for (int i = 0; i < background.length; i++)
			background[i] = !background[i];
		return (int) ConnectedComponents.of(Pixels.mask(background, WIDTH)).objects().stream()
			.filter(part -> !part.touchesBorder()).count();
	}

	/** A frame drawn with a soft pen 5 px wide; where it is drawn twice, the brighter counts. */
	private static final class Picture {

		private final float[] values = new float[WIDTH * HEIGHT];

		void line(final double x0, final double y0, final double x1, final double y1,
			final double peak) {
			final double dx = x1 - x0, dy = y1 - y0;
			draw(peak, (x, y) -> {
				final double t = Math.max(0,
					Math.min(1, ((x - x0) * dx + (y - y0) * dy) / (dx * dx + dy * dy)));
				return Math.hypot(x - x0 - t * dx, y - y0 - t * dy);
			});
		}

		void ring(final double x0, final double y0, final double radius, final double peak) {
			draw(peak, (x, y) -> Math.hypot(x - x0, y - y0) - radius);
		}

		void disc(final double x0, final double y0, final double radius, final double peak) {
			draw(peak, (x, y) -> Math.max(0, Math.hypot(x - x0, y - y0) - radius));
		}

		private void draw(final double peak, final DoubleBinaryOperator distance) {
			for (int i = 0; i < values.length; i++) {
				final double d = distance.applyAsDouble(i % WIDTH, i / WIDTH);
				values[i] = Math.max(values[i], (float) (peak * Math.exp(-d * d / 8)));
			}
		}

		Img<FloatType> clean(final int seed) {
			final Random random = new Random(seed);
			final float[] noisy = values.clone();
			for (int i = 0; i < noisy.length; i++)
				noisy[i] += 0.05f * (float) random.nextGaussian();
			return new FrameCleaner(Cleaning.DEFAULT).clean(Pixels.image(noisy, WIDTH));
		}
	}
}
