"""What stands in all kinds of places, and is made of sectors: candles, boards on legs, lamps."""

from castle.site import cone, floating, outdoors, room, square
from castle.things import candle_flame, flame
from plan import rectangle, ring

CANDLE, FLAME = 0.03, 0.018  # metres from the middle to the sides


def candle(name, x, y, top, ceiling, **air):
    """Pale wax and a small flame, which ends at `top`. Its place is a hole of the air it stands in."""
    flame = square(x, y, FLAME)
    room(name, square(x, y, CANDLE), (top - 0.08, "plaster"), ceiling, skin="plaster", light=1, holes=[flame],
         **air)
    room(f"{name}-flame", flame, (top, "ember"), ceiling, skin="ember", light=1, **air)
    candle_flame(x, y, top)


def on_legs(name, outline, floor, ceiling, top, inset, **other):
    """A board `top` metres above the floor, a leg near each of its ends."""
    (x0, y0), (x1, y1) = outline[0], outline[2]
    legs = [rectangle(x, y0 + inset, x + 0.1, y1 - inset) for x in (x0 + 0.2, x1 - 0.3)]
    z = floor[0] + top
    floating(name, outline, floor, ceiling, z - 0.07, z, "wood", wall="post", lower_holes=legs, **other)


# Metres from the middle of a brazier, a lamp post to its sides.
BOWL, POST = 0.16, 0.14


def lamp_post(name, x, y):
    """An open lantern on a post: its flame, four bars, a roof of four slopes."""
    bars = [square(x + dx, y + dy, 0.015) for dx in (-0.115, 0.115) for dy in (-0.115, 0.115)]
    room(name, square(x, y, POST), (1.75, "iron"), (2.35, "iron"), wall="iron", skin="post", light=0.8,
         holes=[square(x, y, 0.035), *bars])
    room(f"{name}-flame", square(x, y, 0.035), (1.87, "ember"), (2.35, "iron"), skin="ember", light=1)
    flame(x, y, 1.87, 0.16, 0.36)
    cone(f"{name}-roof", x, y, POST, 2.4, 0.25, "iron", 4)


def brazier(name, x, y, z):
    """Embers on a stone that stands at a height."""
    outdoors(name, ring(x, y, BOWL, 8), z + 0.85, "ember", skin="dressed", light=0.9)
    flame(x, y, z + 0.85, 0.42, 0.6)
