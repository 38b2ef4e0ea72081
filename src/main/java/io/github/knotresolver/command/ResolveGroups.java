package io.github.knotresolver.command;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

import io.github.knotresolver.imagej.form.FormGroups;
import io.github.knotresolver.imagej.form.FormGroups.Group;
import io.github.knotresolver.options.Option;
import io.github.knotresolver.options.Option.Section;
import io.github.knotresolver.options.ResolveOptions;

/** How the dialog of {@link ResolveFilamentCommand} is divided: as the options are. */
final class ResolveGroups {

	/** What everyone meets. */
	private static final List<String> BASIC = List.of("image", "movie", "filaments", "channel",
		"frames", "length", "out");

	/** What is done with a result is told to this Command alone. */
	private static final List<String> RESULT = List.of("overlay", "roi_manager", "tables", "plots",
		"force");

	static final FormGroups ALL = all();

	private ResolveGroups() {
	}

	private static FormGroups all() {
		final List<Group> advanced = new ArrayList<>();
		for (final Section section : Section.values()) {
			final List<String> names = new ArrayList<>(
				ResolveOptions.ALL.stream().filter(option -> option.section() == section)
					.map(Option::key).filter(key -> !BASIC.contains(key)).toList());
			// It comes before the threshold in the flow of data, and its two values beside each other.
			names.sort(Comparator.comparing(key -> !key.startsWith("log_")));
			if (section == Section.RUN)
				names.addAll(RESULT);
			advanced.add(new Group(section.heading(), names));
		}
		return new FormGroups(BASIC, advanced);
	}
}
