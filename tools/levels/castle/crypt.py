"""The crypt, below the courtyard."""

from castle.courtyard import OPENING
from castle.site import BELOW, CRYPT, FRAME, TOWER_SOUTH, pillar, plan, room, square
from castle.props import CANDLE, candle
from castle.things import candle_stand, stores, torch
from plan import rectangle, ring

LIGHT = ring(*OPENING, 2.1, 8)  # what lies below the opening
# Where ribs run from wall to wall: the odd strips.
XS, YS = [7, 8.65, 9.35, 15.65, 16.35, 20], [17.5, 19.25, 19.95, 25.05, 25.75, 27.5]


def below(name, outline, ceiling, floor=(CRYPT, "stone"), **other):
    room(name, outline, floor, ceiling, **{"light": BELOW, "wall": "brick", "skin": "brick", **other})


def vaults():
    """Brick between ribs, and a pier where two of them meet."""
    for i in range(5):
        for j in range(5):
            outline = rectangle(XS[i], YS[j], XS[i + 1], YS[j + 1])
            is_middle, is_rib, is_pier = i == j == 2, i % 2 or j % 2, i % 2 and j % 2
            pier = ring((XS[i] + XS[i + 1]) / 2, (YS[j] + YS[j + 1]) / 2, 0.33, 8)
            below("crypt" if is_middle else f"crypt-{i + 1}-{j + 1}", outline,
                  (-1.6, "dressed") if is_rib else (-1.2, "brick"), skin="dressed",
                  holes=[pier] if is_pier else [LIGHT] if is_middle else [])
            if is_pier:
                pillar(f"crypt-pier-{i + 1}-{j + 1}", pier, CRYPT, "ashlar")


def tomb():
    """On a plinth in the light of the opening. Its lid stands over on all sides."""
    plinth, lid, body = (rectangle(12 - x, 22.5 - y, 12 + x, 22.5 + y)
                         for x, y in ((0.8, 1.3), (0.62, 1.12), (0.5, 1)))
    common = {"ceiling": (-0.6, None), "opening": ("crypt-shaft", "crypt-light"), "skin": "dressed"}
    below("crypt-light", LIGHT, holes=[plinth], **common)
    below("tomb-plinth", plinth, floor=(CRYPT + 0.2, "dressed"), holes=[lid], **common)
    below("tomb", lid, (CRYPT + 0.85, "dressed"), floor=(CRYPT + 0.2, "dressed"), holes=[body], wall="dressed")
    below("tomb-lid", lid, floor=(CRYPT + 1, "dressed"), **common)


def niches():
    for row, mouth, inwards in (("north", 17.5, -1), ("south", 27.5, 1)):
        def drop(x, y, mouth=mouth):
            return abs(y - mouth) * 0.9

        for i, x in enumerate((7.8, 11.3, 14.8, 17.6)):
            name, common = f"niche-{row}-{i + 1}", {"ceiling_drop": drop, "light": BELOW + 0.06}
            chest = rectangle(x + 0.25, mouth + 0.8 * inwards, x + 1.55, mouth + 1.4 * inwards)
            below(name, rectangle(x, mouth, x + 1.8, mouth + 1.6 * inwards), (-2.2, "brick"), holes=[chest],
                  surround=FRAME, **common)
            below(f"{name}-chest", chest, (-2.2, "brick"), floor=(CRYPT + 0.5, "dressed"), skin="dressed",
                  **common)


def candles():
    """In niches of the eastern wall, on both sides of the pool."""
    for side, y in (("north", 18.35), ("south", 26.65)):
        ceiling = (-2.9, "brick")
        below(f"candle-niche-{side}", rectangle(20, y - 0.3, 20.3, y + 0.3), ceiling, floor=(-3.5, "dressed"),
              light=0.5, surround=FRAME, holes=[square(20.15, y, CANDLE)])
        candle(f"crypt-candle-{side}", 20.15, y, -3.15, ceiling)


def pool():
    water = CRYPT - 0.35
    columns = [ring(20.35, y, 0.24, 8) for y in (21.2, 23.8)]
    below("crypt-pool", rectangle(20, 19.5, 23.5, 25.5), (-2, "mossy"), floor=(water, "water"), wall="mossy",
          skin="dressed", holes=columns)
    for i, column in enumerate(columns):
        pillar(f"crypt-pool-column-{i + 1}", column, water, "dressed")


def crypt():
    plan.heading("The crypt: below the courtyard")
    vaults()
    tomb()
    niches()
    candles()
    pool()
    below("crypt-passage",
          [(4.6, TOWER_SOUTH), (6.4, TOWER_SOUTH), (6.4, 21.4), (7, 21.4), (7, 23.6), (4.6, 23.6)],
          (-2.3, "brick"), light=BELOW + 0.05, surround=FRAME)
    lights()


def lights():
    """In the passage, on both sides of its mouth, between niches; and beside the tomb."""
    for x, y, angle in ((4.6, 16.4, 0), (4.6, 21.2, 0), (7, 20.9, 0), (7, 24.1, 0), (10.45, 27.5, 270),
                        (13.95, 27.5, 270), (17.1, 17.5, 90)):
        torch(x, y, CRYPT + 1.75, angle)
    candle_stand(10.9, 22.5, CRYPT)
    stores(CRYPT, barrels=[(4.95, 23.2)])
