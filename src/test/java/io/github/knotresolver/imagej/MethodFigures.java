package io.github.knotresolver.imagej;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.awt.image.BufferedImage;
import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import java.util.function.DoubleUnaryOperator;

import javax.imageio.ImageIO;

import net.imglib2.RandomAccessibleInterval;
import net.imglib2.img.Img;
import net.imglib2.img.array.ArrayImgs;
import net.imglib2.type.logic.BitType;
import net.imglib2.type.numeric.RealType;

import org.jfree.chart.ChartFactory;
import org.jfree.chart.ChartUtils;
import org.jfree.chart.JFreeChart;
import org.jfree.chart.axis.NumberAxis;
import org.jfree.chart.plot.XYPlot;
import org.jfree.chart.renderer.xy.XYLineAndShapeRenderer;
import org.jfree.data.xy.XYSeries;
import org.jfree.data.xy.XYSeriesCollection;

import io.github.knotresolver.candidate.Candidate;
import io.github.knotresolver.candidate.CandidateQuery;
import io.github.knotresolver.candidate.TrailCandidates;
import io.github.knotresolver.contour.ContourBuilder;
import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.FilamentEstimator;
import io.github.knotresolver.fit.LineEstimator;
import io.github.knotresolver.fit.LineModel;
import io.github.knotresolver.fit.ModelPicture;
import io.github.knotresolver.fit.NormalizedFrame;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.graph.Node;
import io.github.knotresolver.graph.Segment;
import io.github.knotresolver.graph.SkeletonGraph;
import io.github.knotresolver.image.Contrast;
import io.github.knotresolver.image.FrameCleaner;
import io.github.knotresolver.image.Pixels;
import io.github.knotresolver.mask.FilamentSegmenter;
import io.github.knotresolver.mask.LocalThreshold;
import io.github.knotresolver.model.Cleaning;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.model.Segmentation;
import io.github.knotresolver.model.Settings;
import io.github.knotresolver.model.Tracks;
import io.github.knotresolver.options.InputOptions;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.session.Session;
import io.github.knotresolver.skeleton.Skeletonize;

/**
 * Draws the figures of {@code docs/method.md} from the sample movie; called by
 * {@code scripts/make-figures}.
 */
public final class MethodFigures {

	/** The frame whose way through the stages is shown. */
	private static final int FRAME = 9;

	private static final int COLUMNS = 3, GAP = 8, CAPTION = 26, SCALE = 6, MARGIN = 14;
	private static final double LINE = 2.5, DOT = 5;
	private static final Color[] SEGMENTS = {new Color(0x56b4e9), new Color(0xe69f00),
		new Color(0x009e73), new Color(0xcc79a7), new Color(0xf0e442), new Color(0xd55e00)};

	private final Movie movie = ImageMovie.of(SampleMovie.open(), InputOptions.DEFAULT);
	private final Tracks tracks = new Session(movie, Settings.DEFAULT).solve(List.of(),
		Progress.NONE);
	private final Polyline contour = tracks.only().frames().get(FRAME - 1).contour().orElseThrow();
	private final RandomAccessibleInterval<? extends RealType<?>> frame = movie.frame(FRAME - 1);
	private final Viewport view = around();
	private final FramePainter painter = new FramePainter(Contrast.of(movie, 170), view);
	private final List<BufferedImage> panels = new ArrayList<>();
	private final List<String> captions = new ArrayList<>();

	private MethodFigures() {
	}

	/**
	 * @param args the folder for the figures
	 * @throws IOException if a file cannot be written
	 */
	public static void main(final String[] args) throws IOException {
		System.setProperty("java.awt.headless", "true");
		final Path folder = Files.createDirectories(Path.of(args[0]));
		final MethodFigures figures = new MethodFigures();
		ImageIO.write(figures.stages(), "png", file(folder, "method-stages.png"));
		ChartUtils.saveChartAsPNG(file(folder, "method-lines.png"), lines(), 760, 420);
		ChartUtils.saveChartAsPNG(file(folder, "method-movie.png"), figures.movie(), 760, 420);
	}

	private static File file(final Path folder, final String name) {
		return folder.resolve(name).toFile();
	}

	private Viewport around() {
		int left = movie.width(), top = movie.height(), right = 0, bottom = 0;
		for (int i = 0; i < contour.size(); i++) {
			left = Math.max(0, Math.min(left, (int) contour.x(i) - MARGIN));
			top = Math.max(0, Math.min(top, (int) contour.y(i) - MARGIN));
			right = Math.min(movie.width() - 1, Math.max(right, (int) contour.x(i) + MARGIN));
			bottom = Math.min(movie.height() - 1, Math.max(bottom, (int) contour.y(i) + MARGIN));
		}
		return new Viewport(left, top, right - left + 1, bottom - top + 1, SCALE);
	}

	private BufferedImage stages() {
		add("frame " + FRAME, painter.paint(frame));
		final Img<BitType> mask = new FilamentSegmenter(Segmentation.DEFAULT, new LocalThreshold())
			.segment(new FrameCleaner(Cleaning.DEFAULT).clean(frame));
		add("mask", shown(0, 1.5).paint(mask));
		final SkeletonGraph graph = SkeletonGraph.of(Skeletonize.thin(mask));
		add("skeleton as a graph", graph(graph));
		addTrails(graph);
		addFit();
		return together();
	}

	private void add(final String caption, final BufferedImage panel) {
		captions.add(caption);
		panels.add(panel);
	}

	private FramePainter shown(final double low, final double high) {
		return new FramePainter(new Contrast(low, high, 255), view);
	}

	private BufferedImage graph(final SkeletonGraph graph) {
		final BufferedImage panel = painter.paint(frame);
		final Graphics2D g = smooth(panel);
		g.setStroke(new BasicStroke((float) LINE));
		for (final Segment s : graph.segments()) {
			g.setColor(SEGMENTS[s.id() % SEGMENTS.length]);
			final Path2D path = new Path2D.Double();
			for (int i = 0; i < s.curve().size(); i++)
				if (i == 0)
					path.moveTo(view.screenX(s.curve().x(i)), view.screenY(s.curve().y(i)));
				else
					path.lineTo(view.screenX(s.curve().x(i)), view.screenY(s.curve().y(i)));
			g.draw(path);
		}
		for (final Node node : graph.nodes()) {
			g.setColor(node.isJunction() ? Color.WHITE : Palette.FIXED_END);
			final Point at = node.position();
			g.fill(new Ellipse2D.Double(view.screenX(at.x()) - DOT, view.screenY(at.y()) - DOT,
				2 * DOT, 2 * DOT));
		}
		g.dispose();
		return panel;
	}

	private void addTrails(final SkeletonGraph graph) {
		final List<Candidate> trails = TrailCandidates.DEFAULT.generate(
			CandidateQuery.of(graph, contour.first(), OptionalDouble.of(tracks.only().length())),
			Progress.NONE).candidates();
		for (int i = 0; i < 3; i++) {
			final BufferedImage panel = painter.paint(frame);
			final Polyline way = ContourBuilder.smooth(trails.get(i));
			painter.draw(panel, way, Palette::along, LINE, 1);
			painter.mark(panel, way.first(), DOT);
			add(String.format(Locale.ROOT, "trail %d of %d, price %.1f px", i + 1, trails.size(),
				trails.get(i).price().total()), panel);
		}
	}

	private void addFit() {
		final BufferedImage panel = painter.paint(frame);
		painter.draw(panel, contour, Palette::along, LINE, 1);
		painter.mark(panel, contour.first(), DOT);
		add("the fit that the movie chose", panel);
		final Chain chain = Chain.along(contour, FilamentEstimator.links(contour.length()),
			contour.length());
		final NormalizedFrame pixels = new NormalizedFrame(movie.width(), movie.height(),
			Pixels.doubles(frame));
		final List<LineEstimator.Example> example = List
			.of(new LineEstimator.Example(pixels, chain));
		final LineEstimator.LineEstimate line = LineEstimator.estimate(example,
			LineModel.Kind.ADDITIVE, 1.8, l -> l.misfit(example), Progress.NONE);
		final double[] seen = pixels.rescaled(line.background(), line.amplitude()).pixels();
		final double[] drawn = ModelPicture.of(movie.width(), movie.height(), line.model(), chain)
			.pixels();
		add("its picture", shown(-0.2, 2.5).paint(image(drawn)));
		final double[] rest = new double[seen.length];
		for (int i = 0; i < rest.length; i++)
			rest[i] = seen[i] - drawn[i];
		add("frame minus picture", shown(-1, 1).paint(image(rest)));
	}

	private RandomAccessibleInterval<? extends RealType<?>> image(final double[] values) {
		return ArrayImgs.doubles(values, movie.width(), movie.height());
	}

	private BufferedImage together() {
		final int width = view.screenWidth() + GAP, height = view.screenHeight() + CAPTION + GAP;
		final int rows = (panels.size() + COLUMNS - 1) / COLUMNS;
		final BufferedImage all = new BufferedImage(COLUMNS * width - GAP, rows * height - GAP,
			BufferedImage.TYPE_INT_RGB);
		final Graphics2D g = smooth(all);
		g.setColor(Color.WHITE);
		g.fillRect(0, 0, all.getWidth(), all.getHeight());
		g.setColor(Color.BLACK);
		g.setFont(new Font(Font.SANS_SERIF, Font.PLAIN, 17));
		for (int i = 0; i < panels.size(); i++) {
			final int left = i % COLUMNS * width, top = i / COLUMNS * height;
			g.drawString((char) ('a' + i) + "  " + captions.get(i), left + 2, top + CAPTION - 8);
			g.drawImage(panels.get(i), left, top + CAPTION, null);
		}
		g.dispose();
		return all;
	}

	private static Graphics2D smooth(final BufferedImage picture) {
		final Graphics2D g = picture.createGraphics();
		g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
		g.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING,
			RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
		return g;
	}

	/** Brightness across a single strand and across two strands, by both line models. */
	private static JFreeChart lines() {
		final double sigma = 1.6, apart = 3;
		final XYSeriesCollection data = new XYSeriesCollection();
		final DoubleUnaryOperator additive = d -> Math.exp(-d * d / (2 * sigma * sigma));
		final DoubleUnaryOperator flat = d -> Math.exp(-Math.pow(d * d / (2 * sigma * sigma), 1.5));
		data.addSeries(series("additive, two strands 3 px apart",
			d -> additive.applyAsDouble(d + apart / 2) + additive.applyAsDouble(d - apart / 2)));
		data.addSeries(series("saturating (p = 1.5), two strands 3 px apart",
			d -> Math.max(flat.applyAsDouble(d + apart / 2), flat.applyAsDouble(d - apart / 2))));
		data.addSeries(series("additive, one strand", additive));
		data.addSeries(series("saturating (p = 1.5), one strand", flat));
		return chart("place across the strands [px]", "brightness [strands]", data);
	}

	private static XYSeries series(final String name, final DoubleUnaryOperator value) {
		final XYSeries series = new XYSeries(name);
		for (double d = -7; d <= 7; d += 0.1)
			series.add(d, value.applyAsDouble(d));
		return series;
	}

	/** Vertices of the trellis and confidence, frame by frame. */
	private JFreeChart movie() {
		final XYSeries vertices = new XYSeries("different fits (vertices of the trellis)");
		final XYSeries confidence = new XYSeries("confidence of the chosen one");
		for (final Observation f : tracks.only().frames()) {
			vertices.add(f.frame(), f.candidates());
			confidence.add(f.frame(), f.confidence());
		}
		final JFreeChart chart = chart("frame", "different fits", new XYSeriesCollection(vertices));
		final XYPlot plot = chart.getXYPlot();
		plot.getRangeAxis().setRange(0, 1.1 * vertices.getMaxY());
		final NumberAxis right = new NumberAxis("confidence");
		right.setRange(0, 1.1);
		right.setLabelFont(plot.getRangeAxis().getLabelFont());
		right.setTickLabelFont(plot.getRangeAxis().getTickLabelFont());
		plot.getRangeAxis().setStandardTickUnits(NumberAxis.createIntegerTickUnits());
		plot.setRangeAxis(1, right);
		plot.setDataset(1, new XYSeriesCollection(confidence));
		plot.mapDatasetToRangeAxis(1, 1);
		plot.setRenderer(1, lineOf(new Color(0xd55e00)));
		plot.setRenderer(0, lineOf(new Color(0x0072b2)));
		return chart;
	}

	private static JFreeChart chart(final String x, final String y, final XYSeriesCollection data) {
		final JFreeChart chart = ChartFactory.createXYLineChart(null, x, y, data);
		final XYPlot plot = chart.getXYPlot();
		plot.setBackgroundPaint(Color.WHITE);
		plot.setDomainGridlinePaint(Color.LIGHT_GRAY);
		plot.setRangeGridlinePaint(Color.LIGHT_GRAY);
		final XYLineAndShapeRenderer renderer = new XYLineAndShapeRenderer(true, false);
		final Color[] colours = {new Color(0x0072b2), new Color(0xd55e00), new Color(0x56b4e9),
			new Color(0xe69f00)};
		for (int i = 0; i < colours.length; i++) {
			renderer.setSeriesPaint(i, colours[i]);
			renderer.setSeriesStroke(i, new BasicStroke(i < 2 ? 2.5f : 1.5f));
		}
		plot.setRenderer(renderer);
		return chart;
	}

	private static XYLineAndShapeRenderer lineOf(final Color colour) {
		final XYLineAndShapeRenderer renderer = new XYLineAndShapeRenderer(true, true);
		renderer.setSeriesPaint(0, colour);
		renderer.setSeriesStroke(0, new BasicStroke(1.5f));
		return renderer;
	}
}
