#!/usr/bin/env python3
"""Writes the models of levels/models: what stands in the castle.

usage: tools/models/models.py [OUTDIR]
"""

import sys
from pathlib import Path

import mesh
from cloths import banner, flag, standard
from lamps import candle_stand, chandelier, lantern, torch
from shapes import REPEAT
from statue import statue
from stores import barrel, bench, cart, crate

MODELS = {"banner": banner, "barrel": barrel, "bench": bench, "candle-stand": candle_stand, "cart": cart,
          "chandelier": chandelier, "crate": crate, "flag": flag, "lantern": lantern, "standard": standard,
          "statue": statue, "torch": torch}
LIBRARY = "castle.mtl"


def materials():
    """One for each image that models wear, and of its name."""
    lines = ["# Written by tools/models/models.py: change that."]
    for name in sorted(REPEAT):
        lines += [f"newmtl {name}", f"map_Kd ../../textures/{name}.png"]
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parents[2] / "levels/models"
    folder.mkdir(parents=True, exist_ok=True)
    (folder / LIBRARY).write_text(materials())
    for name, build in MODELS.items():
        (folder / f"{name}.obj").write_text(mesh.text(name, build(), LIBRARY))
