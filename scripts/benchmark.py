"""The tables of docs/benchmark.md; called by scripts/benchmark."""

import argparse
import csv
import importlib.util
import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

import benchmark_fields as fields

ROOT = pathlib.Path(__file__).resolve().parent.parent
SHARED = ROOT.parent / "shared"
DOCUMENT = ROOT / "docs" / "benchmark.md"
MODES = ("published", "default")
SUITES = ("single", "conditions", "scenes", "real")
RENDERINGS = ((False, "rendered as in the paper"), (True, "rendered additively"))
BINS = (0, .3, .6, .9, .99, 1)
KEPT = ("<!-- interpretation: kept when this file is written again -->", "<!-- end of interpretation -->")
METRICS = (
    ("resolved", "{:.1f}", "pct_resolved"), ("silent", "{:.2f}", "pct_silent"), ("crossing frames", "{:.1f}", "pct_resolved_crossing_frames"),
    ("Dice", "{:.3f}", "mean_dice"), ("Fréchet", "{:.2f}", "median_frechet_px"),
    ("error", "{:.3f}", "mean_err_px"), ("length error", "{:.2f}", "median_abs_len_err_pct"),
    ("flipped", "{:.0f}", "frames_flipped"), ("filaments", "{:.0f}", "filaments"), ("seconds", "{:.2f}", "seconds"),
)
TOTALED = ("pct_resolved", "pct_silent", "pct_resolved_crossing_frames", "mean_dice", "mean_err_px",
           "median_abs_len_err_pct", "frames_flipped", "seconds")
LARGER_IS_BETTER = {"pct_resolved", "pct_resolved_crossing_frames", "mean_dice"}
COMPARED = (("pct_resolved", "resolved frames"), ("pct_resolved_crossing_frames", "resolved crossing frames"),
            ("mean_dice", "Dice"), ("median_frechet_px", "Fréchet"), ("mean_err_px", "error"))
REAL = (
    ("filaments", "{:.0f}", "filaments"), ("frames", "{:.0f}", "present"), ("length CV", "{:.4f}", "length_cv"), ("off > 10 %", "{:.0f}", "off_10pct"),
    ("turning jumps", "{:.0f}", "turning_jumps"), ("step of fixed end", "{:.2f}", "end_jump_px"),
    ("most uncovered", "{:.0%}", "uncovered_max"), ("uncovered > 10 %", "{:.0f}", "uncovered_10pct"),
    ("dark > 10 %", "{:.0f}", "dark_10pct"), ("seconds", "{:.2f}", "seconds"),
)


def options():
    p = argparse.ArgumentParser(prog="scripts/benchmark", description=__doc__)
    p.add_argument("--quick", action="store_true", help="SNR 10 and 20 dB, every frame, and the real movies only")
    p.add_argument("--only", default="", metavar="PATTERN",
                   help="movies whose name matches, such as 'L10|dyn1'; the tables go to target/benchmark.md")
    p.add_argument("--suites", default=",".join(SUITES), help="of single,conditions,scenes,real [all]")
    p.add_argument("--modes", default=",".join(MODES), help="of published,default [both]")
    p.add_argument("--bench", type=pathlib.Path, default=SHARED / "bench",
                   help="folder of render.py, score.py, consistency.py and curves")
    p.add_argument("--real", type=pathlib.Path, default=SHARED / "data" / "real", help="folder of the real movies")
    p.add_argument("--public", type=pathlib.Path, default=SHARED / "data" / "public", help="folder of other people's movies")
    p.add_argument("--out", type=pathlib.Path, metavar="FILE", help="write the tables here")
    p.add_argument("--keep", type=pathlib.Path, metavar="DIR", help="keep the movies and results here")
    return p.parse_args()


def conditions(quick):
    """(snr, additive, step), in the order of the document."""
    for additive, _ in RENDERINGS:
        for snr in (10, 20) if quick else (5, 10, 20, 30):
            yield snr, additive, 1
    for step in () if quick else (5, 10, 30):
        for additive, _ in RENDERINGS:
            yield 10, additive, step


def title(condition):
    snr, additive, step = condition
    sparse = "" if step == 1 else f", every {step}th frame"
    return f"SNR {snr} dB, {dict(RENDERINGS)[additive]}{sparse}"


def rendered(args, folder):
    """The simulated movies wanted: {condition: [(name, tiff, truth)]}."""
    import render
    movies = {}
    for snr, additive, step in conditions(args.quick):
        for curves in sorted(args.bench.glob("curves/*.npz")):
            name = render.movie_name(curves.stem, snr, additive, step)
            if not re.search(args.only, name):
                continue
            tiff, truth, _ = render.render_file(str(curves), str(folder), snr, additive, frame_step=step)
            movies.setdefault((snr, additive, step), []).append((name, tiff, truth))
    return movies


def real_movies(args):
    """The authors' movies and other people's."""
    return [f for folder in (args.real, args.public) for f in sorted(folder.glob("*.tif")) if re.search(args.only, f.stem)]


def is_skipped(file):
    """Whether the published method is spared this movie."""
    return any(c in pathlib.Path(file).stem for c in fields.NOT_PUBLISHED)


def resolve(mode, folder, files):
    """{(mode, movie): row of runs.csv}; every movie has a folder with contours.csv and frames.csv."""
    path = subprocess.run([ROOT / "scripts" / "test-classpath"], check=True, capture_output=True, text=True).stdout
    java = pathlib.Path(os.environ["JAVA_HOME"]) / "bin" / "java" if "JAVA_HOME" in os.environ else "java"
    subprocess.run([java, "-Djava.awt.headless=true", *os.environ.get("JAVA_OPTS", "").split(), "-cp", path.strip(),
                    "io.github.knotresolver.session.BenchmarkMain", folder, mode, *files], check=True)
    with open(folder / mode / "runs.csv", encoding="utf-8") as f:
        return {(mode, row["movie"]): row for row in csv.DictReader(f)}


def scored(movies, modes, folder, runs):
    """{(mode, condition): [(name, rows, summary)]} and {mode: [(step, confidence, right)]}."""
    import numpy as np
    import score
    table, judged = {}, {mode: [] for mode in modes}
    for condition, listed in movies.items():
        for mode in modes:
            for name, _, truth in listed:
                result = folder / mode / name
                best, filaments = fields.best_filament(truth, result)
                filament, rows, summary = best or (1, *score.score(truth, {}))
                said = fields.confidences(result)
                sure = [said.get((filament, f), ("", 0))[1] for f in rows["frame"]]
                rows["silent"] = np.array([c > fields.SURE and not ok and there
                                           for c, ok, there in zip(sure, rows["resolved"], rows["present"])], bool)
                summary |= dict(seconds=float(runs[mode, name]["seconds"]), pct_silent=100 * float(rows["silent"].mean()),
                                filaments=filaments)
                table.setdefault((mode, condition), []).append((name, rows, summary))
                judged[mode] += [(condition[2], c, bool(ok))
                                 for c, ok, there in zip(sure, rows["resolved"], rows["present"]) if there]
    return table, judged


def total(results):
    """Of all frames together, not of the movies' figures; times and flips are sums."""
    import numpy as np
    join = lambda key: np.concatenate([rows[key] for _, rows, _ in results])
    ok, crossing, there = join("resolved"), join("crossings") > 0, join("present")
    mean = lambda v: float(v.mean()) if v.size else float("nan")
    return dict(pct_resolved=100 * mean(ok), pct_silent=100 * mean(join("silent")), pct_resolved_crossing_frames=100 * mean(ok[crossing]),
                mean_dice=mean(join("dice")), mean_err_px=mean(join("err_px")[there]),
                median_abs_len_err_pct=float(np.median(abs(join("len_err_pct")[there]))) if there.any() else float("nan"),
                frames_flipped=sum(s["frames_flipped"] for *_, s in results),
                seconds=sum(s["seconds"] for *_, s in results), frames=len(ok))


def text(form, value):
    if value is None or value != value:
        return "-"
    return "∞" if value == float("inf") else form.format(value)


def markdown(header, rows):
    """A table; what stands left of the first figure is text."""
    words = 1 + (header[1] in ("mode", "contours", "what", "light"))
    lines = [header, ["---"] * words + ["---:"] * (len(header) - words), *rows]
    return "\n".join("| " + " | ".join(map(str, line)) + " |" for line in lines) + "\n"


def summary_section(table, modes, movies):
    header = ["movies", "mode", "frames", *(m[0] for m in METRICS if m[2] in TOTALED)]
    rows = []
    for condition in movies:
        for mode in modes:
            t = total(table[mode, condition])
            rows.append([title(condition), mode, t["frames"], *(text(m[1], t[m[2]]) for m in METRICS if m[2] in TOTALED)])
    return markdown(header, rows)


def movie_sections(table, modes, movies):
    for condition, listed in movies.items():
        rows = []
        for i, (name, *_) in enumerate(listed):
            for mode in modes:
                _, scores, summary = table[mode, condition][i]
                rows.append([name.split("_snr")[0], mode, len(scores["frame"]), *(text(m[1], summary[m[2]]) for m in METRICS)])
        yield f"### {title(condition)}\n\n" + markdown(["movie", "mode", "frames", *(m[0] for m in METRICS)], rows)


def behind(table, movies):
    """Rows in which our mode is behind the published one, by more than what is printed."""
    for condition, listed in movies.items():
        for i, (name, *_) in enumerate(listed):
            theirs, ours = (table[mode, condition][i][2] for mode in MODES)
            for key, label in COMPARED:
                form = next(m[1] for m in METRICS if m[2] == key)
                a, b = text(form, theirs[key]), text(form, ours[key])
                worse = (ours[key] < theirs[key]) == (key in LARGER_IS_BETTER) and ours[key] != theirs[key]
                if "-" not in (a, b) and a != b and worse:
                    yield f"* {name}, {label}: published {a}, default {b}"


def calibration_section(judged):
    header = ["confidence", "every frame: frames", "right", "every 5th to 30th: frames", "right"]
    rows = []
    for low, high in zip(BINS, BINS[1:]):
        row = [f"{low:g} to {high:g}"]
        for dense in (True, False):
            right = [ok for step, c, ok in judged
                     if (step == 1) == dense and low <= c and (c < high or high == 1)]
            row += [len(right), f"{100 * sum(right) / len(right):.1f} %" if right else "-"]
        rows.append(row)
    return markdown(header, rows)


def real_curves(contours):
    """{frame: curve} of the filament with the most frames, and how many filaments there are."""
    import consistency
    import scenes
    if len(contours.read_text().splitlines()) < 2:
        return {}, 0
    if not contours.read_text()[:1].isalpha():
        return consistency.read(str(contours)), 1
    every = scenes.read(str(contours))
    return max(every.values(), key=len), len(every)


def judged_real(args, modes, files, folder, runs):
    """{file: {source: figures}}: the original tool's contours, if they are there, and each mode's."""
    import consistency
    import tifffile
    judged = {}
    for file in files:
        frames = len(tifffile.TiffFile(file).pages)
        sources = {mode: folder / mode / file.stem / "contours.csv" for mode in modes}
        originals = args.real / f"{file.stem}_MTdata.csv"
        if originals.exists():
            sources = {"original tool's own contours": originals} | sources
        judged[f"{file.stem} ({frames} frames)"] = figures = {}
        for source, contours in sources.items():
            curves, filaments = real_curves(contours)
            figures[source] = dict.fromkeys(m[2] for m in REAL) | dict(present=0, off_10pct=frames, filaments=filaments)
            if curves:
                figures[source] |= consistency.judge(curves, frames)
                uncovered, dark = consistency.light(curves, str(file))
                figures[source] |= dict(uncovered_max=max(uncovered.values()),
                                        uncovered_10pct=sum(v > .1 for v in uncovered.values()),
                                        dark_10pct=sum(v > .1 for v in dark.values()))
            if (source, file.stem) in runs:
                figures[source]["seconds"] = float(runs[source, file.stem]["seconds"])
    return judged


def real_section(judged):
    rows = [[movie, source, *(text(m[1], figures[m[2]]) for m in REAL)]
            for movie, sources in judged.items() for source, figures in sources.items()]
    return markdown(["movie", "contours", *(m[0] for m in REAL)], rows)


def behind_real(judged):
    for movie, sources in judged.items():
        theirs, ours = (sources[mode] for mode in MODES)
        for label, form, key in REAL[2:-1]:
            if None not in (theirs[key], ours[key]) and ours[key] > theirs[key]:
                a, b = text(form, theirs[key]), text(form, ours[key])
                if a != b:
                    yield f"* {movie}, {label}: published {a}, default {b}"


def interpretation():
    if DOCUMENT.exists():
        found = re.search(re.escape(KEPT[0]) + "(.*)" + re.escape(KEPT[1]), DOCUMENT.read_text(encoding="utf-8"), re.S)
        if found:
            return found.group(1)
    return "\n"


def version():
    pom = (ROOT / "pom.xml").read_text(encoding="utf-8")
    return re.search(r"<artifactId>KnotResolver_</artifactId>\s*<version>([^<]+)", pom).group(1)


def commit():
    git = subprocess.run(["git", "-C", ROOT, "describe", "--always", "--dirty"], capture_output=True, text=True)
    return f", commit {git.stdout.strip()}" if git.returncode == 0 else ""


def field_sections(field_movies, folder, runs, modes):
    conditions, scenes = field_movies
    if conditions:
        yield fields.conditions_section(conditions, folder, runs, modes, markdown, text)
    if scenes:
        yield fields.scenes_section(scenes, folder, runs, modes, markdown, text)


def command(args):
    """The call's arguments without the folder that was kept, which says nothing to others."""
    kept = {"--keep", str(args.keep)} if args.keep else set()
    return "".join(" " + shlex.quote(a) for a in sys.argv[1:] if a not in kept)


def document(args, modes, movies, field_movies, files, folder, runs):
    out = [f"""# Benchmark

Made by `scripts/benchmark{command(args)}` with KnotResolver {version()}{commit()}, on {os.cpu_count()} cores.
Nothing was told about any movie: no fixed end, no length, no threshold.

* **published**: the published method, `--candidates paper --resolver paper --no-refine`.
* **default**: ours, without any option.

Resolved: discrete Fréchet distance to the true curve below 5 px, from the fixed end to the tip (percent of frames; of the
frames whose true curve crosses itself). Dice: as published, within 2 px, mean. Fréchet: median, px. Error: mean distance of the
contour to the true curve, px, of frames that have a contour. Length error: median of its magnitude, percent. Flipped: frames
whose contour is right but runs from the tip. Seconds: wall clock of resolving the movie on all cores, in a JVM that has resolved
others before, without files or plots. The paper's rendering rounds the true curve to whole pixels, so no error in it can come
near 0.

"""]
    if movies:
        out.append(f"## What the figures say\n\n{KEPT[0]}{interpretation()}{KEPT[1]}\n")
    real = judged_real(args, modes, files, folder, runs)
    table, judged = scored(movies, modes, folder, runs)
    if movies:
        out.append("## Simulated movies, all together\n\n" + summary_section(table, modes, movies))
    if set(modes) == set(MODES):
        worse = [*behind(table, movies), *behind_real(real)]
        out.append("## Where the default is behind the published method\n\nCompared are resolved frames, Dice, Fréchet and error of each movie, and everything but time of the real ones.\n\n"
                   + ("\n".join(worse) if worse else "Nowhere.") + "\n")
    if movies:
        if "default" in modes:
            out.append("## What the confidence is worth\n\nShare of the frames with a contour that are resolved, "
                       "by the confidence that `frames.csv` reports (default mode).\n\n" + calibration_section(judged["default"]))
    out += field_sections(field_movies, folder, runs, modes)
    if files:
        out.append("## Real movies\n\nWithout known truth: a stabilised microtubule keeps its length, turns continuously and "
                   "stays clamped. Of several filaments that one is judged which is seen in the most frames. Off:\nframes whose length is more than 10 % from the median, or missing. Turning jumps: steps "
                   "in which the total turning changes by more\nthan 200°. Uncovered: share of the bright object's skeleton "
                   "farther than 4 px from the contour (a foreign filament that touches\ncounts too). Dark: share of the contour "
                   "outside bright pixels.\n\n" + real_section(real))
    if movies:
        out.append("## Simulated movies, one by one\n")
        out += movie_sections(table, modes, movies)
    return "\n".join(out)


def run(args, folder):
    modes = args.modes.split(",")
    unknown = [m for m in modes if m not in MODES]
    if unknown:
        sys.exit(f"There is no mode '{unknown[0]}'; the modes are {' and '.join(MODES)}.")
    suites = args.suites.split(",")
    unknown = [s for s in suites if s not in SUITES]
    if unknown:
        sys.exit(f"There is no suite '{unknown[0]}'; the suites are {', '.join(SUITES)}.")
    (folder / "movies").mkdir(parents=True, exist_ok=True)
    movies = rendered(args, folder / "movies") if "single" in suites else {}
    conditions = fields.render_conditions(folder / "movies", args.only) if "conditions" in suites else []
    scenes = fields.render_scenes(folder / "movies", args.bench, args.only) if "scenes" in suites else {}
    files = real_movies(args) if "real" in suites else []
    every = [tiff for listed in (*movies.values(), conditions, *scenes.values()) for _, tiff, _ in listed] + files
    if not every:
        sys.exit(f"No movie matches '{args.only}'.")
    runs = {}
    for mode in modes:
        runs |= resolve(mode, folder, [f for f in every if mode == "default" or not is_skipped(f)])
    whole = not args.only and set(modes) == set(MODES) and set(suites) == set(SUITES)
    out = args.out or (DOCUMENT if whole else ROOT / "target" / "benchmark.md")
    out.write_text(document(args, modes, movies, (conditions, scenes), files, folder, runs), encoding="utf-8")
    print(f"Wrote {out}.")


def prepare(bench):
    """Checks that data and libraries are there, and makes the scorers importable."""
    if not (bench / "render.py").exists():
        sys.exit(f"The benchmark's data are not at {bench}; say where with --bench.")
    missing = [m for m in ("numpy", "scipy", "numba", "tifffile", "skimage") if importlib.util.find_spec(m) is None]
    if missing:
        sys.exit(f"{sys.executable} does not have {', '.join(missing)}; name another Python by BENCH_PYTHON.")
    os.environ.setdefault("NUMBA_CACHE_DIR", str(ROOT / "target" / "numba"))
    sys.dont_write_bytecode = True
    sys.path.insert(0, str(bench))


def main():
    args = options()
    prepare(args.bench)
    if args.keep:
        (args.keep / "movies").mkdir(parents=True, exist_ok=True)
        run(args, args.keep.resolve())
    else:
        with tempfile.TemporaryDirectory() as folder:
            run(args, pathlib.Path(folder))


if __name__ == "__main__":
    main()
