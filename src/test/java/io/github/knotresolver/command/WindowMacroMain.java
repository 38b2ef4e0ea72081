package io.github.knotresolver.command;

import java.util.Map;

import ij.IJ;
import ij.ImageJ;
import ij.WindowManager;
import ij.plugin.frame.RoiManager;
import io.github.knotresolver.imagej.RoiContours;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.run.MeasureRun;

/** Runs a macro in plain ImageJ on a display: its file. */
public final class WindowMacroMain {

	private WindowMacroMain() {
	}

	/** Why the lines in the ROI Manager cannot be measured; for macros. */
	public static String refusal() {
		try {
			MeasureRun.parse(Map.of()).measure(
				RoiContours.read(RoiManager.getInstance2(), WindowManager.getCurrentImage()).get(0),
				Progress.NONE);
			return "nothing is wrong";
		} catch (final UserException e) {
			return e.getMessage();
		}
	}

	public static void main(final String[] args) {
		new ImageJ(ImageJ.NO_SHOW);
		IJ.runMacroFile(args[0]);
		System.exit(0);
	}
}
