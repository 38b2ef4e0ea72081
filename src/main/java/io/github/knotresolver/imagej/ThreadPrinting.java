package io.github.knotresolver.imagej;

import java.io.OutputStream;
import java.io.PrintStream;

/**
 * Standard output and standard error of one thread, and of those that it starts, somewhere
 * else: for libraries that print. So does what AWT's decoders of pictures print, whose threads
 * belong to nobody. What other threads print goes where it went before.
 */
final class ThreadPrinting extends OutputStream {

	private static final ThreadLocal<PrintStream> OWN = new InheritableThreadLocal<>();

	/** How AWT calls the threads that decode pictures. */
	private static final String DECODER = "Image Fetcher";

	private static volatile PrintStream latest;

	private final PrintStream usual;

	private ThreadPrinting(final PrintStream usual) {
		this.usual = usual;
	}

	/**
	 * @param own where this thread prints from now on
	 */
	static synchronized void to(final PrintStream own) {
		if (!(System.out instanceof Routed))
			System.setOut(new Routed(System.out));
		if (!(System.err instanceof Routed))
			System.setErr(new Routed(System.err));
		OWN.set(own);
		latest = own;
	}

	private PrintStream target() {
		final PrintStream own = Thread.currentThread().getName().startsWith(DECODER)
			? latest
			: OWN.get();
		return own == null ? usual : own;
	}

	@Override
	public void write(final int b) {
		target().write(b);
	}

	@Override
	public void write(final byte[] bytes, final int from, final int count) {
		target().write(bytes, from, count);
	}

	@Override
	public void flush() {
		target().flush();
	}

	/** Leaves it to the thread's stream how text becomes bytes. */
	private static final class Routed extends PrintStream {

		private final ThreadPrinting printing;

		Routed(final PrintStream usual) {
			this(new ThreadPrinting(usual));
		}

		private Routed(final ThreadPrinting printing) {
			super(printing, true);
			this.printing = printing;
		}

		@Override
		public void print(final String text) {
			printing.target().print(text);
		}
	}
}
