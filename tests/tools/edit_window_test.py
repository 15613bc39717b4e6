"""Edits a light in a real window: drags it, undoes that, saves, and compares files and pictures.

usage: edit_window_test.py HEARTH LEVEL
"""

import shutil
import sys
import tempfile
from pathlib import Path

from walk_window_test import Display, Walk, expect_change, settled, wait_for

# The player of `rooms` looks at the first light from 2 m: it is a quarter of the picture's half to
# the left of the middle, at the height of his eye. Spelled as nobody would, to be kept so.
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
            walk = Walk(display, hearth, copy, folder)
            try:
                edits(display, walk, lights)
            finally:
                walk.process.kill()
                walk.process.wait()
        finally:
            display.close()
    print("edited in a window")


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


if __name__ == "__main__":
    main()
