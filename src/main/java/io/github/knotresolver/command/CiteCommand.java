package io.github.knotresolver.command;

import java.awt.GraphicsEnvironment;

import org.scijava.ItemIO;
import org.scijava.command.Command;
import org.scijava.plugin.Attr;
import org.scijava.plugin.Parameter;
import org.scijava.plugin.Plugin;

import ij.macro.Interpreter;
import ij.text.TextWindow;
import io.github.knotresolver.io.ProgramVersion;
import io.github.knotresolver.progress.Progress;

/** {@code About/Cite KnotResolver}: what to name in a paper. */
@Plugin(type = Command.class, label = "About/Cite KnotResolver", attrs = @Attr(name = "no-legacy"))
public class CiteCommand extends KnotCommand {

	private static final int WIDTH = 640, HEIGHT = 360;

	@Parameter(type = ItemIO.OUTPUT)
	private String citation;

	@Override
	void work(final Progress progress) {
		citation = text();
		if (GraphicsEnvironment.isHeadless() || Interpreter.isBatchMode())
			say(citation);
		else
			new TextWindow("About/Cite KnotResolver", citation, WIDTH, HEIGHT);
	}

	private static String text() {
		return ProgramVersion.NAME + " " + ProgramVersion.get() + """

			Tracks a filament that crosses itself through a microscopy movie:
			one ordered, sub-pixel contour per frame, right through every knot.

			If it helps your work, please cite the method and this program
			(CITATION.cff has both for reference managers):

			Khatri D, Yadav SA, Athale CA (2024). KnotResolver: tracking
			self-intersecting filaments in microscopy using directed graphs.
			Bioinformatics 40(9), btae538. doi:10.1093/bioinformatics/btae538

			KnotResolver, https://github.com/knotresolver/knotresolver-fiji,
			version as above.
			""";
	}
}
