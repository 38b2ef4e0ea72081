package io.github.knotresolver.cli;

import io.github.knotresolver.model.UserException;
import io.github.knotresolver.simulate.FilamentProperties;
import io.github.knotresolver.simulate.FilamentProperties.Clamp;
import io.github.knotresolver.simulate.MediumProperties;
import io.github.knotresolver.simulate.MotorProperties;
import io.github.knotresolver.simulate.Schedule;
import io.github.knotresolver.simulate.SimulationParameters;
import picocli.CommandLine.Option;

/** The options that decide a simulated trajectory. */
final class SimulateOptions {

	@Option(names = "--length", paramLabel = "L", defaultValue = "20", description = "Length of the filament in µm [20].")
	private double length;

	@Option(names = "--density", paramLabel = "D", defaultValue = "50", description = "Motors per µm² [50].")
	private double density;

	@Option(names = "--duration", paramLabel = "T", defaultValue = "300", description = "Simulated time in s [300].")
	private double duration;

	@Option(names = "--frames", paramLabel = "N", defaultValue = "120", description = "Frames in that time [120].")
	private int frames;

	@Option(names = "--warm-up", paramLabel = "T", defaultValue = "0", description = "Time before the first frame in s [0].")
	private double warmUp;

	@Option(names = "--seed", paramLabel = "N", defaultValue = "1", description = "Start of the random numbers; the same seed gives the same movie [1].")
	private long seed;

	@Option(names = "--clamp", paramLabel = "KIND", defaultValue = "pivot", description = "How the first end is held: pivot, direction or free [pivot].")
	private Clamp clamp;

	@Option(names = "--persistence-length", paramLabel = "L", description = "In µm [that of a microtubule of this length].")
	private Double persistenceLength;

	@Option(names = "--link", paramLabel = "L", defaultValue = "0.1", description = "Length of a link in µm [0.1].")
	private double link;

	@Option(names = "--time-step", paramLabel = "T", defaultValue = "0.005", description = "Step of the integration in s [0.005].")
	private double timeStep;

	@Option(names = "--motor-speed", paramLabel = "V", defaultValue = "0.1", description = "Without load, in µm/s [0.1].")
	private double motorSpeed;

	@Option(names = "--stall-force", paramLabel = "F", defaultValue = "6", description = "In pN [6].")
	private double stallForce;

	@Option(names = "--binding-rate", paramLabel = "R", defaultValue = "5", description = "Of a motor within reach, per s [5].")
	private double bindingRate;

	@Option(names = "--binding-range", paramLabel = "L", defaultValue = "0.02", description = "Reach of a motor in µm [0.02].")
	private double bindingRange;

	@Option(names = "--unbinding-rate", paramLabel = "R", defaultValue = "0.04", description = "Without load, per s [0.04].")
	private double unbindingRate;

	@Option(names = "--unbinding-force", paramLabel = "F", defaultValue = "3", description = "Load that speeds up unbinding e-fold, in pN [3].")
	private double unbindingForce;

	@Option(names = "--motor-stiffness", paramLabel = "K", defaultValue = "100", description = "Of a motor's linker, in pN/µm [100].")
	private double stiffness;

	@Option(names = "--temperature", paramLabel = "T", defaultValue = "310", description = "In kelvin [310].")
	private double temperature;

	@Option(names = "--viscosity", paramLabel = "V", defaultValue = "0.001", description = "Of the medium, in Pa s [0.001].")
	private double viscosity;

	@Option(names = "--axis-height", paramLabel = "H", defaultValue = "0.05", description = "Of the filament above the surface, in µm [0.05].")
	private double axisHeight;

	/** @return the start of the random numbers */
	long seed() {
		return seed;
	}

	/**
	 * @return the parameters
	 * @throws UserException if one is out of range
	 */
	SimulationParameters parameters() {
		final double bending = persistenceLength == null
			? FilamentProperties.microtubule(length).persistenceLength()
			: persistenceLength;
		return new SimulationParameters(new FilamentProperties(length, bending, link, clamp),
			new MotorProperties(density, bindingRate, bindingRange, unbindingRate, unbindingForce,
				stallForce, motorSpeed, stiffness),
			new MediumProperties(temperature, viscosity, axisHeight),
			new Schedule(duration, frames, timeStep, warmUp), seed);
	}
}
