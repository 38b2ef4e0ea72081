package io.github.knotresolver.cli;

import java.awt.GraphicsEnvironment;
import java.nio.file.Path;
import java.util.concurrent.Callable;
import java.util.concurrent.CountDownLatch;

import ij.ImageJ;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.ui.Reviews;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code knotresolver review}: a result folder in windows; ends when they are closed. */
@Command(name = ReviewSubcommand.NAME, mixinStandardHelpOptions = true, usageHelpAutoWidth = true, description = "Shows a result beside its movie, doubtful frames first, to be corrected; needs a display.%n")
final class ReviewSubcommand implements Callable<Integer> {

	/** What is typed. */
	static final String NAME = "review";

	@Spec
	private CommandSpec spec;

	@Parameters(paramLabel = "RESULT_DIR", description = "Folder that 'resolve' wrote.")
	private Path result;

	private final Progress progress;

	ReviewSubcommand(final Progress progress) {
		this.progress = progress;
	}

	@Override
	public Integer call() throws Exception {
		final CountDownLatch closed = new CountDownLatch(1);
		Usage.of(spec, () -> {
			if (GraphicsEnvironment.isHeadless())
				throw new UserException(
					"review needs a display; without one, give --corrections FILE to 'resolve'.");
			new ImageJ();
			Reviews.open(result, false, progress, closed::countDown);
			return null;
		});
		closed.await();
		return ExitStatus.FINISHED;
	}
}
