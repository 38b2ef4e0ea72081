package io.github.knotresolver.graph;

/**
 * A directed edge of the published method's digraph: where a segment touches a
 * junction, walked one way.
 *
 * @param id its number, which makes parallel edges different
 * @param from the vertex that is left
 * @param to the vertex that is entered; one of the two is a branch vertex, the
 *          other a filament vertex
 * @param atSource whether it is the segment's source that touches the junction,
 *          or its target
 */
public record Contact(int id, Label from, Label to, boolean atSource) {

	/** @return whether it leads from the junction into the segment */
	public boolean entersSegment() {
		return to.filament().isPresent();
	}

	/** The number: the same in every run, so that hashed order is too. */
	@Override
	public int hashCode() {
		return id;
	}
}
