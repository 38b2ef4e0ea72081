
package io.github.knotresolver;

import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.Stream;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;

import org.junit.jupiter.api.Test;

/** Data walks through the rooms in one direction only. */
class ArchitectureTest {

	private static final String ROOT = "io.github.knotresolver.";

	/** The rooms, in the order in which data walks through them. */
	private static final List<String> ROOMS = List.of("geometry", "progress", "model", "image",
		"mask", "skeleton", "graph", "candidate", "contour", "fit", "track", "paper", "session",
		"measure", "simulate", "evaluate", "options", "io", "run", "imagej", "ui", "command",
		"cli");

	private static final int LARGEST = 250;

	private static final JavaClasses CLASSES = new ClassFileImporter()
		.withImportOption(new ImportOption.DoNotIncludeTests())
		.importPackages("io.github.knotresolver");

	@Test
	void roomImportsOnlyFromRoomsAboveIt() {
		for (int i = 0; i < ROOMS.size() - 1; i++) {
			final String[] below = ROOMS.subList(i + 1, ROOMS.size()).stream()
				.map(r -> ROOT + r + "..").toArray(String[]::new);
			noClasses().that().resideInAPackage(ROOT + ROOMS.get(i) + "..").should()
				.dependOnClassesThat().resideInAnyPackage(below).allowEmptyShould(true)
				.check(CLASSES);
		}
	}

	@Test
	void everyPackageIsARoom() {
		final String[] rooms = ROOMS.stream().map(r -> ROOT + r + "..").toArray(String[]::new);
		noClasses().should().resideOutsideOfPackages(append(rooms, "io.github.knotresolver"))
			.check(CLASSES);
	}

	@Test
	void packagesHaveNoCycles() {
		slices().matching(ROOT + "(**)").should().beFreeOfCycles().check(CLASSES);
	}

	@Test
	void onlyTheEdgeKnowsImageJAndAwt() {
		noClasses().that()
			.resideOutsideOfPackages(ROOT + "imagej..", ROOT + "ui..", ROOT + "command..",
				ROOT + "cli..")
			.should().dependOnClassesThat()
			.resideInAnyPackage("ij..", "java.awt..", "javax.swing..", "org.jfree..")
			.check(CLASSES);
	}

	@Test
	void modelsOfWindowsKnowNoWindow() {
		noClasses().that().resideInAPackage(ROOT + "ui.model..").should().dependOnClassesThat()
			.resideInAnyPackage("ij..", "java.awt..", "javax.swing..", "org.jfree..",
				ROOT + "imagej..")
			.check(CLASSES);
	}

	@Test
	void onlyGraphRoomsKnowJGraphT() {
		noClasses().that()
			.resideOutsideOfPackages(ROOT + "graph..", ROOT + "candidate..", ROOT + "track..",
				ROOT + "paper..")
			.should().dependOnClassesThat().resideInAnyPackage("org.jgrapht..").check(CLASSES);
	}

	/** Lines that are neither blank nor comments. */
	@Test
	void noClassIsLargerThanAPersonKeepsInMind() throws IOException {
		final List<String> large = new ArrayList<>();
		try (Stream<Path> files = Files.walk(Path.of("src/main/java"))) {
			for (final Path file : files.filter(f -> f.toString().endsWith(".java")).toList()) {
				final long lines = Files.readString(file).replaceAll("(?s)/\\*.*?\\*/", "").lines()
					.map(String::strip).filter(l -> !l.isEmpty() && !l.startsWith("//")).count();
				if (lines > LARGEST)
					large.add(file.getFileName() + " has " + lines);
			}
		}
		assertEquals(List.of(), large, "files of more than " + LARGEST + " lines of code");
	}

	/** A name means one thing in all rooms. */
	@Test
	void noClassIsNamedLikeAnother() {
		final Map<String, Long> named = CLASSES.stream().map(JavaClass::getSimpleName)
			.filter(n -> !n.isEmpty() && !n.equals("package-info"))
			.collect(Collectors.groupingBy(n -> n, TreeMap::new, Collectors.counting()));
		assertEquals(List.of(), CLASSES.stream().filter(c -> !c.isNestedClass())
			.map(JavaClass::getSimpleName).filter(n -> named.getOrDefault(n, 1L) > 1).toList());
	}

	private static String[] append(final String[] rooms, final String last) {
		final String[] all = java.util.Arrays.copyOf(rooms, rooms.length + 1);
		all[rooms.length] = last;
		return all;
	}
}
