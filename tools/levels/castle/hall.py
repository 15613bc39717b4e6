"""The great hall."""

from castle.furniture import APEX, DAIS, HALL, PLACES, furnish, pitch
from castle.site import (
    INDOORS, STAIR_OUTER, STAIR_X, STAIR_Y, WALK, closed, doorway, floating, glazed, glowing, opening_above,
    outdoors, pillar, plan, room, square)
from castle.props import CANDLE, candle
from castle.things import banner, flame, gonfalon, lantern, put, stores, torch
from plan import rectangle, ring

GALLERY, HALL_WEST = 3.6, 8.9
SHELF = rectangle(8.91, 9.9, 9.21, 11.9)
STRIPS = {"north": (1.4, 6), "middle": (6, 7.5), "south": (7.5, 12.5)}


def roof():
    """Above the windows of its gables it begins higher, so that they are in walls and not in slopes. It is
    cut where its image of 2.4 m begins anew. Dressed stones cover its verges."""
    eaves, ridge, lintel, cuts, scale = 7.4, 6.75, 10.2, (4.34, 9.16), 2.4
    x0, x1 = 8.7, 24.3
    west, east = x0 + scale, x0 + 6 * scale

    def south(x, y):
        return 0.75 * (13 - y)

    def north(x, y):
        return 0.75 * (y - 0.5)

    def part(name, outline, rise, z=eaves, texture="roof", over=0):
        outdoors(f"hall-roof-{name}", outline, z, texture, skin="plaster",
                 floor_rise=lambda x, y: rise(x, y) - (z - eaves) + over)

    part("south", [(west, ridge), (east, ridge), (east, cuts[1]), (x1, cuts[1]), (x1, 13), (x0, 13),
                   (x0, cuts[1]), (west, cuts[1])], south)
    part("north", [(x0, 0.5), (x1, 0.5), (x1, cuts[0]), (east, cuts[0]), (east, ridge), (west, ridge),
                   (west, cuts[0]), (x0, cuts[0])], north)
    for side, begin, end, front, inwards in (("west", x0, west, 8.5, 1), ("east", east, x1, 24.5, -1)):
        part(f"south-{side}", rectangle(begin, ridge, end, cuts[1]), south, lintel)
        part(f"north-{side}", rectangle(begin, cuts[0], end, ridge), north, lintel)
        verge = sorted((front, front + 0.2 * inwards))
        for i, (y0, y1, rise, z) in enumerate(((0.5, cuts[0], north, eaves), (cuts[0], ridge, north, lintel),
                                               (ridge, cuts[1], south, lintel), (cuts[1], 13, south, eaves))):
            part(f"verge-{side}-{i + 1}", rectangle(verge[0], y0, verge[1], y1), rise, z, "dressed", 0.12)
        glazed(f"hall-gable-{side}", [(front, ridge - 0.5), (front, ridge + 0.5)], (inwards, 0), 8.3, 1.65)


def screens():
    """Below the gallery: three bays between joists on posts, wainscot, a door, stores."""
    ceiling, ys = (3.3, "wood"), [1.4, 4.15, 4.55, 8.95, 9.35, 12.5]
    posts = {name: rectangle(12.35, y, 12.65, y + 0.3)
             for name, y in (("-north-joist", 4.2), ("-south-joist", 9))}
    holes = {"-south": [SHELF], **{name: [post] for name, post in posts.items()}}
    for part, y0, y1 in zip(("-north", "-north-joist", "", "-south-joist", "-south"), ys, ys[1:]):
        room(f"screens{part}", rectangle(HALL_WEST, y0, 12.7, y1), (HALL, "marble"),
             (3, "beam") if part in posts else ceiling, skin="beam", foot=[("wood", 1.6)],
             holes=holes.get(part, []))
    for name, post in posts.items():
        pillar(f"screens{name}-post", post, HALL, "post")
    stores(HALL, barrels=[(9.3, 1.8), (9.3, 2.6), (10.05, 1.8)], crates=[(9.35, 3.5, 4)])
    for x, y in ((11.4, 5), (10, 10.9)):
        lantern(x, y, 2.35)
    shelf(ceiling)
    closed("kitchen-door", [(HALL_WEST, 6.15), (HALL_WEST, 7.35)], (-1, 0), HALL, 2.1, "door", INDOORS)


def shelf(ceiling):
    """Pots, and a candle, on the western wall."""
    z, wax = 1.8, (9.06, 10.9)
    pots = [(height, ring(9.06, y, 0.09, 8)) for height, y in ((0.2, 10.2), (0.14, 10.5), (0.24, 11.5))]
    air = {"ceiling": (z + 0.3, None), "opening": opening_above("screens-shelf")}
    floating("screens-shelf", SHELF, (HALL, "marble"), ceiling, z - 0.05, z, "wood", glow=(z + 0.3, 0.4, []),
             upper_holes=[square(*wax, CANDLE), *(outline for _, outline in pots)])
    candle("screens-candle", *wax, z + 0.25, **air)
    for i, (height, outline) in enumerate(pots):
        room(f"screens-pot-{i + 1}", outline, (z + height, "dirt"), skin="dirt", **air)


def hangings():
    """Beside the hearth, below the beams, on the front; and a torch on the gallery."""
    for x in (15.5, 19.75):
        put("standard", x, 1.85, HALL, 90)
    for x in (15.6, 19.4):
        for y in (3.4, 10):
            gonfalon(x, y, 6, 0)
    for x in (15.6, 19.1):
        banner(x, 13, 2.6, 90)
    torch(HALL_WEST, 9.5, 5, 0)


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

    screens()
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
    for x, y, width, height in ((17.3, 1.1, 0.5, 0.7), (17.62, 1.02, 0.55, 0.95), (17.92, 1.12, 0.45, 0.62)):
        flame(x, y, HALL + 0.2, width, height)
    hangings()

    roof()
    tower = ring(STAIR_X, STAIR_Y, STAIR_OUTER, 12)
    north_side = [tower[k] for k in range(4, 10)]
    outdoors("kitchen-roof", [(2.5, 0.5), (8.5, 0.5), *north_side[::-1]], WALK, "roof", skin="ashlar",
             floor_rise=lambda x, y: 0.24 * (11.6 - y))
