package io.github.knotresolver.command;

import static org.junit.jupiter.api.Assertions.assertAll;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Predicate;
import java.util.stream.Collectors;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;

import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.scijava.Context;
import org.scijava.command.CommandInfo;
import org.scijava.command.CommandModule;
import org.scijava.command.CommandService;
import org.scijava.log.LogLevel;
import org.scijava.log.LogService;
import org.scijava.module.Module;
import org.scijava.module.ModuleItem;
import org.scijava.module.ModuleService;

import ij.ImagePlus;
import ij.WindowManager;
import ij.gui.PointRoi;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.imagej.SampleMovie;
import io.github.knotresolver.imagej.TestImages;
import io.github.knotresolver.imagej.form.Form;
import io.github.knotresolver.imagej.form.FormField;
import io.github.knotresolver.model.Region;
import io.github.knotresolver.model.Tracks;
import io.github.knotresolver.options.Option;
import io.github.knotresolver.options.ResolveOptions;
import io.github.knotresolver.options.RunOptions;
import io.github.knotresolver.progress.CancelledException;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.session.Engine;

/** The Command as scripts call it. */
class ResolveFilamentCommandTest {

	@TempDir
	Path home;
	private Context context;

	@BeforeEach
	void start() {
		context = new Context(CommandService.class, ModuleService.class, LogService.class);
		context.service(LogService.class).setLevel(LogLevel.NONE);
	}

	@AfterEach
	void stop() {
		context.dispose();
	}

	@Test
	void isFoundHasNoMenuAndItsKeysAreTheOptions() {
		final CommandInfo info = context.service(CommandService.class)
			.getCommand(ResolveFilamentCommand.class);
		assertNotNull(info);
		assertTrue(info.getMenuPath().isEmpty());
		assertTrue(info.getAnnotation().attrs().length == 1 && info.is("no-legacy"));
		for (final String key : RunOptions.KEYS)
			assertNotNull(info.getInput(key), key);
		for (final ModuleItem<?> input : info.inputs())
			assertFalse(input.isPersisted() && RunOptions.KEYS.contains(input.getName()),
				input.getName());
	}

	/** The Command's fields are annotated in Java; the list of options says with what. */
	@Test
	void itsFormIsThatOfTheListOfOptions() {
		final CommandInfo info = context.service(CommandService.class)
			.getCommand(ResolveFilamentCommand.class);
		final Map<String, FormField> fields = Form.of(new ResolveFilamentCommand()).fields()
			.stream().collect(Collectors.toMap(FormField::name, f -> f));
		for (final Option option : ResolveOptions.ALL) {
			final ModuleItem<?> input = info.getInput(option.key());
			final FormField field = fields.get(option.key());
			assertAll(option.key(), () -> assertEquals(option.label(), input.getLabel()),
				() -> assertEquals(Set.copyOf(option.choices()), Set.copyOf(field.choices())),
				() -> assertEquals(option.kind().name(), field.kind().name()),
				() -> assertTrue(isDefault(option, field.text()), field.text()),
				() -> assertTrue(isRange(option, input), option.range()));
		}
	}

	/** Words of the list stand for nothing, 0 or no in a form. */
	private static boolean isDefault(final Option option, final String text) {
		return switch (option.byDefault()) {
			case "on" -> text.equals("true");
			case "off" -> text.equals("false") || text.equals("0");
			default -> text.equals(option.byDefault()) || text.isEmpty() || text.equals("0");
		};
	}

	private static boolean isRange(final Option option, final ModuleItem<?> input) {
		return !option.range().matches("-?[0-9.]+ to -?[0-9.]+") || input.getMinimumValue() == null
			|| option.range()
				.equals(text(input.getMinimumValue()) + " to " + text(input.getMaximumValue()));
	}

	private static String text(final Object number) {
		return String.valueOf(number).replaceFirst("\\.0$", "");
	}

	/** imagej-legacy takes Commands with {@code no-legacy} from the list of modules. */
	@Test
	void runsByClassAndNameEvenIfLegacyHasTakenItAway() throws Exception {
		final ModuleService modules = context.service(ModuleService.class);
		modules.removeModules(
			modules.getModules().stream().filter(info -> info.is("no-legacy")).toList());
		final CommandService commands = context.service(CommandService.class);
		for (final CommandModule module : List.of(commands.run(CiteCommand.class, true).get(),
			commands.run(CiteCommand.class.getName(), true).get()))
			assertTrue(module.getOutput("citation").toString().contains("btae538"));
	}

	@Test
	void resolvesAFileIntoAFolder() throws Exception {
		final Path file = TestImages.save(TestImages.movie(4, 16), home.resolve("m.tif"));
		final Path out = home.resolve("out");
		final Module module = run(Map.of("movie", file.toFile(), "out", out.toFile(), "threshold",
			"0.3", "frames", "1-3"));
		assertFalse(((ResolveFilamentCommand) module.getDelegateObject()).isCanceled());
		final Tracks resolution = (Tracks) module.getOutput("resolution");
		assertEquals(0.3, resolution.settings().segmentation().threshold().getAsDouble());
		assertEquals(3, resolution.settings().frames().size());
		assertTrue(Files.exists(out.resolve("contours.csv")));
	}

	@Test
	void takesTheImageAndItsPointSelectionAndChangesNothing() throws Exception {
		final ImagePlus image = TestImages.movie(4, 8);
		image.setRoi(new PointRoi(12.0, 30.0));
		final byte[] before = ((byte[]) image.getStack().getPixels(2)).clone();
		final Tracks resolution = (Tracks) run(Map.of("image", image)).getOutput("resolution");
		assertEquals(Optional.of(new Point(12, 30)), resolution.settings().fixedEnd());
		assertEquals("µm", resolution.movie().calibration().unit());
		assertTrue(Arrays.equals(before, (byte[]) image.getStack().getPixels(2)));
		assertEquals(3 * 16, image.getOverlay().size());
	}

	@Test
	void overlayCanBeLeftOut() throws Exception {
		final ImagePlus image = TestImages.movie(4, 8);
		run(Map.of("image", image, "overlay", false));
		assertNull(image.getOverlay());
	}

	@Test
	void areaSelectionLimitsTheSearch() throws Exception {
		final ImagePlus image = TestImages.movie(4, 8);
		image.setRoi(5, 2, 60, 50);
		final Tracks resolution = (Tracks) run(Map.of("image", image, "fixed_end", "12,30"))
			.getOutput("resolution");
		assertEquals(Optional.of(new Region(5, 2, 60, 50)), resolution.settings().region());
		assertEquals(TestImages.WIDTH, resolution.movie().width());
		assertRefused("reaches outside of 'movie', which has 80 x 60 pixels",
			Map.of("image", image, "region", "5,2,76,50"));
	}

	@Test
	void runInASelectionIsRepeatedFromItsParameters() throws Exception {
		final ImagePlus image = TestImages.movie(4, 8);
		image.setRoi(5, 2, 60, 50);
		final File first = home.resolve("first").toFile(), second = home.resolve("second").toFile();
		run(Map.of("image", image, "fixed_end", "12,30", "out", first));
		final JsonObject options = JsonParser
			.parseString(Files.readString(first.toPath().resolve("parameters.json")))
			.getAsJsonObject().getAsJsonObject("options");
		assertEquals("5,2,60,50", options.get("region").getAsString());
		image.deleteRoi();
		final Map<String, Object> again = new HashMap<>(Map.of("image", image, "out", second));
		for (final String key : List.of("region", "fixed_end", "threshold"))
			again.put(key, options.get(key).getAsString());
		run(again);
		assertEquals(-1, Files.mismatch(first.toPath().resolve("contours.csv"),
			second.toPath().resolve("contours.csv")));
	}

	/** Esc at the first sign of each stage, of the real pipeline and its files. */
	@Test
	void everyStageCanBeCancelled() throws Exception {
		final Set<String> stages = new LinkedHashSet<>();
		resolveUntil(stage -> {
			stages.add(stage);
			return false;
		});
		assertTrue(stages.containsAll(Set.of("Writing tables", "Drawing")), stages.toString());
		assertTrue(stages.size() >= 5, stages.toString());
		for (final String wanted : stages) {
			final ImagePlus sample = resolveUntil(wanted::equals);
			assertNull(sample.getOverlay(), "It went on after " + wanted);
			assertFalse(Files.exists(home.resolve("stages")), "A folder is left after " + wanted);
		}
	}

	/** Resolves a part of the sample, and cancels at a stage. */
	private ImagePlus resolveUntil(final Predicate<String> stage) throws Exception {
		final ImagePlus sample = SampleMovie.open();
		final AtomicBoolean reached = new AtomicBoolean();
		final Progress progress = new Progress() {

			@Override
			public void report(final String name, final double fraction) {
				// Frame and time left come after a colon.
				if (stage.test(name.split(": ")[0]))
					reached.set(true);
			}

			@Override
			public boolean isCancelled() {
				return reached.get();
			}
		};
		final ResolveFilamentCommand command = new ResolveFilamentCommand();
		Form.of(command).fill(
			Map.of("frames", "1-3", "out", home.resolve("stages").toString(), "force", "true"));
		WindowManager.setTempCurrentImage(sample);
		try {
			command.work(progress);
			Files.move(home.resolve("stages"), home.resolve("whole"));
		} catch (final CancelledException e) {
			assertTrue(reached.get());
		} finally {
			WindowManager.setTempCurrentImage(null);
		}
		return sample;
	}

	@Test
	void selectionTooSmallForAFilamentIsRefused() throws Exception {
		final ImagePlus image = TestImages.movie(4, 8);
		image.setRoi(5, 2, 3, 50);
		assertRefused("too small for a filament", Map.of("image", image));
		image.setRoi(40, 2, 30, 50);
		assertRefused("lies outside the region 40,2,30,50",
			Map.of("image", image, "fixed_end", "12,30"));
	}

	@Test
	void defaultsAreTheCommandLines() throws Exception {
		final Tracks resolution = (Tracks) run(Map.of("image", TestImages.movie(4, 8)))
			.getOutput("resolution");
		assertEquals(RunOptions.parse(Map.of()).parameters(resolution.movie()),
			resolution.settings());
	}

	@Test
	void wrongValuesCancelWithTheSentence() throws Exception {
		final ImagePlus image = TestImages.movie(4, 8);
		assertRefused("threshold must be a number from 0 to 1",
			Map.of("image", image, "threshold", "1.5"));
		assertRefused("candidates must be trails or paper",
			Map.of("image", image, "candidates", "all"));
		assertRefused("iterations must be a whole number from 0 to 1000",
			Map.of("image", image, "iterations", 5000));
		assertRefused("There is no image open", Map.of());
		assertRefused("There is no file", Map.of("movie", home.resolve("absent.tif").toFile()));
		assertRefused("not a result",
			Map.of("image", image, "out",
				Files.writeString(Files.createDirectory(home.resolve("mine")).resolve("a.txt"), "x")
					.getParent().toFile()));
	}

	@Test
	void repeatedRunsLeaveNoThreadsNoImagesAndNoMemoryBehind() {
		final ImagePlus sample = SampleMovie.open();
		long settled = 0;
		for (int i = 0; i < 20; i++) {
			final ResolveFilamentCommand command = new ResolveFilamentCommand();
			command.setContext(context);
			Form.of(command).fill(Map.of("frames", "1-2"));
			WindowManager.setTempCurrentImage(sample);
			command.run();
			assertFalse(command.isCanceled(), command.getCancelReason());
			if (i == 5)
				settled = usedMemory();
		}
		WindowManager.setTempCurrentImage(null);
		assertTrue(usedMemory() - settled < 4_000_000, "Memory grows from run to run.");
		assertEquals(0, WindowManager.getImageCount());
		assertTrue(Thread.getAllStackTraces().keySet().stream().noneMatch(
			t -> t.getName().contains("KnotResolver") && lives(t)), "A worker is still there.");
	}

	/** Threads that were told to stop may need a moment. */
	private static boolean lives(final Thread thread) {
		try {
			thread.join(5000);
		} catch (final InterruptedException e) {
			Thread.currentThread().interrupt();
		}
		return thread.isAlive();
	}

	private static long usedMemory() {
		for (int i = 0; i < 3; i++)
			System.gc();
		return Runtime.getRuntime().totalMemory() - Runtime.getRuntime().freeMemory();
	}

	@Test
	void cancelLeavesNothing() throws Exception {
		final Module module = run(
			Map.of("image", TestImages.movie(4, 8), "out", home.resolve("out").toFile()),
			(m, p, progress) -> {
				throw new CancelledException();
			});
		assertTrue(((ResolveFilamentCommand) module.getDelegateObject()).isCanceled());
		assertFalse(Files.exists(home.resolve("out")));
	}

	private void assertRefused(final String sentence, final Map<String, Object> inputs)
		throws Exception {
		final ResolveFilamentCommand command = (ResolveFilamentCommand) run(inputs)
			.getDelegateObject();
		assertTrue(command.isCanceled());
		assertTrue(command.getCancelReason().contains(sentence), command.getCancelReason());
	}

	private Module run(final Map<String, Object> inputs)
		throws InterruptedException, ExecutionException {
		return run(inputs, TestImages::resolve);
	}

	private Module run(final Map<String, Object> inputs, final Engine engine)
		throws InterruptedException, ExecutionException {
		final CommandInfo info = context.service(CommandService.class)
			.getCommand(ResolveFilamentCommand.class);
		final ModuleService modules = context.service(ModuleService.class);
		final Module module = modules.createModule(info);
		((ResolveFilamentCommand) module.getDelegateObject()).setEngine(engine);
		return modules.waitFor(modules.run(module, true, new HashMap<>(inputs)));
	}
}
