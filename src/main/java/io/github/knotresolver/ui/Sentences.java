package io.github.knotresolver.ui;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.FontMetrics;
import java.util.Arrays;
import java.util.List;

import javax.swing.BorderFactory;
import javax.swing.BoxLayout;
import javax.swing.JPanel;
import javax.swing.JTextArea;

/** Sentences below each other, each in as many lines as it needs; no room if there are none. */
final class Sentences extends JPanel {

	private static final long serialVersionUID = 1L;
	private static final Color WRONG = new Color(0xa0, 0x00, 0x00);
	private static final int ROOM = 36;

	/** Sentences that say what is wrong. */
	Sentences() {
		setLayout(new BoxLayout(this, BoxLayout.Y_AXIS));
	}

	void clear() {
		removeAll();
		revalidate();
	}

	/** Adds what is wrong. */
	void add(final String sentence) {
		add(new Lines("\u2716 " + sentence, WRONG));
		GuiFont.scale(this);
		revalidate();
	}

	/** @return whether another sentence is shown now */
	boolean show(final String sentence) {
		return show(List.of(sentence), "");
	}

	/** @return whether other sentences are shown now: what is to be known */
	boolean show(final List<String> notes) {
		return show(notes, "\u26a0 ");
	}

	private boolean show(final List<String> sentences, final String mark) {
		final List<String> wanted = sentences.stream().map(n -> mark + n).toList();
		if (wanted.equals(Arrays.stream(getComponents()).map(c -> ((Lines) c).sentence).toList()))
			return false;
		removeAll();
		wanted.forEach(n -> add(new Lines(n, getForeground())));
		GuiFont.scale(this);
		revalidate();
		repaint();
		return true;
	}

	/** Text in lines of a certain width. */
	private static final class Lines extends JTextArea {

		private static final long serialVersionUID = 1L;

		private final String sentence;

		Lines(final String sentence, final Color colour) {
			this.sentence = sentence;
			setEditable(false);
			setFocusable(false);
			setOpaque(false);
			setForeground(colour);
			setFont(new JPanel().getFont());
			setBorder(BorderFactory.createEmptyBorder(2, 0, 2, 0));
			setAlignmentX(0);
			wrap();
		}

		@Override
		public void setFont(final Font font) {
			super.setFont(font);
			if (sentence != null)
				wrap();
		}

		private void wrap() {
			final FontMetrics metrics = getFontMetrics(getFont());
			final StringBuilder lines = new StringBuilder(), line = new StringBuilder();
			for (final String word : sentence.split(" ")) {
				if (line.length() > 0
					&& metrics.stringWidth(line + " " + word) > ROOM * metrics.getHeight()) {
					lines.append(line).append('\n');
					line.setLength(0);
				}
				line.append(line.length() == 0 ? "" : " ").append(word);
			}
			setText(lines.append(line).toString());
		}

		@Override
		public Dimension getMaximumSize() {
			return new Dimension(Short.MAX_VALUE, getPreferredSize().height);
		}
	}
}
