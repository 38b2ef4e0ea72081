package io.github.knotresolver.fuzz;

import java.nio.file.Path;
import java.util.Map;

import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.ShrinkingMode;

import io.github.knotresolver.imagej.ImageFile;
import io.github.knotresolver.imagej.ImageMovie;
import io.github.knotresolver.options.InputOptions;
import io.github.knotresolver.options.RunOptions;

/** TIFF files are opened, or refused in a sentence, and soon, whatever their directories say. */
class ImagesFuzzTest extends Fuzzing {

	private static final Guard GUARD = new Guard("images");

	private static final InputOptions SLICES_ARE_FRAMES = RunOptions
		.parse(Map.of("z_as_time", "true")).input();

	@Provide
	Arbitrary<byte[]> tiffs() {
		return DrawnTiff.any();
	}

	@Property(seed = "20260102", shrinking = ShrinkingMode.OFF)
	void imagesAreOpenedOrRefused(@ForAll("tiffs") final byte[] bytes) {
		final Path file = folder.write("movie.tif", bytes);
		GUARD.run(() -> Drawings.shown(bytes),
			() -> ImageMovie.of(ImageFile.open(file), SLICES_ARE_FRAMES));
	}
}
