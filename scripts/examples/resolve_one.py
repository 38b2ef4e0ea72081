#!/usr/bin/env python3
"""Resolves one movie from Python, with scyjava (pip install scyjava; PyImageJ brings it).

    KNOTRESOLVER_JARS=FIJI python resolve_one.py MOVIE RESULT

FIJI is the folder that scripts/install-into-fiji installed into, the one with plugins/ and jars/ in it.
With PyImageJ, imagej.init(FIJI) does what start() does here, and brings all of Fiji.
"""
import os
import sys
from pathlib import Path

import scyjava


def start(folder):
    """Starts Java without a display, with the program and its libraries; returns the service that runs Commands."""
    jars = [*Path(folder, "plugins").glob("KnotResolver_-*.jar"), *Path(folder, "jars").glob("*.jar")]
    scyjava.config.set_java_constraints(fetch="auto", version="17")  # left alone, scyjava fetches Java 11
    scyjava.config.add_classpath(*map(str, jars))
    scyjava.config.enable_headless_mode()
    scyjava.start_jvm()
    everything = scyjava.jimport("org.scijava.Context")(False)  # False: not an empty context
    return everything.service("org.scijava.command.CommandService")


def resolve(commands, movie, out):
    """Writes a result folder; returns the resolved contours, an (x, y) list of pixels for each frame number."""
    File = scyjava.jimport("java.io.File")
    Command = scyjava.jimport("io.github.knotresolver.command.ResolveFilamentCommand")
    # The options are the macro keys; those left out have their defaults.
    module = commands.run(Command, True, "movie", File(str(movie)), "out", File(str(out)), "force", True).get()
    if module.getDelegateObject().isCanceled():
        raise ValueError(str(module.getDelegateObject().getCancelReason()))
    return {int(frame.frame()): list(zip(frame.contour().get().xs(), frame.contour().get().ys()))
            for frame in module.getOutput("resolution").frames() if frame.contour().isPresent()}


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    contours = resolve(start(os.environ["KNOTRESOLVER_JARS"]), *sys.argv[1:])
    for number, points in contours.items():
        print(f"frame {number}: {len(points)} points, tip at ({points[-1][0]:.2f}, {points[-1][1]:.2f}) px")
