"""An empty hall with a player, and at most one thing before it."""

import struct
from collections import namedtuple

from .view import Place
from .wad import Map

WALL, FLOOR, CEILING = "STARTAN2", "FLOOR0_1", "CEIL3_5"
HALF_SIDE, HEIGHT, LIGHT = 1024, 128, 255
EYE = 41
NORTH = 90
PLAYER, IN_ALL_SKILLS = 1, 7
CORNERS = [(-HALF_SIDE, -HALF_SIDE), (-HALF_SIDE, HALF_SIDE), (HALF_SIDE, HALF_SIDE),
           (HALF_SIDE, -HALF_SIDE)]

# A type, the angle to which it is turned, and how many units it is before the player.
Stand = namedtuple("Stand", "type angle depth")


class Hall(Map):
    def __init__(self, name, stand=None):
        self.name, self.place = name, Place(0, -HALF_SIDE // 2, EYE, NORTH)
        things = [(0, self.place.y, NORTH, PLAYER, IN_ALL_SKILLS)]
        if stand:
            things.append((0, self.place.y + stand.depth, stand.angle, stand.type, IN_ALL_SKILLS))
        self.lumps = lumps_of_hall(b"".join(struct.pack("<hhHHH", *thing) for thing in things))


def lumps_of_hall(things):
    """Its four lines are the segs of a single subsector, so there are no nodes."""
    ends = [(i, (i + 1) % 4) for i in range(4)]
    directions = [0x4000, 0, 0xC000, 0x8000]  # 0x10000 is a turn
    return {
        "THINGS": things,
        "LINEDEFS": b"".join(struct.pack("<7H", *ends[i], 1, 0, 0, i, 0xFFFF) for i in range(4)),
        "SIDEDEFS": struct.pack("<hh8s8s8sH", 0, 0, b"-", b"-", WALL.encode(), 0) * 4,
        "VERTEXES": b"".join(struct.pack("<hh", *corner) for corner in CORNERS),
        "SEGS": b"".join(struct.pack("<6H", *ends[i], directions[i], i, 0, 0) for i in range(4)),
        "SSECTORS": struct.pack("<HH", 4, 0),
        "NODES": b"",
        "SECTORS": struct.pack("<hh8s8sHHH", 0, HEIGHT, FLOOR.encode(), CEILING.encode(), LIGHT, 0, 0),
        "REJECT": b"\0",
        "BLOCKMAP": b"",  # dsda-doom makes one
    }
