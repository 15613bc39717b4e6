"""What stands in stores and yards: barrel, crate, bench, cart."""

import math

from mesh import around, moved, turned
from shapes import PLANK, REPEAT, band, board, box, lathe, rod

STAVES = 16


def barrel():
    """Of sixteen staves, one plank of the image each, in four hoops; its head lies below the rim."""
    height, end, belly, hoop = 0.9, 0.25, 0.06, 0.008

    def radius(y):
        return end + belly * (1 - (2 * y / height - 1) ** 2)

    profile, wear = [(end, 0)], []
    for y0, y1 in ((0.03, 0.09), (0.22, 0.27), (0.63, 0.68), (0.81, 0.87)):
        if y0 > height / 2 > profile[-1][1]:
            profile.append((radius(height / 2), height / 2))
            wear.append("wood")
        profile += [(radius(y0), y0), (radius(y0) + hoop, y0), (radius(y1) + hoop, y1), (radius(y1), y1)]
        wear += ["wood", "iron", "iron", "iron"]
    profile += [(end, height), (end - 0.025, height), (end - 0.025, height - 0.03)]
    wear += ["wood"] * 3
    return lathe(profile, STAVES, wear, repeats=STAVES * PLANK)


def crate():
    """Boxes in a frame: planked panels between posts and rails, a brace across each of the sides."""
    half, height, beam, inset = 0.35, 0.7, 0.08, 0.025
    inner = half - inset
    repeat = REPEAT["wood"]

    def panel(point, normal):
        thin = max(range(3), key=lambda axis: abs(normal[axis]))
        sides = [axis for axis in (1, 2, 0) if axis != thin]
        return (point[sides[0]] / repeat, (point[sides[1]] + inner) / (2 * inner) * 6 * PLANK + PLANK / 2)

    part = box("wood", (-inner, inset, -inner), (inner, height - inset, inner), 1, panel)
    part += around(board(2, (half - beam, 0, half - beam), (half, height, half), 1), 4)
    flush = half - 0.004
    for i, y in enumerate((0, height - beam)):
        lo, hi = (flush - beam, y + 0.004 * i, beam - half), (flush, y + beam - 0.004, half - beam)
        part += around(board(3 + i, lo, hi, 2), 4)
    slope = math.degrees(math.atan2(height - 2 * beam, 2 * (half - beam)))
    reach = math.hypot(half - beam, height / 2 - beam) - 0.03
    brace = board(6, (flush - 0.05, -0.04, -reach), (flush - 0.008, 0.04, reach), 2)
    part += around(moved(turned(brace, 0, slope), 0, height / 2, 0), 4)
    return part


def bench():
    """Of two boards on trestles; one sits down from either side."""
    part = []
    for i, z in enumerate((-0.2, 0.01)):
        part += board(i, (-0.8, 0.41, z), (0.8, 0.46, z + 0.19), 0)
    for i, x in enumerate((-0.6, 0.54)):
        part += board(3 + i, (x, 0.06, -0.14), (x + 0.06, 0.41, 0.14), 1)
        part += board(5 + i, (x - 0.02, 0, -0.2), (x + 0.08, 0.07, 0.2), 2)
    part += board(7, (-0.66, 0.16, -0.02), (0.66, 0.24, 0.02), 0)
    return part


def wheel(radius):
    """Upright, its axle along z."""
    part = around(board(1, (0.05, -0.02, -0.02), (radius - 0.04, 0.02, 0.02), 0), 8)
    part += band("wood", radius - 0.07, radius - 0.01, -0.03, 0.03, 16, 4)
    part += band("iron", radius - 0.012, radius, -0.025, 0.025, 16, 4)
    part += lathe([(0.05, -0.09), (0.075, -0.04), (0.075, 0.04), (0.05, 0.09)], 8, "wood")
    return turned(part, 0, 90)


def cart():
    """A handcart that rests on its shafts' feet, its shafts towards x."""
    radius, bed = 0.38, 0.5
    part = []
    for i in range(6):
        z = -0.42 + 0.14 * i
        part += board(i, (-0.75, bed, z + 0.002), (0.6, bed + 0.04, z + 0.138), 0)
    for side in (-1, 1):
        z = side * 0.44
        part += board(6, (-0.75, bed - 0.08, z - 0.035), (1.5, bed, z + 0.035), 0)
        part += moved(wheel(radius), -0.1, radius, side * 0.55)
        for i, y in enumerate((0.62, 0.78)):
            part += board(2 + i, (-0.73, y, z - 0.012), (0.58, y + 0.11, z + 0.012), 0)
        for x in (-0.7, -0.1, 0.5):
            outer = z + side * 0.03
            part += board(4, (x, bed, outer - 0.018), (x + 0.05, 0.92, outer + 0.018), 1)
        part += board(1, (0.62, 0, z - 0.03), (0.68, bed, z + 0.03), 1)
    for i, y in enumerate((0.56, 0.72)):
        part += board(5 + i, (-0.755, y, -0.42), (-0.73, y + 0.12, 0.42), 2)
    part += rod("iron", [(-0.1, radius, -0.66), (-0.1, radius, 0.66)], 0.025)
    part += rod("wood", [(1.42, bed - 0.04, -0.5), (1.42, bed - 0.04, 0.5)], 0.025)
    return part
