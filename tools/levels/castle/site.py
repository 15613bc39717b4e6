"""What the parts of the castle share: its axis, heights, textures, and kinds of rooms."""

import math

from plan import Plan, SKY, rectangle, ring

# Metres of one repeat across and down; beams and dressed stones hang from the top of what they clad.
TEXTURES = {
    "ashlar": (2, 2, 0), "banner": (0.75, 3.75, 0), "beam": (2, 0.8, 0.2), "brick": (1.6, 1.6, 0),
    "carpet": (1.5, 1.5, 0), "cobble": (2.4, 2.4, 0), "dirt": (3, 3, 0), "door": (1.6, 2.6, 0),
    "dressed": (1.6, 1.6, 0.2), "ember": (1.2, 1.2, 0), "glass": (1, 1, 0), "grass": (3, 3, 0),
    "hay": (1.6, 1.6, 0), "iron": (1.2, 1.2, 0), "marble": (2, 2, 0), "mossline": (2, 2, 0),
    "mossy": (2, 2, 0), "plaster": (3, 3, 0), "post": (0.8, 2, 0), "roof": (2.4, 2.4, 0),
    "slate": (2.4, 2.4, 0), "stone": (2.4, 2.4, 0), "tapestry": (1.375, 3.75, 0), "water": (4, 4, 0),
    "window": (2, 4.5, 0), "wood": (2, 2, 0),
}
# Those that are one picture: metres along their walls where it begins, and the height of its top.
PICTURES = {"banner": (4.125, 5.25), "tapestry": (13.5, 5.25), "window": (15.75, 6.75)}
DIRECTED = {"roof", "slate"}  # those that come turned, for slopes

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

plan = Plan(TEXTURES, "sky 1,1 -426,0", DIRECTED, PICTURES)


def outdoors(name, outline, z, texture, **other):
    plan.add(name, outline, (z, texture), OPEN_AIR, **{"light": OUTDOORS, "wall": "ashlar", **other})


def room(name, outline, floor, ceiling, **other):
    plan.add(name, outline, floor, ceiling, **{"light": INDOORS, "wall": "plaster", **other})


def pillar(name, outline, z, skin):
    """Solid from floor to ceiling, in what its room's walls do not wear."""
    room(name, outline, (z, skin), (z, skin), skin=skin)


def floating(name, outline, floor, ceiling, low, high, stuff, lower_holes=(), upper_holes=(), glow=None,
             **other):
    """A slab of `stuff` between two heights in a room's air. `other` is said of the air above it.
    `glow` = (z, light, holes) is what the air on it has of flames, up to a height where other air with
    `holes` begins: ceilings have nothing of it."""
    below = {"wall": other["wall"]} if "wall" in other else {}
    room(f"{name}-under", outline, floor, (low, stuff), holes=lower_holes, **below)
    if glow:
        top, light, holes = glow
        opening = opening_above(name)
        room(name, outline, (high, stuff), (top, None), skin=stuff, holes=upper_holes,
             **{**other, "light": light, "opening": opening})
        room(opening[0], outline, (top, None), ceiling, holes=holes, **other, opening=opening)
    else:
        room(name, outline, (high, stuff), ceiling, skin=stuff, holes=upper_holes, **other)


def opening_above(name):
    return (f"{name}-above", name)


def glowing(name, outline, z, top, beside, **other):
    """Embers in the air that glows `beside` them, and that ends above them at `top`."""
    room(name, outline, (z, "ember"), (top, None), skin="ember", opening=opening_above(beside), **other)


FRAME = ("dressed", 0.2)  # around openings


def doorway(name, outline, z, height, **other):
    room(name, outline, (z, "stone"), (z + height, "dressed"),
         **{"wall": "dressed", "surround": FRAME, "light": INDOORS + 0.05, **other})


def closed(name, front, inwards, z, height, stuff, light, **other):
    """A doorway in a reveal behind the line `front`, and `stuff` that fills it."""
    def behind(depth):
        return [(x + depth * inwards[0], y + depth * inwards[1]) for x, y in front]

    doorway(name, [*front, *behind(0.2)[::-1]], z, height, **other)
    room(f"{name}-{stuff}", [*behind(0.2), *behind(0.22)[::-1]], (z, "dressed"), (z + height, "dressed"),
         **{**other, "wall": stuff, "light": light})


def glazed(name, front, inwards, z, height):
    """A window of leaded glass with a light behind it."""
    closed(name, front, inwards, z, height, "glass", 0.85)


def moss(z):
    """What stands in the wet below a height; z is 0.75 above a whole number, where courses end that
    "mossline" is painted for."""
    return [("mossy", z - 0.5), ("mossline", z)]


def square(x, y, apothem):
    return rectangle(x - apothem, y - apothem, x + apothem, y + apothem)


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


def cone(name, x, y, apothem, eaves, height, stuff="slate", sides=8):
    corners = ring(x, y, apothem, sides)
    for k in range(sides):
        a, b = corners[k], corners[(k + 1) % sides]

        def rise(px, py, middle=((a[0] + b[0]) / 2 - x, (a[1] + b[1]) / 2 - y)):
            return height * (1 - ((px - x) * middle[0] + (py - y) * middle[1]) / apothem ** 2)

        outdoors(f"{name}-{k + 1}", [a, b, (x, y)], eaves, stuff,
                 skin="ashlar" if stuff == "slate" else stuff, floor_rise=rise)
