/**
 * A skeleton becomes a graph.
 * <p>
 * {@link io.github.knotresolver.graph.SkeletonGraph} is an undirected
 * pseudograph: its vertices are junctions and free ends, its edges the ordered
 * pixel chains between them; parallel edges and loops are normal, since a
 * filament that crosses itself meets the same junction twice.
 * {@link io.github.knotresolver.graph.RootedGraph} says where a walk from the
 * fixed end may begin, and {@link io.github.knotresolver.graph.FilamentDigraph}
 * is the directed graph of the published method.
 */

package io.github.knotresolver.graph;
