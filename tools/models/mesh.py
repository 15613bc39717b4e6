"""Closed surfaces of polygons, and the OBJ files that they are written to.

A part is a list of shells. A shell is a list of faces (material, corners) that closes without gaps; a
corner is a point and its place in the image. Shells of a part may touch and cross.

Lengths are metres. As in OBJ files, y is up; x and z are the level's x and y. What has a front has it
towards x, so that `angle` in a level is the direction that it faces. Every model stands on y = 0.
"""

import math

DIGITS = 4  # of lengths: a tenth of a millimetre; and of places in images


def rounded(values):
    return tuple(round(value, DIGITS) + 0.0 for value in values)


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def volume(shell):
    """In cubic metres; negative if the faces look inwards."""
    six = 0
    for _, corners in shell:
        points = [point for point, _ in corners]
        six += sum(dot(points[0], cross(a, b)) for a, b in zip(points[1:], points[2:]))
    return six / 6


def outward(shell):
    """The shell with its corners counter-clockwise as seen from outside, which is a face's front."""
    if volume(shell) > 0:
        return shell
    return [(material, corners[::-1]) for material, corners in shell]


# --- Moving parts

def changed(part, change):
    return [outward([(material, [(change(point), place) for point, place in corners])
                     for material, corners in shell]) for shell in part]


def moved(part, dx, dy, dz):
    return changed(part, lambda p: (p[0] + dx, p[1] + dy, p[2] + dz))


def turned(part, axis, degrees):
    """About an axis through the origin, from the next axis towards the one after it."""
    first, second = (axis + 1) % 3, (axis + 2) % 3
    cosine, sine = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))

    def turn(point):
        result = list(point)
        result[first] = cosine * point[first] - sine * point[second]
        result[second] = sine * point[first] + cosine * point[second]
        return tuple(result)

    return changed(part, turn)


def mirrored(part):
    """In z, so that left becomes right."""
    return changed(part, lambda p: (p[0], p[1], -p[2]))


def around(part, count, start=0):
    """So many of them, evenly around the upright axis."""
    return [shell for i in range(count) for shell in turned(part, 1, start + 360 * i / count)]


# --- Writing

class Numbers:
    """Lines of one kind in the order in which they are first wanted, numbered from 1."""

    def __init__(self):
        self.lines = {}

    def of(self, key, text):
        return self.lines.setdefault((key, text), len(self.lines) + 1)

    def texts(self):
        return [text for _, text in self.lines]


def listed(values):
    return " ".join(f"{value:g}" for value in values)


def text(name, part, library):
    """The OBJ file of a part. Shells have corners of their own even where they touch."""
    points, places, faces, worn = Numbers(), Numbers(), [], None
    by_material = sorted({material for shell in part for material, _ in shell})
    for material in by_material:
        for i, shell in enumerate(part):
            for wears, corners in shell:
                if wears != material:
                    continue
                if worn != material:
                    faces.append(f"usemtl {material}")
                    worn = material
                faces.append("f " + " ".join(
                    f"{points.of(i, f'v {listed(rounded(point))}')}/"
                    f"{places.of(0, f'vt {listed(rounded(place))}')}" for point, place in corners))
    head = [f"# {name}: written by tools/models/models.py; change that.", f"mtllib {library}"]
    return "\n".join([*head, *points.texts(), *places.texts(), *faces]) + "\n"
