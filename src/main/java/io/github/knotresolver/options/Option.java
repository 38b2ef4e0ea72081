package io.github.knotresolver.options;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.function.BiConsumer;
import java.util.function.Function;

/**
 * An option of a run, said once. Command line, macros, batch sheets,
 * {@code parameters.json} and the tables of the documents follow from it.
 * An option is added by one entry in {@link ResolveOptions}.
 */
public final class Option {

	/** What kind of value an option takes. */
	public enum Kind {
		/** Any text. */
		TEXT,
		/** One of a few words. */
		CHOICE,
		/** A whole number. */
		WHOLE,
		/** A number. */
		NUMBER,
		/** Yes or no. */
		FLAG,
		/** A file that is read. */
		FILE
	}

	private final String key;
	private final Kind kind;
	private Section section;
	private String values = "";
	private List<String> choices = List.of();
	private String label;
	private String help = "";
	private String byDefault = "";
	private String range = "";
	private BiConsumer<RunOptions.Draft, String> reader;
	private Function<RunOptions.Chosen, Object> writer;

	Option(final String key, final Kind kind) {
		this.key = key;
		this.kind = kind;
		label = key;
	}

	/** @return the name in macros, sheets and JSON, such as {@code contraction_bias} */
	public String key() {
		return key;
	}

	/** @return the name on the command line, such as {@code --contraction-bias} */
	public String name() {
		return "--" + key.replace('_', '-');
	}

	/** @return what kind of value it takes */
	public Kind kind() {
		return kind;
	}

	/** @return what it is about */
	public Section section() {
		return section;
	}

	/** @return what stands for its value in a help text, such as {@code X,Y}; empty for a flag */
	public String values() {
		return values;
	}

	/** @return the words to choose from; empty if it is no choice */
	public List<String> choices() {
		return choices;
	}

	/** @return what a form shows beside it */
	public String label() {
		return label;
	}

	/** @return what it is, with its unit: a phrase that begins with a capital, without a full stop */
	public String help() {
		return help;
	}

	/** @return what is taken if it is not told */
	public String byDefault() {
		return byDefault;
	}

	/** @return which values are allowed; empty if the kind says it all */
	public String range() {
		return range;
	}

	/** Takes a value from text. */
	void read(final RunOptions.Draft draft, final String text) {
		reader.accept(draft, text);
	}

	/** @return whether it is written with a result, so that the run can be repeated */
	boolean isWritten() {
		return writer != null;
	}

	/** @return its value as JSON has it; null if it was not told and has no value of its own */
	Object value(final RunOptions.Chosen chosen) {
		return writer.apply(chosen);
	}

	Option about(final Section about) {
		section = about;
		return this;
	}

	Option takes(final String placeholder) {
		values = placeholder;
		return this;
	}

	<E extends Enum<E>> Option oneOf(final Class<E> words) {
		choices = Arrays.stream(words.getEnumConstants())
			.map(c -> c.name().toLowerCase(Locale.ROOT)).toList();
		values = String.join("|", choices).replace('_', '-');
		return this;
	}

	Option label(final String text) {
		label = text;
		return this;
	}

	Option help(final String text) {
		help = text;
		return this;
	}

	Option byDefault(final String text) {
		byDefault = text;
		return this;
	}

	Option range(final String text) {
		range = text;
		return this;
	}

	Option reads(final BiConsumer<RunOptions.Draft, String> how) {
		reader = how;
		return this;
	}

	Option writes(final Function<RunOptions.Chosen, Object> how) {
		writer = how;
		return this;
	}

	/** What an option is about. */
	public enum Section {

		/** What a user knows of it. */
		FILAMENT("What you know about the filament"),

		/** Frames and region. */
		FRAMES("Which frames, and where"),

		/** Image processing. */
		MASK("From frame to mask"),

		/** Candidates, fit and choice. */
		METHOD("How the filament is resolved"),

		/** Calibration. */
		UNITS("Units"),

		/** Files and threads. */
		RUN("The run");

		private final String heading;

		Section(final String heading) {
			this.heading = heading;
		}

		/** @return the heading over the options of this section */
		public String heading() {
			return heading;
		}
	}
}
