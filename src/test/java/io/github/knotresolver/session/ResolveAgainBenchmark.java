package io.github.knotresolver.session;

import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;

import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

import io.github.knotresolver.fit.DrawnMovie;
import io.github.knotresolver.fit.LineModel;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.imagej.ImageFile;
import io.github.knotresolver.imagej.ImageMovie;
import io.github.knotresolver.model.Constraint;
import io.github.knotresolver.model.Constraint.Kind;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.Settings;
import io.github.knotresolver.model.Tracks;
import io.github.knotresolver.options.InputOptions;
import io.github.knotresolver.progress.Progress;

/**
 * Guards the promise that a movie of 120 frames that was resolved is resolved again within
 * half a second after one more word of the user, on two cores. Each time another frame is
 * spoken of, so that nothing of the answer is known before. The movie is a drawn one unless
 * {@code -p movie=FILE} names another.
 */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.SingleShotTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Fork(1)
@Warmup(iterations = 8)
@Measurement(iterations = 16)
public class ResolveAgainBenchmark {

	private static final String DRAWN = "drawn";
	private static final int FRAMES = 120, STRIDE = 37;

	/** A movie's file, or the drawn one. */
	@Param(DRAWN)
	public String movie;

	/** What is said of the frame. */
	@Param({"CONTOUR", "THROUGH", "TIP", "NOT"})
	public Kind kind;

	private Session session;
	private Tracks silent;
	private int asked;
	private Constraint said;

	/** Opens the movie and resolves it. */
	@Setup(Level.Trial)
	public void resolve() {
		final Movie frames = movie.equals(DRAWN)
			? DrawnMovie.draw(DrawnMovie.waves(FRAMES, 80, 3.6), List.of(),
				LineModel.uniform(LineModel.Kind.ADDITIVE, 1.6, 1), 0.05, 41).movie()
			: ImageMovie.of(ImageFile.open(Path.of(movie)), InputOptions.DEFAULT);
		session = new Session(frames, Settings.DEFAULT);
		silent = session.solve(List.of(), Progress.NONE);
	}

	/** Chooses a frame that has not been spoken of, and what is said of it. */
	@Setup(Level.Iteration)
	public void speak() {
		Polyline contour;
		int frame;
		do {
			frame = asked++ * STRIDE % silent.movie().size() + 1;
			contour = silent.only().frames().get(frame - 1).contour().orElse(null);
		} while (contour == null);
		said = new Constraint(1, frame, kind, switch (kind) {
			case CONTOUR -> bent(contour);
			case NOT -> contour;
			case THROUGH -> Polyline.of(List.of(contour.point(contour.size() / 2)));
			case TIP -> Polyline.of(List.of(contour.last()));
			default -> throw new IllegalStateException(kind + " decides no contour.");
		});
	}

	/** Drawn by hand: up to 6 pixels beside the line. */
	private static Polyline bent(final Polyline contour) {
		final double[] x = contour.xs();
		for (int i = 0; i < x.length; i++)
			x[i] += 6.0 * i / x.length;
		return Polyline.of(x, contour.ys());
	}

	/** The answer after one more word. */
	@Benchmark
	public Tracks again() {
		return session.solve(List.of(said), Progress.NONE);
	}
}
