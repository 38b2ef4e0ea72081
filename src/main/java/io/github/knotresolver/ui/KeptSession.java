package io.github.knotresolver.ui;

import java.util.List;

import io.github.knotresolver.model.Constraint;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.Settings;
import io.github.knotresolver.model.Tracks;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.run.Engine;
import io.github.knotresolver.session.Session;
import io.github.knotresolver.ui.model.Solver;

/** The engine of one run, which remembers what it worked out, so that its result can be reviewed. */
public final class KeptSession implements Engine, Solver {

	private Session session;

	@Override
	public Tracks resolve(final Movie movie, final Settings settings, final Progress progress) {
		session = new Session(movie, settings.edit().constraints(List.of()).build());
		return session.solve(settings.constraints(), progress);
	}

	@Override
	public Tracks solve(final List<Constraint> said, final Progress progress) {
		return session.solve(said, progress);
	}
}
