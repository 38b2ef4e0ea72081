/**
 * Forms: the parameters of a SciJava Command as ImageJ's users meet them. One
 * definition, the {@code @Parameter}s of the Command, gives the dialog, the
 * keys of macros, the line that the recorder writes, and the ranges that every
 * value is checked against.
 */

package io.github.knotresolver.imagej.form;
