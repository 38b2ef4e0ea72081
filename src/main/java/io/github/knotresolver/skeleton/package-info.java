/**
 * A mask becomes lines one pixel wide, with their branch and end pixels. The
 * lines have as many parts and as many holes as the mask, and lie in its middle
 * ({@link io.github.knotresolver.skeleton.Skeletonize}). What the evidence is not sure of is cut,
 * pruned, joined or dropped ({@link io.github.knotresolver.skeleton.EvidenceFinder}); what lines look
 * like is found out once for a movie ({@link io.github.knotresolver.skeleton.AppearanceFinder}).
 */

package io.github.knotresolver.skeleton;
