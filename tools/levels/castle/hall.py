"""The great hall."""

from castle.furniture import APEX, DAIS, HALL, PLACES, furnish, pitch
from castle.site import (
    STAIR_OUTER, STAIR_X, STAIR_Y, WALK, doorway, glowing, opening_above, outdoors, pillar, plan, room)
from plan import rectangle, ring

GALLERY, HALL_WEST = 3.6, 8.9
STRIPS = {"north": (1.4, 6), "middle": (6, 7.5), "south": (7.5, 12.5)}


def hall():
    plan.heading("The great hall: three strips, the outer two below slopes; beams, dais, gallery")

    def bay(name, x0, x1, z, floor, carpet="carpet", **other):
        for strip, (y0, y1) in STRIPS.items():
            is_middle = strip == "middle"
            texture = carpet if is_middle else floor
            room(f"hall-{name}-{strip}", rectangle(x0, y0, x1, y1), (z, texture), (APEX, "wood"),
                 **{"wall": "plaster", "skin": "beam", "ceiling_drop": None if is_middle else pitch,
                    "holes": PLACES.get(name, {}).get(strip, []), **other})

    def beam(name, x0, x1):
        for strip, (y0, y1) in STRIPS.items():
            texture = "carpet" if strip == "middle" else "marble"
            room(f"hall-below-{name}-{strip}", rectangle(x0, y0, x1, y1), (HALL, texture), (6, "post"),
                 skin="beam")
        bay(name, x0, x1, 6.4, "post", "post")

    posts = [rectangle(12.35, y, 12.65, y + 0.3) for y in (4.2, 9)]
    room("screens", rectangle(HALL_WEST, 1.4, 12.7, 12.5), (HALL, "marble"), (3.3, "wood"), wall="wood",
         skin="beam", holes=posts)
    for i, post in enumerate(posts):
        pillar(f"screens-post-{i + 1}", post, HALL, "post")
    bay("gallery", HALL_WEST, 12.5, GALLERY, "wood", "wood")
    bay("rail", 12.5, 12.7, GALLERY + 0.9, "beam", "beam", skin="wood")
    bay("west", 12.7, 15.4, HALL, "marble")
    beam("west-beam", 15.4, 15.8)
    bay("centre", 15.8, 19.2, HALL, "marble")
    beam("east-beam", 19.2, 19.6)
    bay("east", 19.6, 21, HALL, "marble")
    bay("dais", 21, 24, DAIS, "wood", skin="wood")
    furnish()
    doorway("hall-door", rectangle(16.6, 12.5, 18.2, 13), HALL, 2.8)
    for name, x, width, z, height in (("west", 13.5, 1.1, 2.6, 3), ("door", 16.8, 1.2, 4.2, 1.6),
                                      ("east", 20, 0.8, 2.6, 3),
                                      ("gallery", 10, 1, 4.6, 1.6)):
        mullion = rectangle(x + width / 2 - 0.05, 12.7, x + width / 2 + 0.05, 12.8)
        doorway(f"hall-window-{name}", rectangle(x, 12.5, x + width, 13), z, height, holes=[mullion])
    fire = rectangle(17, 0.85, 18.2, 1.3)
    room("hall-hearth", [(16.4, 1.4), (16.8, 0.7), (18.4, 0.7), (18.8, 1.4)], (HALL, "stone"),
         (2.3, "brick"), wall="brick", holes=[fire], surround=("dressed", 0.3))
    glowing("hall-fire", fire, HALL + 0.2, HALL + 0.25, "hall-fire", light=0.8)
    room("hall-fire-above", fire, (HALL + 0.25, None), (2.3, "brick"), wall="brick",
         opening=opening_above("hall-fire"))

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
