"""The country before the castle: road, meadows, hills, moat; and the lake and the sky around it all."""

from castle.site import COURT, LAKE, OPEN_AIR, OUTDOORS, WATER, mirrored, on_both_sides, outdoors, plan, room
from plan import rectangle

BANK, BANK_END, HILL_END = 40, 50, 56
WEST, EAST = -8, 42


def country():
    plan.heading("The country before the castle: road, meadows, hills, two lamp posts")
    outdoors("road", rectangle(15.2, BANK, 18.8, BANK_END), COURT, "dirt", skin="mossy")
    post_w, post_e = rectangle(14.2, 41, 14.75, 41.55), mirrored(rectangle(14.2, 41, 14.75, 41.55))
    outdoors("meadow-west", rectangle(WEST, BANK, 15.2, BANK_END), COURT, "grass", skin="mossy",
             holes=[post_w])
    outdoors("meadow-east", rectangle(18.8, BANK, EAST, BANK_END), COURT, "grass", skin="mossy",
             holes=[post_e])
    outdoors("post-west", post_w, 1.5, "stone", skin="ashlar")
    outdoors("post-east", post_e, 1.5, "stone", skin="ashlar")

    def rise(name, outline, heights):
        outdoors(name, outline, COURT, "grass", skin="mossy", floor_rise=heights)

    def south(x, y):
        return 0.4 * (y - BANK_END)

    rise("hill-south", [(WEST, BANK_END), (EAST, BANK_END), (EAST, HILL_END), (WEST, HILL_END)], south)
    for side, turned in (("west", lambda points: points), ("east", mirrored)):
        def aside(x, y, turned=turned):
            return 0.4 * (WEST - turned([(x, y)])[0][0])
        rise(f"hill-{side}", turned(rectangle(WEST - 6, BANK, WEST, BANK_END)), aside)
        corner, far = (WEST, BANK_END), (WEST - 6, HILL_END)
        rise(f"hill-{side}-corner", turned([corner, far, (WEST - 6, BANK_END)]), aside)
        rise(f"hill-south-{side}", turned([corner, (WEST, HILL_END), far]), south)


# --- The moat

def moat():
    plan.heading("The moat, its dams and steps, and the bridge with the water below it")
    dam = [(WEST, 30.5), (-1.768, 30.5), (-1.768, 33), (-6, 33), (-6, BANK), (WEST, BANK)]
    water = [(-3.3, 33), (-1.768, 33), (0, 34.768), (2.5, 34.768), (4.268, 33), (12, 33), (12, 34.4),
             (12.8, 35.2), (14.4, 35.2), (15.2, 34.4), (15.2, BANK), (-6, BANK), (-6, 34), (-3.3, 34)]

    def side(name, turned):
        outdoors(f"dam-{name}", turned(dam), COURT, "grass", skin="mossy")
        outdoors(f"moat-{name}", turned(water), WATER, "water", foot=("mossy", -0.75))
        for i in range(6):
            outdoors(f"moat-step-{name}-{i + 1}", turned(rectangle(-6 + 0.45 * i, 33, -5.55 + 0.45 * i, 34)),
                     -0.35 - 0.36 * i, "stone", skin="mossy")
        outdoors(f"kerb-{name}", turned(rectangle(15.2, 34, 15.4, BANK)), 0.3, "beam", skin="beam")

    on_both_sides(side)
    outdoors("bridge", rectangle(15.4, 34, 18.6, BANK), COURT, "wood", skin="beam")
    room("under-bridge", rectangle(15.2, 34.4, 18.8, BANK), (WATER, "water"), (-0.4, "beam"),
         wall="mossy", light=OUTDOORS)


def void():
    plan.heading("Nothing but sky above and below, which closes where it would end")
    shore = plan.outline_of_skies()
    assert len(shore) == 1, f"there are gaps in the open air: {[loop[:3] for loop in shore]}"
    edge = rectangle(-90, -90, 124, 146)
    plan.add("lake", edge, (LAKE, "sky"), OPEN_AIR, holes=shore, light=OUTDOORS, wall="ashlar")
    for i, (a, b) in enumerate(zip(edge, edge[1:] + edge[:1])):
        middle = (17, 28)
        away = [(p[0] + (p[0] - middle[0]) * 0.02, p[1] + (p[1] - middle[1]) * 0.02) for p in (a, b)]
        plan.add(f"end-{i + 1}", [a, b, *away[::-1]], (LAKE, "sky"), (LAKE, "sky"), wall="ashlar")
