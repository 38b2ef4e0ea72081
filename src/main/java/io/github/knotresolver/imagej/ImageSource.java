package io.github.knotresolver.imagej;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Function;

import ij.ImagePlus;
import io.github.knotresolver.imagej.tiff.TiffImage;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.options.InputOptions;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.run.MovieSource;

/** A movie in an image of ImageJ, which may be closed once it has been read. */
public final class ImageSource implements MovieSource {

	private final Function<Progress, ImagePlus> opener;
	private final Optional<Path> file;
	private RoiConverter rois;
	private List<String> notes = List.of();

	private ImageSource(final Function<Progress, ImagePlus> opener, final Optional<Path> file) {
		this.opener = opener;
		this.file = file;
	}

	/**
	 * @param file an image file
	 * @return the movie in it, opened when it is read
	 */
	public static ImageSource of(final Path file) {
		return new ImageSource(progress -> ImageFile.open(file, progress),
			Optional.of(file.toAbsolutePath().normalize()));
	}

	/**
	 * @param file an image file
	 * @return the movie in it, opened when it is read first, and kept: it may be read again with other
	 *         options, by one thread at a time
	 */
	public static ImageSource kept(final Path file) {
		final AtomicReference<ImagePlus> opened = new AtomicReference<>();
		return new ImageSource(progress -> {
			if (opened.get() == null)
				opened.set(ImageFile.open(file, progress));
			return opened.get();
		}, Optional.of(file.toAbsolutePath().normalize()));
	}

	/**
	 * @param image an image; its file is known if it was not changed since it was opened
	 * @return the movie in it
	 */
	public static ImageSource of(final ImagePlus image) {
		return new ImageSource(progress -> image, ImageFile.of(image));
	}

	/**
	 * @param image an image
	 * @return the movie in it, whatever its file; no disk is asked
	 */
	public static ImageSource inMemory(final ImagePlus image) {
		return new ImageSource(progress -> image, Optional.empty());
	}

	@Override
	public Movie read(final InputOptions options, final Progress progress) {
		final ImagePlus image = opener.apply(progress);
		final Movie movie = ImageMovie.of(image, options);
		notes = image.getProperty(TiffImage.NOTE) instanceof String note
			? List.of(note)
			: List.of();
		rois = RoiConverter.forImage(image, options.channel());
		return movie;
	}

	@Override
	public List<String> notes() {
		return notes;
	}

	@Override
	public Optional<Path> file() {
		return file;
	}

	/**
	 * @return makes ROIs for the image
	 * @throws IllegalStateException if it has not been read
	 */
	public RoiConverter rois() {
		if (rois == null)
			throw new IllegalStateException("The image has not been read.");
		return rois;
	}
}
