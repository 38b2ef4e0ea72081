package io.github.knotresolver.command;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;

import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.scijava.Context;
import org.scijava.command.CommandService;
import org.scijava.module.Module;
import org.scijava.module.ModuleService;

import ij.IJ;
import io.github.knotresolver.imagej.TestImages;

/** No Command replaces what it reads, or anything unasked. */
class UsersFilesCommandsTest {

	@TempDir
	Path home;
	private Context context;
	private File movie, result, sim;

	@BeforeEach
	void makeAMovieAndItsResult() throws Exception {
		System.setProperty("java.awt.headless", "true");
		context = new Context(CommandService.class, ModuleService.class);
		movie = TestImages.save(TestImages.movie(5, 8), home.resolve("movie.tif")).toFile();
		result = home.resolve("result").toFile();
		sim = home.resolve("sim").toFile();
		assertEquals("", run(ResolveFilamentCommand.class,
			Map.of("movie", movie, "out", result, "plots", false)));
		assertEquals("", run(SimulateMovieCommand.class,
			Map.of("out", sim, "length", 4.0, "frames", 4, "duration", 4.0, "time_step", 0.02)));
	}

	@AfterEach
	void dispose() {
		context.dispose();
	}

	@Test
	void whatIsReadIsNeverReplaced() throws Exception {
		final File overlay = new File(result, "overlay.tif"),
			contours = new File(result, "contours.csv"), truth = new File(sim, "contours.csv");
		refused("overlay.tif, which is read", ResolveFilamentCommand.class,
			Map.of("movie", overlay, "out", result, "force", true));
		refused("overlay.tif, which is read", ResolveFilamentCommand.class,
			Map.of("image", IJ.openImage(overlay.toString()), "out", result, "force", true));
		refused("contours.csv, which is read", ResolveFilamentCommand.class,
			Map.of("movie", movie, "out", result, "force", true, "corrections", contours));
		refused("is the folder that is read", MeasureContoursCommand.class,
			Map.of("result", result, "out", result, "force", true));
		refused("contours.csv, which is read", MeasureContoursCommand.class,
			Map.of("result", contours, "out", result, "force", true));
		refused("is a file that is read", EvaluateCommand.class,
			Map.of("truth", truth, "result", result, "out", truth, "force", true));
		refused("is the folder that is read", EvaluateCommand.class,
			Map.of("like", result, "movie", movie, "out", result, "force", true));
		final File sheet = new File(home.toFile(), "batch.csv");
		Files.write(sheet.toPath(), List.of("FileName,FolderPath", "movie.tif,."));
		refused("batch.csv, which is read", BatchCommand.class,
			Map.of("input", sheet, "out", home.toFile(), "force", true));
	}

	@Test
	void nothingIsReplacedUnasked() throws Exception {
		refused("--force", ResolveFilamentCommand.class, Map.of("movie", movie, "out", result));
		refused("--force", SimulateMovieCommand.class, Map.of("out", sim));
		refused("never replaced by", SimulateMovieCommand.class,
			Map.of("out", result, "force", true));
		refused("not written by this program", EvaluateCommand.class,
			Map.of("truth", sim, "result", result, "out", movie, "force", true));
	}

	/** Refused, and not a byte is changed. */
	private void refused(final String sentence, final Class<? extends KnotCommand> command,
		final Map<String, Object> inputs) throws Exception {
		final Map<String, byte[]> before = contents();
		final String reason = run(command, inputs);
		assertTrue(reason.contains(sentence.replace("--force", "force")), reason);
		final Map<String, byte[]> after = contents();
		assertEquals(before.keySet(), after.keySet());
		before.forEach((name, bytes) -> assertArrayEquals(bytes, after.get(name), name));
	}

	/** @return why it was cancelled; nothing if it was not */
	private String run(final Class<? extends KnotCommand> command, final Map<String, Object> inputs)
		throws Exception {
		final ModuleService modules = context.service(ModuleService.class);
		final Module module = modules
			.createModule(context.service(CommandService.class).getCommand(command));
		final KnotCommand delegate = (KnotCommand) module.getDelegateObject();
		if (delegate instanceof ResolveFilamentCommand resolve)
			resolve.setEngine(TestImages::resolve);
		modules.waitFor(modules.run(module, true, new HashMap<>(inputs)));
		return delegate.isCanceled() ? String.valueOf(delegate.getCancelReason()) : "";
	}

	private Map<String, byte[]> contents() throws IOException {
		final Map<String, byte[]> contents = new TreeMap<>();
		try (Stream<Path> files = Files.walk(home)) {
			for (final Path file : files.filter(Files::isRegularFile).toList())
				contents.put(home.relativize(file).toString(), Files.readAllBytes(file));
		}
		return contents;
	}
}
