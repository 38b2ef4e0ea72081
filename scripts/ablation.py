"""The table of docs/constants.md; called by scripts/ablation."""

import argparse
import concurrent.futures
import hashlib
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
SOURCES = ROOT / "src" / "main" / "java"
MEASURED = ROOT / "target" / "ablation.json"
DOCUMENT = ROOT / "docs" / "constants.md"
CONSTANT = re.compile(r"/\*\*((?:(?!\*/).)*)\*/\s*(?:public )?static final (int|double) (\w+) = ([^;]+);", re.S)
TEXT = re.compile(r"\[([^\]]+)\] (.*) Why: (.*)", re.S)
FACTORS = (0.5, 2)
AT_MOST_ONE = ("share", "cosine", "probability")
NO_CONTOURS = ("measure",)
CONDITIONS = (("drift10_L20_d25", 8), ("base_L15_d50", 8))
SCENES = (("glide5", 5),)
INTRODUCTION = """# Tuning constants

What the method is tuned by, room by room: each number with its unit, what it is, and why it has its value. `scripts/ablation`
writes this page from the classes named `...Tuning`.

*px* are pixels where a pixel is meant; a *line width* is the standard deviation of the line's profile; a *noise sigma* the
standard deviation of what is measured where there is no line; *strands* is brightness in units of a single strand's.
"""
ABLATION = """
`scripts/ablation` also halves and doubles one constant at a time, resolves {movies}, and scores them against the truth.
*halved* and *doubled*: percentage of filament-frames in which a contour lies on the true one, whichever way it runs, and in
brackets of contours that lie on none with a confidence above 0.9; as the constants are, it is **{base}**. `=` says that no contour changed at all: these movies do not need the constant.
`fails` says that the program does not work so. A blank cell was not measured; constants of `measure` change no contour, and
`scripts/measurement-accuracy` shows what they are worth. Shares, cosines and probabilities are doubled to 1 at most. Constants of `SceneTuning` are
tried on scenes only.
"""
FIGURES = re.compile(r"as the constants are, it is \*\*(.+?)\*\*")
ROW = re.compile(r"\| `(\w+)` \| (.+?) \| .+ \*Why:\* .+? \|(?: (.*?) \| (.*?) \|)?$")


class Constant:
    """One number of a room."""

    def __init__(self, file, match):
        text = TEXT.fullmatch(" ".join(re.sub(r"\n\s*\*", " ", match[1]).split()))
        if not text:
            sys.exit(f"{file.name}: {match[3]} has no '[unit] what it is. Why: reason'.")
        self.file, self.type, self.name, self.value = file, match[2], match[3], " ".join(match[4].split())
        self.unit, self.what, self.why = text.groups()
        self.room = file.parent.name

    def changed(self, factor):
        if self.type == "int":
            return f"(int) Math.max(1, Math.rint({factor} * ({self.value})))"
        times = f"{factor} * ({self.value})"
        return f"Math.min(1, {times})" if self.unit in AT_MOST_ONE else times

    def key(self, factor):
        return f"{self.room}.{self.name}={self.value}*{factor}"


def constants():
    return [Constant(file, m) for file in sorted(SOURCES.rglob("*Tuning.java")) for m in CONSTANT.finditer(file.read_text())]


def movies(folder, bench):
    """[(tiff, truth)] of the movies, rendered into a folder."""
    import conditions
    import render
    import scenes
    found = []
    for name, count in CONDITIONS:
        condition, curves = name.split("_", 1)
        stack, curve, pixel, interval = conditions.movie(condition, str(bench / "curves" / f"{curves}.npz"), 40, count, 1)
        found.append((name, stack, {1: curve}, pixel, interval))
    for name, count in SCENES:
        stack, curves, interval = scenes.render(str(bench / "scenes" / f"{name}.npz"))
        found.append((name, stack[:count], {k: c[:count] for k, c in curves.items()}, scenes.PIXEL, interval))
    for name, stack, truth, pixel, interval in found:
        render.write_tiff(str(folder / f"{name}.tif"), stack, pixel=pixel, interval=interval)
        scenes.write_truth(str(folder / f"{name}_truth.csv"), truth)
    return [(folder / f"{name}.tif", folder / f"{name}_truth.csv") for name, *_ in found]


def resolve(path, found, folder):
    """Of each movie the percentages found and silently wrong, and a digest of its contours; None if the program fails."""
    import scenes
    out = folder / "out"
    run = subprocess.run(["java", "-Djava.awt.headless=true", "-XX:TieredStopAtLevel=1", "-XX:+UseSerialGC", "-Xmx3g", "-cp", path,
                          "io.github.knotresolver.session.BenchmarkMain", str(out), "default"] + [str(tiff) for tiff, _ in found],
                         capture_output=True, text=True, check=False, timeout=1800)
    if run.returncode:
        return None
    got = {}
    for tiff, truth in found:
        result = out / "default" / tiff.stem / "contours.csv"
        score = scenes.score(str(truth), str(result), str(result.with_name("frames.csv")))
        got[tiff.stem] = {"found": score["found"] or 0, "silent": score["silent"] or 0,
                          "contours": hashlib.sha256(result.read_bytes()).hexdigest()}
    return got


def variant(constant, factor, path, found):
    """What resolve says with one constant changed: its class and all that name it are compiled anew."""
    if constant.file.stem == "SceneTuning":
        found = [(tiff, truth) for tiff, truth in found if tiff.stem in dict(SCENES)]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        source = constant.file.read_text()
        old = re.search(rf"static final \w+ {constant.name} = [^;]+;", source)[0]
        changed = folder / constant.file.name
        changed.write_text(source.replace(old, f"static final {constant.type} {constant.name} = {constant.changed(factor)};"))
        users = [str(f) for f in SOURCES.rglob("*.java") if f != constant.file and constant.file.stem in f.read_text()]
        classes = folder / "classes"
        subprocess.run(["javac", "-nowarn", "-proc:none", "--release", "17", "-d", str(classes), "-cp", path, str(changed)] + users,
                       check=True, capture_output=True)
        return resolve(f"{classes}{os.pathsep}{path}", found, folder)


def measure(args):
    sys.path.insert(0, str(args.bench))
    path = args.classpath or subprocess.run([ROOT / "scripts" / "test-classpath"], check=True, capture_output=True, text=True).stdout.strip()
    measured = json.loads(MEASURED.read_text()) if MEASURED.exists() else {}
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        found = movies(folder, args.bench)
        base = resolve(path, found, folder)
        if measured.get("base", base) != base:
            print("The contours are others than when target/ablation.json was written: all is measured anew.", file=sys.stderr)
            measured = {}
        measured["base"] = base
        MEASURED.parent.mkdir(exist_ok=True)
        wanted = [(c, f) for c in constants() for f in FACTORS if c.room not in NO_CONTOURS
                  and c.key(f) not in measured and re.search(args.only, f"{c.room}.{c.name}")]
        with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
            runs = {pool.submit(variant, c, f, path, found): c.key(f) for c, f in wanted}
            for done, run in enumerate(concurrent.futures.as_completed(runs), 1):
                measured[runs[run]] = run.result()
                MEASURED.write_text(json.dumps(measured, indent=1))
                print(f"{done} of {len(wanted)}: {runs[run]} {cell(measured, runs[run])}", file=sys.stderr)


def cell(measured, key):
    if key not in measured:
        return ""
    got, base = measured[key], measured["base"]
    if got is None:
        return "fails"
    if all(got[m]["contours"] == base[m]["contours"] for m in got):
        return "="
    return figures({**base, **got})


def figures(got):
    mean = lambda key: sum(g[key] for g in got.values()) / len(got)
    return f"{mean('found'):.1f} ({mean('silent'):.1f})"


def known():
    """What is measured, as (text of the base row, {(room, constant, value): cells}); else what the document says already."""
    if MEASURED.exists():
        measured = json.loads(MEASURED.read_text())
        return figures(measured["base"]), {(c.room, c.name, c.value): [cell(measured, c.key(f)) for f in FACTORS] for c in constants()}
    base, cells, room = None, {}, None
    for line in DOCUMENT.read_text().splitlines() if DOCUMENT.exists() else []:
        said, row = FIGURES.search(line), ROW.match(line)
        base = said[1] if said else base
        room = line.strip("# `") if line.startswith("## ") else room
        if row and row[3] is not None:
            cells[room, row[1], row[2]] = [row[3], row[4]]
    return base, cells


def table():
    base, cells = known()
    names = ", ".join(f"{n} ({c} frames)" for n, c in CONDITIONS + SCENES)
    text = INTRODUCTION
    if cells:
        text += ABLATION.format(movies=f"short movies of `scripts/benchmark`: {names}", base=base)
    room = None
    for c in constants():
        if c.room != room:
            room = c.room
            text += f"\n## `{room}`\n\n| constant | value | unit | what, and why |" + (" halved | doubled |" if cells else "")
            text += "\n|---|---:|---|---|" + ("---:|---:|" if cells else "") + "\n"
        text += f"| `{c.name}` | {c.value} | {c.unit} | {c.what} *Why:* {c.why} |"
        text += "".join(f" {text_of} |" for text_of in cells.get((c.room, c.name, c.value), ["", ""])) if cells else ""
        text += "\n"
    DOCUMENT.write_text(text)


def main():
    p = argparse.ArgumentParser(prog="scripts/ablation", description=__doc__)
    p.add_argument("--only", default="", metavar="PATTERN", help="constants whose name, room.NAME, matches")
    p.add_argument("--table", action="store_true", help="write the table of what was measured before, measure nothing")
    p.add_argument("--jobs", type=int, default=1, metavar="N", help="so many variants at a time [1]")
    p.add_argument("--bench", type=pathlib.Path, default=ROOT.parent / "shared" / "bench", help="folder of render.py, score.py and curves")
    p.add_argument("--classpath", metavar="PATH", help="compiled classes and libraries [built by scripts/test-classpath]")
    args = p.parse_args()
    if not args.table:
        measure(args)
    table()


if __name__ == "__main__":
    main()
