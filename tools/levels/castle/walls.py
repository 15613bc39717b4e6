"""The castle's walls: corner towers and ramparts."""

import math

from castle.props import BOWL, brazier
from castle.site import (
    COURT, MERLON, PARAPET, STEP, WALK, battlement, cone, doorway, mirrored, on_both_sides, outdoors, plan, room)
from castle.things import lantern, put, stores
from plan import rectangle, ring

# In a groove of the western wall, beside the stair tower; from north to south.
LIFT = [(2.5, 15.9), (1.3, 15.9), (1.3, 17.3), (2.5, 17.3)]
TOWER_X, TOWER_Y, TOWER_APOTHEM = 1.25, 31.75, 1.25 / math.tan(math.pi / 8)


def corner_towers():
    plan.heading("The corner towers: a chamber below a roof of eight slopes")

    def side(name, turned):
        x = turned([(TOWER_X, TOWER_Y)])[0][0]
        room(f"tower-{name}", ring(x, TOWER_Y, TOWER_APOTHEM - 0.5, 8), (WALK, "wood"), (8.6, "wood"),
             wall="brick")
        y0, y1 = TOWER_Y - TOWER_APOTHEM, TOWER_Y - TOWER_APOTHEM + 0.5
        doorway(f"tower-{name}-north-door", turned(rectangle(0.8, y0, 1.8, y1)), WALK, 2.1)
        x0, x1 = TOWER_X + TOWER_APOTHEM - 0.5, TOWER_X + TOWER_APOTHEM
        doorway(f"tower-{name}-door", turned(rectangle(x0, 31.2, x1, 32.2)), WALK, 2.1)
        y0, y1 = TOWER_Y + TOWER_APOTHEM - 0.5, TOWER_Y + TOWER_APOTHEM
        doorway(f"tower-{name}-window", turned(rectangle(0.9, y0, 1.6, y1)), 6.9, 1.2)
        cone(f"tower-{name}-roof", x, TOWER_Y, TOWER_APOTHEM, 9.2, 5)
        put("flag", x, TOWER_Y, 14.2, 8, solid=False)
        lantern(x, TOWER_Y, 7.85)
        stores(WALK, barrels=turned([(-0.7, 32.4), (0, 33.4)]),
               crates=[(*place, 5) for place in turned([(-0.72, 31.45)])])

    on_both_sides(side)


def ramparts():
    plan.heading("The ramparts")
    tower_y, tower_x = TOWER_Y - TOWER_APOTHEM, TOWER_X + TOWER_APOTHEM
    battlements = [1.5, 0.9] * 11 + [1.5]

    def side(name, turned):
        walk = turned(rectangle(0.5, 0.5, 2.5, tower_y))
        if name == "west":
            walk[2:2] = LIFT
        outdoors(f"rampart-{name}", walk, WALK, "stone", skin="ashlar",
                 holes=[ring(0.8, 20, BOWL, 8)] if name == "west" else [])
        battlement(f"parapet-{name}", turned([(0, 0.5), (0, tower_y)]), turned([(0.5, 0.5), (0.5, tower_y)]),
                   battlements, PARAPET, MERLON)
        outdoors(f"parapet-{name}-corner", turned(rectangle(0, 0, 0.5, 0.5)), MERLON, "stone", skin="ashlar")
        battlement(f"parapet-south-{name}", turned([(tower_x, 33), (12, 33)]),
                   turned([(tower_x, 32.5), (12, 32.5)]),
                   [1.3, 0.8] * 3 + [1.3], PARAPET, MERLON)

    on_both_sides(side)
    battlement("parapet-north-west", [(0.5, 0), (2.5, 0)], [(0.5, 0.5), (2.5, 0.5)], [0.9, 1.1], PARAPET,
               MERLON)
    battlement("parapet-north-east", [(24.5, 0), (33.5, 0)], [(24.5, 0.5), (33.5, 0.5)],
               [1.3, 0.8] * 4 + [1.3], PARAPET, MERLON)
    brazier("brazier-rampart", 0.8, 20, WALK)
    outdoors("lift", LIFT, COURT, "wood", skin="wood")
    plan.move("lift", "floor", WALK, ["lift"], wait=4, trigger="use")
    outdoors("terrace", rectangle(24.5, 0.5, 31.5, 13), WALK, "stone", skin="ashlar",
             holes=[ring(26, 6.7, BOWL, 8)])
    brazier("brazier-terrace", 26, 6.7, WALK)
    outdoors("rampart-south-east", mirrored(rectangle(tower_x, 30.5, 12, 32.5)), WALK, "stone", skin="ashlar")
    outdoors("rampart-south-west",
             [(tower_x, 30.5), (9.6, 30.5), (9.6, 31.3), (12, 31.3), (12, 32.5), (tower_x, 32.5)],
             WALK, "stone", skin="ashlar")
    for i in range(5):
        x = 9.6 + 0.48 * i
        outdoors(f"gate-stair-{i + 1}", rectangle(x, 30.5, x + 0.48, 31.3), WALK + STEP * (i + 1), "stone",
                 skin="ashlar")
