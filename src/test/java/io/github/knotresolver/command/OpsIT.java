package io.github.knotresolver.command;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.BeforeEach;

/** The list of ops in the built jar: what {@link OpsTest} says holds there too. */
class OpsIT extends OpsTest {

	@BeforeEach
	void listComesFromTheJar() {
		assertEquals("jar", OpsTest.class.getResource("/ops.yaml").getProtocol());
	}
}
