package io.github.knotresolver.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import io.github.knotresolver.model.UserException;
import io.github.knotresolver.progress.Progress;

/** What a result was made from, and which rows of a batch are finished by it. */
class RunIdentityTest {

	/** The SHA-256 of abc, by FIPS 180-2. */
	private static final String ABC = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";

	@TempDir
	Path home;
	private Path movie;

	@BeforeEach
	void writeMovie() throws IOException {
		home = home.toRealPath();
		movie = Files.writeString(home.resolve("movie.tif"), "abc");
	}

	private RunIdentity identity(final Map<String, String> texts) throws IOException {
		return RunIdentity.of(movie, texts, Progress.NONE);
	}

	/** A result folder that tells of an identity. */
	private Path result(final String name, final RunIdentity i) throws IOException {
		final StringBuilder given = new StringBuilder();
		i.given().forEach((key, value) -> given.append(given.length() == 0 ? "" : ", ").append("\"")
			.append(key).append("\": \"").append(value).append("\""));
		final Path folder = Files.createDirectory(home.resolve(name));
		Files.writeString(folder.resolve(ParametersJson.FILE),
			"{\"program\": \"KnotResolver\", \"version\": \"" + i.version()
				+ "\", \"options\": {}, \"movie\": {\"file\": \"" + i.movie() + "\", \"sha256\": \""
				+ i.sha256() + "\"}, \"given\": {" + given + "}, \"corrections_sha256\": \""
				+ i.corrections() + "\"}");
		return folder;
	}

	@Test
	void movieIsKnownByPathAndContents() throws IOException {
		final RunIdentity i = RunIdentity.of(home.resolve("./movie.tif"), Map.of(), Progress.NONE);
		assertEquals(movie, i.movie());
		assertEquals(ABC, i.sha256());
		assertEquals(ProgramVersion.get(), i.version());
		assertEquals("", i.corrections());
		final Path folder = Files.createDirectory(home.resolve("frames"));
		Files.writeString(folder.resolve("1.png"), "a");
		final String one = RunIdentity.of(folder, Map.of(), Progress.NONE).sha256();
		Files.move(folder.resolve("1.png"), folder.resolve("2.png"));
		assertNotEquals(one, RunIdentity.of(folder, Map.of(), Progress.NONE).sha256());
	}

	@Test
	void whatDoesNotChangeTheResultIsNoPartOfIt() throws IOException {
		final Map<String, String> texts = new HashMap<>(
			Map.of("threads", "3", "length", " ", "threshold", "0.3"));
		texts.put("unit", null);
		assertEquals(Map.of("threshold", "0.3"), identity(texts).given());
	}

	@Test
	void correctionsAreKnownByTheirContents() throws IOException {
		final Path file = Files.writeString(home.resolve("c.csv"), "abc");
		final Map<String, String> texts = Map.of("corrections", file.toString());
		assertEquals(ABC, identity(texts).corrections());
		assertEquals(Map.of(), identity(texts).given());
		assertEquals(List.of(movie, file), RunIdentity.files(Optional.of(movie), texts));
		assertEquals(List.of(movie),
			RunIdentity.files(Optional.of(movie), Map.of("corrections", " ")));
		assertEquals(List.of(), RunIdentity.files(Optional.empty(), Map.of()));
		assertEquals(Optional.empty(), RunIdentity.of(Optional.empty(), Map.of(), Progress.NONE));
		final Map<String, String> odd = Map.of("corrections", "a\0b");
		assertThrows(UserException.class, () -> RunIdentity.files(Optional.of(movie), odd));
		assertThrows(UserException.class, () -> identity(odd));
	}

	@Test
	void resultIsTheSameOnlyIfAllOfItIs() throws IOException {
		final RunIdentity i = identity(Map.of("threshold", "OTSU", "iterations", "10"));
		assertTrue(i.isSame(identity(Map.of())));
		assertFalse(i.isSame(identity(Map.of("threshold", "0.3"))));
		assertFalse(i.isSame(identity(Map.of("threshold", "not a number"))));
		assertFalse(i.isSame(
			new RunIdentity(home.resolve("other.tif"), i.sha256(), i.version(), i.given(), "")));
		assertFalse(i.isSame(new RunIdentity(movie, "00", i.version(), i.given(), "")));
		assertFalse(i.isSame(new RunIdentity(movie, i.sha256(), "0.0.1", i.given(), "")));
		assertFalse(i.isSame(new RunIdentity(movie, i.sha256(), i.version(), i.given(), ABC)));
		final RunIdentity unknown = new RunIdentity(movie, "", i.version(), i.given(), "");
		assertFalse(unknown.isSame(unknown));
	}

	@Test
	void isReadBackFromAResult() throws IOException {
		final RunIdentity i = new RunIdentity(movie, ABC, "1.2.3", Map.of("threshold", "0.3"),
			"77");
		assertEquals(Optional.of(i), RunIdentity.read(result("a", i)));
		for (final String json : List.of("{", "[]", "{\"options\": {}}",
			"{\"program\": \"KnotResolver\", \"options\": {}}",
			"{\"program\": \"KnotResolver\", \"options\": {}, \"movie\": {\"file\": null}}",
			"{\"program\": \"KnotResolver\", \"options\": {}, \"movie\": {\"file\": {}}}",
			"{\"program\": \"KnotResolver\", \"options\": {}, \"movie\": {\"file\": \"a\\u0000b\"}}")) {
			Files.writeString(home.resolve("a").resolve(ParametersJson.FILE), json);
			assertEquals(Optional.empty(), RunIdentity.read(home.resolve("a")), json);
		}
	}

	@Test
	void rowIsFinishedByTheSameResultAndGetsNoOtherMoviesFolder() throws IOException {
		final Path out = Files.createDirectory(home.resolve("out"));
		final BatchRow row = row(movie, Map.of()), twice = row(movie, Map.of("iterations", "11")),
			other = row(Files.writeString(
				Files.createDirectory(home.resolve("in")).resolve("movie.tif"), "x"), Map.of());
		Files.move(result("kept", identity(Map.of())), out.resolve("kept"));
		Files.move(result("movie", identity(Map.of("iterations", "12"))), out.resolve("movie"));
		Files.createDirectory(out.resolve("MOVIE-2"));
		final BatchFolders folders = BatchFolders.of(out, List.of(row, twice, other), Map.of(),
			BatchFolders.Rows.ALL, Progress.NONE);
		assertEquals(new BatchFolders.Place("kept", true), folders.place(row));
		assertEquals(new BatchFolders.Place("movie-2", false), folders.place(other));
		assertEquals(new BatchFolders.Place("movie", false), folders.place(twice));
	}

	private static BatchRow row(final Path movie, final Map<String, String> texts) {
		return new BatchRow(2, movie.toString(), texts, List.of());
	}
}
