"""The curves of a simulated filament; called by compare_simulation.py and benchmark_fields.py."""

import pathlib
import subprocess
import tempfile

import numpy as np

PIXEL = 0.1  # um


def simulate(root, length, density, seed):
    """For each of 120 frames the curve in um, clamped end first."""
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder, "movie")
        subprocess.run([root / "scripts/knotresolver", "simulate", "--out", out, "--length",
                        str(length), "--density", str(density), "--seed", str(seed), "--pixel-size",
                        str(PIXEL), "--snr", "inf"], check=True, stdout=subprocess.DEVNULL,
                       stderr=subprocess.DEVNULL)
        rows = np.loadtxt(out / "contours.csv", delimiter=",", skiprows=1)
    return [rows[rows[:, 0] == f, 2:4] * PIXEL for f in range(1, 121)]
