package io.github.knotresolver.imagej.plot;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import io.github.knotresolver.progress.CancelledException;

class PicturesTest {

	@TempDir
	Path folder;

	@Test
	void whatCannotBeDrawnIsLeftOutWithANote() throws IOException {
		final Pictures pictures = new Pictures(folder);
		pictures.draw("z.png", file -> {
			Files.writeString(file, "half");
			throw new OutOfMemoryError("Java heap space");
		});
		pictures.draw("a.png",
			file -> new BufferedImage(50_000, 50_000, BufferedImage.TYPE_INT_RGB));
		pictures.draw("b.png", file -> Files.writeString(file, "drawn"));
		assertFalse(Files.exists(folder.resolve("z.png")));
		assertEquals("drawn", Files.readString(folder.resolve("b.png")));
		assertEquals(2, pictures.notes().size());
		assertEquals("a.png was left out. The picture would be larger than Java can draw.",
			pictures.notes().get(0));
		assertTrue(pictures.notes().get(1).startsWith("z.png was left out. There is not enough"),
			pictures.notes().get(1));
	}

	@Test
	void fullDiskAndCancelAreNoMatterOfThePicture() {
		final Pictures pictures = new Pictures(folder);
		assertThrows(IOException.class, () -> pictures.draw("a.png", file -> {
			throw new IOException("No space left on device");
		}));
		assertThrows(CancelledException.class, () -> pictures.draw("a.png", file -> {
			throw new CancelledException();
		}));
		assertEquals(0, pictures.notes().size());
	}
}
