package io.github.knotresolver.imagej.form;

import java.io.File;

import org.scijava.ItemIO;
import org.scijava.plugin.Parameter;
import org.scijava.widget.FileWidget;

import ij.ImagePlus;

/** What kind of value a parameter takes. */
public enum FieldKind {
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

	FieldKind(final String label) {
		this.label = label;
	}

	/** @return what people call it */
	public String label() {
		return label;
	}

	static FieldKind of(final Class<?> type, final Parameter parameter) {
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
