"""The country before the castle: road, meadows, hills, moat; and the lake and the sky around it all."""

from castle.props import POST, lamp_post
from castle.site import (
    AXIS, COURT, LAKE, OPEN_AIR, OUTDOORS, WATER, glazed, mirrored, moss, on_both_sides, outdoors, plan, room,
    square)
from castle.things import put, stores
from plan import rectangle, ring

BANK, BANK_END, HILL_END = 40, 50, 56
WEST, EAST = -8, 42


def country():
    plan.heading("The country before the castle: road, meadows, hills, two lamp posts")
    outdoors("road", rectangle(15.2, BANK, 18.8, HILL_END - 0.4), COURT, "dirt", skin="mossy")
    outdoors("road-end", rectangle(16, HILL_END - 0.4, 18, HILL_END), 2.6, "ashlar", skin="door")
    for side, x0, x1 in (("west", 15.2, 16), ("east", 18, 18.8)):
        outdoors(f"road-end-{side}", rectangle(x0, HILL_END - 0.4, x1, HILL_END), 3.2, "dressed", skin="ashlar")
    for side, x0, x1, post in (("west", WEST, 15.2, 14.5), ("east", 18.8, EAST, 19.5)):
        outdoors(f"meadow-{side}", rectangle(x0, BANK, x1, BANK_END), COURT, "grass", skin="mossy",
                 holes=[square(post, 41.3, POST)])
        lamp_post(f"post-{side}", post, 41.3)
    stores(COURT, barrels=[(20.5, 42.7), (21.6, 42.9)], crates=[(20.9, 41.8, 12), (21.8, 42, 80)])
    put("crate", 21.3, 41.9, COURT + 0.7, 35, 0.8)
    put("cart", 12.9, 43.4, COURT, 75)

    def rise(name, outline, heights):
        outdoors(name, outline, COURT, "grass", skin="mossy", floor_rise=heights)

    def south(x, y):
        return 0.4 * (y - BANK_END)

    for side, x0, x1 in (("west", WEST, 15.2), ("east", 18.8, EAST)):
        rise(f"hill-south-of-{side}", rectangle(x0, BANK_END, x1, HILL_END), south)
    for side, turned in (("west", lambda points: points), ("east", mirrored)):
        def aside(x, y, turned=turned):
            return 0.4 * (WEST - turned([(x, y)])[0][0])
        rise(f"hill-{side}", turned(rectangle(WEST - 6, BANK, WEST, BANK_END)), aside)
        corner, far = (WEST, BANK_END), (WEST - 6, HILL_END)
        rise(f"hill-{side}-corner", turned([corner, far, (WEST - 6, BANK_END)]), aside)
        rise(f"hill-south-{side}", turned([corner, (WEST, HILL_END), far]), south)


# --- The moat

BUTTRESS = [(8.7, 33), (8.7, 33.5), (9.6, 33.5), (9.6, 33)]


def moat():
    plan.heading("The moat, its dams and steps, and the bridge with the water below it")
    dam = [(WEST, 30.5), (-1.768, 30.5), (-1.768, 33), (-6, 33), (-6, BANK), (WEST, BANK)]
    water = [(-3.3, 33), (-1.768, 33), (0, 34.768), (2.5, 34.768), (4.268, 33), *BUTTRESS, (12, 33), (12, 34.4),
             (12.8, 35.2), (14.4, 35.2), (15.2, 34.4), (15.2, BANK), (-6, BANK), (-6, 34), (-3.3, 34)]

    def side(name, turned):
        outdoors(f"dam-{name}", turned(dam), COURT, "grass", skin="mossy")
        outdoors(f"moat-{name}", turned(water), WATER, "water", foot=moss(-0.25))
        outdoors(f"buttress-{name}", turned(BUTTRESS), 4.4, "dressed", skin="ashlar",
                 floor_rise=lambda x, y: 2 * (33.5 - y))
        glazed(f"loop-{name}", turned([(10.875, 33), (11.125, 33)]), (0, -1), 2.25, 1.25)
        for i in range(6):
            outdoors(f"moat-step-{name}-{i + 1}", turned(rectangle(-6 + 0.45 * i, 33, -5.55 + 0.45 * i, 34)),
                     -0.35 - 0.36 * i, "stone", skin="mossy")
        outdoors(f"kerb-{name}", turned(rectangle(15.2, 34, 15.4, BANK)), 0.3, "beam", skin="beam")

    on_both_sides(side)
    outdoors("bridge", rectangle(15.4, 34, 18.6, BANK), COURT, "wood", skin="beam")
    room("under-bridge", rectangle(15.2, 34.4, 18.8, BANK), (WATER, "water"), (-0.4, "beam"),
         wall="mossy", light=OUTDOORS)


# Metres to where the lake ends: 0.5 degrees below the horizon, seen from the look-out.
MIDDLE, HORIZON = (AXIS, 28), 2000


def void():
    plan.heading("Nothing but sky above and below, which closes where it would end")
    shore = plan.outline_of_skies()
    assert len(shore) == 1, f"there are gaps in the open air: {[loop[:3] for loop in shore]}"
    edge, beyond = ring(*MIDDLE, HORIZON, 24), ring(*MIDDLE, HORIZON + 10, 24)
    plan.add("lake", edge, (LAKE, "sky"), OPEN_AIR, holes=shore, light=OUTDOORS, wall="ashlar",
             foot=moss(LAKE + 1.75))
    for i in range(24):
        outline = [edge[i], edge[(i + 1) % 24], beyond[(i + 1) % 24], beyond[i]]
        plan.add(f"end-{i + 1}", outline, (LAKE, "sky"), (LAKE, "sky"), wall="ashlar")
