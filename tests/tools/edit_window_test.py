"""Edits a level in a real window: drags a light, undoes that, saves, and writes a bookmark as a shot;
compares files and pictures.

usage: edit_window_test.py HEARTH LEVEL
"""

import json
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from walk_window_test import Display, Walk, expect_change, hold, settled, turn_to, wait_for

# The player of `rooms` looks at the first light from 2 m: it is a quarter of the picture's half to
# the left of the middle, at the height of the eye. The odd spelling must be kept.
LIGHTS = b"""\xef\xbb\xbf[
 {"//": "first", "x" : 3.0, "y":1.50, "z": 16e-1,
  "intensity": 220, "falloff": 4e-1},
 {"x": 6, "y": 2, "z": 5, "sector": "garden", "intensity": 180 } ]"""


def drag(display, walk, start, end):
    display.do("mousemove", "--window", walk.window, *map(str, start))
    settled(display)
    display.do("mousedown", "1")
    for share in (0.5, 1):
        at = [round(a + share * (b - a)) for a, b in zip(start, end)]
        expect_change(display, "the light follows the mouse",
                      lambda at=at: display.do("mousemove", "--window", walk.window, *map(str, at)))
    display.do("mouseup", "1")
    settled(display)


def main():
    hearth, level = (Path(argument).resolve() for argument in sys.argv[1:])
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        copy, lights = folder / "rooms.json", folder / "rooms.lights.json"
        shutil.copy(level, copy)
        lights.write_bytes(LIGHTS)
        display = Display(name)
        try:
            edit(Walk(display, hearth, copy, folder), edits, display, lights)
            state = str(folder / "state")
            edit(Walk(display, hearth, copy, folder, XDG_STATE_HOME=state), writes_a_shot, display, copy)
        finally:
            display.close()
    print("edited in a window")


def edit(walk, how, display, file):
    try:
        how(display, walk, file)
    finally:
        walk.process.kill()
        walk.process.wait()


def edits(display, walk, lights):
    walk.expect_screenshot()
    first = settled(display)
    width, height = walk.geometry()[2:]
    mark = (width // 2 - width // 8, height // 2)
    display.do("key", "F1")
    drag(display, walk, mark, (mark[0] - width // 8, mark[1] + width // 16))
    if lights.read_bytes() != LIGHTS:
        sys.exit("FAILED: nothing is saved before it is asked for")
    display.do("key", "F1")
    wait_for("the light shows where it was dragged to", lambda: settled(display) != first)

    display.do("key", "F1")
    display.do("key", "ctrl+s")
    moved = LIGHTS.replace(b"1.50", b"1").replace(b"16e-1", b"1.35")
    wait_for("Ctrl+S saves the drag, and nothing else", lambda: lights.read_bytes() == moved)
    display.do("key", "F1")
    walk.expect_screenshot()  # which `hearth shot` draws from the file

    display.do("key", "F1")
    settled(display)
    display.do("key", "ctrl+z")
    settled(display)
    display.do("key", "F1")
    wait_for("Ctrl+Z gives the first picture back", lambda: settled(display) == first)
    display.do("key", "Escape")
    settled(display)
    if walk.process.poll() is not None:
        sys.exit("FAILED: edits that are not saved are asked about")
    display.do("key", "F1")
    display.do("key", "ctrl+s")
    wait_for("the file is as it was, byte for byte", lambda: lights.read_bytes() == LIGHTS)
    display.do("key", "F1")
    walk.expect_screenshot()
    walk.leave()


def writes_a_shot(display, walk, level):
    """B keeps the place, a click on its `write as a shot` writes it into the level's file."""
    settled(display)
    hold(display, "Right")
    hold(display, "w")
    settled(display)
    display.do("key", "b")
    wait_for("the place is kept", lambda: list(walk.folder.glob("state/hearth/bookmarks/*")))
    display.do("key", "g")  # to the place as it is kept, to the millimetre
    picture = walk.screenshot()[0].read_bytes()
    before = level.read_bytes()
    display.do("key", "F1")
    right, height = walk.geometry()[2:]
    turn_to(display, walk, "Bookmarks")
    display.do("mousemove", "--window", walk.window, str(right - 370), "60")  # the only one's button
    settled(display)
    display.do("click", "1")
    wait_for("the level's file changes", lambda: level.read_bytes() != before)
    expect_only_one_more_shot(before, level.read_bytes())
    drawn = walk.folder / "place.png"
    subprocess.run([walk.hearth, "shot", level, "-o", drawn, "--shot", "place-1", "--size",
                    f"{right}x{height}"], check=True, stdout=subprocess.DEVNULL)
    if drawn.read_bytes() != picture:
        sys.exit("FAILED: the shot shows what the window showed")
    settled(display)
    display.do("key", "F1")
    walk.leave()


def expect_only_one_more_shot(before, after):
    """What was there stays, to the byte, and something stands between."""
    begin = next(i for i, (a, b) in enumerate(zip(before, after)) if a != b)
    if after[len(after) - len(before) + begin:] != before[begin:]:
        sys.exit(f"FAILED: the rest of the file stays as it is: {after}")
    shots, more = (json.loads(text)["shots"] for text in (before, after))
    if more[:-1] != shots or more[-1]["name"] != "place-1":
        sys.exit(f"FAILED: a shot more than {shots}: {more}")


if __name__ == "__main__":
    main()
