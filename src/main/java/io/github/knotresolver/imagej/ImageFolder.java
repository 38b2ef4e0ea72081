package io.github.knotresolver.imagej;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.stream.Stream;

import ij.ImagePlus;
import ij.ImageStack;
import ij.util.StringSorter;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.progress.Progress;

/** A folder with one image a frame: PNG, JPEG, TIFF, BMP, PGM, GIF or DICOM files. */
final class ImageFolder {

	private static final Set<String> ENDINGS = Set.of("png", "jpg", "jpeg", "tif", "tiff", "bmp",
		"pgm", "gif", "dcm");

	private ImageFolder() {
	}

	/**
	 * @param folder its images are frames, in the order of the numbers in their names
	 * @param progress may cancel
	 * @return the movie
	 * @throws UserException if there are none, or they do not fit each other; in one
	 *           sentence
	 */
	static ImagePlus open(final Path folder, final Progress progress) {
		final List<Path> files = files(folder);
		if (files.isEmpty())
			throw new UserException(folder
				+ " is a folder without images, but a movie is one image file, or a folder with one image a frame (PNG, JPEG, TIFF); name another one.");
		final ImagePlus first = frame(files.get(0), progress);
		final ImageStack stack = new ImageStack(first.getWidth(), first.getHeight());
		for (final Path file : files) {
			progress.checkCancelled();
			progress.report("Reading", (double) stack.size() / files.size());
			final ImagePlus frame = stack.size() == 0 ? first : frame(file, progress);
			requireLike(first, frame, file);
			stack.addSlice(file.getFileName().toString(), frame.getProcessor());
		}
		final Path place = folder.toAbsolutePath().normalize();
		final ImagePlus movie = new ImagePlus(place.getFileName().toString(), stack);
		movie.setDimensions(1, 1, stack.size());
		movie.setCalibration(first.getCalibration());
		ImageFile.remember(movie, place);
		return movie;
	}

	private static List<Path> files(final Path folder) {
		try (Stream<Path> all = Files.list(folder)) {
			final String[] names = all.filter(ImageFolder::isImage)
				.map(p -> p.getFileName().toString()).sorted().toArray(String[]::new);
			return Stream.of(StringSorter.sortNumerically(names)).map(folder::resolve).toList();
		} catch (final IOException e) {
			throw new UserException(
				"The folder " + folder + " cannot be read: " + e.getMessage() + ".", e);
		}
	}

	private static boolean isImage(final Path file) {
		final String name = file.getFileName().toString().toLowerCase(Locale.ROOT);
		return !name.startsWith(".") && ENDINGS.contains(name.substring(name.lastIndexOf('.') + 1))
			&& Files.isRegularFile(file);
	}

	private static ImagePlus frame(final Path file, final Progress progress) {
		final ImagePlus frame = GreyImage.of(ImageFile.open(file, progress));
		if (frame.getStackSize() != 1)
			throw new UserException(file + " has " + frame.getStackSize()
				+ " images, but in a folder that is a movie each file is one frame; name the file itself.");
		return frame;
	}

	private static void requireLike(final ImagePlus first, final ImagePlus frame, final Path file) {
		if (frame.getWidth() != first.getWidth() || frame.getHeight() != first.getHeight()
			|| frame.getBitDepth() != first.getBitDepth())
			throw new UserException("All frames of a movie have one size, but " + file + " is "
				+ describe(frame) + ", the first " + describe(first)
				+ "; put those that belong together into a folder of their own.");
	}

	private static String describe(final ImagePlus image) {
		return image.getWidth() + " x " + image.getHeight() + " of " + image.getBitDepth() + " bit";
	}
}
