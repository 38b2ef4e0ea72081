
package io.github.knotresolver.imagej;

import java.io.File;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.Set;

import ij.ImagePlus;
import ij.ImageStack;
import ij.io.FileInfo;
import ij.io.Opener;
import ij.plugin.AVI_Reader;
import io.github.knotresolver.imagej.tiff.TiffImage;
import io.github.knotresolver.imagej.tiff.TiffStructure;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.progress.Progress;

/**
 * A movie's file, or a folder of its frames, opened as dragging it onto ImageJ does;
 * or refused in one sentence: missing, empty, cut off, not an image, of a kind that
 * is not read.
 */
public final class ImageFile {

	/** The kinds of file that hold pixels, besides TIFF. */
	private static final Set<Integer> IMAGES = Set.of(Opener.DICOM, Opener.TIFF_AND_DICOM,
		Opener.FITS, Opener.PGM, Opener.JPEG, Opener.GIF, Opener.BMP, Opener.ZIP, Opener.PNG,
		Opener.AVI);
	/** Their palettes are no false colours of intensities, but all there is. */
	private static final Set<Integer> WITH_PALETTE = Set.of(Opener.BMP, Opener.PNG);

	private ImageFile() {
	}

	/**
	 * @param file an image file, or a folder with one image a frame
	 * @return the image
	 * @throws UserException if it is not one, in one sentence
	 */
	public static ImagePlus open(final Path file) {
		return open(file, Progress.NONE);
	}

	/**
	 * @param file an image file, or a folder with one image a frame
	 * @param progress may cancel, whatever is in the file
	 * @return the image
	 * @throws UserException if it is not one, in one sentence
	 */
	public static ImagePlus open(final Path file, final Progress progress) {
		requireFile(file);
		if (Files.isDirectory(file))
			return ImageFolder.open(file, progress);
		try {
			final QuietImageJ.Printed<ImagePlus> opened = QuietImageJ
				.call(() -> read(file, progress), progress);
			requireAll(file, opened.printed());
			return opened.value();
		} catch (final OutOfMemoryError e) {
			throw new UserException("There is not enough memory for " + file
				+ "; give Java more (JAVA_OPTS=-Xmx8g), or cut the movie.", e);
		} catch (final IOException e) {
			throw new UserException(file + " cannot be read: " + e.getMessage() + ".", e);
		} catch (final RuntimeException e) {
			throw e;
		} catch (final Exception e) {
			throw notAnImage(file, e);
		}
	}

	/** ImageJ tells only the log, if at all, what it could not read. */
	private static void requireAll(final Path file, final String printed) {
		if (printed.contains("Out of memory"))
			throw new UserException("There is not enough memory for " + file
				+ ": not all frames were read; give Java more (JAVA_OPTS=-Xmx8g), or cut the movie.",
				new OutOfMemoryError());
		if (printed.contains("Exception"))
			throw new UserException(file
				+ " is damaged: ImageJ could not read all of its pixels; copy the file again from its source.");
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
		return Files.exists(file) ? Optional.of(file) : Optional.empty();
	}

	/** Tells an image where it was read from. */
	static void remember(final ImagePlus image, final Path file) {
		final FileInfo info = image.getOriginalFileInfo() == null
			? new FileInfo()
			: image.getOriginalFileInfo();
		info.directory = file.toAbsolutePath().normalize().getParent() + File.separator;
		info.fileName = file.getFileName().toString();
		image.setFileInfo(info);
	}

	private static ImagePlus read(final Path file, final Progress progress) throws IOException {
		if (TiffStructure.isTiff(file))
			return TiffImage.open(file, progress);
		final int type = new Opener().getFileType(file.toString());
		if (!IMAGES.contains(type))
			throw notAnImage(file, null);
		final ImagePlus image = switch (type) {
			case Opener.GIF -> GifFile.open(file, progress);
			case Opener.ZIP -> ZippedMovie.open(file, progress);
			default -> byImageJ(file, type);
		};
		if (image == null)
			throw notRead(file, null);
		PictureEnd.require(file, type, image);
		if (WITH_PALETTE.contains(type))
			GreyImage.applyPalette(image);
		if (type == Opener.AVI && image.getNFrames() == 1)
			image.setDimensions(1, 1, image.getStackSize());
		remember(image, file);
		return image;
	}

	private static ImagePlus byImageJ(final Path file, final int type) {
		try {
			if (type == Opener.AVI)
				return film(file);
			final Opener opener = new Opener();
			opener.setSilentMode(true);
			return opener.openImage(file.toString());
		} catch (final UserException e) {
			throw e;
		} catch (final RuntimeException e) {
			// ImageJ's readers fail in many ways at a file that is damaged.
			throw notRead(file, e);
		}
	}

	/** ImageJ's reader gives the frames before an error, and tells of the error if asked. */
	private static ImagePlus film(final Path file) {
		final AVI_Reader reader = new AVI_Reader();
		final ImageStack frames = reader.makeStack(file.toString(), 1, 0, false, false, false);
		final String error = reader.getErrorText();
		if (error != null || frames == null || frames.size() == 0)
			throw new UserException(file + " cannot be read to its end"
				+ (error == null ? "" : " (" + reason(error) + ")")
				+ "; copy the file again from its source, or save it as a TIFF stack or as an AVI without compression.");
		return new ImagePlus(file.getFileName().toString(), frames);
	}

	/** The line that says what is wrong; the first says only that something is. */
	private static String reason(final String error) {
		return error.lines().map(String::strip).filter(l -> !l.isEmpty()).skip(1).findFirst()
			.orElse(error.strip());
	}

	private static void requireFile(final Path file) {
		if (!Files.exists(file))
			throw new UserException("There is no file " + file + "; check the path.");
		if (!Files.isReadable(file))
			throw new UserException(file + " may not be read; check its permissions.");
		try {
			if (Files.isRegularFile(file) && Files.size(file) == 0)
				throw new UserException(
					file + " is empty (0 bytes); copy the file again from its source.");
		} catch (final IOException e) {
			throw new UserException(file + " cannot be read: " + e.getMessage() + ".", e);
		}
		if (!Files.isRegularFile(file) && !Files.isDirectory(file))
			throw new UserException(file + " is neither a file nor a folder; name a movie.");
	}

	private static UserException notRead(final Path file, final Throwable cause) {
		return new UserException(file
			+ " is damaged, or of a kind that ImageJ does not read; copy the file again from its source, or save the movie as a TIFF stack.",
			cause);
	}

	private static UserException notAnImage(final Path file, final Throwable cause) {
		return new UserException(file
			+ " is not an image that ImageJ can open; save the movie as a TIFF stack of 8, 16 or 32 bit.",
			cause);
	}

	/** Pictures whose readers fill up in silence what was cut off: JPEG, PNG and PGM. */
	private static final class PictureEnd {

		/** Programs may add something of theirs behind the end. */
		private static final int LOOKED_AT = 1 << 16;
		private static final byte[] JPEG = {(byte) 0xff, (byte) 0xd9}, PNG = {'I', 'E', 'N', 'D'};

		private PictureEnd() {
		}

		/**
		 * @param file a file
		 * @param type its kind, as ImageJ counts them
		 * @param image what was read of it
		 * @throws UserException if its end is missing
		 * @throws IOException if it cannot be read
		 */
		static void require(final Path file, final int type, final ImagePlus image)
			throws IOException {
			try (FileChannel channel = FileChannel.open(file)) {
				final double pixels = (double) image.getWidth() * image.getHeight()
					* Math.max(1, image.getBitDepth() / 8);
				if (type == Opener.JPEG && !hasEnd(channel, JPEG)
					|| type == Opener.PNG && !hasEnd(channel, PNG)
					|| type == Opener.PGM && channel.size() < pixels)
					throw new UserException(file
						+ " is cut off: the file ends before its last pixel; copy the file again from its source.");
			}
		}

		private static boolean hasEnd(final FileChannel channel, final byte[] mark)
			throws IOException {
			final int size = (int) Math.min(LOOKED_AT, channel.size());
			final ByteBuffer tail = ByteBuffer.allocate(size);
			while (tail.hasRemaining()
				&& channel.read(tail, channel.size() - size + tail.position()) >= 0)
				continue;
			for (int i = tail.position() - mark.length; i >= 0; i--)
				if (tail.slice(i, mark.length).equals(ByteBuffer.wrap(mark)))
					return true;
			return false;
		}
	}
}
