"""A random search over appearances; called by scripts/appearance-search."""

import argparse
import os
import pathlib
import sys
import tempfile

import benchmark
import benchmark_fields as fields

SLOW = 5
SILENT_PERCENT = .2


def options():
    p = argparse.ArgumentParser(prog="scripts/appearance-search", description=__doc__)
    p.add_argument("--movies", type=int, default=300, help="how many [300]")
    p.add_argument("--seed", type=int, default=1, help="of the random numbers [1]")
    p.add_argument("--bench", type=pathlib.Path, default=benchmark.SHARED / "bench", help="folder of conditions.py and curves")
    p.add_argument("--keep", type=pathlib.Path, metavar="DIR", help="keep the movies and results here")
    return p.parse_args()


def appearance(random):
    """One draw: everything that makes a movie look as it does."""
    log = lambda low, high: float(low * (high / low) ** random.random())
    photons = log(8, 400)
    return dict(
        curves=str(random.choice(("L10_d12", "L10_d100", "L15_d50", "L20_d25", "L20_d50", "L30_d50", "L40_d25"))),
        first=int(random.integers(0, 60)), frames=int(log(4, 60)), step=int(random.choice((1, 1, 1, 2, 4))),
        sigma=log(.8, 5), photons=photons, background=photons * log(.05, 10), read_noise=log(.5, 8),
        gradient=float(random.choice((0, 0, 3, 8))), haze=float(random.choice((0, 0, 1))), beads=int(random.choice((0, 0, 5, 20))),
        margin=int(log(12, 150)), dark=bool(random.random() < .2), eight_bit=bool(random.random() < .2),
        dim_tip=float(random.choice((0, 0, .5, .7))))


def draw(look, random):
    """The stack (T, H, W), and the true curve of every frame."""
    import conditions
    import numpy as np
    from scipy import ndimage as ndi
    pixel = .106 * 1.4 / look["sigma"]
    curves, shape = conditions.curves(os.path.join(conditions.HERE, "curves", look["curves"] + ".npz"), pixel,
                                      look["first"], look["frames"] * look["step"])
    curves = [c + look["margin"] - 24 for c in curves[::look["step"]]]
    height, width = (n + 2 * (look["margin"] - 24) for n in shape)
    yy, xx = np.mgrid[:height, :width]
    base = np.full((height, width), look["background"]) * (1 + look["gradient"] * xx / width)
    if look["haze"]:
        blurred = ndi.gaussian_filter(random.normal(0, 1, (height, width)), 12)
        base = base + look["haze"] * look["photons"] * (blurred - blurred.min()) / np.ptp(blurred)
    for x, y in random.uniform((0, 0), (width, height), (look["beads"], 2)):
        base += 1.5 * look["photons"] * np.exp(-((xx - x) ** 2 + (yy - y) ** 2) / (2 * (1.3 * look["sigma"]) ** 2))
    stack = []
    for c in curves:
        light = np.zeros((height, width))
        conditions.paint(light, c, look["sigma"], look["photons"], lambda u: 1 - look["dim_tip"] * u)
        stack.append(random.poisson(light + base) + random.normal(100, look["read_noise"], light.shape))
    stack = np.array(stack)
    if look["dark"]:
        stack = stack.max() + 10 - stack
    if look["eight_bit"]:
        low, high = np.percentile(stack, (.1, 99.95))
        return np.clip(np.rint(230 * (stack - low) / (high - low) + 10), 0, 255).astype(np.uint8), curves, pixel
    return np.clip(np.rint(stack), 0, 65535).astype(np.uint16), curves, pixel


def render_all(args, folder):
    import conditions
    import numpy as np
    import render
    movies = []
    for i in range(args.movies):
        random = np.random.default_rng((args.seed, i))
        look = appearance(random)
        stack, curves, pixel = draw(look, random)
        name, tiff = f"look{i:03d}", folder / f"look{i:03d}.tif"
        render.write_tiff(str(tiff), stack, pixel=pixel, interval=2.5 * look["step"])
        conditions.write_gt(str(folder / f"{name}_gt.csv"), curves)
        movies.append((name, str(tiff), folder / f"{name}_gt.csv", look | dict(frames=len(stack), size=stack.size, shape=stack.shape)))
    return movies


def report(movies, folder, runs):
    import numpy as np
    per_size = {n: float(runs["default", n]["seconds"]) / (look["frames"] + look["size"] / 1e6) for n, _, _, look in movies}
    usual = float(np.median(list(per_size.values())))
    total = right = said_wrong = silent = empty = 0
    for name, _, truth, look in movies:
        best, _ = fields.best_filament(truth, folder / "default" / name)
        said = fields.confidences(folder / "default" / name)
        failure = runs["default", name]["failure"]
        total += look["frames"]
        wrong = [] if best is None else [said[best[0], f] for f, ok in zip(best[1]["frame"], best[1]["resolved"]) if not ok and (best[0], f) in said]
        wrong = [c for status, c in wrong if status == "resolved"]
        quiet = sum(c > fields.SURE for c in wrong)
        right += 0 if best is None else int(best[1]["resolved"].sum())
        said_wrong, silent, empty = said_wrong + len(wrong), silent + quiet, empty + (best is None)
        slow = per_size[name] / usual
        if quiet or best is None or slow > SLOW:
            print(f"{name}: {quiet} silent, {len(wrong)} said wrong, {slow:.1f} times the usual time, {failure} {look}")
    print(f"{len(movies)} movies, {total} frames: resolved {100 * right / total:.1f} %, said wrong {100 * said_wrong / total:.2f} %, "
          f"silent {100 * silent / total:.2f} % (at most {SILENT_PERCENT} wanted), {empty} movies refused or without a filament; "
          f"slowest {max(per_size.values()) / usual:.1f} times the median for its size (at most {SLOW} wanted).")


def run(args, folder):
    (folder / "movies").mkdir(parents=True, exist_ok=True)
    movies = render_all(args, folder / "movies")
    report(movies, folder, benchmark.resolve("default", folder, [m[1] for m in movies]))


def main():
    args = options()
    benchmark.prepare(args.bench)
    if args.keep:
        run(args, args.keep.resolve())
    else:
        with tempfile.TemporaryDirectory() as folder:
            run(args, pathlib.Path(folder))


if __name__ == "__main__":
    sys.exit(main())
