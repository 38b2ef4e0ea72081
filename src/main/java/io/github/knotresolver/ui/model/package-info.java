/**
 * What windows show and change, without windows: models that know neither AWT nor Swing nor ImageJ,
 * so that all behaviour is tested without a display.
 */
package io.github.knotresolver.ui.model;
