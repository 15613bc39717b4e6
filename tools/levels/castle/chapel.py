"""The chapel."""

from castle.site import closed, doorway, floating, opening_above, outdoors, plan, room, square
from castle.props import CANDLE, candle
from castle.things import candle_stand, chandelier, put, torch
from plan import rectangle, ring

NAVE = 0.2


def chapel():
    plan.heading("The chapel: sloped ceilings hung from its vault, coloured glass above the altar")

    def strips(name, x0, x1, z, middle, columns=(), corner=0):
        sides = {"north": (13.6, 15.6), "south": (19.9, 17.9)}
        for side, (wall, aisle) in sides.items():
            outline = [(x0, wall), (x1 - corner, wall), (x1, aisle), (x0, aisle)]
            row = aisle - 0.35 if side == "north" else aisle + 0.35
            room(f"{name}-{side}", outline, (z, "marble"), (7.8, "wood"), wall="ashlar", skin="marble",
                 holes=[ring(x, row, 0.33, 8) for x in columns],
                 ceiling_drop=lambda x, y, aisle=aisle: 1.5 * abs(y - aisle))
            for i, x in enumerate(columns):
                column = f"column-{side}-{i + 1}"
                room(column, ring(x, row, 0.33, 8), (z + 0.35, "dressed"), (5.8, "dressed"), skin="dressed",
                     wall="dressed", holes=[ring(x, row, 0.22, 8)])
        room(f"{name}-aisle", rectangle(x0, 15.6, x1, 17.9), (z, middle), (7.8, "wood"), wall="ashlar",
             skin="marble",
             holes=[ALTAR] if name == "chancel" else [])

    ALTAR = rectangle(29.35, 15.85, 30, 17.65)
    strips("nave", 22.6, 27.4, NAVE, "carpet", columns=(25.1, 26.8))
    strips("chancel", 27.4, 31, NAVE + 0.2, "marble", corner=1.2)
    candles, flames = [(29.65, y) for y in (16.1, 17.4)], NAVE + 1.65
    floating("altar", ALTAR, (NAVE + 0.2, "marble"), (7.8, "wood"), NAVE + 1.2, NAVE + 1.3, "dressed",
             lower_holes=[rectangle(29.45, 15.97, 29.9, 17.53)], wall="dressed",
             upper_holes=[square(*place, CANDLE) for place in candles], glow=(flames + 0.02, 0.5, []))
    for i, place in enumerate(candles):
        candle(f"altar-candle-{i + 1}", *place, flames, (flames + 0.02, None), opening=opening_above("altar"))
    doorway("chapel-door", rectangle(22, 15.9, 22.6, 17.6), NAVE, 2.8)
    for side, y0, y1 in (("north", 15.75, 16.75), ("south", 16.75, 17.75)):
        closed(f"chapel-window-{side}", [(31, y0), (31, y1)], (1, 0), 2.25, 4.5, "window", 0.6,
               surround=("dressed", 0.1), sidewall="dressed",
               ceiling_drop=lambda x, y: 1.4 * abs(y - 16.75))
    for i, x in enumerate((23.4, 25.4, 28.4)):
        doorway(f"chapel-window-{i + 1}", rectangle(x, 19.9, x + 0.7, 20.5), 1.8, 2.4)

    furnish()

    ridge = 16.8  # beside the window's middle: outlines of rooms and of what lies above stay apart
    for name, eaves in (("north", 13), ("south", 20.5)):
        outdoors(f"chapel-roof-{name}", rectangle(22, eaves, 31.5, ridge), 6.4, "slate", skin="ashlar",
                 floor_rise=lambda x, y, eaves=eaves: 4 * (y - eaves) / (ridge - eaves))


def furnish():
    """Benches, a statue in the north, candles on both sides of the altar, a chandelier by the door."""
    put("statue", 27.9, 14.1, NAVE + 0.2, 155, 0.9)
    for y in (15.2, 18.3):
        candle_stand(28.9, y, NAVE + 0.2)
    chandelier(23.4, 16.75, 4.9)
    for x in (24.2, 25.95):
        for y in (14.6, 18.9):
            put("bench", x, y, NAVE, 90)
    torch(22, 16.75, 3.3, 180)
