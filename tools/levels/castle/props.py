"""What stands in rooms of all kinds: candles, barrels, boards on legs."""

from castle.site import floating, room, square
from plan import rectangle, ring

CANDLE, FLAME, BARREL = 0.03, 0.018, 0.29  # metres from the middle to the sides


def candle(name, x, y, top, ceiling, **air):
    """Pale wax and a small flame, which ends at `top`. Its place is a hole of the air it stands in."""
    flame = square(x, y, FLAME)
    room(name, square(x, y, CANDLE), (top - 0.08, "plaster"), ceiling, skin="plaster", light=1, holes=[flame],
         **air)
    room(f"{name}-flame", flame, (top, "ember"), ceiling, skin="ember", light=1, **air)


def barrel(name, x, y, z, ceiling):
    room(name, ring(x, y, BARREL, 8), (z + 0.9, "wood"), ceiling, skin="post")


def on_legs(name, outline, floor, ceiling, top, inset, **other):
    """A board `top` metres above the floor, a leg near each of its ends."""
    (x0, y0), (x1, y1) = outline[0], outline[2]
    legs = [rectangle(x, y0 + inset, x + 0.1, y1 - inset) for x in (x0 + 0.2, x1 - 0.3)]
    z = floor[0] + top
    floating(name, outline, floor, ceiling, z - 0.07, z, "wood", wall="post", lower_holes=legs, **other)
