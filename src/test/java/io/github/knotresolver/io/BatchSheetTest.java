package io.github.knotresolver.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import io.github.knotresolver.model.UserException;

class BatchSheetTest {

	private static final String HEADER = "FileName,FolderPath,segThresh,segIteration,segContract,segSmooth,requiresManual,IgnoreFrames,useLogP,logPk,logPs,InvertManual,manualCheck";

	@TempDir
	Path home;

	@Test
	void originalSheetIsReadAsItIs() throws IOException {
		final List<BatchRow> rows = read(HEADER,
			"a b.tif,../in,0.46,10,0.4,0.2,0,0,False,False,False,False,False",
			"c.tif,,0,0,0,0,[1 5],[1 5 7],True,8,1.5,False,[1]",
			"d.tif,/abs,[],,,,False,1;5;7,0,0,0,,").rows();
		assertEquals(home.resolve("../in/a b.tif").normalize().toString(), rows.get(0).movie());
		assertEquals(Map.of("threshold", "0.46", "iterations", "10", "contraction_bias", "0.4",
			"smooth_factor", "0.2"), rows.get(0).texts());
		assertEquals(List.of(), rows.get(0).notes());
		assertEquals(home.resolve("c.tif").toString(), rows.get(1).movie());
		assertEquals(
			Map.of("iterations", "0", "contraction_bias", "0", "smooth_factor", "0",
				"ignore_frames", "[1 5 7]", "log_size", "9", "log_sigma", "1.5"),
			rows.get(1).texts());
		assertEquals(3, rows.get(1).notes().size(), rows.get(1).notes().toString());
		assertEquals(Path.of("/abs/d.tif").toString(), rows.get(2).movie());
		assertEquals(Map.of("ignore_frames", "1;5;7"), rows.get(2).texts());
		rows.forEach(BatchRow::options);
	}

	@Test
	void ownColumnsGoOverTheOriginalsAndUnknownOnesAreNamed() throws IOException {
		final BatchSheet sheet = read(
			"\uFEFFfilename,FOLDERPATH,segThresh,threshold,Fixed_End,corrections,remark",
			"a.tif,.,0.46,0.3,\"3,4\",fix.csv,good one");
		assertEquals(Map.of("threshold", "0.3", "fixed_end", "3,4", "corrections",
			home.resolve("fix.csv").toString()), sheet.rows().get(0).texts());
		assertEquals(List.of("remark"), sheet.unknownColumns());
	}

	@Test
	void badRowIsRefusedAlone() throws IOException {
		final List<BatchRow> rows = read(HEADER, "a.tif,.,1.5", "b.tif,.,0.5").rows();
		assertEquals(2, rows.get(0).line());
		assertTrue(assertThrows(UserException.class, rows.get(0)::options).getMessage()
			.contains("threshold"));
		rows.get(1).options();
	}

	@Test
	void whatIsNoSheetIsRefused() throws IOException {
		assertTrue(assertThrows(UserException.class, () -> read("name,folder", "a,b")).getMessage()
			.contains("FileName and FolderPath"));
		assertTrue(
			assertThrows(UserException.class, () -> read()).getMessage().contains("FileName"));
		assertThrows(UserException.class, () -> BatchSheet.read(home.resolve("absent.csv")));
	}

	@Test
	void theOriginalToolsOwnSheetHasNoBadRow() {
		final Path sheet = Path.of("../shared/data/real/original_sheet.csv");
		assumeTrue(Files.exists(sheet), "The original tool's sheet is not here.");
		final BatchSheet read = BatchSheet.read(sheet);
		assertEquals(3, read.rows().size());
		assertEquals(List.of(), read.unknownColumns());
		assertEquals("0.655738", read.rows().get(2).texts().get("threshold"));
		read.rows().forEach(BatchRow::options);
	}

	private BatchSheet read(final String... lines) throws IOException {
		return BatchSheet
			.read(Files.writeString(home.resolve("sheet.csv"), String.join("\n", lines)));
	}
}
