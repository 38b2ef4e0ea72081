package io.github.knotresolver.command;

import java.awt.GraphicsEnvironment;

import org.scijava.ItemIO;
import org.scijava.command.Command;
import org.scijava.plugin.Attr;
import org.scijava.plugin.Parameter;
import org.scijava.plugin.Plugin;

import ij.ImagePlus;
import ij.macro.Interpreter;
import io.github.knotresolver.imagej.ImageView;
import io.github.knotresolver.imagej.SampleMovie;
import io.github.knotresolver.progress.Progress;

/** {@code File > Open Samples > Knotted Filament}. */
@Plugin(type = Command.class, label = "Knotted Filament", attrs = @Attr(name = "no-legacy"))
public class SampleCommand extends KnotCommand {

	@Parameter(type = ItemIO.OUTPUT)
	private ImagePlus sample;

	@Override
	void work(final Progress progress) {
		sample = SampleMovie.open();
		if (!GraphicsEnvironment.isHeadless() || Interpreter.isBatchMode())
			ImageView.show(sample);
	}
}
