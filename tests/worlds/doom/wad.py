"""Reads WAD files, and the maps in them, as Doom does: https://doomwiki.org/wiki/WAD."""

import struct
from collections import namedtuple
from pathlib import Path

Line = namedtuple("Line", "start end flags special tag right left")
Side = namedtuple("Side", "x_offset y_offset upper lower middle sector")
Sector = namedtuple("Sector", "floor ceiling floor_flat ceiling_flat light special tag")
Thing = namedtuple("Thing", "x y angle type flags")

NO_SIDE = 0xFFFF
NO_TEXTURE = "-"
SKY = "F_SKY1"

# The lumps that follow the name of a map.
MAP_LUMPS = ["THINGS", "LINEDEFS", "SIDEDEFS", "VERTEXES", "SEGS", "SSECTORS", "NODES", "SECTORS",
             "REJECT", "BLOCKMAP"]


def name_of(raw):
    return raw.split(b"\0")[0].decode("latin-1").upper()


class Wad:
    def __init__(self, path):
        data = Path(path).read_bytes()
        count, directory = struct.unpack_from("<ii", data, 4)
        self.lumps = []
        for i in range(count):
            begin, size, name = struct.unpack_from("<ii8s", data, directory + 16 * i)
            self.lumps.append((name_of(name), data[begin:begin + size]))
        self.indices = {name: i for i, (name, _) in enumerate(self.lumps)}

    def lump(self, name):
        """The last one of that name; None without any."""
        return self.lumps[self.indices[name]][1] if name in self.indices else None

    def map_lumps(self, name):
        first = self.indices[name] + 1
        lumps = self.lumps[first:first + len(MAP_LUMPS)]
        assert [lump for lump, _ in lumps] == MAP_LUMPS, f"{name} is not a map in Doom's format"
        return dict(lumps)


def write_patch_wad(path, lumps):
    """A WAD whose lumps, pairs of a name and bytes, take the places of others."""
    bodies = b"".join(body for _, body in lumps)
    header = struct.pack("<4sii", b"PWAD", len(lumps), 12 + len(bodies))
    directory, begin = b"", 12
    for name, body in lumps:
        directory += struct.pack("<ii8s", begin, len(body), name.encode("latin-1"))
        begin += len(body)
    Path(path).write_bytes(header + bodies + directory)


def player_start(x, y, angle):
    """The lump THINGS of a map with nothing in it but where the player begins."""
    in_all_skills, type_of_player = 7, 1
    return struct.pack("<hhHHH", x, y, angle, type_of_player, in_all_skills)


class Map:
    def __init__(self, wad, name):
        self.lumps = wad.map_lumps(name)
        self.name = name
        self.vertices = self.records("VERTEXES", "<hh", lambda *xy: xy)
        self.lines = self.records("LINEDEFS", "<HHHHHHH", Line)
        self.things = self.records("THINGS", "<hhHHH", Thing)
        self.sides = self.records("SIDEDEFS", "<hh8s8s8sH",
                                  lambda x, y, u, l, m, s: Side(x, y, name_of(u), name_of(l), name_of(m), s))
        self.sectors = self.records("SECTORS", "<hh8s8sHHH",
                                    lambda f, c, ff, cf, *rest: Sector(f, c, name_of(ff), name_of(cf), *rest))

    def records(self, lump, layout, make):
        return [make(*fields) for fields in struct.iter_unpack(layout, self.lumps[lump])]
