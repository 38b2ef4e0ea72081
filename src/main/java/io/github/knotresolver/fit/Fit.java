package io.github.knotresolver.fit;

/**
 * A chain that has been fitted to a frame.
 *
 * @param chain the filament
 * @param light change of the frame's robust price by drawing the chain: the
 *          more negative, the more light it explains
 * @param energy light plus the prices of bending and of leaving the fixed end
 * @param iterations steps that were taken
 */
public record Fit(Chain chain, double light, double energy, int iterations) {
}
