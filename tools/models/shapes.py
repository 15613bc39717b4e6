"""Boxes, turned and drawn shapes: parts of one shell each."""

import math

from mesh import cross, outward

# Metres that one repeat of an image covers. Things are smaller than walls, so their images are, too.
REPEAT = {"banner": 1, "dressed": 1.6, "ember": 0.4, "hewn": 1, "iron": 0.8,
          "plaster": 1, "post": 1.2, "wood": 0.9}
PLANK = 1 / 8  # of the image of wood: the height of one of its planks


def by_metres(material, grain=0):
    """Places in the image by position, the image's rows along axis `grain` where the face has it."""
    repeat = REPEAT[material]

    def place(point, normal):
        thin = max(range(3), key=lambda axis: abs(normal[axis]))
        across = [axis for axis in (0, 2, 1) if axis != thin]
        if grain in across and across[0] != grain:
            across.reverse()
        return tuple(point[axis] / repeat for axis in across)

    return place


def plank(index, lo, hi, grain):
    """One plank of the image of wood covers a board between two corners, whatever its width."""
    def place(point, normal):
        thin = max(range(3), key=lambda axis: abs(normal[axis]))
        sides = [axis for axis in range(3) if axis not in (thin, grain)]
        across = (point[sides[0]] - lo[sides[0]]) / (hi[sides[0]] - lo[sides[0]])
        along = point[grain] if thin != grain else point[sides[-1]]
        return (along / REPEAT["wood"] + 0.37 * index, PLANK * (index - 0.5 + across))

    return place


def normal_of(points):
    """Newell's, not of length one."""
    total = (0, 0, 0)
    for a, b in zip(points, points[1:] + points[:1]):
        total = tuple(t + c for t, c in zip(total, cross(a, b)))
    return total


def faced(material, points, place):
    normal = normal_of(points)
    return (material, [(point, place(point, normal)) for point in points])


def box(material, lo, hi, grain=0, place=None):
    place = place or by_metres(material, grain)
    corners = ((0, 0), (1, 0), (1, 1), (0, 1))
    sides = []
    for axis in range(3):
        for end in (lo, hi):
            side = []
            for a, b in corners if end is hi else corners[::-1]:
                point = list(end)
                point[axis - 2], point[axis - 1] = (lo, hi)[a][axis - 2], (lo, hi)[b][axis - 1]
                side.append(tuple(point))
            sides.append(faced(material, side, place))
    return [outward(sides)]


def board(index, lo, hi, grain):
    return box("wood", lo, hi, grain, plank(index, lo, hi, grain))


def tapered(material, base, top, y0, y1, grain=0):
    """A block whose half widths (x, z) change from its base to its top."""
    rings = [[(sx * w, y, sz * d) for sx, sz in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
             for (w, d), y in ((base, y0), (top, y1))]
    return [drawn(rings, material, by_metres(material, grain))]


# --- Shapes that are drawn from outline to outline

def drawn(rings, material, place):
    """The shell between rings of as many corners each, closed by its first and its last."""
    faces = []
    for below, above in zip(rings, rings[1:]):
        count = len(below)
        for i in range(count):
            j = (i + 1) % count
            faces.append(faced(material, [below[i], below[j], above[j], above[i]], place))
    faces.append(faced(material, rings[0][::-1], place))
    faces.append(faced(material, rings[-1], place))
    return outward(faces)


def circle(radius, y, sides, start=0):
    turns = [math.radians(start) + 2 * math.pi * k / sides for k in range(sides)]
    return [(radius * math.cos(turn), y, radius * math.sin(turn)) for turn in turns]


def lathe(profile, sides, wear, repeats=1):
    """A profile of (radius, height) from the bottom to the top, turned about y. `wear` = (material, ...)
    of what lies between its corners, or one for all; ends that are not on the axis are closed with the
    first and the last. The image goes round `repeats` times; that of wood with its planks upright."""
    wear = [wear] * (len(profile) - 1) if isinstance(wear, str) else wear
    lengths = [0]
    for (r0, y0), (r1, y1) in zip(profile, profile[1:]):
        lengths.append(lengths[-1] + math.hypot(r1 - r0, y1 - y0))

    def corner(i, k, material):
        r, y = profile[i]
        turn = 2 * math.pi * k / sides
        point = (r * math.cos(turn), y, r * math.sin(turn)) if r else (0, y, 0)
        around, up = repeats * k / sides, lengths[i] / REPEAT[material]
        return (point, (up, around + PLANK / 2) if material == "wood" else (around, up))

    faces = []
    for i, material in enumerate(wear):
        for k in range(sides):
            quad = [corner(i, k, material), corner(i, k + 1, material), corner(i + 1, k + 1, material),
                    corner(i + 1, k, material)]
            if not profile[i][0]:
                del quad[1]
            elif not profile[i + 1][0]:
                del quad[2]
            quad = [(point if point[2] or point[0] else (0, point[1], 0), place) for point, place in quad]
            faces.append((material, quad))
    for end, (r, y), material in ((0, profile[0], wear[0]), (1, profile[-1], wear[-1])):
        if r:
            points = circle(r, y, sides)
            faces.append(faced(material, points if end else points[::-1], by_metres(material)))
    return [outward(closed_round(faces, profile, sides))]


def closed_round(faces, profile, sides):
    """The faces with the corners after a whole turn exactly on those of its beginning."""
    begin = {}
    for r, y in profile:
        for point in circle(r, y, sides):
            begin[tuple(round(value, 6) + 0.0 for value in point)] = point
    return [(material, [(begin[tuple(round(value, 6) + 0.0 for value in point)], place)
                        for point, place in corners]) for material, corners in faces]


def ball(material, radius, sides=8, rows=4, stretch=1):
    profile = [(radius * math.sin(math.pi * k / rows) if 0 < k < rows else 0,
                -radius * stretch * math.cos(math.pi * k / rows)) for k in range(rows + 1)]
    return lathe(profile, sides, material)


def band(material, inner, outer, y0, y1, sides, repeats=1):
    """A hoop."""
    profile = [(inner, y0), (outer, y0), (outer, y1), (inner, y1), (inner, y0)]
    rings = [circle(r, y, sides) for r, y in profile[:-1]]
    lengths = [0]
    for (r0, z0), (r1, z1) in zip(profile, profile[1:]):
        lengths.append(lengths[-1] + math.hypot(r1 - r0, z1 - z0))
    faces = []
    for i in range(4):
        for k in range(sides):
            corners = [(rings[a % 4][b % sides], (repeats * b / sides, lengths[a] / REPEAT[material]))
                       for a, b in ((i, k), (i, k + 1), (i + 1, k + 1), (i + 1, k))]
            faces.append((material, corners))
    return [outward(faces)]


def rod(material, path, radii, sides=6):
    """A tube along points. `radii` = one, or one for each of the points."""
    radii = [radii] * len(path) if isinstance(radii, (int, float)) else radii
    rings = []
    for i, (point, radius) in enumerate(zip(path, radii)):
        before, after = path[max(i - 1, 0)], path[min(i + 1, len(path) - 1)]
        along = tuple(b - a for a, b in zip(before, after))
        helper = (1, 0, 0) if abs(along[1]) > 0.8 * math.hypot(*along) else (0, 1, 0)
        side = cross(along, helper)
        other = cross(along, side)
        side = tuple(value / math.hypot(*side) for value in side)
        other = tuple(value / math.hypot(*other) for value in other)
        turns = [2 * math.pi * k / sides for k in range(sides)]
        rings.append([tuple(p + radius * (math.cos(turn) * a + math.sin(turn) * b)
                            for p, a, b in zip(point, side, other)) for turn in turns])
    return [drawn(rings, material, by_metres(material, 1))]


def sheet(material, front, places, back):
    """A cloth: rows of points with their places in the image, and the same rows behind them."""
    rows, columns = len(front), len(front[0])
    faces = []

    def corner(points, i, j):
        return (points[i][j], places[i][j])

    for i in range(rows - 1):
        for j in range(columns - 1):
            quad = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)]
            for side, order in ((front, quad), (back, quad[::-1])):
                corners = [corner(side, *at) for at in order]
                faces += [(material, corners[:3]), (material, [corners[0], *corners[2:]])]
    rim = [(i, 0) for i in range(rows)] + [(rows - 1, j) for j in range(1, columns)]
    rim += [(i, columns - 1) for i in range(rows - 2, -1, -1)] + [(0, j) for j in range(columns - 2, 0, -1)]
    for a, b in zip(rim, rim[1:] + rim[:1]):
        faces.append((material, [corner(front, *b), corner(front, *a), corner(back, *a), corner(back, *b)]))
    return [outward(faces)]
