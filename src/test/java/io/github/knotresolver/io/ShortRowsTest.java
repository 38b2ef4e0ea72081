package io.github.knotresolver.io;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ShortRowsTest {

	@Test
	void aRowThatEndsBeforeXTellsNoPixelSizeAndTheOthersDo(@TempDir final Path folder)
		throws IOException {
		final Path file = Files.writeString(folder.resolve("contours.csv"),
			"frame,index,x_px,y_px,unit,x\n1,0,10,5,nm,20\n1,1,20,5,nm\n1,2,30,5,nm,60\n");
		final ContourInput read = ContourInput.read(file);
		assertEquals(3, read.contours().get(0).orElseThrow().size());
		assertEquals(2, read.calibration().pixelSize(), 1e-9);
	}
}
