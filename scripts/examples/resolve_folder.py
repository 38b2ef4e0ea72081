#!/usr/bin/env python3
"""Resolves every movie of a folder from Python.

    python resolve_folder.py MOVIES RESULTS

Needs JPype (pip install jpype1; scyjava and PyImageJ bring it) and the program's jars, which
scripts/install-into-fiji copies into a folder: set KNOTRESOLVER_JARS to that
folder, the one with plugins/ and jars/ in it.
"""
import glob
import os
import sys
from pathlib import Path


def start_java():
    """Starts Java with the program's jars and without a display."""
    import jpype

    home = os.environ["KNOTRESOLVER_JARS"]
    jars = glob.glob(f"{home}/plugins/KnotResolver_-*.jar") + glob.glob(f"{home}/jars/*.jar")
    jpype.startJVM("-Djava.awt.headless=true", classpath=jars)
    return jpype


def main(movies, results):
    java = start_java()
    File = java.JClass("java.io.File")
    context = java.JClass("org.scijava.Context")()
    commands = context.service("org.scijava.command.CommandService")
    command = java.JClass("io.github.knotresolver.command.ResolveFilamentCommand")
    for movie in sorted(Path(movies).glob("*.tif")):
        module = commands.run(command, True, "movie", File(str(movie)), "out",
                              File(str(Path(results) / movie.stem)), "force", True).get()
        delegate = module.getDelegateObject()
        if delegate.isCanceled():
            print(f"{movie.name}: {delegate.getCancelReason()}")
        else:
            print(f"{movie.name}: {module.getOutput('resolution').resolved()} frames resolved")
    context.dispose()


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
