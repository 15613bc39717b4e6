"""The stair tower."""

from castle.hall import GALLERY, HALL_WEST
from castle.site import (
    BELOW, COURT, CRYPT, NEWEL, STAIR_INNER, STAIR_OUTER, STAIR_X, STAIR_Y, STEP, TOWER_SOUTH, WALK,
    doorway, outdoors, plan, room)
from castle.things import out, put, torch
from plan import rectangle, ring

FIRST, LAST, UNDER_TOP = -12, 28, 18  # steps; those up to UNDER_TOP have others above them


def stair_tower():
    plan.heading("The stair tower: twelve steps a turn, sector over sector, from the crypt to its top")
    inner, outer = ring(STAIR_X, STAIR_Y, STAIR_INNER, 12), ring(STAIR_X, STAIR_Y, STAIR_OUTER, 12)
    newel = ring(STAIR_X, STAIR_Y, NEWEL, 12)

    def wedge(k, near, far):
        a, b = k % 12, (k + 1) % 12
        return [near[a], near[b], far[b], far[a]]

    for k in range(FIRST, LAST + 3):
        z = STEP * min(k, LAST)
        name = f"stair-{k}" if k >= 0 else f"stair-below-{-k}"
        if k <= UNDER_TOP:
            room(name, wedge(k, newel, inner), (z, "stone"), (min(z + 3.8, STEP * LAST - 0.5), "ashlar"),
                 wall="ashlar", skin="ashlar", light=0.2)
        else:
            outdoors(name, wedge(k, newel, inner), z, "stone", skin="ashlar")
    outdoors("stair-newel", newel, STEP * LAST + STEP, "stone", skin="ashlar")
    for k in range(12):
        outdoors(f"stair-parapet-{k + 1}", wedge(k, inner, outer), 12.5 if k % 2 else 11.8, "stone",
                 skin="ashlar")

    for angle, z in ((150, -3.1), (150, 1.7), (330, 4.9), (210, 8)):
        torch(*out(STAIR_X, STAIR_Y, angle, STAIR_INNER), z, angle + 180)
    torch(STAIR_X, TOWER_SOUTH, 2.45, 90)
    put("flag", STAIR_X, STAIR_Y, STEP * LAST + STEP, 20)

    south, east, west = STAIR_Y + STAIR_INNER, STAIR_X + STAIR_INNER, STAIR_X - STAIR_INNER
    doorway("stair-door", rectangle(5, south, 6, TOWER_SOUTH), COURT, 2.2)
    crypt_door(south)
    doorway("stair-door-gallery", rectangle(east, 11.6, HALL_WEST, 12.5), GALLERY, 2.1)
    doorway("stair-door-rampart", rectangle(2.5, 11.6, west, 12.6), WALK, 2.1)


def crypt_door(south):
    """A leaf of wood that is drawn up, in the middle of its doorway."""
    leaf = (south + TOWER_SOUTH) / 2 - 0.06, (south + TOWER_SOUTH) / 2 + 0.06
    doorway("stair-door-crypt", rectangle(5, south, 6, leaf[0]), CRYPT, 2.2, light=BELOW)
    room("crypt-door", rectangle(5, leaf[0], 6, leaf[1]), (CRYPT, "stone"), (CRYPT, "wood"), wall="dressed",
         skin="door", light=BELOW)
    doorway("stair-door-crypt-outer", rectangle(5, leaf[1], 6, TOWER_SOUTH), CRYPT, 2.2, light=BELOW)
    plan.move("crypt-door", "ceiling", CRYPT + 2.2, ["crypt-door"], speed=1.8, wait=4, trigger="use")
