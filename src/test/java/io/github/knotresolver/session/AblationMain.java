package io.github.knotresolver.session;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.lang.reflect.Field;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;

/**
 * Resolves movies for {@code scripts/ablation} with one constant changed at a time, in one warm JVM
 * of a build in which the constants are not final.
 */
public final class AblationMain {

	private AblationMain() {
	}

	/**
	 * Answers each line of the standard input with a line, {@code done} or why it failed.
	 * The fields of a line, tabs between them: class, constant, factor, largest value, folder of the
	 * results, movies. A constant is as it was for the line after.
	 *
	 * @param args none
	 * @throws IOException if the standard input cannot be read
	 */
	public static void main(final String[] args) throws IOException {
		final BufferedReader lines = new BufferedReader(
			new InputStreamReader(System.in, StandardCharsets.UTF_8));
		for (String line = lines.readLine(); line != null; line = lines.readLine()) {
			String answer = "done";
			try {
				run(line.split("\t"));
			} catch (final Exception | Error e) {
				answer = String.valueOf(e).replaceAll("\\s+", " ");
			}
			System.out.println(answer);
		}
	}

	private static void run(final String[] fields)
		throws IOException, ReflectiveOperationException {
		final Field constant = Class.forName(fields[0]).getDeclaredField(fields[1]);
		constant.setAccessible(true);
		final double factor = Double.parseDouble(fields[2]), most = Double.parseDouble(fields[3]);
		final Object before = constant.get(null);
		if (before instanceof Integer)
			constant.setInt(null, (int) Math.max(1, Math.rint(factor * (Integer) before)));
		else
			constant.setDouble(null, Math.min(most, factor * (Double) before));
		try {
			final List<Path> movies = Arrays.stream(fields).skip(5).map(Path::of).toList();
			new BenchmarkMain(Path.of(fields[4])).run("default", movies);
		} finally {
			constant.set(null, before);
		}
	}
}
