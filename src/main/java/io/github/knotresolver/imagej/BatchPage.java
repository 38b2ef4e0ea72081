package io.github.knotresolver.imagej;

import java.awt.image.BufferedImage;
import java.io.BufferedWriter;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.Writer;
import java.net.URI;
import java.net.URISyntaxException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Base64;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;

import javax.imageio.ImageIO;

import io.github.knotresolver.io.BatchList;
import io.github.knotresolver.io.BatchOutcome;
import io.github.knotresolver.io.ContoursCsv;
import io.github.knotresolver.io.FilamentsCsv;
import io.github.knotresolver.io.FramesCsv;
import io.github.knotresolver.io.ProgramVersion;
import io.github.knotresolver.io.ResultDigest;
import io.github.knotresolver.progress.Progress;

/**
 * {@code batch.html}: all results of a batch on one page, each with its montage, its confidence frame
 * by frame, its length and links to its files. It opens in any browser without a network: styles and
 * pictures are in it, links are relative. It is well-formed XML, too. The same results give the same
 * bytes.
 */
final class BatchPage {

	private static final int THUMBNAIL = 480;
	private static final String MONTAGE = "montage.png";
	private static final List<String> LINKED = List.of(MONTAGE, ContoursCsv.FILE, FramesCsv.FILE,
		FilamentsCsv.FILE);
	private static final String STYLE = """
		body { font: 15px/1.4 system-ui, sans-serif; margin: 1.5em; color: #222; background: #fff; }
		h1 { font-size: 1.4em; } h2 { font-size: 1em; margin: 0 0 .3em; overflow-wrap: anywhere; }
		main { display: grid; grid-template-columns: repeat(auto-fill, minmax(20em, 1fr)); gap: 1em; }
		section { border: 1px solid #ccc; border-top: 4px solid #009e73; border-radius: 4px; padding: .7em; }
		section.failed { border-top-color: #d55e00; }
		p { margin: .4em 0; overflow-wrap: anywhere; }
		img.montage { width: 100%; background: #000; }
		img.strip { width: 100%; image-rendering: pixelated; border: 1px solid #888; box-sizing: border-box; }
		.key i { font-style: normal; white-space: nowrap; }
		.key span { display: inline-block; width: 1em; height: 1em; vertical-align: -.15em; margin: 0 .3em 0 1em; }
		""";

	private final Writer html;
	private final Path out;

	private BatchPage(final Writer html, final Path out) {
		this.html = html;
		this.out = out;
	}

	/**
	 * @param file the new file
	 * @param out the folder of the result folders, in which the page will be
	 * @param outcomes what came of the rows, in their order
	 * @param progress told how far it is; may cancel
	 * @throws IOException if it cannot be written
	 */
	static void write(final Path file, final Path out, final List<BatchOutcome> outcomes,
		final Progress progress) throws IOException {
		try (BufferedWriter html = Files.newBufferedWriter(file, StandardCharsets.UTF_8)) {
			final BatchPage page = new BatchPage(html, out);
			page.head(outcomes);
			for (int i = 0; i < outcomes.size(); i++) {
				progress.checkCancelled();
				progress.report("Writing " + BatchList.PAGE, (double) i / outcomes.size());
				page.section(outcomes.get(i));
			}
			html.write("</main>\n</body>\n</html>\n");
		}
	}

	private void head(final List<BatchOutcome> outcomes) throws IOException {
		final long failed = outcomes.stream().filter(o -> o.folder().isEmpty()).count();
		html.write("<!DOCTYPE html>\n<html xmlns=\"http://www.w3.org/1999/xhtml\" lang=\"en\">\n"
			+ "<head>\n<meta charset=\"utf-8\" />\n" + BatchList.PAGE_MARK + " />\n"
			+ "<meta name=\"viewport\" content=\"width=device-width\" />\n<title>"
			+ ProgramVersion.NAME + ": " + outcomes.size() + " movies</title>\n<style>\n" + STYLE
			+ "</style>\n</head>\n<body>\n<h1>" + (outcomes.size() - failed) + " of "
			+ outcomes.size() + " movies have a result</h1>\n");
		if (failed > 0)
			html.write("<p>Without a result: " + outcomes
				.stream().filter(o -> o.folder().isEmpty()).map(o -> "<a href=\"#line-"
					+ o.row().line() + "\">" + text(o.row().name()) + "</a>")
				.collect(Collectors.joining(", ")) + ".</p>\n");
		html.write(
			"<p class=\"key\">The strip below a montage has a column for every frame and a row"
				+ " for every filament." + key("#009e73", "confidence 0.9 and more")
				+ key("#f0e442", "0.5 to 0.9") + key("#e69f00", "less, or unresolved")
				+ key("#d55e00", "lost") + key("#0072b2", "corrected")
				+ key("#b0b0b0", "not in view") + key("#808080", "ignored") + "</p>\n<main>\n");
	}

	private static String key(final String colour, final String meaning) {
		return " <i><span style=\"background: " + colour + "\"></span>" + meaning + "</i>";
	}

	private void section(final BatchOutcome outcome) throws IOException {
		html.write("<section id=\"line-" + outcome.row().line() + "\" class=\"" + outcome.label()
			+ "\">\n<h2>" + text(outcome.row().name()) + "</h2>\n");
		if (outcome.folder().isPresent())
			result(outcome.folder().get());
		html.write("<p>" + text(outcome.label() + ". " + outcome.message()) + "</p>\n</section>\n");
	}

	private void result(final String name) throws IOException {
		final Path folder = out.resolve(name);
		final Optional<BufferedImage> montage = SmallPicture.read(folder.resolve(MONTAGE),
			THUMBNAIL);
		if (montage.isPresent())
			html.write(
				"<a href=\"" + link(name, MONTAGE) + "\"><img class=\"montage\" alt=\"Montage of "
					+ text(name) + "\" src=\"" + embedded(montage.get(), "jpeg") + "\" /></a>\n");
		final Optional<ResultDigest> digest = ResultDigest.read(folder).filter(d -> d.frames() > 0);
		if (digest.isPresent())
			tables(digest.get());
		html.write("<p><a href=\"" + link(name, "") + "\">" + text(name) + "</a>");
		for (final String file : LINKED)
			if (Files.exists(folder.resolve(file)))
				html.write(" · <a href=\"" + link(name, file) + "\">" + file + "</a>");
		html.write("</p>\n");
	}

	/** A picture as text that a browser shows without another file: PNG to the pixel, JPEG in fewer bytes. */
	private static String embedded(final BufferedImage picture, final String kind)
		throws IOException {
		final ByteArrayOutputStream bytes = new ByteArrayOutputStream();
		if (!ImageIO.write(picture, kind, bytes))
			throw new IOException("This Java cannot write " + kind + " pictures.");
		return "data:image/" + kind + ";base64,"
			+ Base64.getEncoder().encodeToString(bytes.toByteArray());
	}

	private void tables(final ResultDigest digest) throws IOException {
		final BufferedImage strip = ConfidenceRows.of(digest);
		html.write("<img class=\"strip\" style=\"height: " + (6 + 8 * strip.getHeight())
			+ "px\" alt=\"Confidence of each frame\" src=\"" + embedded(strip, "png") + "\" />\n<p>"
			+ digest.resolved() + " of " + digest.frames() + " frames, length "
			+ text(digest.filaments().stream()
				.map(f -> f.length().isEmpty() ? "not known" : f.length())
				.collect(Collectors.joining(", ")))
			+ "</p>\n");
	}

	private static String link(final String folder, final String file) {
		try {
			return text(new URI(null, null, "./" + folder + "/" + file, null).toASCIIString());
		} catch (final URISyntaxException e) {
			throw new IllegalStateException(e);
		}
	}

	/** Marks of HTML as text; what no page may hold is shown as a question mark in a box. */
	private static String text(final String text) {
		return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")
			.replace("\"", "&quot;")
			.replaceAll("[\\x00-\\x08\\x0b\\x0c\\x0e-\\x1f\\ufffe\\uffff]", "\ufffd");
	}
}
