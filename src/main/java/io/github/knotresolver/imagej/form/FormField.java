package io.github.knotresolver.imagej.form;

import java.io.File;
import java.lang.reflect.Field;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

import org.scijava.ItemIO;
import org.scijava.plugin.Attr;
import org.scijava.plugin.Parameter;
import org.scijava.widget.FileWidget;

import ij.ImagePlus;
import ij.WindowManager;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.options.OptionText;

/**
 * One {@code @Parameter} of a Command. Its name is that of the Java field and of the option on the
 * command line; its label starts with the words of its key. In macros it has the same name, and,
 * where the name ends like another one's, a key of its own: ImageJ's recorder looks for
 * {@code force=} anywhere in a line and so takes {@code stall_force=6} for a key that comes twice.
 */
public final class FormField {

	/** The attribute of a {@code @Parameter} that has a key of its own. */
	public static final String KEY = "key";

	/** Characters of a field, where a parameter says nothing else. */
	private static final int USUAL = 8;

	private final Object command;
	private final Field field;
	private final Parameter parameter;
	private final Kind kind;

	FormField(final Object command, final Field field) {
		this.command = command;
		this.field = field;
		this.parameter = field.getAnnotation(Parameter.class);
		this.kind = Kind.of(field.getType(), parameter);
		field.setAccessible(true);
	}

	/** @return the option's name, which macros may say, too */
	public String name() {
		return field.getName();
	}

	/** @return the key in macros, as it is recorded */
	public String key() {
		return Arrays.stream(parameter.attrs()).filter(a -> a.name().equals(KEY)).map(Attr::value)
			.findFirst().orElse(name());
	}

	/** @return whether macros may call it so */
	boolean isCalled(final String word) {
		return word.equals(key()) || word.equals(name());
	}

	/** @return what the dialog shows beside it */
	public String label() {
		return parameter.label();
	}

	/** @return more words about it; may be empty */
	public String description() {
		return parameter.description();
	}

	/** @return whether it takes a line of words, more than the few characters that are usual */
	public boolean isLong() {
		return kind == Kind.TEXT && parameter.columns() > USUAL;
	}

	/** @return what kind of value it takes */
	public Kind kind() {
		return kind;
	}

	/** @return the words to choose from */
	public List<String> choices() {
		return List.of(parameter.choices());
	}

	/** @return what values are allowed, such as {@code a whole number from 0 to 10} */
	public String allowed() {
		return switch (kind) {
			case CHOICE -> String.join(" or ", parameter.choices());
			case FLAG -> "true or false";
			case WHOLE -> "a whole number" + range();
			case NUMBER -> "a number" + range();
			case FILE -> "a file";
			case FOLDER -> "a folder";
			case IMAGE -> "the title of an open image";
			default -> "text";
		};
	}

	private String range() {
		final boolean least = !parameter.min().isEmpty(), most = !parameter.max().isEmpty();
		if (least && most)
			return " from " + parameter.min() + " to " + parameter.max();
		return least ? " from " + parameter.min() + " on" : "";
	}

	/** @return the value as text; empty if there is none */
	public String text() {
		final Object value = get();
		if (value == null)
			return "";
		if (value instanceof ImagePlus image)
			return image.getTitle();
		if (value instanceof Double number && number == Math.rint(number) && Math.abs(number) < 1e9)
			return String.format(Locale.ROOT, "%.0f", number);
		return value.toString();
	}

	/** @return the value that the Command has before anybody fills it in, as text */
	public String byDefault() {
		try {
			return new FormField(command.getClass().getDeclaredConstructor().newInstance(), field)
				.text();
		} catch (final ReflectiveOperationException e) {
			throw new IllegalStateException(e);
		}
	}

	/**
	 * @param text what was typed; blank for none, where none is a value
	 * @throws UserException if it is not allowed; one sentence that
	 *           names key, value and what is
	 */
	public void set(final String text) {
		try {
			field.set(command, value(text.strip()));
		} catch (final IllegalAccessException e) {
			throw new IllegalStateException(e);
		}
	}

	private Object value(final String text) {
		return switch (kind) {
			case WHOLE -> whole(text);
			case NUMBER -> number(text);
			case FLAG -> OptionText.flag(key(), text);
			case CHOICE -> choice(text);
			case FILE, FOLDER -> text.isEmpty() ? null : new File(text);
			case IMAGE -> text.isEmpty() ? null : image(text);
			default -> text;
		};
	}

	private Object whole(final String text) {
		final double value = number(text);
		if (value != Math.rint(value))
			throw refusal(text);
		if (field.getType() == long.class)
			return (long) value;
		return (int) value;
	}

	private double number(final String text) {
		final double value;
		try {
			value = OptionText.number(key(), text);
		} catch (final UserException e) {
			throw refusal(text);
		}
		if (!isInRange(value))
			throw refusal(text);
		return value;
	}

	private boolean isInRange(final double value) {
		final double least = parameter.min().isEmpty()
			? field.getType() == int.class ? Integer.MIN_VALUE : Double.NEGATIVE_INFINITY
			: Double.parseDouble(parameter.min());
		final double most = parameter.max().isEmpty()
			? field.getType() == int.class ? Integer.MAX_VALUE : Double.POSITIVE_INFINITY
			: Double.parseDouble(parameter.max());
		return value >= least && value <= most;
	}

	private String choice(final String text) {
		return Arrays.stream(parameter.choices()).filter(text::equalsIgnoreCase).findFirst()
			.orElseThrow(() -> refusal(text));
	}

	private ImagePlus image(final String title) {
		return openImage(title).orElseThrow(() -> refusal(title));
	}

	/**
	 * @param title title of an image
	 * @return the open image of that title, of two the active one; empty if there is none
	 */
	public static Optional<ImagePlus> openImage(final String title) {
		final ImagePlus active = WindowManager.getCurrentImage();
		return Optional.ofNullable(active != null && title.equals(active.getTitle())
			? active
			: WindowManager.getImage(title));
	}

	/**
	 * Checks a value that did not come from text.
	 *
	 * @throws UserException if it is not allowed, as for
	 *           {@link #set(String)}
	 */
	void check() {
		final Object value = get();
		if (value instanceof Number number && !isInRange(number.doubleValue()))
			throw refusal(value.toString());
		if (kind == Kind.CHOICE)
			choice(value == null ? "" : value.toString());
	}

	private Object get() {
		try {
			return field.get(command);
		} catch (final IllegalAccessException e) {
			throw new IllegalStateException(e);
		}
	}

	private UserException refusal(final String text) {
		return OptionText.refusal(key(), allowed(), text);
	}

	/** What kind of value a parameter takes. */
	public enum Kind {
		/** Any text. */
		TEXT("text"),
		/** One of a few words. */
		CHOICE("choice"),
		/** A whole number. */
		WHOLE("whole number"),
		/** A number. */
		NUMBER("number"),
		/** Yes or no. */
		FLAG("yes or no"),
		/** A file, or something that is read. */
		FILE("file"),
		/** A folder that is written. */
		FOLDER("folder"),
		/** An open image. */
		IMAGE("open image"),
		/** Nothing that a person fills in. */
		NONE("");

		private final String label;

		Kind(final String label) {
			this.label = label;
		}

		/** @return what people call it */
		public String label() {
			return label;
		}

		static Kind of(final Class<?> type, final Parameter parameter) {
			if (parameter.type() != ItemIO.INPUT)
				return NONE;
			if (type == String.class)
				return parameter.choices().length > 0 ? CHOICE : TEXT;
			if (type == int.class || type == long.class)
				return WHOLE;
			if (type == double.class)
				return NUMBER;
			if (type == boolean.class)
				return FLAG;
			if (type == File.class)
				return parameter.style().equals(FileWidget.DIRECTORY_STYLE) ? FOLDER : FILE;
			return type == ImagePlus.class ? IMAGE : NONE;
		}
	}
}
