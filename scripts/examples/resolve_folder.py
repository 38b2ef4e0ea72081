#!/usr/bin/env python3
"""Resolves every movie of a folder from Python, each into its own result folder.

    KNOTRESOLVER_JARS=FIJI python resolve_folder.py MOVIES RESULTS

What it needs, and FIJI, are explained in resolve_one.py. A movie that fails is reported, and the rest go on.
"""
import os
import sys
from pathlib import Path

from resolve_one import resolve, start

if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    movies, results = map(Path, sys.argv[1:])
    commands = start(os.environ["KNOTRESOLVER_JARS"])
    for movie in sorted(movies.glob("*.tif")):
        try:
            print(f"{movie.name}: {len(resolve(commands, movie, results / movie.stem))} frames resolved")
        except ValueError as error:
            print(f"{movie.name}: {error}")
