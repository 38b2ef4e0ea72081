package io.github.knotresolver.imagej.form;

import java.util.List;

/**
 * How the fields of a form are put before a person: those that everyone meets, and the others in
 * groups that are closed at first.
 *
 * @param basic names of the fields that are seen at once, in order; empty for all fields of the form
 * @param advanced the others
 */
public record FormGroups(List<String> basic, List<Group> advanced) {

	/** All fields at once, in the order of the form. */
	public static final FormGroups NONE = new FormGroups(List.of(), List.of());

	/**
	 * Fields about one thing.
	 *
	 * @param heading what they are about
	 * @param names of the fields, in order
	 */
	public record Group(String heading, List<String> names) {

		public Group {
			names = List.copyOf(names);
		}
	}

	public FormGroups {
		basic = List.copyOf(basic);
		advanced = List.copyOf(advanced);
	}
}
