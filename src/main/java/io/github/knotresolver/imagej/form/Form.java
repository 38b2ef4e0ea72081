package io.github.knotresolver.imagej.form;

import java.lang.reflect.Field;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;

import org.scijava.plugin.Parameter;

import io.github.knotresolver.model.UserException;

/**
 * What a person or a macro fills in for a Command: its own parameters, in their
 * order.
 */
public final class Form {

	private final List<FormField> fields;

	private Form(final List<FormField> fields) {
		this.fields = List.copyOf(fields);
	}

	/**
	 * @param command a Command
	 * @return its form; values go straight into the Command
	 */
	public static Form of(final Object command) {
		final List<FormField> fields = new ArrayList<>();
		for (final Field field : command.getClass().getDeclaredFields())
			if (field.isAnnotationPresent(Parameter.class)) {
				final FormField one = new FormField(command, field);
				if (one.kind() != FormField.Kind.NONE)
					fields.add(one);
			}
		return new Form(fields);
	}

	/** @return the fields, in the order of the Command */
	public List<FormField> fields() {
		return fields;
	}

	/** @return all values as text, by the option's name */
	public Map<String, String> texts() {
		final Map<String, String> texts = new LinkedHashMap<>();
		fields.forEach(f -> texts.put(f.name(), f.text()));
		return texts;
	}

	/**
	 * Fills in values; what is not named keeps its default.
	 *
	 * @param texts values by key or name
	 * @throws UserException if there is no such key, or its value is not
	 *           allowed; in one sentence
	 */
	public void fill(final Map<String, String> texts) {
		texts.forEach((key, text) -> field(key).set(text));
	}

	/**
	 * Fills in the options of a macro.
	 *
	 * @param options what the macro says, such as
	 *          {@code threshold=0.4 out=[/my folder] force}
	 * @throws UserException likewise
	 */
	public void fill(final MacroOptions options) {
		final Set<FormField> named = new HashSet<>();
		options.values().forEach((key, text) -> {
			final FormField field = field(key);
			if (!named.add(field))
				throw new UserException("The keys '" + field.key() + "' and '" + field.name()
					+ "' mean the same; name one of them.");
			if (text.isEmpty() && field.kind() != FormField.Kind.FLAG)
				throw new UserException(key + " needs a value, such as " + key + "=[" + field.text()
					+ "]; it must be " + field.allowed() + ".");
			field.set(text.orElse("true"));
		});
	}

	/**
	 * Checks all values, wherever they came from.
	 *
	 * @throws UserException if one is not allowed, in one sentence
	 */
	public void check() {
		fields.forEach(FormField::check);
	}

	/**
	 * @param key a key or a name
	 * @return the option's name; the key itself if there is none
	 */
	public String name(final String key) {
		return fields.stream().filter(f -> f.isCalled(key)).map(FormField::name).findFirst()
			.orElse(key);
	}

	/**
	 * @param sentence why a Command refuses
	 * @return the field that it is about: the one that it begins with, or else the first that it
	 *         names by a key with an underscore
	 */
	public Optional<FormField> mentioned(final String sentence) {
		final String[] words = sentence.split("[^A-Za-z_]+");
		return Stream
			.concat(Stream.of(words).limit(1), Stream.of(words).filter(w -> w.contains("_")))
			.flatMap(word -> fields.stream().filter(f -> f.isCalled(word))).findFirst();
	}

	private FormField field(final String key) {
		return fields.stream().filter(f -> f.isCalled(key)).findFirst()
			.orElseThrow(() -> new UserException("There is no key '" + key + "'; the keys are "
				+ fields.stream().map(FormField::key).collect(Collectors.joining(", ")) + "."));
	}
}
