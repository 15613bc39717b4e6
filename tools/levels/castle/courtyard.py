"""The courtyard with garden and stable."""

from castle.props import POST, lamp_post
from castle.site import (
    COURT, OPEN_AIR, OUTDOORS, STAIR_OUTER, STAIR_X, STAIR_Y, cone, mirrored, moss, outdoors, pillar, plan,
    room, square)
from castle.things import lantern, put, stores, straw
from castle.walls import TOWER_APOTHEM, TOWER_X, TOWER_Y
from plan import rectangle, ring

OPENING = (12.5, 22.5)


CROWN = 1.1  # metres from the middle of the tree to its sides


def tree(name, x, y, z):
    """A small fir: a trunk, and from a man's height up eight slopes of green."""
    room(name, ring(x, y, CROWN, 8), (z, "grass"), (z + 1.9, "grass"), wall="post", skin="grass",
         light=OUTDOORS, holes=[ring(x, y, 0.14, 8)])
    cone(f"{name}-crown", x, y, CROWN, z + 2.1, 3.4, "grass")


def courtyard():
    plan.heading("The courtyard, open to the crypt below through an eight-sided kerb")
    kerb, shaft = ring(*OPENING, 2.5, 8), ring(*OPENING, 2.1, 8)
    garden = rectangle(24, 22.8, 29.6, 28.4)
    beds = [rectangle(24.4, y, 29.2, y + 0.7) for y in (23.2, 27.3)]
    tower = ring(STAIR_X, STAIR_Y, STAIR_OUTER, 12)
    south_side = [tower[k] for k in (11, 0, 1, 2, 3)]  # the corners from the hall's front to the rampart
    border = [*south_side[::-1], (8.5, 13), (16, 13), (16, 14.4), (18.8, 14.4), (18.8, 13), (22, 13),
              (22, 20.5), (31.5, 20.5),
              *mirrored([(2.5, TOWER_Y - TOWER_APOTHEM), (TOWER_X + TOWER_APOTHEM, 30.5)]),
              (22, 30.5), (22, 30), (12, 30), (12, 30.5),
              (TOWER_X + TOWER_APOTHEM, 30.5), (2.5, TOWER_Y - TOWER_APOTHEM),
              (2.5, 26), (6, 26), (6, 18), (2.5, 18)]
    lamps = [(15.5, 14.9), (19.3, 14.9)]
    outdoors("courtyard", border, COURT, "cobble", foot=moss(0.75),
             holes=[kerb, garden, *(square(*lamp, POST) for lamp in lamps)])
    for side, lamp in zip(("west", "east"), lamps):
        lamp_post(f"court-post-{side}", *lamp)
    outdoors("hall-step", rectangle(16, 13, 18.8, 14.4), 0.2, "stone", skin="dressed", foot=moss(0.75))
    outdoors("garden", garden, 0.2, "grass", skin="dressed",
             holes=[ring(26.8, 25.6, CROWN, 8), *beds])
    tree("garden-tree", 26.8, 25.6, 0.2)
    for side, bed in zip(("north", "south"), beds):
        outdoors(f"garden-bed-{side}", bed, 0.35, "dirt", skin="dressed")
    outdoors("kerb", kerb, 0.4, "dressed", skin="ashlar", holes=[shaft])
    plan.add("crypt-shaft", shaft, (-0.6, None), OPEN_AIR, wall="ashlar", light=OUTDOORS,
             opening=("crypt-shaft", "crypt-light"))

    put("statue", 21.4, 19.9, COURT, 160)
    put("bench", 24.6, 25.6, 0.2, 90)
    stores(COURT, barrels=[(9.1, 13.45), (9.85, 13.42), (9.5, 14.1)], crates=[(10.9, 13.5, 6), (11.75, 13.55, 86)])
    put("crate", 11.3, 13.5, COURT + 0.7, 22, 0.85)
    put("cart", 7.6, 19.4, COURT, 150)
    stable()


def stable():
    plan.heading("The stable, below its roof of boards: three stalls, mangers, hay")
    loft, back = (2.5, "wood"), 2.51
    posts = [rectangle(5.65, y, 5.9, y + 0.25) for y in (18.3, 20.6, 23.15, 25.45)]
    partitions = [rectangle(back, y, 4.9, y + 0.12) for y in (20.66, 23.21)]
    mangers = [rectangle(back, y, 3.1, y + 1.9) for y in (18.5, 23.6)]
    heap = [(back, 20.79), (4.1, 20.79), (3.25, 23.2), (back, 23.2)]
    room("stable", rectangle(2.5, 18.15, 6, 25.85), (COURT, "dirt"), loft, wall="wood", skin="wood",
         holes=[*posts, *partitions, *mangers, heap])
    for i, post in enumerate(posts):
        pillar(f"stable-post-{i + 1}", post, COURT, "post")
    for i, partition in enumerate(partitions):
        room(f"stable-partition-{i + 1}", partition, (0.95, "wood"), loft, skin="wood")
    for i, manger in enumerate(mangers):
        room(f"stable-manger-{i + 1}", manger, (0.7, "hay"), loft, skin="wood", sidewall="hay",
             floor_rise=lambda x, y: 0.6 * (3.1 - x))
    room("stable-hay", heap, (COURT, "hay"), loft, skin="hay",
         floor_rise=lambda x, y: 0.8 * (4.1 - x) - 0.28 * (y - 20.79))
    lantern(4.6, 22, 2.05)
    for x, y, angle in ((4.1, 19.5, 20), (4.9, 20.6, 100), (4.4, 24.5, 55), (5.3, 23.1, 0)):
        straw(x, y, COURT, angle)
    outdoors("stable-roof", rectangle(2.5, 18, 6, 26), 2.75, "wood", skin="wood",
             floor_rise=lambda x, y: 0.5 * (6 - x))
