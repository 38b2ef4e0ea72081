package io.github.knotresolver.ui;

import java.awt.GridLayout;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;

import javax.swing.JCheckBox;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JSpinner;
import javax.swing.SpinnerNumberModel;

import io.github.knotresolver.ui.model.TuneModel;

/** The values of a segmentation, each with its unit and its help. */
final class TuneValues {

	private static final int GAP = 6;

	private final TuneModel model;
	private final Map<String, JSpinner> spinners = new LinkedHashMap<>();
	private final JCheckBox automatic = new JCheckBox("automatic", true);
	private boolean refreshing;

	TuneValues(final TuneModel model) {
		this.model = model;
	}

	/** @return them in rows; called once */
	JPanel panel() {
		final JPanel grid = new JPanel(new GridLayout(0, 4, GAP, GAP));
		automatic.setName("automatic threshold");
		automatic.setToolTipText("Otsu's threshold, made local, in each frame");
		automatic.addActionListener(e -> model.set("threshold",
			automatic.isSelected() ? "otsu" : number(model.automatic().orElse(0.5), 2)));
		spinner(grid, "threshold", "Threshold (0..1)",
			"Brightness above which a pixel starts as filament, of the stretched frame",
			new SpinnerNumberModel(0.5, 0, 1, 0.01));
		grid.add(automatic);
		grid.add(new JLabel());
		spinner(grid, "iterations", "Iterations (steps)",
			"Steps of the active contour that moves the mask's outline",
			new SpinnerNumberModel(10, 0, 1000, 1));
		spinner(grid, "contraction_bias", "Contraction bias",
			"How much the outline wants to shrink; negative lets it grow",
			new SpinnerNumberModel(0.4, -1, 1, 0.05));
		spinner(grid, "smooth_factor", "Smooth factor", "How smooth the outline becomes",
			new SpinnerNumberModel(0.2, 0, 10, 0.1));
		grid.add(new JLabel());
		grid.add(new JLabel());
		spinner(grid, "log_size", "LoG size (px; 0: off)",
			"Edge of a Laplacian of Gaussian for uneven background: odd, 3 to 99",
			new SpinnerNumberModel(0, 0, 99, 1));
		spinner(grid, "log_sigma", "LoG sigma (px; 0: off)", "Its standard deviation",
			new SpinnerNumberModel(0, 0, 50, 0.1));
		return grid;
	}

	private void spinner(final JPanel grid, final String key, final String words, final String help,
		final SpinnerNumberModel numbers) {
		final JSpinner spinner = new JSpinner(numbers);
		final JLabel label = new JLabel(words);
		label.setLabelFor(spinner);
		label.setToolTipText(help);
		spinner.setToolTipText(help);
		spinner.setName(key);
		final int digits = numbers.getStepSize().doubleValue() >= 1 ? 0 : 2;
		spinner.addChangeListener(e -> {
			if (!refreshing)
				model.set(key, number(((Number) spinner.getValue()).doubleValue(), digits));
		});
		spinners.put(key, spinner);
		grid.add(label);
		grid.add(spinner);
	}

	/** As short as it can be: 0.4 and not 0.40. */
	private static String number(final double value, final int digits) {
		final String text = String.format(Locale.ROOT, "%." + digits + "f", value);
		return text.contains(".") ? text.replaceAll("\\.?0+$", "") : text;
	}

	/** Shows the values of the model. */
	void refresh() {
		refreshing = true;
		model.texts().forEach((key, text) -> {
			final double value = text.equals("otsu")
				? model.automatic().orElse(0.5)
				: Double.parseDouble(text);
			final JSpinner spinner = spinners.get(key);
			if (((Number) spinner.getValue()).doubleValue() != value)
				spinner
					.setValue(spinner.getValue() instanceof Integer ? (Object) (int) value : value);
		});
		automatic.setSelected(model.threshold().isEmpty());
		refreshing = false;
	}
}
