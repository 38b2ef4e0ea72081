package io.github.knotresolver.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.InputStream;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.net.URI;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

import org.junit.jupiter.api.Test;
import org.yaml.snakeyaml.Yaml;

/** The list of ops that the build writes, as an op environment reads it. */
class OpsTest {

	@Test
	void everyOpIsAPublicStaticMethodWithItsParameters() throws Exception {
		final Set<String> names = new HashSet<>();
		for (final Map<String, Map<String, Object>> entry : entries()) {
			assertEquals(Set.of("op"), entry.keySet());
			final Map<String, Object> op = entry.get("op");
			final Method method = method((String) op.get("source"));
			assertTrue(Modifier.isPublic(method.getModifiers())
				&& Modifier.isStatic(method.getModifiers()), method.toString());
			assertEquals(parameters(op, "INPUT"), types(method));
			assertEquals(List.of(plain(method.getReturnType().getTypeName())),
				parameters(op, "OUTPUT"));
			assertFalse(((String) op.get("description")).isBlank(), method.toString());
			((List<?>) op.get("names")).forEach(n -> assertTrue(names.add(n.toString())));
		}
		assertTrue(names.containsAll(Set.of("knotresolver.stretch", "knotresolver.median",
			"knotresolver.laplacianOfGaussian", "knotresolver.otsu", "knotresolver.chanVese",
			"knotresolver.skeletonize", "knotresolver.branchPixels")), names.toString());
	}

	private static List<Map<String, Map<String, Object>>> entries() throws Exception {
		try (InputStream in = OpsTest.class.getResourceAsStream("/ops.yaml")) {
			return new Yaml().load(in);
		}
	}

	/** {@code javaMethod:/package.Class.method%28type%2Ctype%29}. */
	private static Method method(final String source) throws ClassNotFoundException {
		final String text = URI.create(source).getPath();
		final String name = text.substring(1, text.indexOf('('));
		final Class<?> type = Class.forName(name.substring(0, name.lastIndexOf('.')));
		final List<String> wanted = List
			.of(text.substring(text.indexOf('(') + 1, text.indexOf(')')).split(","));
		for (final Method method : type.getDeclaredMethods())
			if (method.getName().equals(name.substring(name.lastIndexOf('.') + 1))
				&& types(method).equals(wanted.stream().map(OpsTest::plain).toList()))
				return method;
		throw new AssertionError("There is no method " + text);
	}

	private static List<String> types(final Method method) {
		final List<String> types = new ArrayList<>();
		for (final Class<?> type : method.getParameterTypes())
			types.add(type.getTypeName());
		return types;
	}

	private static List<String> parameters(final Map<String, Object> op, final String kind) {
		final List<String> types = new ArrayList<>();
		for (final Object parameter : (List<?>) op.get("parameters")) {
			final Map<?, ?> p = (Map<?, ?>) parameter;
			if (kind.equals(p.get("parameter type")))
				types.add(plain((String) p.get("type")));
		}
		return types;
	}

	private static String plain(final String type) {
		return type.replaceAll("<.*>", "");
	}
}
