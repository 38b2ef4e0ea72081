package io.github.knotresolver.imagej.tiff;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;

import ij.ImagePlus;
import ij.ImageStack;
import ij.io.FileInfo;
import ij.io.Opener;
import ij.io.TiffDecoder;
import ij.plugin.FileInfoVirtualStack;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.progress.Progress;

/**
 * A TIFF file as an image of ImageJ: by ImageJ's own reader what that reads right, by
 * a library what it does not, with axes and units of OME-TIFF as well. Whether all
 * frames came is checked: too little memory makes ImageJ leave out the last.
 */
public final class TiffImage {

	/** Property of an image: a sentence on how it was read, for people. */
	public static final String NOTE = "KnotResolver.note";

	/** A movie that takes more than this share of the memory stays in its file. */
	private static final double LARGE = 0.25;

	private static final int MEGABYTE = 1 << 20, FLOAT_BYTES = 4;

	private final Path path;
	private final TiffKind kind;
	private final TiffDescription description;

	private TiffImage(final Path path) throws IOException {
		this.path = path;
		final TiffStructure structure = TiffStructure.read(path);
		kind = new TiffKind(structure);
		description = new TiffDescription(path, kind.first());
	}

	/**
	 * @param path a file that begins as a TIFF
	 * @param progress may cancel
	 * @return the image, its planes in ImageJ's order
	 * @throws UserException if it is damaged, cut off, of a kind that is not read, or
	 *           larger than the memory; in one sentence
	 * @throws IOException if the file cannot be read
	 */
	public static ImagePlus open(final Path path, final Progress progress) throws IOException {
		return new TiffImage(path).open(progress);
	}

	/**
	 * @param path a file
	 * @return how many pixels all of its frames have; 0 if it is no TIFF
	 * @throws UserException if it is damaged, in one sentence
	 * @throws IOException if it cannot be read
	 */
	public static long pixels(final Path path) throws IOException {
		return TiffStructure.isTiff(path) ? (long) new TiffImage(path).pixels() : 0;
	}

	private double pixels() {
		final double frames = Math.max(kind.frames().size(), description.promised());
		return frames * kind.first().width() * kind.first().height() * kind.first().samples();
	}

	private ImagePlus open(final Progress progress) throws IOException {
		return open(progress, Runtime.getRuntime().maxMemory());
	}

	/** As {@link #open(Path, Progress)} with so much memory in bytes. */
	static ImagePlus open(final Path path, final Progress progress, final long memory)
		throws IOException {
		return new TiffImage(path).open(progress, memory);
	}

	/** A movie that takes much of the memory stays in its file, if that is possible. */
	private ImagePlus open(final Progress progress, final long memory) throws IOException {
		requireImages();
		final boolean large = bytes() > LARGE * memory;
		if (large && kind.frames().stream().map(kind::page).allMatch(RawStack::canRead))
			return fromFile();
		requireMemory(memory);
		return kind.isForImageJ() ? byImageJ() : byLibrary(progress);
	}

	/** Opened, but its pixels are read frame by frame when they are looked at. */
	private ImagePlus fromFile() throws IOException {
		final int frames = Math.max(kind.frames().size(), description.promised());
		final RawStack stack = new RawStack(path, kind.first(), kind.order(),
			RawStack.offsets(kind.frames().stream().map(kind::page).toList(), frames));
		if (!kind.isForImageJ())
			return described(stack);
		final ImagePlus image = FileInfoVirtualStack.openVirtual(path.toAbsolutePath().toString());
		if (image == null || image.getStackSize() != frames)
			throw TiffStructure.damaged(path, "ImageJ finds other images in it than its list has");
		image.setStack(stack);
		arranged(image);
		return image;
	}

	/** ImageJ's own stacks have one directory for many frames in a row. */
	private void requireImages() throws IOException {
		final int found = kind.frames().size(), promised = description.promised();
		if (promised <= found)
			return;
		final long[] start = kind.first().values(TiffPage.STRIP_OFFSETS);
		final boolean inARow = found == 1 && kind.isForImageJ() && start.length > 0;
		if (!inARow)
			throw new UserException(path + " tells of " + promised + " images, but holds " + found
				+ "; the rest is in other files, or was cut off: open them together and save them as one stack.");
		if (start[0] + promised * kind.first().bytes() > Files.size(path))
			throw TiffStructure.cutOff(path);
	}

	private double bytes() {
		final TiffPage page = kind.first();
		return pixels() * (page.bits() <= 8 ? 1 : page.bits() <= 16 ? 2 : FLOAT_BYTES);
	}

	private void requireMemory(final long memory) {
		final double needed = bytes();
		if (needed > memory)
			throw noMemory("needs " + (long) Math.ceil(needed / MEGABYTE) + " MB");
	}

	private UserException noMemory(final String what) {
		return new UserException("There is not enough memory for " + path + ": it " + what
			+ ", and Java has " + Runtime.getRuntime().maxMemory() / MEGABYTE
			+ " MB; give Java more (JAVA_OPTS=-Xmx8g, in ImageJ Edit > Options > Memory & Threads), or cut the movie.",
			new OutOfMemoryError());
	}

	private ImagePlus byImageJ() throws IOException {
		final String folder = path.toAbsolutePath().getParent() + File.separator,
			name = path.getFileName().toString();
		final FileInfo[] infos = new TiffDecoder(folder, name).getTiffInfo();
		if (infos == null || infos.length == 0)
			throw TiffStructure.damaged(path, "ImageJ finds no image in it");
		final Opener opener = new Opener();
		opener.setSilentMode(true);
		final ImagePlus image = opener.openTiff(folder, name);
		final int expected = Math.max(Math.max(infos[0].nImages, kind.frames().size()),
			description.promised());
		if (image == null)
			throw TiffStructure.damaged(path, "ImageJ cannot read its pixels");
		final int found = image.getStackSize();
		if (found < expected)
			throw noMemory("has " + expected + " frames, of which " + found + " were read");
		arranged(image);
		return image;
	}

	/** What ImageJ does not know of axes and units. */
	private void arranged(final ImagePlus image) {
		if (description.isForeign())
			calibrate(image);
		if (description.isForeign() || description.axes(image.getStackSize(), 1).isEmpty())
			arrange(image);
	}

	private ImagePlus byLibrary(final Progress progress) throws IOException {
		return described(new TiffPixels(path, kind.first()).read(kind.frames(), progress));
	}

	private ImagePlus described(final ImageStack stack) {
		final ImagePlus image = new ImagePlus(path.getFileName().toString(), stack);
		final FileInfo info = new FileInfo();
		info.directory = path.toAbsolutePath().getParent() + File.separator;
		info.fileName = path.getFileName().toString();
		info.description = kind.first().description();
		image.setFileInfo(info);
		calibrate(image);
		arrange(image);
		return image;
	}

	private void calibrate(final ImagePlus image) {
		description.calibrate(image.getCalibration());
	}

	/** Images of which nothing is told are frames: the file is named as a movie. */
	private void arrange(final ImagePlus image) {
		final int planes = image.getStackSize(),
			perImage = Math.max(1, planes / kind.frames().size());
		final Optional<TiffAxes> told = description.axes(planes, perImage);
		told.orElseGet(() -> TiffAxes.inOrder(perImage, 1, planes / perImage)).arrange(image);
		image.setOpenAsHyperStack(image.getNChannels() > 1);
		if (told.isEmpty() && image.getNFrames() > 1)
			image.setProperty(NOTE, "'" + path.getFileName() + "' does not say what its "
				+ image.getNFrames() + " images are; they are read as frames, in their order.");
	}
}
