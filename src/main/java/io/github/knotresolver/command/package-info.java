/**
 * SciJava Commands: they turn parameters into options, call the run and
 * show what came of it. The fields of a Command are its macro keys, so they are
 * written in snake_case. The Commands have no menu path and are hidden from
 * imagej-legacy ({@code no-legacy}): the menu goes through
 * {@code plugins.config}.
 */

package io.github.knotresolver.command;
