"""What the parts of the castle share: its axis, heights, textures, and kinds of rooms."""

import math

from plan import Plan, SKY

# Metres of one repeat across and down; beams hang from the top of what they clad.
TEXTURES = {
    "ashlar": (2, 2, 0), "beam": (2, 0.8, 0.2), "brick": (1.6, 1.6, 0), "carpet": (1.5, 1.5, 0),
    "cobble": (2.4, 2.4, 0), "dirt": (3, 3, 0), "glass": (1.2, 1.2, 0), "grass": (3, 3, 0),
    "grate": (1.2, 1.2, 0), "marble": (2, 2, 0), "mossy": (2, 2, 0),
    "plaster": (3, 3, 0), "roof": (2.4, 2.4, 0), "slate": (2.4, 2.4, 0), "stone": (2.4, 2.4, 0),
    "water": (4, 4, 0), "wood": (2, 2, 0),
}

AXIS = 17
COURT, WALK, PARAPET, MERLON = 0, 6, 6.9, 7.8
WATER, LAKE, CRYPT = -2.5, -6, -4.8
STEP = 0.4
OPEN_AIR = (SKY, "sky")

STAIR_X, STAIR_INNER, STAIR_OUTER, NEWEL = 5.5, 2.4, 3.0, 0.3
STAIR_Y = 13 - STAIR_OUTER * math.tan(math.pi / 12)  # a corner of the tower meets the hall's front
TOWER_SOUTH = STAIR_Y + STAIR_OUTER

# The light of the open air, of rooms, and of what lies below the ground.
OUTDOORS, INDOORS, BELOW = 0.2, 0.13, 0.1

plan = Plan(TEXTURES, "sky 1,1 -426,0")


def outdoors(name, outline, z, texture, **other):
    plan.add(name, outline, (z, texture), OPEN_AIR, **{"light": OUTDOORS, "wall": "ashlar", **other})


def room(name, outline, floor, ceiling, **other):
    plan.add(name, outline, floor, ceiling, **{"light": INDOORS, "wall": "plaster", **other})


def doorway(name, outline, z, height, **other):
    room(name, outline, (z, "stone"), (z + height, "ashlar"), **{"wall": "ashlar", **other})


def lit_window(name, outline, z, height):
    """A shallow niche of leaded glass with a light behind it."""
    room(name, outline, (z, "ashlar"), (z + height, "ashlar"), wall="glass", light=0.85)


def mirrored(points):
    """In the east as in the west."""
    return [(2 * AXIS - x, y) for x, y in points]


def on_both_sides(build):
    build("west", lambda points: points)
    build("east", mirrored)


def between(a, b, part):
    return (a[0] + (b[0] - a[0]) * part, a[1] + (b[1] - a[1]) * part)


def battlement(name, outer, inner, parts, low, high, skin="ashlar"):
    """Merlons and gaps on the strip between two lines, from west or north: `parts` of its length,
    the first of them a merlon."""
    begin = 0
    for i, part in enumerate(parts):
        end = begin + part / sum(parts)
        outline = [between(*outer, begin), between(*outer, end), between(*inner, end), between(*inner, begin)]
        z = low if i % 2 else high
        outdoors(f"{name}-{i + 1}", outline, z, "stone", skin=skin)
        begin = end
