package io.github.knotresolver.options;

import java.util.Collections;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.Set;
import java.util.SortedSet;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.model.Polarity;
import io.github.knotresolver.model.Segmentation;
import io.github.knotresolver.model.Settings.AnchorChoice;
import io.github.knotresolver.model.Settings.CandidateMethod;
import io.github.knotresolver.model.Settings.FilamentChoice;
import io.github.knotresolver.model.Settings.LengthModel;
import io.github.knotresolver.model.Settings.ResolverMethod;
import io.github.knotresolver.options.Option.Kind;
import io.github.knotresolver.options.Option.Section;

/** Every option of {@code resolve}, once, in the order in which a person thinks of them. */
public final class ResolveOptions {

	/** The options. */
	public static final List<Option> ALL = List.of(

		option("fixed_end", Kind.TEXT).about(Section.FILAMENT).takes("X,Y")
			.label("Fixed end (x,y in pixels)")
			.help("The clamped end, in pixels from 0 at the centre of the top left one")
			.byDefault("found").range("inside the image")
			.reads((d, t) -> d.settings.fixedEnd(Optional.of(OptionText.point("fixed_end", t))))
			.writes(c -> c.settings().fixedEnd().map(Point::toString).orElse(null)),

		option("region", Kind.TEXT).about(Section.FRAMES).takes("X,Y,W,H")
			.label("Region (x,y,width,height in px)")
			.help("Search only there: left column, upper row, width and height in pixels")
			.byDefault("everywhere").range("inside the image, 8 x 8 pixels at least")
			.reads((d, t) -> d.settings.region(Optional.of(OptionText.region("region", t))))
			.writes(c -> c.settings().region().map(Object::toString).orElse(null)),

		option("threshold", Kind.TEXT).about(Section.MASK).takes("T|otsu")
			.label("Threshold (0..1 or otsu)")
			.help("Brightness above which a pixel starts as filament, of a stretched frame")
			.byDefault("otsu").range("0 to 1")
			.reads((d, t) -> d.segmentation = d.segmentation.withThreshold(OptionText.threshold(t)))
			.writes(c -> c.settings().segmentation().threshold().isPresent()
				? c.settings().segmentation().threshold().getAsDouble()
				: "otsu"),

		option("iterations", Kind.WHOLE).about(Section.MASK).takes("N").label("Iterations (steps)")
			.help("Steps of the active contour that moves the mask's outline").byDefault("10")
			.range("0 to 1000")
			.reads((d,
				t) -> d.segmentation = d.segmentation
					.withIterations(OptionText.wholeNumber("iterations", t)))
			.writes(c -> c.settings().segmentation().iterations()),

		option("contraction_bias", Kind.NUMBER).about(Section.MASK).takes("B")
			.label("Contraction bias").help("How much the mask's outline wants to shrink")
			.byDefault("0.4").range("-1 to 1")
			.reads((d,
				t) -> d.segmentation = d.segmentation
					.withContractionBias(OptionText.number("contraction_bias", t)))
			.writes(c -> c.settings().segmentation().contractionBias()),

		option("smooth_factor", Kind.NUMBER).about(Section.MASK).takes("S").label("Smooth factor")
			.help("How smooth the mask's outline becomes").byDefault("0.2").range("0 to 10")
			.reads((d,
				t) -> d.segmentation = d.segmentation
					.withSmoothFactor(OptionText.number("smooth_factor", t)))
			.writes(c -> c.settings().segmentation().smoothFactor()),

		option("segmentation", Kind.CHOICE).about(Section.MASK).oneOf(Segmentation.Steps.class)
			.label("Segmentation")
			.help("What makes the mask; threshold and published method get both")
			.byDefault("evidence")
			.reads((d,
				t) -> d.segmentation = d.segmentation
					.withSteps(OptionText.choice("segmentation", t, Segmentation.Steps.class)))
			.writes(c -> word(c.settings().segmentation().steps())),

		option("polarity", Kind.CHOICE).about(Section.FILAMENT).oneOf(Polarity.class)
			.label("Polarity")
			.help("Whether filaments are brighter or darker than their background")
			.byDefault("auto")
			.reads((d,
				t) -> d.segmentation = d.segmentation
					.withPolarity(OptionText.choice("polarity", t, Polarity.class)))
			.writes(c -> word(c.settings().segmentation().polarity())),

		option("log_size", Kind.WHOLE).about(Section.MASK).takes("N")
			.label("LoG size (px, odd; 0: off)")
			.help("Edge of a Laplacian of Gaussian in pixels, for uneven background")
			.byDefault("off").range("odd, 3 to 99")
			.reads((d, t) -> d.logSize = OptionalInt.of(OptionText.wholeNumber("log_size", t)))
			.writes(
				c -> c.settings().cleaning().enhances() ? c.settings().cleaning().logSize() : null),

		option("log_sigma", Kind.NUMBER).about(Section.MASK).takes("S")
			.label("LoG sigma (px; 0: off)").help("Its standard deviation in pixels")
			.byDefault("off").range("above 0 to 50")
			.reads((d, t) -> d.logSigma = OptionalDouble.of(OptionText.number("log_sigma", t)))
			.writes(c -> c.settings().cleaning().enhances()
				? c.settings().cleaning().logSigma()
				: null),

		option("candidates", Kind.CHOICE).about(Section.METHOD).oneOf(CandidateMethod.class)
			.label("Candidates").help("How contours are proposed from the skeleton's graph")
			.byDefault("trails")
			.reads((d, t) -> d.settings
				.candidates(OptionText.choice("candidates", t, CandidateMethod.class)))
			.writes(c -> word(c.settings().candidates())),

		option("resolver", Kind.CHOICE).about(Section.METHOD).oneOf(ResolverMethod.class)
			.label("Resolver").help("How one is chosen in each frame").byDefault("movie")
			.reads((d, t) -> d.settings
				.resolver(OptionText.choice("resolver", t, ResolverMethod.class)))
			.writes(c -> word(c.settings().resolver())),

		option("length", Kind.TEXT).about(Section.FILAMENT).takes("L")
			.label("Length (if known; image's unit)")
			.help("Known length of the filament, in the image's unit").byDefault("estimated")
			.range("above 0")
			.reads((d, t) -> d.length = OptionalDouble.of(OptionText.positive("length", t)))
			.writes(c -> c.settings().length().isPresent()
				? c.settings().length().getAsDouble() * c.calibration().pixelSize()
				: null),

		option("length_model", Kind.CHOICE).about(Section.FILAMENT).oneOf(LengthModel.class)
			.label("Length model").help("Whether the filament keeps its length").byDefault("auto")
			.reads((d, t) -> d.settings
				.lengthModel(OptionText.choice("length_model", t, LengthModel.class)))
			.writes(c -> word(c.settings().lengthModel())),

		option("filaments", Kind.CHOICE).about(Section.FILAMENT).oneOf(FilamentChoice.class)
			.label("Filaments").help("Which filaments of the field are followed").byDefault("auto")
			.reads((d, t) -> d.settings
				.filaments(OptionText.choice("filaments", t, FilamentChoice.class)))
			.writes(c -> word(c.settings().filaments())),

		option("anchor", Kind.CHOICE).about(Section.FILAMENT).oneOf(AnchorChoice.class)
			.label("Anchor").help("Whether filaments are held at one end").byDefault("auto")
			.reads((d, t) -> d.settings.anchor(OptionText.choice("anchor", t, AnchorChoice.class)))
			.writes(c -> word(c.settings().anchor())),

		option("refine", Kind.FLAG).about(Section.METHOD).label("Refine (sub-pixel)")
			.help("Fit the filament to the image, sub-pixel").byDefault("on")
			.reads((d, t) -> d.settings.refine(OptionText.flag("refine", t)))
			.writes(c -> c.settings().refine()),

		option("channel", Kind.WHOLE).about(Section.FRAMES).takes("N").label("Channel")
			.help("Channel of the filament, from 1").byDefault("1")
			.range("1 to the number of channels")
			.reads((d, t) -> d.channel = OptionText.wholeNumber("channel", t, 1))
			.writes(c -> c.input().channel()),

		option("z_as_time", Kind.FLAG).about(Section.FRAMES).label("Z as time (slices are frames)")
			.help("Read the slices of a Z-stack as frames").byDefault("off")
			.reads((d, t) -> d.zAsTime = OptionText.flag("z_as_time", t))
			.writes(c -> c.input().zAsTime()),

		option("frames", Kind.TEXT).about(Section.FRAMES).takes("LIST").label("Frames (as 1-40,45)")
			.help("Frames to resolve, such as 1-40,45").byDefault("all")
			.range("frames of the movie")
			.reads((d, t) -> d.settings.frames(FrameSelection.parse("frames", t)))
			.writes(c -> selection(c.settings().frames())),

		option("ignore_frames", Kind.TEXT).about(Section.FRAMES).takes("LIST")
			.label("Ignored frames").help("Frames to leave out, such as 7,12-15").byDefault("none")
			.range("frames of the movie")
			.reads((d, t) -> d.settings.ignoreFrames(FrameSelection.parse("ignore_frames", t)))
			.writes(c -> selection(c.settings().ignoreFrames())),

		option("corrections", Kind.FILE).about(Section.FRAMES).takes("FILE")
			.label("Corrections (CSV)")
			.help("What you say of frames: contours, places passed, tips, refusals, exchanges")
			.byDefault("none")
			.reads((d, t) -> d.corrections = Optional.of(OptionText.path("corrections", t))),

		option("pixel_size", Kind.TEXT).about(Section.UNITS).takes("P").label("Pixel size")
			.help("Edge of a pixel").byDefault("the image's").range("0.1 nm to 1 mm")
			.reads((d, t) -> d.pixelSize = OptionalDouble.of(OptionText.positive("pixel_size", t)))
			.writes(c -> c.calibration().hasLengthUnit() ? c.calibration().pixelSize() : null),

		option("unit", Kind.TEXT).about(Section.UNITS).takes("U").label("Unit")
			.help("Unit of the pixel size").byDefault("the image's").range("a unit of length")
			.reads((d, t) -> d.unit = Optional.of(UnitText.length(t)))
			.writes(c -> c.calibration().hasLengthUnit() ? c.calibration().unit() : null),

		option("frame_interval", Kind.TEXT).about(Section.UNITS).takes("S")
			.label("Frame interval (s)").help("Seconds between frames").byDefault("the image's")
			.range("1e-9 s to a year")
			.reads((d,
				t) -> d.frameInterval = OptionalDouble.of(OptionText.positive("frame_interval", t)))
			.writes(c -> c.calibration().hasTimeUnit() ? c.calibration().frameInterval() : null),

		// Not written: the result does not depend on it.
		option("threads", Kind.WHOLE).about(Section.RUN).takes("N").label("Threads (0: all cores)")
			.help("Threads; the result does not depend on them").byDefault("all cores")
			.range("1 or more")
			.reads((d, t) -> d.settings.threads(OptionText.wholeNumber("threads", t, 1))));

	/** The keys of all options, in the same order. */
	public static final Set<String> KEYS = Collections
		.unmodifiableSet(new LinkedHashSet<>(ALL.stream().map(Option::key).toList()));

	private ResolveOptions() {
	}

	private static Option option(final String key, final Kind kind) {
		return new Option(key, kind);
	}

	private static String word(final Enum<?> constant) {
		return constant.name().toLowerCase(Locale.ROOT);
	}

	private static String selection(final SortedSet<Integer> frames) {
		return frames.isEmpty() ? null : FrameSelection.format(frames);
	}
}
