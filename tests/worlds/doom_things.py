"""Holds how the things of imported maps stand and look against Doom.

usage: doom_things.py HEARTH [TYPE...] [--all] [--plant] [--keep DIR]

dsda-doom and Hearth draw the same hall, in full brightness: once empty, and then with one thing
before the player. Both pictures are sampled at the middles of the texels of the thing's image. Those
where an engine's two pictures differ show the thing.

Of all shifts by whole texels, that counts with which the two engines have the same colour in most
texels of the thing. It must be none to the side. Up it must be as many texels as the thing's images
reach below the floor, and down as many as they reach above the ceiling if the thing hangs: Doom draws
over floor and ceiling what lies behind them, and Hearth moves the images. At least 90 % of the texels
must have the same colour then. Fewer than all have it because dsda-doom shows others in place of the
palette's last colour, and because thin parts of images lie between two pixels. Of an animated thing
any frame may show in Doom: that of Hearth's counts that fits best. Things with sides are seen from
all eight.

Without types, some of each kind are compared. Prints a table. Status 1 if a thing stands or looks
otherwise; 2 if something cannot be drawn. With --plant, a thing of the level is moved, raised and
turned, and the status is 1 if that is not found.

Needs Debian's dsda-doom, freedoom, python3-numpy and python3-pil; no display.
"""

import argparse
import json
import struct
import sys
import tempfile
from collections import namedtuple
from pathlib import Path

import numpy as np

from doom.hall import EYE, HEIGHT, Hall, Stand
from doom.pictures import DOOM_SCREEN, HEARTH_SCREEN, UNIT, Doom, Hearth, brightened, write_map
from doom.wad import Wad

DSDA_DOOM = "/usr/games/dsda-doom"
FREEDOOM = "/usr/share/games/doom/freedoom2.wad"
MAP = "MAP01"
MIN_EQUAL = 0.9
SHIFTS = range(-4, 5)  # texels beside those that are expected
NEAR, FAR, LARGE = 200, 320, 100  # units: where things stand, and from which size on far away

# Still, animated, hanging, low and wide ones; those with sides.
FEW = [2035, 46, 2028, 34, 54, 49, 61, 2014, 5, 2001, 80, 15, 3001, 68]
# But the spectre, which is half invisible in Doom.
ALL = [*range(5, 11), 12, 13, *range(15, 58), *range(59, 87), 88, *range(2001, 2009), *range(2010, 2016),
       2018, 2019, *range(2022, 2027), 2028, 2035, *range(2045, 2050), *range(3001, 3007)]

# Of one thing: the share of its texels that are equal, and how far Hearth's are shifted.
Match = namedtuple("Match", "equal right up")


class Looker:
    def __init__(self, hearth, folder):
        self.folder = folder
        self.wad = Wad(FREEDOOM)
        self.doom, self.hearth = Doom(DSDA_DOOM, FREEDOOM, folder), Hearth(hearth, folder)
        hall = Hall(MAP)
        self.place = hall.place
        self.empty = (self.doom.draw_with_things(hall),
                      self.hearth.draw(self.level_of(hall), self.place))

    def level_of(self, hall):
        maps = self.folder / "hall.wad"
        write_map(maps, MAP, hall.lumps)
        for old in self.folder.glob("map01*.json"):
            old.unlink()
        return self.hearth.import_map(maps, MAP, "--iwad", FREEDOOM, "--monsters", "--skill", "4")

    def thing_of(self, stand):
        """What the level has of it; None if nothing."""
        level = json.loads(self.level_of(Hall(MAP, stand)).read_text())
        return level["things"][0] if "things" in level else None

    def match(self, stand, raised, change=lambda thing: None):
        """The best of all frames. `raised` is the shift that is expected."""
        file = self.level_of(Hall(MAP, stand))
        level = json.loads(file.read_text())
        thing = level["things"][0]
        change(thing)
        file.write_text(json.dumps(level))
        doom = self.texels(self.doom.draw_with_things(Hall(MAP, stand)), 0, stand.depth)
        return max(best_match(doom, self.texels(self.hearth.draw(file, self.place, seconds), 1,
                                                stand.depth), raised)
                   for seconds in times_of(thing))

    def texels(self, picture, engine, depth):
        """What an engine's picture has in the plane of the thing, and where that is the thing."""
        screen = (DOOM_SCREEN, HEARTH_SCREEN)[engine]
        size = int(depth * 0.6)
        x = np.arange(-size, size) + 0.5
        z = np.arange(EYE + size, EYE - size, -1) - 0.5
        columns = (screen.width / 2 + x * screen.focal_x / depth).astype(int)
        rows = (screen.height / 2 - (z - EYE) * screen.focal_y / depth).astype(int)
        rows, columns = np.meshgrid(rows.clip(0, screen.height - 1), columns, indexing="ij")
        colours, before = picture[rows, columns], self.empty[engine][rows, columns]
        is_thing = (colours != before).any(axis=-1)
        return (colours if engine == 0 else brightened(colours)), is_thing

    def raised(self, thing):
        """By how many texels: as many as the image that reaches furthest down is below the floor, or
        the one that reaches furthest up is above the ceiling."""
        bottoms, tops = zip(*self.extents(thing))
        if "z" in thing:
            return min(0, HEIGHT - round(thing["z"] / UNIT) - max(tops))
        return max(0, -min(bottoms))

    def extents(self, thing):
        """Of each of its images: how far its lower and upper edges are above the thing."""
        frames = {image.removeprefix("sprite-")[:5].upper() for image in images_of(thing)}
        begin, end = (self.wad.indices[marker] for marker in ("S_START", "S_END"))
        for name, patch in self.wad.lumps[begin + 1:end]:
            if len(name) in (6, 8) and {name[:5], name[:4] + name[6:7]} & frames:
                _, height, _, top = struct.unpack_from("<4h", patch)
                yield top - height, top


def images_of(thing):
    for views in thing.get("frames", [thing.get("sprite")]):
        yield from [views] if isinstance(views, str) else views


def times_of(thing):
    """One for each frame that differs from the one before."""
    frames = thing.get("frames", [None])
    return [(i + 0.5) / thing.get("fps", 1) for i, frame in enumerate(frames)
            if i == 0 or frame != frames[i - 1]]


def best_match(doom, hearth, raised):
    return max((match_shifted(doom, hearth, right, raised + up) for right in SHIFTS for up in SHIFTS),
               key=lambda match: (match.equal, -abs(match.right), -abs(match.up - raised)))


def match_shifted(doom, hearth, right, up):
    colours, is_thing = (np.roll(array, (up, -right), (0, 1)) for array in hearth)
    of_either = is_thing | doom[1]
    is_equal = (colours == doom[0]).all(axis=-1) & is_thing & doom[1]
    return Match(is_equal.sum() / max(1, of_either.sum()), right, up)


def stand_of(looker, number, angle):
    """Large things stand further away, so that all of them is seen."""
    stand = Stand(number, angle, NEAR)
    thing = looker.thing_of(stand)
    if thing and max(thing["size"]) >= LARGE * UNIT:
        return stand._replace(depth=FAR), thing
    return stand, thing


def angles_of(thing):
    return range(0, 360, 45) if "angle" in thing else [0]


def is_right(match, raised):
    return match.equal >= MIN_EQUAL and (match.right, match.up) == (0, raised)


def print_row(*cells):
    print("| " + " | ".join(map(str, cells)) + " |", flush=True)


def compare(looker, numbers):
    """Whether all types are as in Doom."""
    print_row("type", "name", "views", "raised", "% equal, at least", "wrong")
    print_row(*["---"] * 6)
    wrong = 0
    for number in numbers:
        stand, thing = stand_of(looker, number, 0)
        if not thing:
            print_row(number, "makes no sprite", 0, "", "", "")
            continue
        raised = looker.raised(thing)
        matches = [looker.match(stand._replace(angle=angle), raised) for angle in angles_of(thing)]
        bad = [match for match in matches if not is_right(match, raised)]
        wrong += len(bad)
        print_row(number, thing["name"], len(matches), raised,
                  f"{100 * min(match.equal for match in matches):.1f}", len(bad))
        for match in bad:
            print(f"type {number}: {match}, expected up {raised}", file=sys.stderr)
    return wrong == 0


def is_planted_found(looker):
    def move(thing):
        thing["x"] += 2 * UNIT

    def rise(thing):
        thing["offset"] = [*thing.get("offset", [0, 0])]
        thing["offset"][1] += 2 * UNIT

    def turn(thing):
        thing["angle"] += 45

    stand, thing = stand_of(looker, 3001, 90)
    raised = looker.raised(thing)
    matches = [looker.match(stand, raised, change) for change in (move, rise, turn)]
    print(*matches, sep="\n")
    return (matches[0][1:] == (2, raised) and matches[1][1:] == (0, raised + 2) and
            matches[2].equal < MIN_EQUAL and is_right(looker.match(stand, raised), raised))


def parse_arguments():
    parser = argparse.ArgumentParser(description="Holds things of imported maps against Doom.")
    parser.add_argument("hearth", type=lambda path: Path(path).resolve())
    parser.add_argument("types", nargs="*", type=int, default=FEW, metavar="TYPE")
    parser.add_argument("--all", action="store_true", help="all types, in some minutes")
    parser.add_argument("--plant", action="store_true", help="change a thing, and find that")
    parser.add_argument("--keep", type=Path, help="a folder for the last level and pictures")
    return parser.parse_args()


def main():
    arguments = parse_arguments()
    with tempfile.TemporaryDirectory() as temporary:
        try:
            looker = Looker(arguments.hearth, arguments.keep or Path(temporary))
            if arguments.plant:
                return 0 if is_planted_found(looker) else 1
            return 0 if compare(looker, ALL if arguments.all else arguments.types) else 1
        except (RuntimeError, OSError) as error:
            print(error, file=sys.stderr)
            return 2


if __name__ == "__main__":
    sys.exit(main())
