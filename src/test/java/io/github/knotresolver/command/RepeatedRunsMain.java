package io.github.knotresolver.command;

import java.awt.EventQueue;
import java.awt.Window;
import java.lang.reflect.Field;
import java.util.Collection;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;

import ij.IJ;
import ij.ImageJ;
import ij.ImagePlus;
import ij.WindowManager;
import io.github.knotresolver.imagej.SampleMovie;

/**
 * The same run many times in one ImageJ, with overlay, ROI Manager, tables and
 * measurements; prints what has piled up after the first runs and at the end.
 */
final class RepeatedRunsMain {

	private static final int RUNS = 50, SETTLED = 15;

	private RepeatedRunsMain() {
	}

	public static void main(final String[] args) throws Exception {
		new ImageJ();
		Map<String, Long> settled = Map.of();
		for (int run = 1; run <= RUNS; run++) {
			run(args[0]);
			if (run == SETTLED)
				settled = counts();
		}
		final Map<String, Long> end = counts();
		settled.forEach((what, before) -> System.out.printf(Locale.ROOT, "%s: %d -> %d%n", what,
			before, end.get(what)));
		System.exit(0);
	}

	/** Opens, resolves, writes, shows, measures and closes. */
	private static void run(final String out) {
		final ImagePlus image = SampleMovie.open();
		image.show();
		IJ.runMacro("run(\"Resolve Filament...\", \"frames=1-4 plots=false out=[" + out
			+ "] force\"); run(\"Measure Contours...\", \"show\");");
		if (image.getOverlay() == null)
			throw new IllegalStateException("Nothing came of it: " + IJ.getLog());
		for (final int id : WindowManager.getIDList()) {
			final ImagePlus open = WindowManager.getImage(id);
			open.changes = false;
			open.close();
		}
		IJ.log("\\Clear");
	}

	private static Map<String, Long> counts() throws Exception {
		final Map<String, Long> counts = new TreeMap<>();
		// Threads and windows may need a moment to go.
		for (int i = 0; i < 5; i++) {
			Thread.sleep(300);
			EventQueue.invokeAndWait(() -> {
				// What was queued is done.
			});
			System.gc();
		}
		final Runtime runtime = Runtime.getRuntime();
		counts.put("memory [MB]", (runtime.totalMemory() - runtime.freeMemory()) >> 20);
		counts.put("threads",
			Thread.getAllStackTraces().keySet().stream().filter(t -> !t.isDaemon()).count());
		counts.put("images", (long) WindowManager.getImageCount());
		counts.put("windows", (long) WindowManager.getNonImageTitles().length);
		long showing = 0;
		for (final Window window : Window.getWindows())
			showing += window.isShowing() ? 1 : 0;
		counts.put("showing windows", showing);
		counts.put("image listeners", size(ImagePlus.class, "listeners"));
		counts.put("event listeners", size(IJ.class, "eventListeners"));
		return counts;
	}

	private static long size(final Class<?> type, final String list) throws Exception {
		final Field field = type.getDeclaredField(list);
		field.setAccessible(true);
		final Object value = field.get(null);
		return value == null ? 0 : ((Collection<?>) value).size();
	}
}
