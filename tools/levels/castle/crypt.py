"""The crypt, below the courtyard."""

from castle.courtyard import OPENING
from castle.site import BELOW, CRYPT, TOWER_SOUTH, plan, room
from plan import rectangle, ring


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
