/**
 * Windows for a person, thin: they paint what the models in
 * {@link io.github.knotresolver.ui.model} say, and hand on what is clicked, dragged and typed.
 */
package io.github.knotresolver.ui;
