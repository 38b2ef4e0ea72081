/**
 * KnotResolver: one ordered contour per frame of a filament that crosses
 * itself.
 * <p>
 * Data walks through the rooms (packages) in this order; a room imports only
 * from rooms above it:
 * <ol start="0">
 * <li>{@code geometry}, {@code progress}: points, polylines, arc length;
 * progress, cancel, threads</li>
 * <li>{@code model}: what all rooms talk about</li>
 * <li>{@code image}: a frame becomes evidence of lines</li>
 * <li>{@code mask}: evidence, or a threshold, becomes the filament's mask</li>
 * <li>{@code skeleton}: a mask becomes a one-pixel line</li>
 * <li>{@code graph}: a skeleton becomes a graph of junctions and segments</li>
 * <li>{@code candidate}: a graph becomes possible contours with their
 * price</li>
 * <li>{@code contour}: a candidate becomes a polyline; distances between
 * curves</li>
 * <li>{@code fit}: a polyline becomes a physical filament fitted to the
 * image</li>
 * <li>{@code track}: candidates and fits of all frames become tracks</li>
 * <li>{@code paper}: the published method</li>
 * <li>{@code session}: walks a movie through the rooms above, keeps what it
 * found, and answers again and again</li>
 * <li>{@code measure}: contours become calibrated quantities</li>
 * <li>{@code simulate}, {@code evaluate}: side rooms, movies with known truth
 * and scores against it</li>
 * <li>{@code options}: every option once; texts become settings</li>
 * <li>{@code io}: results become files, and back</li>
 * <li>{@code run}: the use cases, from a source to a sink</li>
 * <li>{@code imagej}: the ImageJ edge</li>
 * <li>{@code ui}: windows, thin, and their models, which know no window</li>
 * <li>{@code command}, {@code cli}: SciJava Commands and the command line</li>
 * </ol>
 */

package io.github.knotresolver;
