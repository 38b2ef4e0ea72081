"""Table and figure of docs/simulation.md; called by scripts/compare-simulation."""

import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

from simulated_curves import simulate

SEEDS = (1, 2, 3)
STEP = 0.2  # um between points when shapes are measured: the longest published link
SHOWN = range(0, 120, 10)
FIGURES = (
    ("turns, median", "{:.2f}"), ("turns, most", "{:.2f}"),
    ("min. radius, median [µm]", "{:.2f}"), ("min. radius, least [µm]", "{:.2f}"),
    ("crossing frames", "{:.0f}"), ("first crossing frame", "{:.0f}"),
    ("tip speed, median [µm/s]", "{:.3f}"), ("end to end / length, median", "{:.2f}"),
    ("turns of the clamped end", "{:.2f}"),
)


def resample(curve):
    arc = np.r_[0, np.cumsum(np.hypot(*np.diff(curve, axis=0).T))]
    t = np.linspace(0, arc[-1], int(round(arc[-1] / STEP)) + 1)
    return np.c_[np.interp(t, arc, curve[:, 0]), np.interp(t, arc, curve[:, 1])]


def crosses(c):
    """Whether links that are not neighbours properly intersect."""
    a, b = c[:-1], c[1:]
    d = b - a

    def side(o, v, p):
        return v[:, None, 0] * (p[None, :, 1] - o[:, None, 1]) - v[:, None, 1] * (
            p[None, :, 0] - o[:, None, 0])

    through = side(a, d, a) * side(a, d, b) < 0
    both = through & through.T
    return bool(np.triu(both, 2).any())


def measure(curves, interval=2.5):
    """The figures of one movie: a list of curves in um, clamped end first."""
    shapes = np.array([resample(c) for c in curves])
    d = np.diff(shapes, axis=1)
    heading = np.unwrap(np.arctan2(d[..., 1], d[..., 0]), axis=1)
    turns = np.abs(heading[:, -1] - heading[:, 0]) / (2 * np.pi)
    # curvature averaged over 0.6 um: motors make shorter wiggles
    curvature = np.abs([np.convolve(row, np.ones(3) / 3, "valid")
                        for row in np.diff(heading, axis=1) / STEP])[1:]
    radius = 1 / curvature.max(axis=1)
    crossing = np.array([crosses(c) for c in shapes])
    speed = np.hypot(*np.diff(shapes[:, -1], axis=0).T) / interval
    span = np.hypot(*(shapes[:, -1] - shapes[:, 0]).T) / (STEP * d.shape[1])
    clamp = np.unwrap(heading[:, 0])
    first = crossing.argmax() + 1 if crossing.any() else np.nan
    return (np.median(turns), turns.max(), np.median(radius), radius.min(), crossing.sum(), first,
            np.median(speed), np.median(span), np.ptp(clamp) / (2 * np.pi))


def cell(values, form):
    known = [form.format(v) for v in values if np.isfinite(v)]
    return " / ".join(known) if known else "-"


def draw(rows, path):
    fig, axes = plt.subplots(len(rows), len(SHOWN), figsize=(12, 0.52 * len(rows)))
    for line, (name, curves) in zip(axes, rows):
        reach = max(np.abs(c - c[0]).max() for c in curves) * 1.05
        for axis, frame in zip(line, SHOWN):
            c = curves[frame] - curves[frame][0]
            axis.scatter(c[:, 0], c[:, 1], c=np.linspace(0, 1, len(c)), s=0.6, cmap="viridis")
            axis.plot(0, 0, "r.", ms=3)
            axis.set(xlim=(-reach / 3, reach), ylim=(-reach / 3, reach / 3), xticks=[], yticks=[])
            axis.set_aspect("equal")
        line[0].set_ylabel(name, rotation=0, ha="right", va="center", fontsize=7)
    for axis, frame in zip(axes[0], SHOWN):
        axis.set_title(f"frame {frame + 1}", fontsize=7)
    fig.subplots_adjust(0.1, 0.005, 0.995, 0.965, 0.03, 0.05)
    fig.savefig(path, dpi=110)


def main(root, folder):
    lines = ["| | " + " | ".join(name for name, _ in FIGURES) + " |",
             "|---|" + "---|" * len(FIGURES)]
    rows = []
    for file in sorted(folder.glob("L*_d*.npz")):
        archive = np.load(file)
        published = list(archive["points"].astype(float))
        length, density = float(archive["length_um"]), float(archive["density"])
        ours = [simulate(root, length, density, seed) for seed in SEEDS]
        rows += [(f"{length:g} µm, {density:g}/µm²\npublished", published), ("ours", ours[0])]
        figures = [measure(c) for c in ours]
        theirs = measure(published)
        lines.append(f"| {length:g} µm, {density:g}/µm²: published | " + " | ".join(
            cell([v], form) for v, (_, form) in zip(theirs, FIGURES)) + " |")
        lines.append("| ours, seeds 1 / 2 / 3 | " + " | ".join(
            cell([f[k] for f in figures], form) for k, (_, form) in enumerate(FIGURES)) + " |")
        print(lines[-2], lines[-1], sep="\n", flush=True)
    page = root / "docs/simulation.md"
    text = page.read_text(encoding="utf-8")
    before, rest = text.split("<!-- table -->")[0], text.split("<!-- end of table -->")[1]
    page.write_text(before + "<!-- table -->\n" + "\n".join(lines) + "\n<!-- end of table -->" + rest,
                    encoding="utf-8")
    draw(rows, root / "docs/images/simulation.png")


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]))
