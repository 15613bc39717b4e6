"""Writes small WADs of Doom for fuzz-wad to begin with.

usage: wad_seeds.py FOLDER
"""

import struct
import sys
from pathlib import Path

SOLID = 0xFFFF


def name(text):
    return text.encode().ljust(8, b"\0")


def wad(lumps):
    body, directory = b"", b""
    for lump, data in lumps:
        directory += struct.pack("<ii", 12 + len(body), len(data)) + name(lump)
        body += data
    return b"PWAD" + struct.pack("<ii", len(lumps), 12 + len(body)) + body + directory


def texture(called, width, height, patches):
    placed = b"".join(struct.pack("<5h", x, y, patch, 1, 0) for x, y, patch in patches)
    return name(called) + struct.pack("<ihhih", 0, width, height, 0, len(patches)) + placed


def textures(definitions):
    begin = 4 + 4 * len(definitions)
    offsets = [begin + sum(map(len, definitions[:i])) for i in range(len(definitions))]
    return struct.pack(f"<{1 + len(offsets)}i", len(offsets), *offsets) + b"".join(definitions)


def patch(width, height, left=0, top=0):
    """Its columns are two posts, with a hole between them."""
    half = height // 2 - 1
    post = bytes([half, 0]) + bytes(range(half)) + b"\0"
    column = b"\0" + post + bytes([half + 2]) + post + b"\xff"
    offsets = [8 + 4 * width + len(column) * i for i in range(width)]
    return struct.pack("<4h", width, height, left, top) + struct.pack(f"<{width}i", *offsets) + column * width


def pictures(*definitions):
    return [("PLAYPAL", bytes(range(256)) * 3), ("PNAMES", struct.pack("<i", 1) + name("PATCH")),
            ("TEXTURE1", textures(definitions)), ("PATCH", patch(8, 8))]


PLAIN = pictures(texture("WALL", 8, 8, [(0, 0, 0)]), texture("SKY1", 16, 8, [(0, 0, 0), (8, 0, 0)]))


# The sides of an imp, of which some are the mirror images of others; a lamp; and what hangs.
SPRITES = [("S_START", b"")] + [
    (name, patch(8, 8, left, top)) for name, left, top in (
        ("TROOA1", 4, 8), ("TROOA2A8", 3, 7), ("TROOA3A7", 4, 10), ("TROOA4A6", 0, 0), ("TROOA5", 9, 9),
        ("TROOB0", 4, 8), ("COLUA0", 4, 8), ("GOR2A0", -5, 12))] + [("S_END", b"")]


class Map:
    """Sectors are (floor, ceiling, ceiling's flat, tag)."""

    def __init__(self, *sectors):
        self.sectors = b"".join(struct.pack("<hh", floor, ceiling) + name("LAVA1") + name(flat) +
                                struct.pack("<hHH", 160, 0, tag)
                                for floor, ceiling, flat, tag in sectors)
        self.vertices, self.lines, self.sides, self.things = [], b"", b"", b""

    def side(self, sector, middle):
        if sector is None:
            return SOLID
        self.sides += struct.pack("<hh", 0, 0) + name("WALL") + name("-") + name(middle)
        self.sides += struct.pack("<H", sector)
        return len(self.sides) // 30 - 1

    def line(self, begin, end, right, left=None, flags=1, special=0, tag=0, middle="WALL"):
        for place in (begin, end):
            if place not in self.vertices:
                self.vertices.append(place)
        ends = (self.vertices.index(begin), self.vertices.index(end))
        sides = (self.side(right, middle), self.side(left, middle))
        self.lines += struct.pack("<7H", *ends, flags, special, tag, *sides)

    def loop(self, corners, right, left=None, **how):
        for begin, end in zip(corners, corners[1:] + corners[:1]):
            self.line(begin, end, right, left, **how)

    def thing(self, x, y, kind):
        self.things += struct.pack("<hhhHH", x, y, 90, kind, 7)

    def lumps(self, called="MAP01"):
        vertices = b"".join(struct.pack("<hh", *place) for place in self.vertices)
        return [(called, b""), ("THINGS", self.things), ("LINEDEFS", self.lines),
                ("SIDEDEFS", self.sides), ("VERTEXES", vertices), ("SECTORS", self.sectors)]


def box(x, y, width, height):
    return [(x, y), (x, y + height), (x + width, y + height), (x + width, y)]


def door():
    """Two rooms, the second one under the sky, with a door between them."""
    made = Map((0, 128, "CEIL", 0), (0, 0, "CEIL", 7), (24, 96, "F_SKY1", 0))
    for at in (0, 64, 128):
        made.line((at + 64, 0), (at, 0), at // 64)
        made.line((at, 64), (at + 64, 64), at // 64)
    made.line((0, 0), (0, 64), 0)
    made.line((192, 64), (192, 0), 2)
    made.line((64, 64), (64, 0), 0, 1, special=1, middle="-")
    made.line((128, 0), (128, 64), 2, 1, flags=0x1C, special=2, tag=7, middle="-")
    made.thing(32, 32, 1)
    made.thing(160, 32, 2028)
    return made


def pool():
    """A room with a pillar, and a pool in which a grate hangs."""
    made = Map((0, 128, "CEIL", 0), (-16, 128, "CEIL", 0))
    made.loop(box(0, 0, 256, 256), 0)
    made.loop(box(32, 32, 64, 64)[::-1], 0)
    made.loop(box(128, 128, 64, 96), 1, 0, flags=4)
    made.thing(16, 16, 1)
    return made


def tangle():
    """Lines that cross, overlap and miss one another by hardly anything, and a player in a low room."""
    made = Map((0, 40, "CEIL", 0), (0, 128, "CEIL", 0))
    made.loop(box(0, 0, 1000, 1000), 0)
    made.loop(box(500, 500, 1000, 1001), 1)
    made.line((1, 0), (1000, 999), 0, 1)
    made.line((0, 1), (999, 1000), 0, 0)
    made.line((-9000, 499), (20000, 501), 1, 0)
    made.thing(100, 100, 1)
    made.thing(700, 700, 2)
    return made


def things():
    """One of each way to stand, in a room, in one without air, and outside."""
    made = Map((0, 128, "CEIL", 0), (8, 8, "CEIL", 0))
    made.loop(box(0, 0, 256, 256), 0)
    made.loop(box(128, 128, 64, 96), 1, 0, flags=4)
    for x, y in ((64, 64), (160, 160), (128, 144), (900, 64)):
        for kind in (3001, 2028, 50, 59, 12345):
            made.thing(x, y, kind)
    return made


def main():
    folder = Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    for called, made in (("door", door()), ("pool", pool()), ("tangle", tangle())):
        (folder / f"{called}.wad").write_bytes(wad(PLAIN + made.lumps()))
    flats = [("F_START", b""), ("LAVA1", bytes(range(64)) * 64), ("F_END", b"")]
    overlaid = texture("WALL", 24, 16, [(0, 0, 0), (4, -2, 0), (12, 3, 0), (-3, 5, 0)])
    (folder / "pictures.wad").write_bytes(wad(pictures(overlaid) + flats + pool().lumps("E1M1")))
    (folder / "things.wad").write_bytes(wad(PLAIN + SPRITES + things().lumps()))
    (folder / "two_maps.wad").write_bytes(wad(PLAIN + door().lumps() + tangle().lumps("MAP30")))


if __name__ == "__main__":
    main()
