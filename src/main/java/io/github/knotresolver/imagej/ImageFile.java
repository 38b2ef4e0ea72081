
package io.github.knotresolver.imagej;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.Set;

import ij.ImagePlus;
import ij.io.FileInfo;
import ij.io.Opener;
import ij.io.TiffDecoder;

import io.github.knotresolver.model.UserException;

/**
 * An image file, opened with ImageJ's own readers, or refused in one sentence:
 * missing, empty, cut off, or not an image.
 */
public final class ImageFile {

	/** The kinds of file that hold pixels. */
	private static final Set<Integer> IMAGES = Set.of(Opener.TIFF, Opener.DICOM,
		Opener.TIFF_AND_DICOM, Opener.FITS, Opener.PGM, Opener.JPEG, Opener.GIF, Opener.BMP,
		Opener.ZIP, Opener.PNG, Opener.AVI);

	private ImageFile() {
	}

	/**
	 * @param file an image file that plain ImageJ reads
	 * @return the image
	 * @throws UserException if it is not one, in one sentence
	 */
	public static ImagePlus open(final Path file) {
		requireFile(file);
		final int type = new Opener().getFileType(file.toString());
		if (!IMAGES.contains(type))
			throw notAnImage(file);
		if (type == Opener.TIFF)
			requireWhole(file);
		final QuietImageJ.Outcome<ImagePlus> opened = QuietImageJ.call(() -> read(file));
		if (opened.value() == null)
			throw notAnImage(file);
		if (opened.printed().contains("Exception"))
			throw new UserException(file
				+ " is damaged: ImageJ could not read all of its pixels; copy the file again from its source.");
		return opened.value();
	}

	/**
	 * @param image an image
	 * @return the file that it was opened from; empty if there is none, or if the
	 *         image was changed since
	 */
	public static Optional<Path> of(final ImagePlus image) {
		final FileInfo info = image.getOriginalFileInfo();
		if (info == null || image.changes || info.directory == null || info.fileName == null)
			return Optional.empty();
		final Path file = Path.of(info.directory, info.fileName).toAbsolutePath().normalize();
		return Files.isRegularFile(file) ? Optional.of(file) : Optional.empty();
	}

	private static ImagePlus read(final Path file) {
		try {
			final Opener opener = new Opener();
			opener.setSilentMode(true);
			return opener.openImage(file.toString());
		} catch (final RuntimeException e) {
			return null;
		}
	}

	private static void requireFile(final Path file) {
		if (!Files.exists(file))
			throw new UserException("There is no file " + file + "; check the path.");
		if (Files.isDirectory(file))
			throw new UserException(
				file + " is a folder, but a movie is one image file; name the file.");
		if (!Files.isReadable(file))
			throw new UserException(file + " may not be read; check its permissions.");
		try {
			if (Files.size(file) == 0)
				throw new UserException(
					file + " is empty (0 bytes); copy the file again from its source.");
		} catch (final IOException e) {
			throw new UserException(file + " cannot be read: " + e.getMessage() + ".",
				e);
		}
	}

	private static void requireWhole(final Path file) {
		try {
			if (TiffFile.isComplete(file) && frameDataAreComplete(file))
				return;
		} catch (final IOException e) {
			throw new UserException(file + " cannot be read: " + e.getMessage() + ".",
				e);
		}
		throw new UserException(file
			+ " is cut off: the file ends before its last frame; copy the file again from its source.");
	}

	/** ImageJ's own stacks have one directory for many frames in a row. */
	private static boolean frameDataAreComplete(final Path file) throws IOException {
		final QuietImageJ.Outcome<FileInfo[]> outcome = QuietImageJ.call(() -> infos(file));
		if (outcome.value() == null || outcome.value().length == 0)
			return false;
		final FileInfo info = outcome.value()[0];
		if (info.nImages <= 1)
			return true;
		final long frame = (long) info.width * info.height * info.getBytesPerPixel();
		return info.getOffset() + info.nImages * frame + (info.nImages - 1) * info.getGap() <= Files
			.size(file);
	}

	private static FileInfo[] infos(final Path file) {
		try {
			final Path folder = file.toAbsolutePath().getParent();
			return new TiffDecoder(folder + File.separator, file.getFileName().toString())
				.getTiffInfo();
		} catch (final IOException | RuntimeException e) {
			return null;
		}
	}

	private static UserException notAnImage(final Path file) {
		return new UserException(file
			+ " is not an image that ImageJ can open; save the movie as a TIFF stack of 8, 16 or 32 bit.");
	}
}
