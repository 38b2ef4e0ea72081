package io.github.knotresolver.imagej.tiff;

import java.nio.ByteOrder;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.IntStream;

import io.github.knotresolver.model.UserException;

/**
 * Which kind of TIFF a file is: one that ImageJ reads right, one that a library
 * must read, or one that is not read here, with the reason.
 */
final class TiffKind {

	private static final Set<Integer> READ = Set.of(1, 2, 3, 4, 5, 6, 7, 8, 32773, 32946);
	private static final Map<Integer, String> NAMES = Map.ofEntries(Map.entry(34712, "JPEG 2000"),
		Map.entry(33003, "JPEG 2000"), Map.entry(33005, "JPEG 2000"), Map.entry(34925, "LZMA"),
		Map.entry(50000, "Zstandard"), Map.entry(50001, "WebP"), Map.entry(50002, "JPEG XL"),
		Map.entry(52546, "JPEG XL"), Map.entry(34887, "LERC"), Map.entry(34892, "lossy JPEG"),
		Map.entry(32809, "ThunderScan"), Map.entry(34676, "SGI Log"), Map.entry(34661, "JBIG"));
	/** Differences, and differences of floating-point numbers. */
	private static final int LAST_PREDICTOR = 3;
	private static final String SAVE = "; save it without compression, or with LZW or Deflate.";

	private final TiffStructure tiff;
	private final List<Integer> frames;
	private final TiffPage first;

	/**
	 * @param tiff a file's structure
	 * @throws UserException if it is not read here, in one sentence with the reason
	 */
	TiffKind(final TiffStructure tiff) {
		this.tiff = tiff;
		final List<TiffPage> pages = tiff.pages();
		frames = IntStream.range(0, pages.size()).filter(i -> !pages.get(i).isReduced()).boxed()
			.toList();
		if (frames.isEmpty())
			throw TiffStructure.damaged(tiff.path(), "it holds thumbnails only");
		first = pages.get(frames.get(0));
		requireAlike(pages);
		requireReadable(tiff.path());
	}

	/** @return indices of the images that are no thumbnails, from 0; at least one */
	List<Integer> frames() {
		return frames;
	}

	/** @return the first image that is no thumbnail */
	TiffPage first() {
		return first;
	}

	/**
	 * @param i index of an image of the file, from 0
	 * @return its directory
	 */
	TiffPage page(final int i) {
		return tiff.pages().get(i);
	}

	/** @return the order of the bytes in a number */
	ByteOrder order() {
		return tiff.order();
	}

	/** @return whether ImageJ reads all of it, and right */
	boolean isForImageJ() {
		return !tiff.isBig()
			&& isInARow() && frames.size() == tiff.pages().size() && frames.stream()
				.map(tiff.pages()::get).allMatch(p -> p.compression() == 1 && !p.isTiled())
			&& isForImageJ(first);
	}

	/**
	 * Where ImageJ's lines tell of several images, ImageJ takes them to follow each
	 * other without a gap, whatever their own directories say.
	 */
	private boolean isInARow() {
		if (!first.description().startsWith("ImageJ=") || frames.size() == 1)
			return true;
		final long[] start = first.values(TiffPage.STRIP_OFFSETS);
		for (int i = 0; i < frames.size(); i++) {
			final long[] own = tiff.pages().get(frames.get(i)).values(TiffPage.STRIP_OFFSETS);
			if (own.length == 0 || start.length == 0
				|| own[0] != start[0] + i * (long) first.bytes())
				return false;
		}
		return true;
	}

	/** Palettes of ImageJ's are false colours of intensities, others are not. */
	private static boolean isForImageJ(final TiffPage page) {
		if (page.photometric() == TiffPage.PALETTE && !page.description().startsWith("ImageJ="))
			return false;
		return switch (page.format()) {
			case TiffPage.UNSIGNED -> page.bits() <= 32;
			case TiffPage.SIGNED -> page.bits() == 16;
			case TiffPage.FLOAT -> page.bits() == 32;
			default -> false;
		} && (page.samples() == 1 || page.bits() == 8 || page.bits() == 16)
			&& (page.bits() != 32 || page.format() == TiffPage.FLOAT);
	}

	private void requireAlike(final List<TiffPage> pages) {
		for (final int i : frames)
			if (!pages.get(i).isLike(first))
				throw new UserException("All frames of a movie have one size, but in " + tiff.path()
					+ " image " + (i + 1) + " is " + pages.get(i) + ", the first " + first
					+ "; save those that belong together as a stack.");
	}

	private void requireReadable(final Path path) {
		final int compression = first.compression();
		if (!READ.contains(compression))
			throw new UserException(path + " is compressed with "
				+ NAMES.getOrDefault(compression, "method " + compression + " of TIFF")
				+ ", which is not read here" + SAVE);
		if (first.predictor() > LAST_PREDICTOR)
			throw new UserException(path + " is compressed with the predictor " + first.predictor()
				+ ", which is not read here" + SAVE);
		final int format = first.format(), bits = first.bits();
		if (format > TiffPage.FLOAT && format != 4)
			throw new UserException(path
				+ " holds complex numbers, but a movie has intensities; save their magnitude.");
		if (format == TiffPage.FLOAT
			? bits != 16 && bits != 32 && bits != 64
			: bits > 32 || bits < 1)
			throw new UserException(path + " holds "
				+ (format == TiffPage.FLOAT ? "floating-point" : "whole") + " numbers of " + bits
				+ " bit, which are not read here; save it with 8, 16 or 32 bit.");
		if (first.bytes() > Integer.MAX_VALUE)
			throw new UserException("The frames of " + path + " are " + first
				+ ", more than the 2 GiB a frame may have; cut the part that is needed out of it.");
	}
}
