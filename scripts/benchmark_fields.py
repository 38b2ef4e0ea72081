"""Whole fields in the benchmark: conditions one at a time, and scenes of several filaments; called by benchmark.py."""

import os
import pathlib
import re

CURVES = ("L20_d25", "L15_d50", "L30_d50")
# A filament that is a ring with its tip on it in all frames; each of these was lost or silently wrong, and some are lost.
RING = "L10_d100"
RING_CONDITIONS = ("base", "drift10", "field512", "hot", "clipped", "dimtip", "photons10")
# Filaments of our own simulator, {name: (length in um, motors per um2, seed)}, and what was lost or silently wrong of them.
SIMULATED = {"L10_d50": (10, 50, 11), "L25_d75": (25, 75, 16)}
SIMULATED_CONDITIONS = {"L10_d50": ("drift10",), "L25_d75": ("drift10", "static_cross")}
APART = (RING, *SIMULATED)
FOREIGN = ("static_cross", "glide_cross", "neigh1", "neigh3")
# The published method takes most of a large field for filament and thins it for minutes.
NOT_PUBLISHED = ("field512", "field1024")
SCENE_SETS = {
    "photons 100": {}, "photons 100, brightest strand only": dict(saturating=True),
    "photons 30": dict(photons=30.), "photons 100, every 2nd frame": dict(step=2), "photons 100, other noise": dict(seed=2),
}
SURE = .9
CONDITION_COLUMNS = (("resolved", "{:.1f}"), ("crossing", "{:.1f}"), ("said_wrong", "{:.1f}"), ("silent", "{:.2f}"),
                     ("err_px", "{:.3f}"), ("len_err", "{:.2f}"), ("filaments", "{:.1f}"), ("seconds", "{:.1f}"))
CONDITION_HEADER = ("resolved", "crossing frames", "said wrong", "silent", "error", "length error", "filaments", "seconds")
SCENE_COLUMNS = (("resolved", "{:.1f}"), ("resolved_crossing", "{:.1f}"), ("found", "{:.1f}"), ("switches", "{:.0f}"), ("false", "{:.2f}"),
                 ("silent", "{:.2f}"), ("direction", "{:.0f}"), ("err_px", "{:.3f}"), ("len_err", "{:.2f}"))
SCENE_HEADER = ("resolved", "crossing", "found", "switches", "false", "silent", "direction", "error", "length error")


def render_conditions(folder, pattern):
    """[(name, tiff, truth)] of the condition movies whose name, CONDITION_CURVES, matches."""
    import conditions
    import render
    found = []
    listed = dict.fromkeys(CURVES, conditions.CONDS) | {RING: RING_CONDITIONS} | SIMULATED_CONDITIONS
    for curves, wanted in listed.items():
        for condition in wanted:
            name = f"{condition}_{curves}"
            if not re.search(pattern, name):
                continue
            base = folder / name
            tiff, truth = base.with_suffix(".tif"), folder / f"{name}_gt.csv"
            if not tiff.exists():
                points = simulated(folder, curves) if curves in SIMULATED else os.path.join(conditions.HERE, "curves", curves + ".npz")
                stack, curve, pixel, interval = conditions.movie(condition, str(points))
                render.write_tiff(str(tiff), stack, pixel=pixel, interval=interval)
                conditions.write_gt(str(truth), curve)
            found.append((name, str(tiff), str(truth)))
    return found


def simulated(folder, name):
    """The file with a simulated filament's curves, as those of the benchmark are."""
    import numpy as np
    import render
    import simulated_curves
    points = folder / f"{name}.npz"
    if not points.exists():
        length, density, seed = SIMULATED[name]
        curves = simulated_curves.simulate(pathlib.Path(__file__).parent.parent, length, density, seed)
        links = round(length / simulated_curves.PIXEL)
        np.savez(points, points=np.array([render.resample(c, np.hypot(*np.diff(c, axis=0).T).sum() / links) for c in curves]))
    return points


def render_scenes(folder, bench, pattern):
    """{set: [(name, tiff, truth)]} of the scenes whose name matches."""
    import render
    import scenes
    found = {}
    for label, light in SCENE_SETS.items():
        suffix = "".join(f"_{k}{v:g}" if v is not True else f"_{k}" for k, v in light.items())
        for file in sorted(bench.glob("scenes/*.npz")):
            name = file.stem + suffix
            if not re.search(pattern, name):
                continue
            tiff, truth = folder / f"{name}.tif", folder / f"{name}_truth.csv"
            if not tiff.exists():
                stack, curves, interval = scenes.render(str(file), **light)
                render.write_tiff(str(tiff), stack, pixel=scenes.PIXEL, interval=interval)
                scenes.write_truth(str(truth), curves)
            found.setdefault(label, []).append((name, str(tiff), str(truth)))
    return found


def confidences(result):
    """{(filament, frame): (status, confidence)} of a result folder."""
    import conditions
    return {(int(r.get("filament") or 1), int(r["frame"])): (r["status"], float(r["confidence"] or 0))
            for r in conditions.rows(result / "frames.csv")}


def best_filament(truth, result):
    """The result's filament that agrees best with the truth: (id, rows, summary), or None; and how many there are."""
    import scenes
    import score
    true_curves = score.read_curves(str(truth))
    curves = scenes.read(str(result / "contours.csv"))
    scored = [(k, *score.score(true_curves, c)) for k, c in sorted(curves.items())]
    return max(scored, key=lambda s: s[2]["pct_resolved"], default=None), len(curves)


def judged_frames(truth, result):
    """[(confidence, right)] of the frames that are said to be resolved, of the filament that agrees best."""
    best, _ = best_filament(truth, result)
    if best is None:
        return []
    filament, rows, _ = best
    said = confidences(result)
    return [(said[filament, f][1], bool(ok)) for f, ok in zip(rows["frame"], rows["resolved"])
            if said.get((filament, f), ("",))[0] == "resolved"]


def condition_scores(movies, folder, runs, mode):
    """[(condition, {column: mean over the curves})]."""
    import conditions
    import numpy as np
    scores = {}
    for name, _, truth in movies:
        result = folder / mode / name
        if (mode, name) not in runs:
            continue
        figures = conditions.score(truth, str(result / "contours.csv"))
        figures["seconds"] = float(runs[mode, name]["seconds"])
        figures["filaments"] = best_filament(truth, result)[1]
        scores.setdefault(name if name.endswith(APART) else name.rsplit("_L", 1)[0], []).append(figures)
    mean = lambda values: float(np.mean(values)) if values else None
    return [(condition, {key: mean([f[key] for f in listed if f[key] is not None]) for key, _ in CONDITION_COLUMNS})
            for condition, listed in scores.items()]


def conditions_section(movies, folder, runs, modes, markdown, text):
    import conditions
    curves = [c for c in CURVES if any(name.endswith(c) for name, *_ in movies)]
    out = ["## Conditions, one at a time\n",
           f"Physical light (`bench/conditions.py`, 60 frames), mean over the curves {', '.join(curves)}, and of {RING} and of our simulated {', '.join(SIMULATED)} by themselves; `breaks`, `leaves` and others as "
           "`conditions.py list` tells. Said wrong: frames whose\nstatus is `resolved` and whose contour is wrong; silent: those of them with "
           f"confidence above {SURE:g}; percent of all frames. Filaments: how many the result has;\nthe one that agrees best with the truth counts. "
           "The published method is not run on the large fields, where it thins for minutes.\n"]
    for mode in modes:
        scores = condition_scores(movies, folder, runs, mode)
        if not scores:
            continue
        rows = [[c, conditions.CONDS[c.rsplit("_L", 1)[0]], *(text(form, figures[key]) for key, form in CONDITION_COLUMNS)] for c, figures in scores]
        judged = [j for name, _, truth in movies if (mode, name) in runs for j in judged_frames(truth, folder / mode / name)]
        sure = [ok for c, ok in judged if c > SURE]
        share = f"{100 * sum(sure) / len(sure):.2f} %" if sure else "none"
        out.append(f"### {mode}\n\n" + markdown(["condition", "what", *CONDITION_HEADER], rows)
                   + f"\nFrames with confidence above {SURE:g}: {len(sure)} of {len(judged)} that are called resolved; right: {share}.\n")
    return "\n".join(out)


def scenes_section(movies, folder, runs, modes, markdown, text):
    import scenes
    out = ["## Scenes of several and free filaments\n",
           "`bench/scenes.py`, 120 frames (60 with every 2nd). Resolved: percent of true filament-frames with the right curve under the right "
           "name; crossing: of those that cross\nthemselves or another. Found: by any name. Switches: changes of name. False: result "
           f"filament-frames that agree with no true one, percent; silent: those with\nconfidence above {SURE:g}. Direction: percent of filaments that run the right way.\n"]
    for mode in modes:
        rows = []
        for label, listed in movies.items():
            for name, _, truth in listed:
                if (mode, name) not in runs:
                    continue
                result = folder / mode / name
                figures = scenes.score(truth, str(result / "contours.csv"), str(result / "frames.csv"))
                rows.append([re.sub(r"_(saturating|photons\d+|step\d+|seed\d+)$", "", name), label, f"{figures['result_filaments']} of {figures['filaments']}",
                             *(text(form, figures[key]) for key, form in SCENE_COLUMNS), text("{:.1f}", float(runs[mode, name]["seconds"]))])
        if rows:
            out.append(f"### {mode}\n\n" + markdown(["scene", "light", "filaments", *SCENE_HEADER, "seconds"], rows))
    return "\n".join(out)
