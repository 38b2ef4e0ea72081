/**
 * The vocabulary that all rooms share.
 */
package io.github.knotresolver.model;
