"""Draws places of a map with dsda-doom and with Hearth."""

import math
import os
import subprocess

import numpy as np
from PIL import Image

from .view import DIRECTIONS, Screen
from .wad import MAP_LUMPS, player_start, write_patch_wad

# The same view, 90 degrees wide. Doom's pixels are not squares: there are 1.2 times as many rows. It
# samples them at their upper left corners, in the next of its directions: on the mean by half the
# way from one to the other further left.
HEARTH_SCREEN = Screen(1280, 800, 640, 640, 0.5, 0)
DOOM_SCREEN = Screen(1280, 960, 640, 768, 0, math.pi / DIRECTIONS)

UNIT = 1 / 32  # metres

# dsda-doom hands over its frames as they are to a program: here to one that keeps them.
DOOM_SETTINGS = """
cap_videocommand "cat > %f"
cap_soundcommand "cat > /dev/null"
cap_muxcommand "true"
cap_wipescreen 0
cap_fps 35
render_wipescreen 0
uncapped_framerate 0
screenblocks 11
hud_displayed 0
dsda_hide_weapon 1
show_messages 0
hudadd_demoprogressbar 0
palette_ondamage 0
usegamma 0
"""

# Of tables of shades, each leaves colours as they are: full brightness.
FULL_BRIGHTNESS = bytes(range(256)) * 34

SECONDS = 60  # each program may take


def brightened(image):
    """As dsda-doom shows colours, by the lowest step of its gamma: the dark half one level brighter."""
    return np.where(image < 128, image + 1, image)


class Doom:
    def __init__(self, program, wad_path, folder):
        self.program, self.wad_path, self.folder = program, wad_path, folder
        (folder / "settings").write_text(DOOM_SETTINGS)

    def draw(self, doom_map, place):
        """A place of a map without things, where the player stands still for four tics. That is
        before the first of what is animated moves."""
        lumps = doom_map.lumps | {"THINGS": player_start(place.x, place.y, place.angle)}
        return self.last_frame(doom_map.name, lumps, demo_of_standing(doom_map.name, 4))

    def draw_with_things(self, doom_map):
        """What the player of a map sees in the second tic, the first that is drawn. Most things
        show their first frame yet, and monsters have not noticed the player."""
        demo = demo_of_standing(doom_map.name, 2, has_monsters=True)
        return self.last_frame(doom_map.name, doom_map.lumps, demo)

    def last_frame(self, map_name, lumps, demo):
        write_map(self.folder / "place.wad", map_name, lumps, [("COLORMAP", FULL_BRIGHTNESS)])
        (self.folder / "still.lmp").write_bytes(demo)
        frames = self.folder / "frames"
        frames.unlink(missing_ok=True)
        self.run()
        size = DOOM_SCREEN.width * DOOM_SCREEN.height * 3
        frame = np.frombuffer(frames.read_bytes()[-size:], np.uint8)
        return frame.reshape(DOOM_SCREEN.height, DOOM_SCREEN.width, 3)

    def run(self):
        run([self.program, "-iwad", self.wad_path, "-file", "place.wad", "-timedemo", "still.lmp",
             "-viddump", "frames", "-config", "settings", "-nosound", "-nomusic", "-window",
             "-geom", f"{DOOM_SCREEN.width}x{DOOM_SCREEN.height}w"],
            cwd=self.folder,
            env=os.environ | {"HOME": str(self.folder), "SDL_VIDEODRIVER": "dummy",
                              "SDL_AUDIODRIVER": "dummy"})


def write_map(path, name, lumps, others=()):
    """A WAD with a map and other lumps."""
    write_patch_wad(path, [*others, (name, b""), *((lump, lumps[lump]) for lump in MAP_LUMPS)])


def demo_of_standing(map_name, tics, has_monsters=False):
    """https://doomwiki.org/wiki/Demo: version 1.9, skill 4, one player, no key."""
    if map_name.startswith("MAP"):
        episode, number = 1, int(map_name[3:])
    else:
        episode, number = int(map_name[1]), int(map_name[3])
    return (bytes([109, 3, episode, number, 0, 0, 0, not has_monsters, 0, 1, 0, 0, 0]) +
            bytes(4 * tics) + b"\x80")


class Hearth:
    def __init__(self, program, folder):
        self.program, self.folder = program, folder

    def import_map(self, wad_path, map_name, *options):
        """Returns the level's file."""
        run([self.program, "import", wad_path, map_name, "-o", self.folder, "--doors", "closed",
             *options])
        return self.folder / f"{map_name.lower()}.json"

    def draw(self, level, place, seconds=0):
        picture = self.folder / "place.png"
        camera = f"{place.x * UNIT},{-place.y * UNIT},{place.eye * UNIT},{-place.angle % 360}"
        run([self.program, "shot", level, "-o", picture, "--camera", camera, "--light", "none",
             "--fov", "90", "--time", f"{seconds}",
             "--size", f"{HEARTH_SCREEN.width}x{HEARTH_SCREEN.height}", "--quiet"])
        return np.array(Image.open(picture).convert("RGB"))


def run(command, **options):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True,
                          timeout=SECONDS, **options)
    if done.returncode != 0:
        raise RuntimeError(f"{' '.join(map(str, command))}: status {done.returncode}\n"
                           f"{done.stdout}{done.stderr}")
