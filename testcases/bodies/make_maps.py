#!/usr/bin/env python3
"""Writes the maps of this folder again: town.png (300 x 200 pixels) and workshop.map (50 x 50 cells)."""

import pathlib
import struct
import zlib

folder = pathlib.Path(__file__).parent


def field(width, height, rectangles, discs=()):
    """Rows from the top; True where something stands. Places count from the upper left corner."""
    rows = [[False] * width for _ in range(height)]
    for left, top, right, bottom in rectangles:
        for y in range(top, bottom):
            rows[y][left:right] = [True] * (right - left)
    for x0, y0, radius in discs:
        for y in range(height):
            for x in range(width):
                if (x + 0.5 - x0) ** 2 + (y + 0.5 - y0) ** 2 <= radius**2:
                    rows[y][x] = True
    return rows


def write_png(path, rows):
    def chunk(kind, data):
        return (struct.pack(">I", len(data)) + kind + data
                + struct.pack(">I", zlib.crc32(kind + data)))

    lines = b"".join(b"\0" + bytes(40 if cell else 250 for cell in row) for row in rows)
    header = struct.pack(">IIBBBBB", len(rows[0]), len(rows), 8, 0, 0, 0, 0)
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header)
                     + chunk(b"IDAT", zlib.compress(lines, 9)) + chunk(b"IEND", b""))


def write_grid(path, rows):
    lines = [f"height {len(rows)}", f"width {len(rows[0])}"]
    lines += [" ".join("1" if cell else "0" for cell in row) for row in rows]
    path.write_text("\n".join(lines) + "\n")


# Buildings and their wings, a pond, and two long houses with an alley 6 pixels wide between them.
town = field(
    300, 200,
    [(18, 16, 62, 44), (18, 44, 36, 72), (80, 14, 128, 32), (112, 32, 128, 66), (148, 0, 166, 58),
     (186, 16, 238, 40), (220, 40, 238, 76), (256, 20, 284, 60), (14, 92, 52, 122), (70, 84, 96, 140),
     (116, 84, 206, 104), (116, 110, 206, 132), (226, 94, 252, 150), (252, 94, 282, 110),
     (18, 144, 48, 182), (66, 158, 108, 184), (126, 150, 144, 200), (162, 152, 206, 180),
     (222, 168, 270, 186)],
    [(192, 66, 9)])

# Posts, a beam from the ceiling and a bench around an arm that stands in the middle of the floor.
workshop = field(
    50, 50, [(8, 38, 12, 50), (6, 20, 14, 23), (23, 0, 26, 10), (37, 34, 40, 50), (36, 16, 46, 19)])

write_png(folder / "town.png", town)
write_grid(folder / "workshop.map", workshop)
