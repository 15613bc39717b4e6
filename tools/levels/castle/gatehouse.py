"""The gatehouse."""

from castle.props import BOWL, brazier, on_legs
from castle.site import (
    COURT, PARAPET, WALK, battlement, doorway, glazed, mirrored, on_both_sides, outdoors, plan, room)
from castle.things import banner, chandelier, stores, torch
from plan import rectangle, ring

GATE_TOP = 8.4


# From the courtyard to the bridge: names, where they begin and end, whether the portcullis hangs there.
PASSAGE = [("inner", 30, 33, False), ("portcullis", 33, 33.3, True), ("outer", 33.3, 34, False)]
BARS = (33.1, 33.2)


def bars(name, turned, x0, x1, middles, **vault):
    """The portcullis between two places: upright bars 40 cm apart, which move, and one across them, which
    guides them. Names those that move."""
    def iron(part, begin, end, ceiling, floor=(COURT, "cobble"), **other):
        room(f"{name}-{part}", turned(rectangle(begin, BARS[0], end, BARS[1])), floor, ceiling, wall="iron",
             skin="iron", **other)

    for i, x in enumerate(middles):
        iron(f"bar-{i + 1}", x - 0.05, x + 0.05, (COURT, "iron"))
    begins, ends = [x0, *(x + 0.05 for x in middles)], [*(x - 0.05 for x in middles), x1]
    for i, (begin, end) in enumerate(zip(begins, ends)):
        iron(f"gap-{i + 1}", begin, end, (2.9, "iron"))
        iron(f"gap-{i + 1}-above", begin, end, (4.4, "ashlar"), floor=(3, "iron"), **vault)
    return [f"{name}-bar-{i + 1}" for i in range(len(middles))]


def gatehouse():
    plan.heading("The gatehouse: a passage below a guardroom below a platform")
    outer = [(12, 33), (12, 34.4), (12.8, 35.2), (14.4, 35.2), (15.2, 34.4)]
    inner = [(12.5, 33), (12.5, 34.193), (13.007, 34.7), (14.193, 34.7), (14.893, 34)]

    moving = []

    def side(name, turned):
        heights = [PARAPET + 3.2, PARAPET + 2.4, PARAPET + 3.2, PARAPET + 2.4]
        for i, z in enumerate(heights):
            outline = [outer[i], outer[i + 1], inner[i + 1], inner[i]]
            outdoors(f"bastion-{name}-{i + 1}", turned(outline), z, "stone", skin="ashlar")
        outdoors(f"bastion-{name}-5", turned([(15.2, 34.4), (15.2, 34), (14.893, 34)]), 9.3, "stone",
                 skin="ashlar")
        battlement(f"gate-flank-{name}", turned([(12, 31.3), (12, 33)]), turned([(12.5, 31.3), (12.5, 33)]),
                   [1, 0.7], 9.3, 10.1)
        glazed(f"bastion-{name}-window", turned([(13.25, 35.2), (14, 35.2)]), (0, -1), 3.25, 1.5)
        glazed(f"gate-{name}-lamp", turned([(15.2, 31.25), (15.2, 31.625)]), (-1 if name == "west" else 1, 0),
               1.75, 0.75)
        doorway(f"guard-door-{name}", turned(rectangle(12, 31.45, 12.6, 32.4)), WALK, 1.95)
        vault = turned([(15.2, 0), (16.1, 0)])

        def spring(x, y, foot=vault[0][0], crown=vault[1][0]):
            return 1.3 * (crown - x) / (crown - foot)

        for part, y0, y1, holes in PASSAGE:
            room(f"gate-{part}-{name}", turned(rectangle(15.2, y0, 16.1, y1)), (COURT, "cobble"),
                 (4.4, "ashlar"), wall="ashlar", skin="ashlar", ceiling_drop=spring,
                 holes=[turned(rectangle(15.22, BARS[0], 16.08, BARS[1]))] if holes else [])
        moving.extend(bars(f"portcullis-{name}", turned, 15.22, 16.08, [15.4, 15.8], ceiling_drop=spring))

    on_both_sides(side)
    outdoors("gate-top-entry", rectangle(12, 30.5, 12.5, 31.3), GATE_TOP, "stone", skin="ashlar")
    outdoors("gate-flank-corner", mirrored(rectangle(12, 30.5, 12.5, 31.3)), 9.3, "stone", skin="ashlar")
    battlement("gate-back", [(12, 30), (22, 30)], [(12, 30.5), (22, 30.5)], [1.2, 0.8] * 5, 9.3, 10.1)
    battlement("gate-front", [(15.2, 34), (18.8, 34)], [(15.2, 33.5), (18.8, 33.5)],
               [0.8, 0.6, 0.8, 0.6, 0.8], 9.3, 10.1)
    top = [(12.5, 33), (12.5, 34.193), (13.007, 34.7), (14.193, 34.7), (14.893, 34), (15.2, 34), (15.2, 33.5)]
    outdoors("gate-top", [(12.5, 30.5), *top, *mirrored(top)[::-1], (21.5, 30.5)], GATE_TOP, "stone",
             skin="ashlar", holes=[ring(18.4, 32.2, BOWL, 8)])
    brazier("brazier-gate", 18.4, 32.2, GATE_TOP)
    for x in (13.6, 20.4):
        banner(x, 35.2, 5.15, 90)

    guardroom()
    doorway("guard-window", rectangle(16.5, 33.2, 17.5, 34), 6.4, 1.2)
    doorway("guard-window-court", rectangle(16.2, 30, 17.8, 30.7), 6.4, 1.2)
    for part, y0, y1, holes in PASSAGE:
        room(f"gate-{part}", rectangle(16.1, y0, 17.9, y1), (COURT, "cobble"), (4.4, "ashlar"),
             wall="ashlar", skin="ashlar", holes=[rectangle(16.12, BARS[0], 17.88, BARS[1])] if holes else [])
    moving.extend(bars("portcullis", lambda points: points, 16.12, 17.88, [16.2, 16.6, 17, 17.4, 17.8]))
    passage = [f"gate-{part}{side}" for part, *_ in PASSAGE for side in ("", "-west", "-east")]
    plan.move("portcullis", "ceiling", 2.75, moving, wait=4, trigger="enter", zones=["bridge", *passage])


def guardroom():
    """Three bays between beams: a chest and a bed, the windows, a table and a bench."""
    floor, ceiling, xs = (5.6, "wood"), (7.95, "wood"), [12.6, 15, 15.3, 18.5, 18.8, 21.4]
    chest, bed = rectangle(13.3, 30.75, 14.4, 31.25), rectangle(12.8, 32.5, 14.7, 33.15)
    table, bench = rectangle(19, 31.3, 20.8, 31.9), rectangle(19, 30.95, 20.8, 31.15)
    for part, x0, x1, holes in zip(("-west", "-west-beam", "", "-east-beam", "-east"), xs, xs[1:],
                                   ([chest, bed], [], [], [], [table, bench])):
        above, skin = ((7.8, "post"), "beam") if part.endswith("beam") else (ceiling, "ashlar")
        room(f"guardroom{part}", rectangle(x0, 30.7, x1, 33.2), floor, above, skin=skin, holes=holes)
    room("guard-chest", chest, (6.1, "wood"), ceiling, skin="door")
    room("guard-bed", bed, (6, "hay"), ceiling, skin="wood")
    on_legs("guard-table", table, floor, ceiling, 0.76, 0.15)
    on_legs("guard-bench", bench, floor, ceiling, 0.45, 0.03)
    chandelier(17, 32, 7.3)
    for x in (13.9, 19.9):
        torch(x, 30.7, 6.75, 90)
    stores(floor[0], barrels=[(20.2, 32.85)], crates=[(19.35, 32.8, 0)])
