#!/usr/bin/env python3
"""Writes levels/keep.json: the plan of a small castle.

usage: tools/levels/keep.py [OUT.json]

The gate is in the south, the hall in the north, the chapel in the east, a stair tower between hall
and western rampart. x = 17 is the axis of gate and bridge.
"""

import math
import sys
from pathlib import Path

from plan import SKY, Plan, rectangle, ring

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

# The light of the open air, of rooms, and of what lies below the ground.
OUTDOORS, INDOORS, BELOW = 0.2, 0.13, 0.1

plan = Plan(TEXTURES, "sky 1,1 -142,0")


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


# --- The country before the castle

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


# --- Walls and towers

def cone(name, x, y, apothem, eaves, height):
    corners = ring(x, y, apothem, 8)
    for k in range(8):
        a, b = corners[k], corners[(k + 1) % 8]

        def rise(px, py, middle=((a[0] + b[0]) / 2 - x, (a[1] + b[1]) / 2 - y)):
            return height * (1 - ((px - x) * middle[0] + (py - y) * middle[1]) / apothem ** 2)

        outdoors(f"{name}-roof-{k + 1}", [a, b, (x, y)], eaves, "slate", skin="ashlar", floor_rise=rise)


TOWER_X, TOWER_Y, TOWER_APOTHEM = 1.25, 31.75, 1.25 / math.tan(math.pi / 8)


def corner_towers():
    plan.heading("The corner towers: a chamber below a roof of eight slopes")

    def side(name, turned):
        x = turned([(TOWER_X, TOWER_Y)])[0][0]
        room(f"tower-{name}", ring(x, TOWER_Y, TOWER_APOTHEM - 0.5, 8), (WALK, "wood"), (8.6, "beam"),
             wall="brick")
        y0, y1 = TOWER_Y - TOWER_APOTHEM, TOWER_Y - TOWER_APOTHEM + 0.5
        doorway(f"tower-{name}-north-door", turned(rectangle(0.8, y0, 1.8, y1)), WALK, 2.1)
        x0, x1 = TOWER_X + TOWER_APOTHEM - 0.5, TOWER_X + TOWER_APOTHEM
        doorway(f"tower-{name}-door", turned(rectangle(x0, 31.2, x1, 32.2)), WALK, 2.1)
        y0, y1 = TOWER_Y + TOWER_APOTHEM - 0.5, TOWER_Y + TOWER_APOTHEM
        doorway(f"tower-{name}-window", turned(rectangle(0.9, y0, 1.6, y1)), 6.9, 1.2)
        cone(f"tower-{name}", x, TOWER_Y, TOWER_APOTHEM, 9.2, 5)

    on_both_sides(side)


def ramparts():
    plan.heading("The ramparts")
    tower_y, tower_x = TOWER_Y - TOWER_APOTHEM, TOWER_X + TOWER_APOTHEM
    battlements = [1.5, 0.9] * 11 + [1.5]

    def side(name, turned):
        outdoors(f"rampart-{name}", turned(rectangle(0.5, 0.5, 2.5, tower_y)), WALK, "stone", skin="ashlar")
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
    outdoors("terrace", rectangle(24.5, 0.5, 31.5, 13), WALK, "stone", skin="ashlar")
    outdoors("rampart-south-east", mirrored(rectangle(tower_x, 30.5, 12, 32.5)), WALK, "stone", skin="ashlar")
    outdoors("rampart-south-west",
             [(tower_x, 30.5), (9.6, 30.5), (9.6, 31.3), (12, 31.3), (12, 32.5), (tower_x, 32.5)],
             WALK, "stone", skin="ashlar")
    for i in range(5):
        x = 9.6 + 0.48 * i
        outdoors(f"gate-stair-{i + 1}", rectangle(x, 30.5, x + 0.48, 31.3), WALK + STEP * (i + 1), "stone",
                 skin="ashlar")


GATE_TOP = 8.4


def gatehouse():
    plan.heading("The gatehouse: a passage below a guardroom below a platform")
    outer = [(12, 33), (12, 34.4), (12.8, 35.2), (14.4, 35.2), (15.2, 34.4)]
    inner = [(12.5, 33), (12.5, 34.193), (13.007, 34.7), (14.193, 34.7), (14.893, 34)]

    def side(name, turned):
        heights = [PARAPET + 3.2, PARAPET + 2.4, PARAPET + 3.2, PARAPET + 2.4]
        for i, z in enumerate(heights):
            outline = [outer[i], outer[i + 1], inner[i + 1], inner[i]]
            outdoors(f"bastion-{name}-{i + 1}", turned(outline), z, "stone", skin="ashlar")
        outdoors(f"bastion-{name}-5", turned([(15.2, 34.4), (15.2, 34), (14.893, 34)]), 9.3, "stone",
                 skin="ashlar")
        battlement(f"gate-flank-{name}", turned([(12, 31.3), (12, 33)]), turned([(12.5, 31.3), (12.5, 33)]),
                   [1, 0.7], 9.3, 10.1)
        lit_window(f"bastion-{name}-window", turned(rectangle(13.3, 35.08, 13.9, 35.2)), 3.25, 1.5)
        lit_window(f"gate-{name}-lamp", turned(rectangle(15.08, 31.2, 15.2, 31.6)), 1.75, 0.75)
        doorway(f"guard-door-{name}", turned(rectangle(12, 31.45, 12.6, 32.4)), WALK, 1.95)
        vault = turned([(15.2, 0), (16.1, 0)])

        def spring(x, y, foot=vault[0][0], crown=vault[1][0]):
            return 1.3 * (crown - x) / (crown - foot)

        for part, y0, y1 in (("inner", 30, 33), ("outer", 33.3, 34)):
            room(f"gate-{part}-{name}", turned(rectangle(15.2, y0, 16.1, y1)), (COURT, "cobble"),
                 (4.4, "ashlar"),
                 wall="ashlar", skin="ashlar", ceiling_drop=spring)

    on_both_sides(side)
    outdoors("gate-top-entry", rectangle(12, 30.5, 12.5, 31.3), GATE_TOP, "stone", skin="ashlar")
    outdoors("gate-flank-corner", mirrored(rectangle(12, 30.5, 12.5, 31.3)), 9.3, "stone", skin="ashlar")
    battlement("gate-back", [(12, 30), (22, 30)], [(12, 30.5), (22, 30.5)], [1.2, 0.8] * 5, 9.3, 10.1)
    battlement("gate-front", [(15.2, 34), (18.8, 34)], [(15.2, 33.5), (18.8, 33.5)],
               [0.8, 0.6, 0.8, 0.6, 0.8], 9.3, 10.1)
    top = [(12.5, 33), (12.5, 34.193), (13.007, 34.7), (14.193, 34.7), (14.893, 34), (15.2, 34), (15.2, 33.5)]
    outdoors("gate-top", [(12.5, 30.5), *top, *mirrored(top)[::-1], (21.5, 30.5)], GATE_TOP, "stone",
             skin="ashlar")

    room("guardroom", rectangle(12.6, 30.7, 21.4, 33.2), (5.6, "wood"), (7.95, "beam"), wall="plaster",
         skin="ashlar")
    doorway("guard-window", rectangle(16.5, 33.2, 17.5, 34), 6.4, 1.2)
    doorway("guard-window-court", rectangle(16.2, 30, 17.8, 30.7), 6.4, 1.2)
    for part, y0, y1 in (("inner", 30, 33), ("outer", 33.3, 34)):
        room(f"gate-{part}", rectangle(16.1, y0, 17.9, y1), (COURT, "cobble"), (4.4, "ashlar"),
             wall="ashlar", skin="ashlar")
    room("portcullis", rectangle(15.2, 33, 18.8, 33.3), (COURT, "cobble"), (2.5, "grate"), wall="ashlar",
         skin="grate")


# --- The courtyard and what lies below it

OPENING = (12.5, 22.5)


def courtyard():
    plan.heading("The courtyard, open to the crypt below through an eight-sided kerb")
    kerb, shaft = ring(*OPENING, 2.5, 8), ring(*OPENING, 2.1, 8)
    garden = rectangle(24, 22.8, 29.6, 28.4)
    tower = ring(STAIR_X, STAIR_Y, STAIR_OUTER, 12)
    south_side = [tower[k] for k in (11, 0, 1, 2, 3)]  # the corners from the hall's front to the rampart
    border = [*south_side[::-1], (8.5, 13), (16, 13), (16, 14.4), (18.8, 14.4), (18.8, 13), (22, 13),
              (22, 20.5), (31.5, 20.5),
              *mirrored([(2.5, TOWER_Y - TOWER_APOTHEM), (TOWER_X + TOWER_APOTHEM, 30.5)]),
              (22, 30.5), (22, 30), (12, 30), (12, 30.5),
              (TOWER_X + TOWER_APOTHEM, 30.5), (2.5, TOWER_Y - TOWER_APOTHEM),
              (2.5, 26), (6, 26), (6, 18), (2.5, 18)]
    outdoors("courtyard", border, COURT, "cobble", holes=[kerb, garden], foot=("mossy", 0.75))
    outdoors("hall-step", rectangle(16, 13, 18.8, 14.4), 0.2, "stone", skin="stone")
    outdoors("garden", garden, 0.2, "grass", skin="mossy",
             holes=[rectangle(26, 24.8, 27.6, 26.4)])
    outdoors("garden-bed", rectangle(26, 24.8, 27.6, 26.4), 0.55, "dirt", skin="mossy")
    outdoors("kerb", kerb, 0.4, "stone", skin="stone", holes=[shaft])
    plan.add("crypt-shaft", shaft, (-0.6, None), OPEN_AIR, wall="stone", light=OUTDOORS,
             opening=("crypt-shaft", "crypt-light"))

    plan.heading("The stable, below its roof of boards")
    posts = [rectangle(5.65, y, 5.9, y + 0.25) for y in (18.3, 20.6, 23.15, 25.45)]
    room("stable", rectangle(2.5, 18.15, 6, 25.85), (COURT, "dirt"), (2.5, "wood"), wall="wood",
         skin="wood", holes=posts)
    outdoors("stable-roof", rectangle(2.5, 18, 6, 26), 2.75, "wood", skin="wood",
             floor_rise=lambda x, y: 0.5 * (6 - x))


def crypt():
    plan.heading("The crypt: below the courtyard")
    light, tomb = ring(*OPENING, 2.1, 8), rectangle(10.8, 21.4, 12, 23.6)
    piers = [ring(x, y, 0.45, 8) for x in (9, 16) for y in (19.6, 25.4)]

    def below(name, outline, ceiling, floor=(CRYPT, "stone"), **other):
        room(name, outline, floor, ceiling, **{"light": BELOW, "wall": "brick", "skin": "brick", **other})

    below("crypt", rectangle(7, 17.5, 20, 27.5), (-1.2, "brick"), holes=[light, *piers])
    below("crypt-light", light, (-0.6, None), holes=[tomb], opening=("crypt-shaft", "crypt-light"),
          wall="stone")
    below("tomb", tomb, (-0.6, None), floor=(CRYPT + 0.9, "marble"), opening=("crypt-shaft", "crypt-light"),
          skin="ashlar")
    for row, y0, y1, drop in (("north", 15.9, 17.5, lambda x, y: (17.5 - y) * 0.9),
                              ("south", 27.5, 29.1, lambda x, y: (y - 27.5) * 0.9)):
        for i, x in enumerate((7.8, 11.3, 14.8, 17.6)):
            below(f"niche-{row}-{i + 1}", rectangle(x, y0, x + 1.8, y1), (-2.2, "brick"), ceiling_drop=drop)
    below("crypt-pool", rectangle(20, 19.5, 23.5, 25.5), (-2, "mossy"), floor=(CRYPT - 0.35, "water"),
          wall="mossy", skin="mossy")
    below("crypt-passage",
          [(4.6, TOWER_SOUTH), (6.4, TOWER_SOUTH), (6.4, 21.4), (7, 21.4), (7, 23.6), (4.6, 23.6)],
          (-2.3, "brick"))


# --- The stair tower

STAIR_X, STAIR_INNER, STAIR_OUTER, NEWEL = 5.5, 2.4, 3.0, 0.3
STAIR_Y = 13 - STAIR_OUTER * math.tan(math.pi / 12)  # a corner of the tower meets the hall's front
TOWER_SOUTH = STAIR_Y + STAIR_OUTER
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

    south, east, west = STAIR_Y + STAIR_INNER, STAIR_X + STAIR_INNER, STAIR_X - STAIR_INNER
    doorway("stair-door", rectangle(5, south, 6, TOWER_SOUTH), COURT, 2.2)
    doorway("stair-door-crypt", rectangle(5, south, 6, TOWER_SOUTH), CRYPT, 2.2, light=BELOW)
    doorway("stair-door-gallery", rectangle(east, 11.6, HALL_WEST, 12.5), GALLERY, 2.1)
    doorway("stair-door-rampart", rectangle(2.5, 11.6, west, 12.6), WALK, 2.1)


# --- The hall

HALL, GALLERY, APEX, HALL_WEST = 0.4, 3.6, 10.6, 8.9
STRIPS = {"north": (1.4, 6), "middle": (6, 7.5), "south": (7.5, 12.5)}


def hall():
    plan.heading("The great hall: three strips, the outer two below slopes; beams, dais, gallery")

    def pitch(x, y):
        return 0.8 * max(6 - y, y - 7.5)

    def bay(name, x0, x1, z, floor, carpet="carpet", **other):
        for strip, (y0, y1) in STRIPS.items():
            is_middle = strip == "middle"
            texture = carpet if is_middle else floor
            room(f"hall-{name}-{strip}", rectangle(x0, y0, x1, y1), (z, texture), (APEX, "wood"),
                 **{"wall": "plaster", "skin": "beam", "ceiling_drop": None if is_middle else pitch, **other})

    def beam(name, x0, x1):
        for strip, (y0, y1) in STRIPS.items():
            texture = "carpet" if strip == "middle" else "marble"
            room(f"hall-below-{name}-{strip}", rectangle(x0, y0, x1, y1), (HALL, texture), (6, "beam"),
                 skin="beam")
        bay(name, x0, x1, 6.4, "beam", "beam")

    room("screens", rectangle(HALL_WEST, 1.4, 12.7, 12.5), (HALL, "marble"), (3.3, "beam"), wall="wood",
         skin="beam",
         holes=[rectangle(12.35, y, 12.65, y + 0.3) for y in (4.2, 9)])
    bay("gallery", HALL_WEST, 12.5, GALLERY, "wood", "wood")
    bay("rail", 12.5, 12.7, GALLERY + 0.9, "beam", "beam", skin="wood")
    bay("west", 12.7, 15.4, HALL, "marble")
    beam("west-beam", 15.4, 15.8)
    bay("centre", 15.8, 19.2, HALL, "marble")
    beam("east-beam", 19.2, 19.6)
    bay("east", 19.6, 21, HALL, "marble")
    bay("dais", 21, 24, HALL + 0.2, "wood", skin="wood")
    doorway("hall-door", rectangle(16.6, 12.5, 18.2, 13), HALL, 2.8)
    for name, x, width, z, height in (("west", 13.5, 1.1, 2.6, 3), ("door", 16.8, 1.2, 4.2, 1.6),
                                      ("east", 20, 0.8, 2.6, 3),
                                      ("gallery", 10, 1, 4.6, 1.6)):
        doorway(f"hall-window-{name}", rectangle(x, 12.5, x + width, 13), z, height)
    for name, x in (("west", 13.2), ("east", 19.7)):
        room(f"hall-hanging-{name}", rectangle(x, 1.25, x + 1.9, 1.4), (1.5, "wood"), (5.4, "wood"),
             wall="carpet")
    room("hall-hearth", [(16.4, 1.4), (16.8, 0.7), (18.4, 0.7), (18.8, 1.4)], (HALL, "stone"),
         (2.3, "brick"), wall="brick")
    room("hall-throne", rectangle(24, 5.6, 24.4, 7.9), (1.1, "wood"), (4.6, "wood"), wall="carpet")

    def south(x, y):
        return 0.75 * (13 - y)

    def north(x, y):
        return 0.75 * (y - 0.5)

    outdoors("hall-roof-south", rectangle(8.5, 6.75, 24.5, 13), 7.4, "roof", skin="plaster", floor_rise=south)
    outdoors("hall-roof-north", rectangle(8.5, 0.5, 24.5, 6.75), 7.4, "roof", skin="plaster",
             floor_rise=north)
    tower = ring(STAIR_X, STAIR_Y, STAIR_OUTER, 12)
    north_side = [tower[k] for k in range(4, 10)]
    outdoors("kitchen-roof", [(2.5, 0.5), (8.5, 0.5), *north_side[::-1]], WALK, "roof", skin="ashlar",
             floor_rise=lambda x, y: 0.24 * (11.6 - y))


# --- The chapel

NAVE = 0.2


def chapel():
    plan.heading("The chapel: sloped ceilings hung from its vault, coloured glass above the altar")

    def strips(name, x0, x1, z, middle, columns=(), corner=0):
        sides = {"north": (13.6, 15.6), "south": (19.9, 17.9)}
        for side, (wall, aisle) in sides.items():
            outline = [(x0, wall), (x1 - corner, wall), (x1, aisle), (x0, aisle)]
            row = aisle - 0.35 if side == "north" else aisle + 0.35
            room(f"{name}-{side}", outline, (z, "marble"), (7.8, "wood"), wall="ashlar", skin="marble",
                 holes=[ring(x, row, 0.24, 8) for x in columns],
                 ceiling_drop=lambda x, y, aisle=aisle: 1.5 * abs(y - aisle))
        room(f"{name}-aisle", rectangle(x0, 15.6, x1, 17.9), (z, middle), (7.8, "wood"), wall="ashlar",
             skin="marble",
             holes=[ALTAR] if name == "chancel" else [])

    ALTAR = rectangle(29.4, 15.9, 29.95, 17.6)
    strips("nave", 22.6, 27.4, NAVE, "carpet", columns=(25.1, 26.8))
    strips("chancel", 27.4, 31, NAVE + 0.2, "marble", corner=1.2)
    room("altar", ALTAR, (NAVE + 1.3, "carpet"), (7.8, "wood"), skin="ashlar")
    doorway("chapel-door", rectangle(22, 15.9, 22.6, 17.6), NAVE, 2.8)
    for side, y0, y1 in (("north", 15.75, 16.75), ("south", 16.75, 17.75)):
        doorway(f"chapel-window-{side}", rectangle(31, y0, 31.3, y1), 2.2, 4.6, wall="glass", light=0.6,
                sidewall="ashlar",
                ceiling_drop=lambda x, y: 1.4 * abs(y - 16.75))
    for i, x in enumerate((23.4, 25.4, 28.4)):
        doorway(f"chapel-window-{i + 1}", rectangle(x, 19.9, x + 0.7, 20.5), 1.8, 2.4)

    ridge = 16.8  # beside the window's middle: outlines of rooms and of what lies above stay apart
    for name, eaves in (("north", 13), ("south", 20.5)):
        outdoors(f"chapel-roof-{name}", rectangle(22, eaves, 31.5, ridge), 6.4, "slate", skin="ashlar",
                 floor_rise=lambda x, y, eaves=eaves: 4 * (y - eaves) / (ridge - eaves))


# --- The lake and the sky around it all

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


HEAD = """\
{
  "$schema": "level.schema.json",
  "version": 1,
  "name": "keep",
  "//": "A small castle by a lake at dusk. Written by tools/levels/keep.py from its plan: change that.",
  "//": "Heights: courtyard 0, water of the moat -2.5, crypt -4.8, gallery 3.6, ramparts 6, gatehouse",
  "//": "8.4, look-out of the stair tower 11.2. North is up (y < 0), the gate's axis x = 17. All skies",
  "//": "are at one height, so that towers stand before the sky and not behind steps of it.",
  "textures": "../textures",
  "lights": "keep.lights.json",
  "light": 0.1,
  "player": {
    "sector": "road", "x": 17, "y": 47, "z": 1.6, "angle": 270,
    "height": 1.8, "eye": 1.6, "radius": 0.3, "step": 0.4
  },

  "shots": [
    { "name": "arrival",   "camera": [13, 53.6, 3.3, 279, 5],      "fov": 92 },
    { "name": "bridge",    "camera": [9.4, 40.8, 1.9, 312, -6],    "fov": 95 },
    { "name": "courtyard", "camera": [18.5, 28.8, 1.6, 250, 6],    "fov": 90 },
    { "name": "opening",   "camera": [14.8, 22.9, 2.0, 184, -50],  "fov": 95 },
    { "name": "hall",      "camera": [22.8, 9.8, 2.4, 202, 8],     "fov": 90 },
    { "name": "chapel",    "camera": [22.8, 17.0, 2.0, 355, 6],    "fov": 90 },
    { "name": "crypt",     "camera": [7.6, 24.4, -3, 330, 4],      "fov": 90 },
    { "name": "rampart",   "camera": [1.6, 14, 7.6, 62, -8],       "fov": 90 }
  ],
"""


def build():
    for part in (country, moat, ramparts, gatehouse, corner_towers, courtyard, stair_tower, hall, chapel,
                 crypt, void):
        part()
    return plan.text(HEAD)


if __name__ == "__main__":
    out = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parents[2] / "levels" / "keep.json"
    out.write_text(build())
