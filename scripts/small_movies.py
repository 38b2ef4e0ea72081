"""Short movies, cut out of the sample movie that comes along: many, small and all different."""

import os
import re
import struct

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
SAMPLE = os.path.join(ROOT, 'src/main/resources/io/github/knotresolver/sample/knotted-filament.tif')
WIDTH, HEIGHT, BITS, DESCRIPTION, OFFSETS, COUNTS, RESOLUTION = 256, 257, 258, 270, 273, 279, 282


def sample():
    """-> ((width, height, description, pixels a unit), frames as bytes) of the sample, an ImageJ stack of 8 bit"""
    with open(SAMPLE, 'rb') as f:
        data = f.read()
    order = '<' if data[:2] == b'II' else '>'
    at = struct.unpack_from(order + 'I', data, 4)[0]
    tags = {}
    for i in range(struct.unpack_from(order + 'H', data, at)[0]):
        tag, kind, count, value = struct.unpack_from(order + 'HHII', data, at + 2 + 12 * i)
        if kind == 3 and count == 1:
            value = struct.unpack_from(order + 'H', data, at + 10 + 12 * i)[0]
        tags[tag] = (value, count)
    width, height = tags[WIDTH][0], tags[HEIGHT][0]
    text = data[tags[DESCRIPTION][0]:][:tags[DESCRIPTION][1]].rstrip(b'\0').decode()
    if tags[BITS][0] != 8:
        raise SystemExit('The sample movie must have 8 bit, but has %d.' % tags[BITS][0])
    images = int(dict(line.split('=', 1) for line in text.splitlines() if '=' in line)['images'])
    start, size = tags[OFFSETS][0], width * height
    head = width, height, text, struct.unpack_from(order + 'II', data, tags[RESOLUTION][0])
    return head, [data[start + i * size:][:size] for i in range(images)]


def write(path, head, frames):
    """An ImageJ stack: one directory, the frames one after another"""
    width, height, text, pixels_a_unit = head
    note = re.sub(r'(?m)^(images|frames)=\d+', r'\g<1>=%d' % len(frames), text).encode() + b'\0'
    tags = [(254, 4, 1, 0), (WIDTH, 4, 1, width), (HEIGHT, 4, 1, height), (BITS, 3, 1, 8), (259, 3, 1, 1), (262, 3, 1, 1),
            (DESCRIPTION, 2, len(note), None), (OFFSETS, 4, 1, None), (277, 3, 1, 1), (278, 4, 1, height),
            (COUNTS, 4, 1, width * height), (RESOLUTION, 5, 1, None), (RESOLUTION + 1, 5, 1, None), (296, 3, 1, 1)]
    after = 8 + 2 + 12 * len(tags) + 4
    places = {DESCRIPTION: after + 8, OFFSETS: after + 8 + len(note), RESOLUTION: after, RESOLUTION + 1: after}
    with open(path, 'wb') as f:
        f.write(struct.pack('<2sHI', b'II', 42, 8) + struct.pack('<H', len(tags)))
        for tag, kind, count, value in tags:
            f.write(struct.pack('<HHII', tag, kind, count, places.get(tag, value)))
        f.write(struct.pack('<III', 0, *pixels_a_unit) + note + b''.join(frames))


def make(folder, count, length=4):
    """count movies m0000.tif, ... of length frames each, no two alike"""
    os.makedirs(folder)
    head, frames = sample()
    starts = len(frames) - length + 1
    for i in range(count):
        # Every time that all parts have had their turn, the next ones are one grey value brighter.
        brighter = bytes(min(255, v + i // starts) for v in range(256))
        part = [f.translate(brighter) for f in frames[i % starts:][:length]]
        write(os.path.join(folder, 'm%04d.tif' % i), head, part)
