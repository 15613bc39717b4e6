"""Turns a model in a real window: by mouse, wheel and keys; saves other versions of it meanwhile.

usage: model_window_test.py HEARTH
"""

import sys
import tempfile
import time
from pathlib import Path

from walk_window_test import Display, Walk, expect_change, expect_toggle, hold, panel_rows, settled, wait_for

BOX = ("mtllib box.mtl\nv -1 0 -1\nv 1 0 -1\nv 1 0 1\nv -1 0 1\nv -1 2 -1\nv 1 2 -1\nv 1 2 1\nv -1 2 1\nusemtl paint\n"
       "f 1 5 6 2\nf 2 6 7 3\nf 3 7 8 4\nf 4 8 5 1\nf 8 7 6 5\nf 1 2 3 4\n")


def middle(display, walk):
    """The pixel in the middle of the window."""
    left, top, width, height = walk.geometry()
    return tuple(display.picture(left + width // 2, top + height // 2, 1, 1)[0])


def turns(display, walk):
    whole = settled(display)
    display.do("mousemove", "--window", walk.window, "400", "300")
    display.do("mousemove_relative", "100", "0")
    if settled(display) != whole:
        sys.exit("FAILED: the mouse turns the model only in a drag")
    display.do("mousedown", "1")
    expect_change(display, "a drag turns the model", lambda: display.do("mousemove_relative", "100", "40"))
    display.do("mouseup", "1")
    walk.expect_screenshot()
    expect_change(display, "the wheel comes nearer", lambda: display.do("click", "4"))
    expect_change(display, "the wheel goes farther", lambda: display.do("click", "5"))
    for key in ["Left", "d", "Up", "q", "w", "minus"]:
        expect_change(display, f"{key} moves the model", lambda key=key: hold(display, key))
    display.do("key", "Home")
    wait_for("Home shows the whole model from its front", lambda: settled(display) == whole)
    expect_toggle(display, "the keys", "h")
    for key in ["Tab", "b", "n", "space"]:
        display.do("key", key)
    time.sleep(0.5)
    if settled(display) != whole:
        sys.exit("FAILED: keys of walks do nothing")


def shows_counts(display, walk, model):
    """The overlay opens with the counts, which follow the file."""
    plain = settled(display)
    expect_change(display, "F1 opens the overlay", lambda: display.do("key", "F1"))
    settled(display)
    rows = panel_rows(display, walk)
    model.write_text(BOX.replace("v -1 2 1\n", "v -1 2 1\n" + "v 0 1 0\n" * 992))
    wait_for("the overlay shows that there are more vertices now", lambda: panel_rows(display, walk) != rows)
    display.do("key", "F1")
    wait_for("F1 closes it again, and the view is as before", lambda: settled(display) == plain)


def reloads(display, walk, model, folder):
    expect_change(display, "the model turns", lambda: hold(display, "Right"))
    red = middle(display, walk)
    (folder / "box.mtl").write_text("newmtl paint\nKd 0.1 0.1 0.8\n")
    wait_for("a material that was saved shows", lambda: middle(display, walk)[2] > middle(display, walk)[0])
    good = settled(display)
    model.write_text("v 0 0\n")
    wait_for("a mistake stands over the picture", lambda: display.pixels() != good)
    model.write_text(BOX)
    wait_for("and goes once it is mended", lambda: display.pixels() == good)
    walk.expect_screenshot()
    if red[0] <= red[2]:
        sys.exit(f"FAILED: it was red at first, not {red}")


def main():
    hearth = Path(sys.argv[1]).resolve()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        model = folder / "box.obj"
        model.write_text(BOX)
        (folder / "box.mtl").write_text("newmtl paint\nKd 0.8 0.1 0.1\n")
        display = Display(name)
        try:
            walk = Walk(display, hearth, model, folder, title="box.obj")
            try:
                turns(display, walk)
                shows_counts(display, walk, model)
                reloads(display, walk, model, folder)
                walk.leave()
            finally:
                walk.process.kill()
                walk.process.wait()
        finally:
            display.close()
    print("turned in a window")


if __name__ == "__main__":
    main()
