"""Cloths on rods and poles."""

import math

from mesh import moved
from shapes import ball, box, lathe, rod, sheet

THICK = 0.012


def hung(width, height, wave):
    """A banner below y = 0 in the plane x = 0, its image whole on both sides. `wave` metres deep folds
    grow towards its end."""
    columns, rows = 8, 12
    front, back, places = [], [], []
    for i in range(rows + 1):
        down = i / rows
        row = []
        for j in range(columns + 1):
            across = j / columns
            fold = wave * (0.3 + 0.7 * down) * math.sin(2 * math.pi * (1.5 * across + 0.35 * down))
            row.append((fold + 0.4 * wave * math.sin(5 * down), -height * down, width * (0.5 - across)))
        front.append(row)
        back.append([(x - THICK, y, z) for x, y, z in row])
        places.append([(j / columns, 1 - down) for j in range(columns + 1)])
    return sheet("banner", front, places, back)


def banner():
    """On a rod before a wall, which is at x = 0."""
    width, height, out = 0.75, 3.75, 0.14
    y = height + 0.02
    part = moved(hung(width, height, 0.035), out, y - 0.02, 0)
    part += rod("wood", [(out, y, -0.46), (out, y, 0.46)], 0.022, 8)
    for z in (-0.46, 0.46):
        part += moved(ball("iron", 0.035), out, y, z)
    for z in (-0.41, 0.41):
        part += box("iron", (0, y - 0.06, z - 0.025), (0.014, y + 0.07, z + 0.025), 1)
        part += rod("iron", [(0.01, y - 0.02, z), (out, y - 0.02, z)], 0.011)
    return part


def standard():
    """A banner on a pole of its own."""
    height, y = 2.5, 3.02
    part = lathe([(0.24, 0), (0.24, 0.04), (0.1, 0.09), (0.05, 0.2), (0.026, 0.24), (0.022, 3.15), (0, 3.17)],
                 10, "wood", 2)
    part += moved(lathe([(0, 0), (0.035, 0.03), (0.03, 0.06), (0.05, 0.12), (0, 0.3)], 6, "iron"), 0, 3.13, 0)
    part += rod("wood", [(0.04, y, -0.31), (0.04, y, 0.31)], 0.018, 8)
    for z in (-0.31, 0.31):
        part += moved(ball("iron", 0.03), 0.04, y, z)
    part += moved(hung(0.5, height, 0.025), 0.065, y - 0.015, 0)
    return part


def flag():
    """A pennon on a pole, blown towards x. It wears the chevrons of the banner's image, which point to
    its tip."""
    length, height, hoist, tip = 1.9, 3.2, 0.8, 0.06
    near, far = 1 - 560 / 640, 1 - 352 / 640  # where the image's chevrons end and begin
    columns, rows = 14, 4
    front, back, places = [], [], []
    for i in range(rows + 1):
        row = []
        for j in range(columns + 1):
            out = j / columns
            wide = hoist + (tip - hoist) * out
            blown = 0.14 * out ** 0.7 * math.sin(7.5 * out + 0.5 * i / rows)
            y = height - 0.55 - 0.12 * out ** 2 + wide * (0.5 - i / rows)
            row.append((0.02 + length * out, y, blown))
        front.append(row)
        back.append([(x, y, z - THICK) for x, y, z in row])
        places.append([(i / rows, near + (far - near) * j / columns) for j in range(columns + 1)])
    part = lathe([(0.07, 0), (0.055, height - 0.05), (0, height)], 8, "post")
    part += moved(ball("iron", 0.09), 0, height, 0)
    part += sheet("banner", front, places, back)
    return part
