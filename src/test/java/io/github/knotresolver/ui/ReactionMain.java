package io.github.knotresolver.ui;

import java.awt.EventQueue;
import java.awt.Graphics;
import java.awt.Toolkit;
import java.awt.event.InputEvent;
import java.awt.event.MouseEvent;
import java.lang.management.ManagementFactory;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;

import com.sun.management.OperatingSystemMXBean;

import ij.ImageJ;
import ij.ImagePlus;
import ij.ImageStack;
import ij.gui.ImageCanvas;
import ij.gui.Overlay;
import ij.process.FloatProcessor;
import io.github.knotresolver.fit.DrawnMovie;
import io.github.knotresolver.fit.LineModel;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.image.Pixels;
import io.github.knotresolver.imagej.ImageMovie;
import io.github.knotresolver.imagej.ImageView;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.Settings;
import io.github.knotresolver.model.Tracks;
import io.github.knotresolver.options.InputOptions;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.ui.model.ReviewModel;

/**
 * How fast windows answer: a contour that is dragged in a review is drawn again, a movie of 120 frames of
 * a knotted filament is solved again after one more word, and the preview of a frame of 512 x 512 pixels
 * follows a value and the slider. Started by {@code scripts/reaction-times}, which gives it a display.
 */
final class ReactionMain {

	private static final int FRAMES = 120, WARM = 40, DRAGS = 200, WORDS = 16, STRIDE = 37,
		LOOKS = 20, LARGE = 512;

	private ReactionMain() {
	}

	public static void main(final String[] args) throws Exception {
		new ImageJ();
		final ImagePlus image = image();
		ImageView.show(image);
		final Movie movie = ImageMovie.of(image, InputOptions.DEFAULT);
		final KeptSession session = new KeptSession(image);
		final Tracks tracks = session.resolve(movie, Settings.DEFAULT, Progress.NONE);
		final ReviewedResult result = ReviewedResult
			.of(new LiveResult(tracks, session, Map.of(), Optional.empty()), image);
		EventQueue.invokeAndWait(() -> ReviewWindow.open(result, image, () -> {
		}));
		drags(image, result.model());
		words(result.model());
		previews();
		System.exit(0);
	}

	private static ImagePlus image() {
		return image("drawn", FRAMES, DrawnMovie.SIZE);
	}

	/** A square image, tiled with the drawn movie. */
	private static ImagePlus image(final String title, final int frames, final int edge) {
		final Movie drawn = DrawnMovie.draw(DrawnMovie.waves(frames, 80, 3.6), List.of(),
			LineModel.uniform(LineModel.Kind.ADDITIVE, 1.6, 1), 0.05, 41).movie();
		final ImageStack stack = new ImageStack(edge, edge);
		for (int t = 0; t < frames; t++) {
			final double[] pixels = Pixels.doubles(drawn.frame(t));
			final FloatProcessor frame = new FloatProcessor(edge, edge);
			for (int y = 0; y < edge; y++)
				for (int x = 0; x < edge; x++)
					frame.setf(x, y, (float) pixels[y % DrawnMovie.SIZE * DrawnMovie.SIZE
						+ x % DrawnMovie.SIZE]);
			stack.addSlice(frame);
		}
		final ImagePlus image = new ImagePlus(title, stack);
		image.setDimensions(1, 1, frames);
		image.setDisplayRange(0, 300);
		return image;
	}

	/** From the mouse's event until the image is painted, in the thread of events. */
	private static void drags(final ImagePlus image, final ReviewModel model) throws Exception {
		final ImageCanvas canvas = image.getCanvas();
		final Polyline contour = model.shown().orElseThrow().contour().orElseThrow();
		final Point held = contour.at(contour.length() / 2);
		final double[] millis = new double[DRAGS];
		EventQueue.invokeAndWait(() -> send(canvas, MouseEvent.MOUSE_PRESSED, held, 0));
		for (int i = -WARM; i < DRAGS; i++) {
			final int step = i;
			EventQueue.invokeAndWait(() -> {
				final long start = System.nanoTime();
				send(canvas, MouseEvent.MOUSE_DRAGGED, held, 1 + Math.floorMod(step, 20));
				final Graphics g = canvas.getGraphics();
				canvas.paint(g);
				g.dispose();
				Toolkit.getDefaultToolkit().sync();
				if (step >= 0)
					millis[step] = (System.nanoTime() - start) / 1e6;
			});
		}
		// Back where it was held: nothing is said.
		EventQueue.invokeAndWait(() -> send(canvas, MouseEvent.MOUSE_RELEASED, held, 0));
		Arrays.sort(millis);
		System.out.printf(Locale.ROOT,
			"drag, canvas of %d x %d: %.1f ms (median of %d), %.1f ms (95 %% of them within).%n",
			canvas.getWidth(), canvas.getHeight(), millis[DRAGS / 2], DRAGS,
			millis[DRAGS * 95 / 100]);
	}

	private static void send(final ImageCanvas canvas, final int what, final Point from,
		final int pixels) {
		canvas.dispatchEvent(new MouseEvent(canvas, what, System.currentTimeMillis(),
			InputEvent.BUTTON1_DOWN_MASK, canvas.screenXD(from.x() + 0.5) + pixels,
			canvas.screenYD(from.y() + 0.5), 1, false, MouseEvent.BUTTON1));
	}

	/** From a word until its answer is there, each of another frame, and undone again. */
	private static void words(final ReviewModel model) throws Exception {
		final double[] millis = new double[WORDS], busy = new double[WORDS];
		for (int i = -WORDS / 2; i < WORDS; i++) {
			final long cpu = cpu(), start = System.nanoTime();
			model.goTo(Math.floorMod(i * STRIDE, FRAMES) + 1);
			if (i % 2 == 0)
				model.refuse();
			else
				model.through(model.shown().orElseThrow().contour().orElseThrow().at(30));
			model.atRest();
			if (i >= 0) {
				millis[i] = (System.nanoTime() - start) / 1e6;
				busy[i] = (cpu() - cpu) / 1e6;
			}
			model.undo();
			model.atRest();
		}
		Arrays.sort(millis);
		Arrays.sort(busy);
		System.out.printf(Locale.ROOT,
			"solved again, %d frames: %.0f ms (median of %d), %.0f ms (the longest); %.0f ms of processors' time (median).%n",
			FRAMES, millis[WORDS / 2], WORDS, millis[WORDS - 1], busy[WORDS / 2]);
	}

	/** From a value, or a frame, until mask, skeleton and course are drawn on the image. */
	private static void previews() throws Exception {
		final ImagePlus image = image("large", LOOKS, LARGE);
		ImageView.show(image);
		final PreviewBox box = new PreviewBox();
		EventQueue.invokeAndWait(() -> {
			box.panel(() -> {
			});
			box.changed(texts("otsu"));
		});
		await(image, null);
		final double[] values = new double[LOOKS], frames = new double[LOOKS];
		for (int i = -LOOKS / 2; i < LOOKS; i++) {
			final String threshold = Double.toString(0.4 + 0.02 * Math.floorMod(i, 20));
			final double value = millis(image,
				() -> EventQueue.invokeLater(() -> box.changed(texts(threshold))));
			final int slice = 1 + Math.floorMod(i, LOOKS);
			final double frame = millis(image, () -> image.setSlice(slice));
			if (i >= 0) {
				values[i] = value;
				frames[i] = frame;
			}
		}
		EventQueue.invokeAndWait(box::close);
		Arrays.sort(values);
		Arrays.sort(frames);
		System.out.printf(Locale.ROOT,
			"preview, %d x %d pixels: %.0f ms after a value, %.0f ms after a frame (medians of %d), %.0f ms (the longest).%n",
			LARGE, LARGE, values[LOOKS / 2], frames[LOOKS / 2], LOOKS,
			Math.max(values[LOOKS - 1], frames[LOOKS - 1]));
	}

	private static Map<String, String> texts(final String threshold) {
		return Map.of("image", "large", "fixed_end", "", "region", "", "threshold", threshold);
	}

	private static double millis(final ImagePlus image, final Runnable change)
		throws InterruptedException {
		final Overlay before = image.getOverlay();
		final long start = System.nanoTime();
		change.run();
		await(image, before);
		return (System.nanoTime() - start) / 1e6;
	}

	private static void await(final ImagePlus image, final Overlay before)
		throws InterruptedException {
		while (image.getOverlay() == before)
			Thread.sleep(1);
	}

	private static long cpu() {
		return ManagementFactory.getOperatingSystemMXBean() instanceof OperatingSystemMXBean system
			? system.getProcessCpuTime()
			: 0;
	}
}
