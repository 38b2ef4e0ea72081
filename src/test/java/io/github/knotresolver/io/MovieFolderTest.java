package io.github.knotresolver.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import io.github.knotresolver.model.UserException;

class MovieFolderTest {

	@TempDir
	Path home;

	@Test
	void filmsAndFoldersOfNumberedPicturesAreMovies() throws IOException {
		for (final String name : List.of("b.tif", "a.avi", "c.GIF", "d.btf", "notes.txt", ".e.tif"))
			Files.createFile(home.resolve(name));
		pictures("frames", "t%d.png", 3);
		pictures("few", "t%d.jpg", 2);
		pictures("figures", "figure-%dx.png", 5);
		pictures("result", "t%d.png", 5);
		Files.writeString(home.resolve("result").resolve(ParametersJson.FILE),
			"{\"program\": \"KnotResolver\", \"movie\": {}, \"options\": {}, \"found\": {}}");
		assertEquals(List.of("a.avi", "b.tif", "c.GIF", "d.btf", "frames"),
			MovieFolder.read(home).rows().stream().map(BatchRow::name).toList());
	}

	private void pictures(final String folder, final String name, final int count)
		throws IOException {
		Files.createDirectory(home.resolve(folder));
		for (int i = 1; i <= count; i++)
			Files.createFile(home.resolve(folder).resolve(String.format(name, i)));
	}

	@Test
	void folderWithoutMoviesIsRefused() {
		final String message = assertThrows(UserException.class, () -> MovieFolder.read(home))
			.getMessage();
		assertTrue(message.contains("has no movie") && message.contains("numbered pictures"),
			message);
	}
}
