package io.github.knotresolver.command;

import java.awt.GraphicsEnvironment;
import java.io.File;
import java.io.IOException;
import java.util.List;
import java.util.Locale;

import org.scijava.ItemIO;
import org.scijava.command.Command;
import org.scijava.plugin.Attr;
import org.scijava.plugin.Parameter;
import org.scijava.plugin.Plugin;
import org.scijava.widget.FileWidget;

import ij.ImagePlus;
import ij.macro.Interpreter;
import io.github.knotresolver.imagej.ImageView;
import io.github.knotresolver.imagej.MovieTiff;
import io.github.knotresolver.imagej.form.FormField;
import io.github.knotresolver.io.ResultFolder;
import io.github.knotresolver.io.ResultKind;
import io.github.knotresolver.options.OptionText;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.run.Rendering;
import io.github.knotresolver.run.SimulationRun;
import io.github.knotresolver.simulate.FilamentProperties;
import io.github.knotresolver.simulate.FilamentProperties.Clamp;
import io.github.knotresolver.simulate.MediumProperties;
import io.github.knotresolver.simulate.MotorProperties;
import io.github.knotresolver.simulate.Optics;
import io.github.knotresolver.simulate.Schedule;
import io.github.knotresolver.simulate.SimulatedMovie;
import io.github.knotresolver.simulate.SimulationParameters;

/**
 * {@code Simulate Movie...}: a clamped filament over motors, as a movie with
 * known truth.
 */
@Plugin(type = Command.class, label = "Simulate Movie...", attrs = @Attr(name = "no-legacy"))
public class SimulateMovieCommand extends KnotCommand {

	@Parameter(label = "Length (µm)", description = "Of the filament", min = "1", max = "200", required = false, persist = false)
	private double length = 20;

	@Parameter(label = "Density (motors per µm²)", min = "0", max = "1000", required = false, persist = false)
	private double density = 50;

	@Parameter(label = "Duration (s)", min = "0.001", max = "100000", required = false, persist = false)
	private double duration = 300;

	@Parameter(label = "Frames", min = "2", max = "10000", required = false, persist = false)
	private int frames = 120;

	@Parameter(label = "Warm up (s)", description = "Time before the first frame", min = "0", max = "100000", required = false, persist = false)
	private double warm_up = 0;

	@Parameter(label = "Seed", description = "The same seed gives the same movie", required = false, persist = false)
	private long seed = 1;

	@Parameter(label = "Clamp", description = "How the first end is held", choices = {"pivot",
		"direction", "free"}, required = false, persist = false)
	private String clamp = "pivot";

	@Parameter(label = "Persistence length (µm)", description = "Empty for that of a microtubule of this length", required = false, persist = false, attrs = @Attr(name = FormField.KEY, value = "persistence"))
	private String persistence_length = "";

	@Parameter(label = "Motor speed (µm/s)", description = "Without load", min = "0", max = "10", required = false, persist = false)
	private double motor_speed = 0.1;

	@Parameter(label = "Stall load (pN)", description = "Force at which a motor stands still", min = "0.1", max = "1000", required = false, persist = false, attrs = @Attr(name = FormField.KEY, value = "stall_load"))
	private double stall_force = 6;

	@Parameter(label = "Binding rate (1/s)", description = "Of a motor within reach", min = "0", max = "1000", required = false, persist = false)
	private double binding_rate = 5;

	@Parameter(label = "Binding range (µm)", description = "Reach of a motor", min = "0.001", max = "0.2", required = false, persist = false)
	private double binding_range = 0.02;

	@Parameter(label = "Off rate (1/s)", description = "Of unbinding, without load", min = "0", max = "1000", required = false, persist = false, attrs = @Attr(name = FormField.KEY, value = "off_rate"))
	private double unbinding_rate = 0.04;

	@Parameter(label = "Unbinding load (pN)", description = "Force that speeds up unbinding e-fold", min = "0.1", max = "1000", required = false, persist = false, attrs = @Attr(name = FormField.KEY, value = "unbinding_load"))
	private double unbinding_force = 3;

	@Parameter(label = "Motor stiffness (pN/µm)", description = "Of a motor's linker", min = "1", max = "10000", required = false, persist = false)
	private double motor_stiffness = 100;

	@Parameter(label = "Temperature (K)", min = "1", max = "400", required = false, persist = false)
	private double temperature = 310;

	@Parameter(label = "Viscosity (Pa s)", description = "Of the medium", min = "0.0001", max = "100", required = false, persist = false)
	private double viscosity = 0.001;

	@Parameter(label = "Axis height (µm)", description = "Of the filament above the surface", min = "0.0126", max = "10", required = false, persist = false)
	private double axis_height = 0.05;

	@Parameter(label = "Link (µm)", description = "Length of a link of the simulated chain", min = "0.02", max = "1", required = false, persist = false)
	private double link = 0.1;

	@Parameter(label = "Time step (s)", description = "Of the integration", min = "0.00001", max = "0.1", required = false, persist = false)
	private double time_step = 0.005;

	@Parameter(label = "Rendering", description = "paper: the published one; optical: microscope and camera", choices = {
		"paper", "optical"}, required = false, persist = false)
	private String rendering = "paper";

	@Parameter(label = "Pixel size (µm)", min = "0.005", max = "10", required = false, persist = false)
	private double pixel_size = 0.106;

	@Parameter(label = "Margin (px)", description = "Around the filament", min = "0", max = "1000", required = false, persist = false)
	private int margin = 20;

	@Parameter(label = "SNR (dB or inf)", description = "Signal-to-noise ratio; paper only", required = false, persist = false)
	private String snr = "20";

	@Parameter(label = "Bits", choices = {"8", "16"}, required = false, persist = false)
	private String bits = "8";

	@Parameter(label = "PSF sigma (px)", description = "Width of the point spread function; this and the rest: optical only", min = "0.3", max = "20", required = false, persist = false)
	private double psf_sigma = 1.5;

	@Parameter(label = "Signal (photons)", description = "In a pixel on the filament", min = "0.1", max = "1000000", required = false, persist = false)
	private double signal = 100;

	@Parameter(label = "Background (photons)", description = "In a pixel elsewhere", min = "0", max = "1000000", required = false, persist = false)
	private double background = 20;

	@Parameter(label = "Read noise (electrons)", min = "0", max = "1000", required = false, persist = false)
	private double read_noise = 2;

	@Parameter(label = "Bleaching time (s)", description = "In which light fades e-fold; empty for never", required = false, persist = false)
	private String bleaching_time = "";

	@Parameter(label = "Others", description = "Other filaments that glide through the view", min = "0", max = "100", required = false, persist = false)
	private int others = 0;

	@Parameter(label = "Glide (px)", description = "Way of the others from frame to frame", min = "0", max = "1000", required = false, persist = false)
	private double glide = 1;

	@Parameter(label = "Debris", description = "Specks that shine", min = "0", max = "1000", required = false, persist = false)
	private int debris = 0;

	@Parameter(label = "Out (folder)", description = "Gets movie, truth and parameters; empty to write no files", style = FileWidget.DIRECTORY_STYLE, required = false, persist = false)
	private File out;

	@Parameter(label = "Force (replace a movie)", required = false, persist = false)
	private boolean force = false;

	@Parameter(type = ItemIO.OUTPUT)
	private ImagePlus simulated;

	@Override
	void check() {
		super.check();
		new SimulationRun(parameters(), rendering());
	}

	@Override
	void work(final Progress progress) throws IOException {
		final SimulationRun run = new SimulationRun(parameters(), rendering());
		final SimulatedMovie movie;
		if (out == null)
			movie = run.run(progress);
		else
			try (ResultFolder folder = ResultFolder.reserve(out.toPath(), ResultKind.SIMULATION,
				force, List.of())) {
				movie = run.run(progress);
				run.write(movie, MovieTiff::write, folder);
			}
		simulated = MovieTiff.image(movie.movie());
		if (!GraphicsEnvironment.isHeadless() || Interpreter.isBatchMode())
			ImageView.show(simulated);
		say(SimulationRun.report(movie));
	}

	private SimulationParameters parameters() {
		final double bending = persistence_length.isBlank()
			? FilamentProperties.microtubule(length).persistenceLength()
			: OptionText.positive("persistence_length", persistence_length);
		return new SimulationParameters(
			new FilamentProperties(length, bending, link,
				Clamp.valueOf(clamp.toUpperCase(Locale.ROOT))),
			new MotorProperties(density, binding_rate, binding_range, unbinding_rate,
				unbinding_force, stall_force, motor_speed, motor_stiffness),
			new MediumProperties(temperature, viscosity, axis_height),
			new Schedule(duration, frames, time_step, warm_up), seed);
	}

	private Rendering rendering() {
		final double bleaching = bleaching_time.isBlank()
			? Double.POSITIVE_INFINITY
			: OptionText.positive("bleaching_time", bleaching_time);
		return new Rendering(rendering.equalsIgnoreCase("optical"), pixel_size, margin,
			Integer.parseInt(bits), snr, new Optics(psf_sigma, signal, background, read_noise,
				bleaching, others, glide, debris));
	}
}
