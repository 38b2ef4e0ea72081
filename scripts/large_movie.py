"""A movie of 2048 x 2048 pixels from a simulated one, for scripts/measure-speed --large."""

import argparse
import struct

import numpy as np
import tifffile

EDGE, LEFT, TOP, SHIFTS = 2048, 500, 500, 512


def header(frames):
    """The bytes before the first pixel of an ImageJ TIFF, big-endian, all frames in a row after one directory."""
    text = f"ImageJ=1.54p\nimages={frames}\nframes={frames}\nunit=um\nfinterval=0.5\ntunit=s\nloop=false\n".encode() + b"\0"
    text += b"\0" * (len(text) % 2)
    places = 8 + 2 + 12 * 13 + 4
    pixels = places + len(text) + 16
    tags = [(254, 4, 1, 0), (256, 4, 1, EDGE), (257, 4, 1, EDGE), (258, 3, 1, 16 << 16), (259, 3, 1, 1 << 16), (262, 3, 1, 1 << 16),
            (270, 2, len(text), places), (273, 4, 1, pixels), (277, 3, 1, 1 << 16), (278, 4, 1, EDGE), (279, 4, 1, 2 * EDGE * EDGE),
            (282, 5, 1, places + len(text)), (283, 5, 1, places + len(text) + 8)]
    directory = b"".join(struct.pack(">HHII", *t) for t in tags)
    per_um = struct.pack(">II", 9433962, 1000000)
    return b"MM\0*" + struct.pack(">IH", 8, len(tags)) + directory + struct.pack(">I", 0) + text + per_um + per_um


def main():
    p = argparse.ArgumentParser(prog="scripts/large_movie.py", description=__doc__)
    p.add_argument("movie", help="16-bit TIFF of at most 1548 x 1548 pixels; played to and fro in a frame of noise like its own")
    p.add_argument("out", help="TIFF to write; must not exist")
    p.add_argument("--frames", type=int, default=1000)
    args = p.parse_args()
    movie = tifffile.imread(args.movie)
    count, height, width = movie.shape
    random = np.random.default_rng(1)
    corner = movie[0][:100, :100]
    noise = random.normal(corner.mean(), corner.std(), (EDGE + SHIFTS, EDGE + SHIFTS)).clip(0, 65535).astype(">u2")
    with open(args.out, "xb") as out:
        out.write(header(args.frames))
        for k in range(args.frames):
            at = k % (2 * count - 2)
            y, x = random.integers(0, SHIFTS, 2)
            frame = noise[y:y + EDGE, x:x + EDGE].copy()
            frame[TOP:TOP + height, LEFT:LEFT + width] = movie[min(at, 2 * count - 2 - at)]
            out.write(frame.tobytes())


if __name__ == "__main__":
    main()
