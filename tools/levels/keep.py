#!/usr/bin/env python3
"""Writes levels/keep.json: the plan of a small castle.

usage: tools/levels/keep.py [OUT.json] && hearth fmt levels/keep.json

The plan knows nothing of layout: that is the second command's.

The gate is in the south, the hall in the north, the chapel in the east, a stair tower between hall
and western rampart. x = 17 is the axis of gate and bridge. The parts are in castle/.
"""

import sys
from pathlib import Path

from castle.chapel import chapel
from castle.country import country, moat, void
from castle.courtyard import courtyard
from castle.crypt import crypt
from castle.gatehouse import gatehouse
from castle.hall import hall
from castle.site import plan
from castle.stairs import stair_tower
from castle.walls import corner_towers, ramparts

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
    "sector": "road", "x": 17, "y": 47, "z": 1.6, "angle": 270, "height": 1.8, "eye": 1.6,
    "radius": 0.3, "step": 0.4
  },

  "shots": [
    { "name": "arrival", "camera": [13, 53.6, 3.3, 279, 5], "fov": 92 },
    { "name": "bridge", "camera": [10.3, 40.8, 1.9, 313, -6], "fov": 95 },
    { "name": "courtyard", "camera": [18.5, 28.8, 1.6, 250, 6], "fov": 90 },
    { "name": "opening", "camera": [14.8, 22.9, 2.0, 184, -57], "fov": 95 },
    { "name": "hall", "camera": [22.8, 9.8, 2.4, 202, 8], "fov": 90 },
    { "name": "chapel", "camera": [22.8, 17.0, 2.0, 355, 6], "fov": 90 },
    { "name": "crypt", "camera": [7.6, 24.4, -3, 330, 4], "fov": 90 },
    { "name": "rampart", "camera": [1.6, 14, 7.6, 62, -8], "fov": 90, "movers": { "lift": 1 } },
    { "name": "gate", "camera": [16.4, 36.6, 1.6, 276, 8], "fov": 90, "movers": { "portcullis": 0.5 } },
    { "name": "crypt-door", "camera": [6, 18, -3.2, 261, -2], "fov": 90, "movers": { "crypt-door": 0.5 } },
    { "name": "lift", "camera": [8.2, 16.2, 1.6, 183, 17], "fov": 90, "movers": { "lift": 0.5 } }
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
