package io.github.knotresolver.imagej;

import ij.gui.PolygonRoi;

/**
 * A polyline with a group. ImageJ looks for a colour table in its folder when a
 * group is set, and complains in the log where there is none; this one has a
 * colour of its own.
 */
final class GroupedLine extends PolygonRoi {

	private int group;

	/**
	 * @param line a sub-pixel polyline
	 * @param group 1 to 255
	 */
	GroupedLine(final PolygonRoi line, final int group) {
		super(line.getFloatPolygon().xpoints, line.getFloatPolygon().ypoints, POLYLINE);
		this.group = group;
	}

	@Override
	public int getGroup() {
		return group;
	}

	@Override
	public void setGroup(final int other) {
		group = other;
		super.setGroup(other);
	}
}
