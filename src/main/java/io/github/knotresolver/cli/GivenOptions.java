package io.github.knotresolver.cli;

import java.util.Map;
import java.util.TreeMap;

import io.github.knotresolver.options.Option;
import io.github.knotresolver.options.Option.Kind;
import io.github.knotresolver.options.ResolveOptions;
import picocli.CommandLine;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;

/**
 * The options that decide a result, on the command line: all of
 * {@link ResolveOptions}. Their texts are read and checked by
 * {@link io.github.knotresolver.options.RunOptions}, under the same names.
 */
final class GivenOptions {

	private GivenOptions() {
	}

	/**
	 * @param subcommand a subcommand of picocli
	 * @return it, taking these options after its own
	 */
	static CommandLine taking(final Object subcommand) {
		final CommandSpec spec = CommandSpec.forAnnotatedObject(subcommand);
		ResolveOptions.ALL.forEach(option -> spec.addOption(shown(option)));
		return new CommandLine(spec);
	}

	private static OptionSpec shown(final Option option) {
		final OptionSpec.Builder shown = OptionSpec.builder(option.name())
			.description(option.help() + " [" + option.byDefault() + "].");
		if (option.kind() != Kind.FLAG)
			return shown.type(String.class).arity("1").paramLabel(option.values()).build();
		final boolean on = option.byDefault().equals("on");
		return shown.type(boolean.class).arity("0").negatable(on).defaultValue(Boolean.toString(on))
			.fallbackValue("true").build();
	}

	/**
	 * @param spec a subcommand with these options, parsed
	 * @return the options that were given, by the keys that all front doors share
	 */
	static Map<String, String> of(final CommandSpec spec) {
		final Map<String, String> texts = new TreeMap<>();
		for (final OptionSpec option : spec.commandLine().getParseResult().matchedOptions()) {
			final String key = option.longestName().substring(2).replace('-', '_');
			if (ResolveOptions.KEYS.contains(key))
				texts.put(key, String.valueOf(option.<Object>getValue()));
		}
		return texts;
	}
}
