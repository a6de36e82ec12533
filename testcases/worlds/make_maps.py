#!/usr/bin/env python3
"""Writes the maps of this folder again: islands.png, river.png and floor.png."""

import math
import pathlib
import struct
import zlib

folder = pathlib.Path(__file__).parent
LAND, WATER = 60, 235          # greys of charts
WALL, UNKNOWN, FREE = 0, 205, 254  # as map_saver of ROS has them


def picture(width, height, grey_of):
    """Rows from the top; grey_of(x, y) has its origin in the lower left corner, in pixels."""
    return [bytes(grey_of(x + 0.5, height - y - 0.5) for x in range(width)) for y in range(height)]


def write_png(name, rows):
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", len(rows[0]), len(rows), 8, 0, 0, 0, 0)
    lines = b"".join(b"\0" + row for row in rows)
    (folder / name).write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header)
                                + chunk(b"IDAT", zlib.compress(lines, 9)) + chunk(b"IEND", b""))


# Islands: x, y, radius, and how the shore goes in and out (lobes, depth, turn).
ISLANDS = [(95, 70, 34, 3, 0.22, 0.4), (200, 60, 26, 5, 0.16, 1.1), (150, 135, 30, 4, 0.25, 2.0), (60, 160, 24, 3, 0.2, 2.9),
           (250, 140, 32, 3, 0.25, 0.9), (115, 205, 22, 5, 0.2, 0.2), (200, 200, 24, 4, 0.22, 1.7), (20, 105, 14, 3, 0.2, 0)]


def islands(x, y):
    for x0, y0, radius, lobes, depth, turn in ISLANDS:
        angle = math.atan2(y - y0, x - x0)
        if math.hypot(x - x0, y - y0) < radius * (1 + depth * math.cos(lobes * angle + turn)):
            return LAND
    return WATER


def river(x, y):
    """A river that winds from the left into the sea on the right, with a bar in its mouth."""
    sea = 205 + 14 * math.sin(y / 21) + 6 * math.sin(y / 7)
    middle = 100 + 42 * math.sin(x / 34)
    half_width = 15 + max(0, x - 120) / 8
    bar = ((x - 228) / 9) ** 2 + ((y - 118) / 30) ** 2 < 1
    in_water = (x > sea or abs(y - middle) < half_width) and not bar
    return WATER if in_water else LAND


# Walls of a floor, in cells of 0.05 m: left, bottom, right, top. Between them doors 1 m wide.
FLOOR = [(0, 0, 360, 4), (0, 236, 360, 240), (0, 0, 4, 240), (356, 0, 360, 240),
         (0, 96, 50, 99), (70, 96, 150, 99), (170, 96, 262, 99), (282, 96, 360, 99),       # south of the passage
         (0, 141, 90, 144), (110, 141, 210, 144), (230, 141, 330, 144), (350, 141, 360, 144),  # north of it
         (120, 0, 123, 97), (232, 0, 235, 97), (150, 143, 153, 240), (270, 143, 273, 240),     # between rooms
         (20, 20, 60, 36), (150, 30, 200, 50), (262, 40, 300, 70), (30, 190, 80, 215), (180, 185, 240, 200),
         (300, 180, 312, 240)]


def floor(x, y):
    if any(left <= x < right and low <= y < top for left, low, right, top in FLOOR):
        return WALL
    # Nobody has looked into the room in the upper right corner.
    return UNKNOWN if x > 312 and y > 180 else FREE


write_png("islands.png", picture(300, 240, islands))
write_png("river.png", picture(280, 200, river))
write_png("floor.png", picture(360, 240, floor))
