"""A knight of stone in robe and helm, both hands on a sword, on a plinth."""

import math

from mesh import mirrored, moved, turned
from shapes import ball, box, by_metres, drawn, lathe, rod, tapered

STONE = "hewn"
PLINTH = 0.78  # metres high

# The robe from hem to neck: height above the plinth, half its depth (x) and width (z), how deep its
# folds are as a part of that.
ROBE = [(0.02, 0.25, 0.29, 0.1), (0.06, 0.26, 0.3, 0.11), (0.25, 0.23, 0.27, 0.1), (0.5, 0.2, 0.24, 0.08),
        (0.75, 0.18, 0.215, 0.05), (0.93, 0.165, 0.19, 0.02), (0.97, 0.172, 0.197, 0),
        (1.02, 0.172, 0.197, 0), (1.05, 0.165, 0.19, 0.01), (1.2, 0.175, 0.215, 0.015),
        (1.33, 0.165, 0.235, 0.01), (1.4, 0.13, 0.2, 0), (1.44, 0.09, 0.11, 0), (1.5, 0.075, 0.08, 0)]
# The cloak likewise, its outer side.
CLOAK = [(0.03, 0.34, 0.37), (0.3, 0.3, 0.34), (0.7, 0.25, 0.29), (1.1, 0.22, 0.275), (1.3, 0.205, 0.27),
         (1.41, 0.15, 0.215), (1.45, 0.1, 0.13)]
SIDES = 36


def robe():
    rings = []
    for y, depth, width, fold in ROBE:
        ring = []
        for k in range(SIDES):
            turn = 2 * math.pi * k / SIDES
            deep = 1 + fold * (0.7 * math.cos(9 * turn) + 0.3 * math.cos(5 * turn + 1))
            ring.append((depth * deep * math.cos(turn), y, width * deep * math.sin(turn)))
        rings.append(ring)
    return [in_triangles(drawn(rings, STONE, round_the_figure))]


def round_the_figure(point, normal):
    return (math.atan2(point[2], point[0]) / (2 * math.pi) * 1.5, point[1])


def in_triangles(shell):
    """Corners of folds do not lie in one plane."""
    faces = []
    for material, corners in shell:
        if len(corners) == 4:
            faces += [(material, corners[:3]), (material, [corners[0], *corners[2:]])]
        else:
            faces.append((material, corners))
    return faces


def cloak():
    """From shoulder to shoulder behind the robe, a hand thick."""
    turns = [math.radians(105 + 7.5 * k) for k in range(21)]
    rings = []
    for y, depth, width in CLOAK:
        folds = [1 + 0.05 * max(1.3 - y, 0) * math.cos(11 * turn) for turn in turns]
        ring = [(depth * fold * math.cos(turn), y, width * fold * math.sin(turn))
                for turn, fold in zip(turns, folds)]
        ring += [((depth - 0.05) * math.cos(turn), y, (width - 0.05) * math.sin(turn))
                 for turn in reversed(turns)]
        rings.append(ring)
    return [in_triangles(drawn(rings, STONE, round_the_figure))]


def helm():
    """A great helm: a bucket with a band around it, a ridge down its front and a bar below its slits."""
    bucket = [(0.085, 0), (0.12, 0.02), (0.125, 0.12), (0.12, 0.2), (0.095, 0.27), (0, 0.3)]
    part = moved(lathe(bucket, 14, STONE), -0.01, 1.47, 0)
    part += moved(lathe([(0.13, 0), (0.14, 0.015), (0.13, 0.03)], 14, STONE), -0.01, 1.535, 0)
    part += moved(tapered(STONE, (0.02, 0.014), (0.012, 0.01), 0, 0.24), 0.112, 1.48, 0)
    bar = box(STONE, (-0.012, -0.01, 0), (0.02, 0.01, 0.085), 2)
    bar = moved(turned(bar, 1, -24), 0.108, 1.6, 0.008)
    return part + bar + mirrored(bar)


def arm():
    """The left one, to the sword's hilt."""
    part = moved(ball(STONE, 0.095, 10, 6, 0.9), 0, 1.34, 0.24)
    part += rod(STONE, [(0, 1.34, 0.25), (0.01, 1.22, 0.28), (0.05, 1.09, 0.29), (0.1, 1.03, 0.27),
                        (0.2, 1.03, 0.15), (0.27, 1.05, 0.05)],
                [0.075, 0.075, 0.07, 0.066, 0.055, 0.042], 10)
    part += rod(STONE, [(0.17, 1.03, 0.185), (0.205, 1.03, 0.145)], [0.085, 0.07], 10)
    part += moved(ball(STONE, 0.055, 8, 5), 0.29, 1.05, 0.03)
    return part


def sword():
    part = [drawn([[(0.31 + x * w, y, z * w) for x, z in ((0.014, 0), (0, 0.045), (-0.014, 0), (0, -0.045))]
                   for y, w in ((0.0, 0.2), (0.1, 0.8), (0.9, 1.0))], STONE, by_metres(STONE, 1))]
    part += box(STONE, (0.285, 0.88, -0.15), (0.335, 0.925, 0.15), 2)
    part += rod(STONE, [(0.31, 0.91, 0), (0.31, 1.14, 0)], 0.022, 8)
    part += moved(ball(STONE, 0.04, 8, 4), 0.31, 1.16, 0)
    return part


def feet():
    part = []
    for side in (-1, 1):
        shoe = rod(STONE, [(0.1, 0.045, 0), (0.22, 0.05, 0), (0.31, 0.04, 0), (0.36, 0.03, 0)],
                   [0.05, 0.055, 0.04, 0.015], 8)
        part += moved(turned(shoe, 1, -14 * side), 0, 0, 0.11 * side)
    return part


def plinth():
    part = tapered("dressed", (0.46, 0.46), (0.46, 0.46), 0, 0.14)
    part += tapered("dressed", (0.42, 0.42), (0.36, 0.36), 0.14, 0.22)
    part += tapered("dressed", (0.34, 0.34), (0.34, 0.34), 0.22, 0.62)
    part += tapered("dressed", (0.34, 0.34), (0.41, 0.41), 0.62, 0.7)
    part += tapered("dressed", (0.42, 0.42), (0.42, 0.42), 0.7, PLINTH)
    return part


def statue():
    figure = robe() + cloak() + helm() + arm() + mirrored(arm()) + sword() + feet()
    return plinth() + moved(figure, -0.03, PLINTH, 0)
