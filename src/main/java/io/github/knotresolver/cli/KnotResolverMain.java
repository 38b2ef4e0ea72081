package io.github.knotresolver.cli;

import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

import io.github.knotresolver.io.Failure;
import io.github.knotresolver.io.FailureLog;
import io.github.knotresolver.io.ProgramVersion;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.options.OptionText;
import io.github.knotresolver.progress.Cancellation;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.session.Engine;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.IVersionProvider;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.ScopeType;
import picocli.CommandLine.Spec;

/** {@code knotresolver}: the program's front door on the command line. */
@Command(name = "knotresolver", mixinStandardHelpOptions = true, usageHelpAutoWidth = true, versionProvider = KnotResolverMain.Version.class, description = "Tracks a self-intersecting filament through a microscopy movie.%n", footer = "%nExit status: 0 finished, 1 failed, 2 wrong usage or unreadable input, 130 cancelled.")
public final class KnotResolverMain implements Runnable {

	private static final String MORE_MEMORY = "give Java more, such as JAVA_OPTS=-Xmx8g";

	private static final Pattern KEY = Pattern
		.compile("(^|\\badd |(?<![\\w/.])(?=[a-z]+_))([a-z_]+)(?![\\w/]|\\.\\w)");

	@Spec
	private CommandSpec spec;

	@Option(names = "--debug", scope = ScopeType.INHERIT, description = "Print the whole trace of a failure.")
	private boolean debug;

	private KnotResolverMain() {
	}

	/**
	 * The program.
	 *
	 * @param args the arguments
	 */
	public static void main(final String[] args) {
		start(Engine.PIPELINE, args);
	}

	/**
	 * Runs the program as a process: it ends with its exit status, and cleans up
	 * when the user presses Ctrl-C.
	 *
	 * @param engine what resolves a movie
	 * @param args the arguments
	 */
	static void start(final Engine engine, final String... args) {
		final PrintWriter err = new PrintWriter(System.err, true, StandardCharsets.UTF_8);
		final ConsoleProgress progress = new ConsoleProgress(err);
		final Interruption interruption = Interruption.listen(progress::cancel);
		final int status = run(engine, progress,
			new PrintWriter(System.out, true, StandardCharsets.UTF_8), err, args);
		interruption.finished();
		System.exit(status);
	}

	/**
	 * Runs the program.
	 *
	 * @param engine what resolves a movie
	 * @param progress listens to it, and may cancel it
	 * @param out standard output
	 * @param err standard error
	 * @param args the arguments
	 * @return the exit status
	 */
	static int run(final Engine engine, final Progress progress, final PrintWriter out,
		final PrintWriter err, final String... args) {
		if (args.length == 0 || !args[0].equals(ReviewSubcommand.NAME))
			System.setProperty("java.awt.headless", "true");
		final KnotResolverMain program = new KnotResolverMain();
		final CommandLine line = new CommandLine(program)
			.addSubcommand(GivenOptions.taking(new ResolveSubcommand(engine, progress)))
			.addSubcommand(GivenOptions.taking(new BatchSubcommand(engine, progress)))
			.addSubcommand(new ReviewSubcommand(progress))
			.addSubcommand(new MeasureSubcommand(progress))
			.addSubcommand(new SimulateSubcommand(progress))
			.addSubcommand(new EvaluateSubcommand(engine, progress))
			.setCaseInsensitiveEnumValuesAllowed(true);
		line.setOut(out).setErr(err);
		line.setParameterExceptionHandler((e, a) -> refuse(err, e));
		line.setExecutionExceptionHandler((e, c, r) -> fail(err, c, e));
		line.setExecutionStrategy(parsed -> {
			FailureLog.PROCESS.echo(program.debug ? err::println : trace -> {
			});
			return Cancellation.during(progress, () -> new CommandLine.RunLast().execute(parsed));
		});
		try {
			return line.execute(args);
		} catch (final Error e) {
			return fail(err, line, e);
		} finally {
			out.flush();
			err.flush();
		}
	}

	@Override
	public void run() {
		throw new ParameterException(spec.commandLine(),
			"Say what to do, such as: knotresolver resolve MOVIE.tif --out DIR");
	}

	/** What an option of a Java type takes, in words. */
	private static String kind(final Class<?> type) {
		if (type.isEnum())
			return Arrays.stream(type.getEnumConstants())
				.map(c -> c.toString().toLowerCase(Locale.ROOT))
				.collect(Collectors.joining(" or "));
		if (type == Path.class)
			return "a file or folder";
		if (type == boolean.class || type == Boolean.class)
			return "true or false";
		final boolean fractions = type == double.class || type == Double.class;
		return fractions ? "a number" : "a whole number";
	}

	private static int refuse(final PrintWriter err, final ParameterException e) {
		if (e.getValue() != null && e.getArgSpec() instanceof OptionSpec option)
			return oneLine(err, OptionText
				.refusal(option.longestName(), kind(option.type()), e.getValue()).getMessage(),
				ExitStatus.USAGE);
		final boolean ours = e.getCause() instanceof UserException;
		if (ours)
			FailureLog.PROCESS.show(e.getCause());
		final String help = ours
			? ""
			: " (" + e.getCommandLine().getCommandSpec().qualifiedName() + " --help tells more)";
		return oneLine(err, asOption(e.getCommandLine(), e.getMessage()) + help, ExitStatus.USAGE);
	}

	private static int fail(final PrintWriter err, final CommandLine command,
		final Throwable cause) {
		final Failure failure = Failure.of(cause, MORE_MEMORY);
		final boolean cancelled = failure.kind() == Failure.Kind.CANCELLED;
		return oneLine(err, asOption(command, failure.sentence()),
			cancelled ? ExitStatus.CANCELLED : ExitStatus.FAILED);
	}

	private static int oneLine(final PrintWriter err, final String message, final int status) {
		err.println(message.strip().replaceAll("\\s*\\R\\s*", " "));
		return status;
	}

	/**
	 * Macros say {@code contraction_bias}, the command line {@code --contraction-bias}. A key is a
	 * message's first word, what is to be added, or has an underscore; other words only look alike.
	 */
	private static String asOption(final CommandLine command, final String message) {
		return KEY.matcher(message).replaceAll(match -> {
			final String option = "--" + match.group(2).replace('_', '-');
			final boolean known = command.getCommandSpec().findOption(option) != null;
			return Matcher.quoteReplacement(known ? match.group(1) + option : match.group());
		});
	}

	/** Says which version this is. */
	static final class Version implements IVersionProvider {

		@Override
		public String[] getVersion() {
			return new String[]{ProgramVersion.NAME + " " + ProgramVersion.get()};
		}
	}
}
