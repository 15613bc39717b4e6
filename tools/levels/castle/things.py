"""Models and sprites: fires, lamps, stores, cloths. The models are those of tools/models, whose fronts
look along `angle`; the images are painted by tools/textures."""

import math
import sys
from pathlib import Path

from castle.site import plan
from plan import rounded

sys.path.append(str(Path(__file__).parents[2] / "models"))
from lamps import CHANDELIER_FLAMES, STAND_FLAMES, TORCH_FLAME  # noqa: E402

CHAIN = [0.125, 4]  # metres: where a ceiling is nearer, the rest of it is not seen
RING = 0.03  # metres from the top of what hangs down to where its chain begins


def put(model, x, y, z, angle=0, scale=1, solid=True):
    thing = {"mesh": f"models/{model}.obj", "x": rounded(x), "y": rounded(y), "z": rounded(z)}
    if angle:
        thing["angle"] = rounded(angle)
    if scale != 1:
        thing["scale"] = scale
    if not solid:
        thing["solid"] = False
    plan.things.append(thing)


def out(x, y, angle, distance):
    turn = math.radians(angle)
    return x + distance * math.cos(turn), y + distance * math.sin(turn)


# --- Flames

def burning(image, frames, fps, x, y, z, size):
    """Neighbours begin with other frames."""
    first = len(plan.things) % frames
    names = [f"{image}-{(first + k) % frames + 1}" for k in range(frames)]
    plan.things.append({"frames": names, "fps": fps, "x": rounded(x), "y": rounded(y), "z": rounded(z),
                        "size": size, "bright": True})


def flame(x, y, z, width, height):
    burning("flame", 6, 10, x, y, z, [width, height])


def candle_flame(x, y, z):
    burning("candle", 4, 6, x, y, z, [0.06, 0.12])


# --- Lamps

def torch(x, y, z, angle):
    """On a wall that looks along `angle`."""
    put("torch", *out(x, y, angle, 0.002), z, angle, solid=False)
    away, up = TORCH_FLAME
    flame(*out(x, y, angle, away), z + up, 0.3, 0.45)


def hanging(model, x, y, z, height):
    put(model, x, y, z, solid=False)
    plan.things.append({"sprite": "chain", "x": rounded(x), "y": rounded(y), "z": rounded(z + height - RING),
                        "size": CHAIN})


def lantern(x, y, z):
    """Its light is to be 0.15 m above its lower edge."""
    hanging("lantern", x, y, z, 0.417)
    candle_flame(x, y, z + 0.13)


def candles_around(flames, x, y, z):
    count, away, up = flames
    for k in range(count):
        candle_flame(*out(x, y, 360 * k / count, away), z + up)


def chandelier(x, y, z):
    hanging("chandelier", x, y, z, 0.58)
    candles_around(CHANDELIER_FLAMES, x, y, z)


def candle_stand(x, y, z):
    put("candle-stand", x, y, z)
    candles_around(STAND_FLAMES, x, y, z)


# --- Stores and cloths

def stores(z, barrels=(), crates=()):
    """Barrels at (x, y), crates at (x, y, angle)."""
    for i, (x, y) in enumerate(barrels):
        put("barrel", x, y, z, angle=(70 * i + 40) % 360)
    for x, y, angle in crates:
        put("crate", x, y, z, angle)


def banner(x, y, z, angle):
    """Before a wall that looks along `angle`."""
    put("banner", *out(x, y, angle, 0.002), z, angle, solid=False)


def gonfalon(x, y, top, angle):
    """Below a beam; its image is whole on both sides."""
    plan.things.append({"sprite": "gonfalon", "facing": "angle", "angle": angle, "x": x, "y": y,
                        "z": rounded(top - 1.5), "size": [0.75, 1.5]})


def straw(x, y, z, angle):
    plan.things.append({"sprite": "straw", "facing": "flat", "angle": angle, "x": x, "y": y, "z": z,
                        "size": [1.6, 1.6]})
