"""The courtyard with garden and stable."""

from castle.site import COURT, OPEN_AIR, OUTDOORS, STAIR_OUTER, STAIR_X, STAIR_Y, mirrored, outdoors, plan, room
from castle.walls import TOWER_APOTHEM, TOWER_X, TOWER_Y
from plan import rectangle, ring

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
