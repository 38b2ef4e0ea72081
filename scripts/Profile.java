import java.io.IOException;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collection;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

import jdk.jfr.consumer.RecordedEvent;
import jdk.jfr.consumer.RecordedFrame;
import jdk.jfr.consumer.RecordingFile;

/** Tables of where a recorded run spent its time, and its stacks folded, for a flame graph. */
final class Profile {

	private static final String OURS = "io.github.knotresolver.";

	private final Map<String, Integer> self = new HashMap<>(), within = new HashMap<>();
	private final Map<String, Integer> folded = new TreeMap<>();
	private int samples;
	private long compiled, collected;

	/**
	 * @param args the recording; how many methods; optionally a file for the folded stacks
	 *          (one line each, frames from the outermost, then the number of samples)
	 */
	public static void main(final String[] args) throws IOException {
		final Profile profile = new Profile();
		try (RecordingFile file = new RecordingFile(Path.of(args[0]))) {
			while (file.hasMoreEvents())
				profile.add(file.readEvent());
		}
		profile.print(Integer.parseInt(args[1]));
		if (args.length > 2)
			profile.fold(Path.of(args[2]));
	}

	private void add(final RecordedEvent event) {
		switch (event.getEventType().getName()) {
			case "jdk.ExecutionSample" -> sample(event);
			case "jdk.CompilerStatistics" -> compiled = Math.max(compiled, event.getDuration("totalTimeSpent").toMillis());
			case "jdk.GCPhasePause" -> collected += event.getDuration().toNanos();
			default -> {
			}
		}
	}

	private void sample(final RecordedEvent event) {
		if (event.getStackTrace() == null)
			return;
		final List<RecordedFrame> frames = event.getStackTrace().getFrames();
		samples++;
		self.merge(name(frames.get(0)), 1, Integer::sum);
		final Collection<String> ours = new HashSet<>();
		final StringBuilder stack = new StringBuilder();
		for (int i = frames.size() - 1; i >= 0; i--) {
			final String name = name(frames.get(i));
			stack.append(name).append(i > 0 ? ";" : "");
			if (frames.get(i).getMethod().getType().getName().startsWith(OURS))
				ours.add(name);
		}
		ours.forEach(name -> within.merge(name, 1, Integer::sum));
		folded.merge(stack.toString(), 1, Integer::sum);
	}

	private static String name(final RecordedFrame frame) {
		final String type = frame.getMethod().getType().getName();
		return type.substring(type.lastIndexOf('.') + 1) + "." + frame.getMethod().getName();
	}

	private void print(final int methods) {
		System.out.printf("%d samples; besides: %.1f s compiling, %.1f s collecting garbage%n%n",
			samples, compiled / 1e3, collected / 1e9);
		table("method, itself", self, methods);
		System.out.println();
		table("method, with what it calls", within, methods);
	}

	private void table(final String title, final Map<String, Integer> counts, final int methods) {
		System.out.println("| " + title + " | % |");
		System.out.println("|---|---|");
		final Map<String, Integer> most = new LinkedHashMap<>();
		counts.entrySet().stream().sorted(Map.Entry.<String, Integer> comparingByValue().reversed()
			.thenComparing(Map.Entry.comparingByKey())).limit(methods)
			.forEach(e -> most.put(e.getKey(), e.getValue()));
		most.forEach((name, count) -> System.out.printf("| %s | %.1f |%n", name, 100.0 * count / samples));
	}

	private void fold(final Path file) throws IOException {
		try (PrintWriter out = new PrintWriter(Files.newBufferedWriter(file, StandardCharsets.UTF_8))) {
			folded.forEach((stack, count) -> out.println(stack + " " + count));
		}
	}
}
