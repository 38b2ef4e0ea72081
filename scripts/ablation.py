"""The table of docs/constants.md; called by scripts/ablation."""

import argparse
import concurrent.futures
import hashlib
import json
import os
import pathlib
import queue
import re
import subprocess
import sys
import tempfile
import threading

ROOT = pathlib.Path(__file__).resolve().parent.parent
SOURCES = ROOT / "src" / "main" / "java"
MEASURED = ROOT / "target" / "ablation.json"
DOCUMENT = ROOT / "docs" / "constants.md"
CONSTANT = re.compile(r"/\*\*((?:(?!\*/).)*)\*/\s*(?:public )?static final (int|double) (\w+) = ([^;]+);", re.S)
TEXT = re.compile(r"\[([^\]]+)\] (.*) Why: (.*)", re.S)
FACTORS = (0.5, 2)
AT_MOST_ONE = ("share", "cosine", "probability")
NO_CONTOURS = ("measure",)
LONGEST = 300  # seconds of a variant; what takes longer fails
CONDITIONS = (("drift10_L20_d25", 8),)
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
brackets of contours that lie on none with a confidence above 0.9; as the constants are, it is {base}. `=` says that no contour changed at all: these movies do not need the constant.
`fails` says that the program does not work so. A blank cell was not measured; constants of `measure` change no contour, and
`scripts/measurement-accuracy` shows what they are worth. Shares, cosines and probabilities are doubled to 1 at most. Constants of `SceneTuning` are
tried on scenes only.
"""
FIGURES = re.compile(r"as the constants are, it is (.+?)\. `=`")
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


def changeable(path, folder):
    """The class path of a build whose constants are not final: of the classes that have them, and of all that name one."""
    classes, sources, files = folder / "classes", folder / "sources", {c.file for c in constants()}
    for file in files:
        copy = sources / file.relative_to(SOURCES)
        copy.parent.mkdir(parents=True, exist_ok=True)
        copy.write_text(re.sub(r"static final (int|double) ", r"static \1 ", file.read_text()))
    named = re.compile("|".join(rf"\b{f.stem}\b" for f in files))
    users = [str(f) for f in SOURCES.rglob("*.java") if f not in files and named.search(f.read_text())]
    subprocess.run(["javac", "-nowarn", "-proc:none", "--release", "17", "-d", str(classes), "-cp", path]
                   + [str(f) for f in sources.rglob("*.java")] + users, check=True, capture_output=True)
    return f"{classes}{os.pathsep}{path}"


def kept_by_classes():
    """Names, Class.NAME, of the constants that a class keeps for good once it is loaded."""
    kept = re.compile(r"static final [^;(=]+=([^;]*)")
    return {n for f in SOURCES.rglob("*.java") for m in kept.finditer(f.read_text()) for n in re.findall(r"\w+Tuning\.\w+", m[1])}


class Resolver:
    """A running program that resolves the movies with one constant changed; a new one is begun when it is needed."""

    def __init__(self, path, found):
        self.path, self.found, self.program = path, found, None

    def ask(self, constant, factor, fresh=False):
        """Of each movie the percentages found and silently wrong, and a digest of its contours; None if the program fails."""
        found = [(t, truth) for t, truth in self.found if constant.file.stem != "SceneTuning" or t.stem in dict(SCENES)]
        if fresh or not self.program:
            self.close()
            self.program = subprocess.Popen(["java", "-Djava.awt.headless=true", "-XX:+UseSerialGC", "-Xmx3g", "-cp", self.path,
                                             "io.github.knotresolver.session.AblationMain"], stdin=subprocess.PIPE,
                                            stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        with tempfile.TemporaryDirectory() as out:
            most = 1 if constant.unit in AT_MOST_ONE else "Infinity"
            kind = ".".join(constant.file.relative_to(SOURCES).with_suffix("").parts)
            watch = threading.Timer(LONGEST, self.program.kill)
            watch.start()
            try:
                self.program.stdin.write("\t".join(map(str, [kind, constant.name, factor, most, out] + [t for t, _ in found])) + "\n")
                self.program.stdin.flush()
                answer = self.program.stdout.readline()
            finally:
                watch.cancel()
            if answer != "done\n" or fresh:
                self.close()
            return {t.stem: scored(pathlib.Path(out) / "default" / t.stem, truth) for t, truth in found} if answer == "done\n" else None

    def close(self):
        if self.program:
            self.program.kill()
            self.program.communicate()
        self.program = None


def scored(result, truth):
    import scenes
    score = scenes.score(str(truth), str(result / "contours.csv"), str(result / "frames.csv"))
    return {"found": score["found"] or 0, "silent": score["silent"] or 0,
            "contours": hashlib.sha256((result / "contours.csv").read_bytes()).hexdigest()}


def measure(args):
    sys.path.insert(0, str(args.bench))
    path = args.classpath or subprocess.run([ROOT / "scripts" / "test-classpath"], check=True, capture_output=True, text=True).stdout.strip()
    measured = json.loads(MEASURED.read_text()) if MEASURED.exists() else {}
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        found = movies(folder, args.bench)
        path, kept = changeable(path, folder), kept_by_classes()
        wanted = [c for c in constants() if c.room not in NO_CONTOURS]
        resolvers = [Resolver(path, found) for _ in range(args.jobs)]
        base = resolvers[0].ask(next(c for c in wanted if c.file.stem != "SceneTuning"), 1)
        if measured.get("base", base) != base:
            print("The contours are others than when target/ablation.json was written: all is measured anew.", file=sys.stderr)
            measured = {}
        measured["base"] = base
        measured.setdefault("commit", subprocess.run(["git", "-C", ROOT, "rev-parse", "--short", "HEAD"], check=True, capture_output=True,
                                                     text=True).stdout.strip())
        MEASURED.parent.mkdir(exist_ok=True)
        wanted = [(c, f) for c in wanted for f in FACTORS if c.key(f) not in measured and re.search(args.only, f"{c.room}.{c.name}")]
        free = queue.SimpleQueue()
        for resolver in resolvers:
            free.put(resolver)

        def ask(constant, factor):
            resolver = free.get()
            try:
                return resolver.ask(constant, factor, f"{constant.file.stem}.{constant.name}" in kept)
            finally:
                free.put(resolver)

        with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
            runs = {pool.submit(ask, c, f): c.key(f) for c, f in wanted}
            for done, run in enumerate(concurrent.futures.as_completed(runs), 1):
                measured[runs[run]] = run.result()
                MEASURED.write_text(json.dumps(measured, indent=1))
                print(f"{done} of {len(wanted)}: {runs[run]} {cell(measured, runs[run])}", file=sys.stderr)
        for resolver in resolvers:
            resolver.close()


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
        return f"**{figures(measured['base'])}** (code of {measured['commit']})", {(c.room, c.name, c.value): [cell(measured, c.key(f)) for f in FACTORS] for c in constants()}
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
