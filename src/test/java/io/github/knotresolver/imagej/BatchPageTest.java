package io.github.knotresolver.imagej;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.StringReader;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.stream.IntStream;
import java.util.stream.Stream;

import javax.imageio.ImageIO;
import javax.xml.parsers.DocumentBuilderFactory;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.w3c.dom.Document;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;
import org.xml.sax.InputSource;

import io.github.knotresolver.io.BatchRow;
import io.github.knotresolver.io.ResultDigest;
import io.github.knotresolver.model.FrameStatus;
import io.github.knotresolver.progress.Progress;

/** The page of a batch, by parsing it and in a browser. */
class BatchPageTest {

	private static final List<String> BROWSERS = List.of("/usr/bin/chromium",
		"/usr/bin/chromium-browser", "/usr/bin/google-chrome");

	@TempDir
	Path home;
	private Path page;

	@BeforeEach
	void makeABatchWithOddNamesAndAFailure() throws IOException {
		System.setProperty("java.awt.headless", "true");
		final List<BatchRow> rows = new ArrayList<>();
		for (final String name : List.of("plain.tif", "a & b 50% #1.tif", "<i>ü'.tif",
			"absent.tif")) {
			final Path file = home.resolve(name);
			if (!name.startsWith("absent"))
				TestImages.save(TestImages.movie(5, 8), file);
			rows.add(new BatchRow(rows.size() + 2, file.toString(), Map.of(), List.of()));
		}
		final Path out = home.resolve("out");
		new Batch(TestImages::resolve, Map.of(), false, false, Optional.empty())
			.run(new BatchWork(rows, out, List.of()), o -> {
			}, Progress.NONE);
		page = out.resolve("batch.html");
	}

	@Test
	void allRowsAreThereWithPicturesLengthAndLinksThatLead() throws Exception {
		final Document document = parse();
		final List<Element> sections = elements(document, "section");
		assertEquals(4, sections.size());
		assertTrue(elements(document, "h1").get(0).getTextContent().startsWith("3 of 4 movies"));
		final Element plain = sections.get(0);
		assertTrue(plain.getTextContent().contains("4 of 5 frames, length 20.00 ± 0.03 µm"),
			plain.getTextContent());
		assertEquals("failed", sections.get(3).getAttribute("class"));
		assertTrue(sections.get(3).getTextContent().contains("There is no file"));
		for (final Element link : elements(document, "a")) {
			final String target = link.getAttribute("href");
			if (target.startsWith("#"))
				assertEquals("line-5", target.substring(1));
			else
				assertTrue(Files.exists(Path.of(page.toUri().resolve(URI.create(target)))), target);
		}
	}

	@Test
	void everythingIsInTheFile() throws Exception {
		final Document document = parse();
		final List<Element> images = elements(document, "img");
		assertEquals(6, images.size());
		for (final Element image : images) {
			final String source = image.getAttribute("src");
			assertTrue(source.startsWith("data:image/"), source);
			final BufferedImage picture = ImageIO.read(new ByteArrayInputStream(
				Base64.getDecoder().decode(source.substring(source.indexOf(',') + 1))));
			assertEquals(image.getAttribute("class").equals("strip") ? 5 : 480, picture.getWidth());
		}
		final String text = Files.readString(page);
		assertEquals(List.of(), elements(document, "script"));
		assertFalse(text.contains("url(") || text.contains("@import"));
	}

	@Test
	void aBrowserShowsItOffline() throws Exception {
		final Optional<String> browser = BROWSERS.stream()
			.filter(b -> Files.isExecutable(Path.of(b))).findFirst();
		assumeTrue(browser.isPresent(), "There is no Chromium here: the page was parsed only.");
		final Path shot = home.resolve("page.png");
		final List<String> command = new ArrayList<>(List.of(browser.get(), "--headless",
			"--no-sandbox", "--disable-gpu", "--no-first-run", "--disable-background-networking",
			"--disable-component-update", "--disable-sync", "--hide-scrollbars",
			"--window-size=1000,900", "--user-data-dir=" + home.resolve("profile"),
			"--screenshot=" + shot, page.toUri().toString()));
		final Process process = new ProcessBuilder(command)
			.redirectOutput(home.resolve("browser.log").toFile()).redirectErrorStream(true).start();
		assertTrue(process.waitFor(60, TimeUnit.SECONDS), "the browser does not end");
		final BufferedImage picture = ImageIO.read(shot.toFile());
		final int resolved = Palette.ofConfidence(1).getRGB(),
			failed = Palette.of(FrameStatus.LOST).getRGB();
		final int[] pixels = picture.getRGB(0, 0, picture.getWidth(), picture.getHeight(), null, 0,
			picture.getWidth());
		assertTrue(count(pixels, resolved) > 2000, "strips and borders are drawn");
		assertTrue(count(pixels, failed) > 500, "the failed movie is marked");
		// Montages are dark, the page is white.
		assertTrue(IntStream.of(pixels).filter(p -> (p & 0xff) < 0x30 && (p >> 8 & 0xff) < 0x30)
			.count() > 20_000, "montages are drawn");
	}

	@Test
	void stripShowsTheLeastSureFrameOfAColumn() {
		final List<ResultDigest.Frame> frames = new ArrayList<>();
		for (int i = 0; i < 1200; i++)
			frames.add(new ResultDigest.Frame(
				i == 601 ? FrameStatus.UNRESOLVED : FrameStatus.RESOLVED, i == 11 ? 0.6 : 1));
		final BufferedImage strip = ConfidenceRows
			.of(new ResultDigest(List.of(new ResultDigest.Filament(1, "", frames))));
		assertEquals(600, strip.getWidth());
		assertEquals(Palette.ofConfidence(0.6).getRGB(), strip.getRGB(5, 0));
		assertEquals(Palette.of(FrameStatus.UNRESOLVED).getRGB(), strip.getRGB(300, 0));
		assertEquals(Palette.ofConfidence(1).getRGB(), strip.getRGB(299, 0));
	}

	private static long count(final int[] pixels, final int colour) {
		return IntStream.of(pixels).filter(p -> p == colour).count();
	}

	private Document parse() throws Exception {
		return DocumentBuilderFactory.newInstance().newDocumentBuilder()
			.parse(new InputSource(new StringReader(Files.readString(page))));
	}

	private static List<Element> elements(final Document document, final String name) {
		final NodeList nodes = document.getElementsByTagName(name);
		return Stream.iterate(0, i -> i + 1).limit(nodes.getLength())
			.map(i -> (Element) nodes.item(i)).toList();
	}
}
