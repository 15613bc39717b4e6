"""What stands and hangs in the great hall."""

from castle.site import floating, opening_above, room, square
from castle.props import CANDLE, candle, on_legs
from plan import rectangle

HALL, APEX = 0.4, 10.6
DAIS = HALL + 0.2

# Tables of 2.4 m by their north-western corners, beams of candles and their floors by their middles,
# what hangs before the walls.
TABLES = {"west": (12.9, 3.4), "centre": (16.4, 3.4), "south": (12.9, 9.8)}
CANDLES = {"west": (14, HALL), "centre": (17.5, HALL), "east": (22, DAIS)}
HANGINGS = {"west": rectangle(13.5, 1.41, 14.875, 1.46), "east": rectangle(21.75, 1.41, 23.125, 1.46)}
BANNERS = [rectangle(23.94, y, 23.99, y + 0.75) for y in (4.125, 6.375, 8.625)]
SEAT, BACK = rectangle(23.3, 6.45, 23.74, 7.05), rectangle(23.75, 6.4, 23.85, 7.1)
LEAVES = [rectangle(x, 11.68, x + 0.08, 12.48) for x in (16.5, 18.22)]  # of the door, which is open


def pitch(x, y):
    """How far the ceiling lies below its apex."""
    return max(0.8 * max(6 - y, y - 7.5), 0)


def table(name):
    """Where a table and its two benches stand."""
    x, y = TABLES[name]
    return [rectangle(x, y, x + 2.4, y + 0.6), rectangle(x, y - 0.5, x + 2.4, y - 0.2),
            rectangle(x, y + 0.8, x + 2.4, y + 1.1)]


def candle_beam(name):
    x, _ = CANDLES[name]
    return rectangle(x - 0.8, 6.69, x + 0.8, 6.81)


# The holes that all this leaves in the hall's bays, by strip.
PLACES = {
    "west": {"north": [HANGINGS["west"], *table("west")], "middle": [candle_beam("west")],
             "south": table("south")},
    "centre": {"north": table("centre"), "middle": [candle_beam("centre")], "south": LEAVES},
    "dais": {"north": [HANGINGS["east"], BANNERS[0]], "middle": [candle_beam("east"), SEAT, BACK, BANNERS[1]],
             "south": [BANNERS[2]]},
}


def board(name, outline, floor, low, high, stuff, **other):
    is_middle = 6 < outline[0][1] < 7.5
    floating(name, outline, floor, (APEX, "wood"), low, high, stuff, ceiling_drop=None if is_middle else pitch,
             **other)


def tables():
    def put(name, outline, top, inset):
        on_legs(name, outline, (HALL, "marble"), (APEX, "wood"), top, inset, ceiling_drop=pitch)

    for name in TABLES:
        top, *benches = table(name)
        put(f"table-{name}", top, 0.76, 0.2)
        for side, bench in zip(("north", "south"), benches):
            put(f"bench-{name}-{side}", bench, 0.45, 0.06)


def candles():
    for name, (x, floor) in CANDLES.items():
        places = [(x + dx, 6.75) for dx in (-0.7, -0.35, 0.35, 0.7)]
        chain = square(x, 6.75, 0.02)
        board(f"candles-{name}", candle_beam(name), (floor, "carpet"), 5.1, 5.2, "wood", wall="iron",
              upper_holes=[chain, *(square(*place, CANDLE) for place in places)], glow=(5.45, 0.8, [chain]))
        for i, place in enumerate(places):
            candle(f"candle-{name}-{i + 1}", *place, 5.43, (5.45, None),
                   opening=opening_above(f"candles-{name}"))


def cloths():
    for (side, outline), floor in zip(HANGINGS.items(), ((HALL, "marble"), (DAIS, "wood"))):
        board(f"tapestry-{side}", outline, floor, 1.5, 5.25, "tapestry")
    for i, (outline, stuff) in enumerate(zip(BANNERS, ("wood", "carpet", "wood"))):
        board(f"banner-{i + 1}", outline, (DAIS, stuff), 1.5, 5.25, "banner")


def furnish():
    tables()
    candles()
    cloths()
    for name, outline, z in (("throne", SEAT, DAIS + 0.5), ("throne-back", BACK, DAIS + 1.5)):
        room(name, outline, (z, "wood"), (APEX, "wood"), skin="post")
    for side, outline in zip(("west", "east"), LEAVES):
        room(f"hall-door-{side}", outline, (HALL + 2.6, "wood"), (APEX, "wood"), skin="door",
             ceiling_drop=pitch)
