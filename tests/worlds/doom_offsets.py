"""Holds how the walls of imported maps hang against Doom.

usage: doom_offsets.py HEARTH [--plant] [--places COUNT] [--seed SEED] [--keep DIR] [WAD:MAP...]

dsda-doom and Hearth draw the same places of each map: where the player begins, and where things
stand, at fixed random angles. The field of view is 90 degrees in both, which is measured; all is in
full brightness, Doom's by tables of shades that leave colours as they are. Doors are closed.

Which wall a pixel shows, and where on it, follows from the map alone (doom/view.py). So the colours
of a wall's pixels tell how far its image is shifted: of all shifts, the one with which pixels and
texels differ least (doom/offsets.py). That is found in either picture for itself, and the two may
differ by a texel, along the wall and down. Where an image repeats within itself, several shifts tie,
and a pair of them has to agree; such walls count as tied. A direction in which shifts side by side
tie says nothing and is not judged; such walls count as plain along or down.

Doom knows 8192 directions, and shows walls that are seen at a flat angle or from far away shifted by
texels, other ones from place to place. So pixels count only where on the wall two directions are no
more than a texel apart; walls with fewer than 200 of them, or fewer than 10 columns or rows, are
skipped as far. Skipped are, too: small ones; those covered by the middle texture of a line before
them; moving images, and those with holes; walls without an image; those that are plain in both
directions; and those whose image neither picture shows.

Prints a table. Status 1 and a line for each wall that hangs otherwise; 2 if something cannot be
drawn. With --plant, moves the image of one wall of the first map by two texels, first along and then
down, and the status is 1 if that, and nothing else, is not found.

Needs Debian's dsda-doom, freedoom, python3-numpy and python3-pil; no display.
"""

import argparse
import json
import sys
import tempfile
from collections import Counter
from pathlib import Path

from doom.judge import Scene, is_wrong
from doom.levels import find_texture
from doom.pictures import Doom, Hearth
from doom.places import places_of
from doom.textures import Textures
from doom.wad import Map, Wad

DSDA_DOOM = "/usr/games/dsda-doom"
FREEDOOM = "/usr/share/games/doom/freedoom"
MAPS = [FREEDOOM + "1.wad:E1M1", FREEDOOM + "1.wad:E1M7", FREEDOOM + "1.wad:E2M4",
        FREEDOOM + "2.wad:MAP01", FREEDOOM + "2.wad:MAP02"]
FIELD_OF_VIEW = 90
PLANTED = 2  # texels
REASONS = ["far", "small", "covered", "plain", "moving", "holes", "no texture", "in neither"]


class World:
    """A map in both engines."""

    def __init__(self, spec, hearth, folder):
        wad_path, name = spec.rsplit(":", 1)
        folder = folder / name
        folder.mkdir(parents=True)
        wad = Wad(wad_path)
        self.map, self.textures, self.folder = Map(wad, name), Textures(wad), folder
        self.doom = Doom(DSDA_DOOM, wad_path, folder)
        self.hearth = Hearth(hearth, folder)
        self.level = self.hearth.import_map(wad_path, name)
        remove_things(self.level)

    def read_level(self):
        return json.loads(self.level.read_text())

    def scene(self, place, level):
        return Scene(self.map, self.textures, place, self.doom.draw(self.map, place),
                     self.hearth.draw(level, place))


def remove_things(file):
    """Doom's picture has none, and they hide walls."""
    level = json.loads(file.read_text())
    level.pop("things", None)
    file.write_text(json.dumps(level))


class Tally:
    """Of the walls of a map."""

    def __init__(self, world, count, seed):
        self.name = world.map.name
        self.judged, self.skipped, self.wrong = [], Counter(), []
        places = places_of(world.map, count, seed)
        self.places = len(places)
        self.fields_of_view = ["-", "-"]
        for place in places:
            scene = world.scene(place, world.level)
            is_first = not self.judged
            self.add(place, scene.judge())
            if is_first and self.judged:
                self.fields_of_view = scene.fields_of_view()

    def add(self, place, judgements):
        self.skipped.update(j.skipped for j in judgements if j.skipped)
        self.judged += [j for j in judgements if not j.skipped]
        self.wrong += [(place, j) for j in judgements if is_wrong(j)]

    def mistakes(self):
        found = [described(place, judgement) for place, judgement in self.wrong]
        if not self.judged:
            found.append("no wall was judged")
        elif self.fields_of_view != [FIELD_OF_VIEW] * 2:
            found.append(f"the fields of view are {self.fields_of_view} degrees")
        return found

    def row(self):
        judged = self.judged
        shown = [f"{100 * exact_share([getattr(j, which) for j in judged]):.1f}"
                 for which in ("doom", "hearth")]
        return [self.name, self.places, *self.fields_of_view, len({j.wall for j in judged}),
                len(judged), sum(j.tied for j in judged), sum(not j.along for j in judged),
                sum(not j.down for j in judged), *(self.skipped[reason] for reason in REASONS), *shown,
                max((max(j.difference) for j in judged), default=0), len(self.wrong)]


HEAD = ["map", "places", "Doom's view", "Hearth's", "walls", "views of them", "tied", "plain along",
        "plain down", *REASONS, "% exact, Doom", "% exact, Hearth", "largest difference", "wrong"]


def exact_share(matches):
    return sum(m.equal * m.count for m in matches) / max(1, sum(m.count for m in matches))


def print_row(cells):
    print("| " + " | ".join(map(str, cells)) + " |", flush=True)


def described(place, judgement):
    wall, doom, hearth = judgement.wall, judgement.doom, judgement.hearth
    return (f"line {wall.line}, side {wall.side}, {wall.part} {wall.texture}, seen from "
            f"({place.x}, {place.y}) at {place.angle} degrees: Doom hangs it at ({doom.u}, {doom.v}), "
            f"Hearth at ({hearth.u}, {hearth.v}); {100 * doom.equal:.0f} % and "
            f"{100 * hearth.equal:.0f} % of the pixels are of that image")


def compare_maps(arguments, folder):
    """Whether all walls hang alike, and any was judged on each map."""
    print_row(HEAD)
    print_row(["---"] * len(HEAD))
    is_right = True
    for spec in arguments.maps:
        tally = Tally(World(spec, arguments.hearth, folder), arguments.places, arguments.seed)
        print_row(tally.row())
        mistakes = tally.mistakes()
        for mistake in mistakes:
            print(f"{tally.name}: {mistake}", file=sys.stderr)
        is_right &= not mistakes
    return is_right


def plant_in_map(arguments, folder):
    """Whether a wall whose image is moved is found, and it alone."""
    world = World(arguments.maps[0], arguments.hearth, folder)
    place = places_of(world.map, 1, arguments.seed)[0]
    wall = clearest_wall(world, place)
    return all(is_found(world, place, wall, shift) for shift in ((PLANTED, 0), (0, PLANTED)))


def clearest_wall(world, place):
    """Of those that the level has in one piece and that are judged in both directions, the one of
    which most is seen."""
    judged = [j for j in world.scene(place, world.level).judge()
              if j.along and j.down and not j.tied and find_texture(world.read_level(), world.map, j.wall)]
    return max(judged, key=lambda j: j.hearth.count).wall


def is_found(world, place, wall, shift):
    level = world.read_level()
    texture = find_texture(level, world.map, wall)
    texture["offset"] = [a + b for a, b in zip(texture.get("offset", [0, 0]), shift)]
    planted = world.folder / "planted.json"
    planted.write_text(json.dumps(level))
    wrong = [j for j in world.scene(place, planted).judge() if is_wrong(j)]
    for judgement in wrong:
        print(f"planted {shift}:", described(place, judgement))
    return [(j.wall, j.difference) for j in wrong] == [(wall, shift)]


def parse_arguments():
    parser = argparse.ArgumentParser(description="Holds how walls of imported maps hang against Doom.")
    parser.add_argument("hearth", type=lambda path: Path(path).resolve())
    parser.add_argument("maps", nargs="*", default=MAPS, metavar="WAD:MAP")
    parser.add_argument("--plant", action="store_true", help="move a wall's image, and find that")
    parser.add_argument("--places", type=int, default=6, help="on each map")
    parser.add_argument("--seed", type=int, default=1, help="of the places")
    parser.add_argument("--keep", type=Path, help="a new folder for levels and pictures")
    return parser.parse_args()


def main():
    arguments = parse_arguments()
    with tempfile.TemporaryDirectory() as temporary:
        run = plant_in_map if arguments.plant else compare_maps
        try:
            return 0 if run(arguments, arguments.keep or Path(temporary)) else 1
        except (RuntimeError, OSError) as error:
            print(error, file=sys.stderr)
            return 2


if __name__ == "__main__":
    sys.exit(main())
