"""Drives `hearth walk` in a real window: a display of its own, real key presses, real pixels.

usage: walk_window_test.py HEARTH LEVEL
"""

import os
import re
import shlex
import struct
import subprocess
import sys
import tempfile
import time
import zlib
from pathlib import Path

# No bakes of other runs are found, and none are left.
os.environ["XDG_CACHE_HOME"] = os.devnull
os.environ["XDG_CONFIG_HOME"] = os.environ["XDG_STATE_HOME"] = os.devnull

TIMEOUT = 30  # seconds, for anything to happen
SCREEN = (1024, 768)  # pixels


class Display:
    """An X server without a screen, whose pixels lie in a file."""

    def __init__(self, folder, screen=SCREEN):
        self.pixels_file = Path(folder) / "Xvfb_screen0"
        read_end, write_end = os.pipe()
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write_end), "-screen", "0", "{}x{}x24".format(*screen),
             "-fbdir", folder, "-nocursor", "-noreset", "-nolisten", "tcp"],
            pass_fds=[write_end], stderr=subprocess.DEVNULL)
        os.close(write_end)
        with os.fdopen(read_end) as number:
            self.name = ":" + number.readline().strip()
        self.environment = {**os.environ, "DISPLAY": self.name, "SDL_VIDEODRIVER": "x11",
                            "SDL_AUDIODRIVER": "dummy"}
        self.environment.pop("WAYLAND_DISPLAY", None)

    def pixels(self):
        return self.pixels_file.read_bytes()

    def picture(self, left, top, width, height):
        """A part of the screen, as rows of RGB bytes. The file is an X window dump: a header of
        big-endian words, colours, then rows of blue, green, red and a byte of nothing."""
        data = self.pixels()
        words = struct.unpack(">25I", data[:100])
        header, row_bytes, colours = words[0], words[12], words[19]
        rows = []
        for y in range(top, top + height):
            begin = header + 12 * colours + y * row_bytes + 4 * left
            row = data[begin:begin + 4 * width]
            rgb = bytearray(3 * width)
            rgb[0::3], rgb[1::3], rgb[2::3] = row[2::4], row[1::4], row[0::4]
            rows.append(bytes(rgb))
        return rows

    def do(self, *arguments):
        result = subprocess.run(["xdotool", *arguments], env=self.environment,
                                capture_output=True, text=True)
        return result.stdout.strip()

    def close(self):
        self.server.terminate()
        self.server.wait()


def wait_for(what, condition):
    """The first true value of `condition`, or a failure that says what did not come."""
    end = time.monotonic() + TIMEOUT
    while time.monotonic() < end:
        value = condition()
        if value:
            return value
        time.sleep(0.1)
    sys.exit(f"FAILED: {what}, not within {TIMEOUT} s")


def settled(display):
    """The pixels, once they have stopped changing."""
    last = [None]

    def is_same():
        now = display.pixels()
        same, last[0] = now == last[0], now
        return same and now
    return wait_for("the picture comes to rest", is_same)


def hold(display, key, seconds=0.4):
    display.do("keydown", key)
    time.sleep(seconds)
    display.do("keyup", key)


def expect_change(display, what, act):
    before = settled(display)
    act()
    wait_for(what, lambda: display.pixels() != before)


def expect_toggle(display, what, key):
    """A key that changes the picture, and once more gives it back."""
    before = settled(display)
    expect_change(display, f"{key} shows {what}", lambda: display.do("key", key))
    settled(display)
    display.do("key", key)
    wait_for(f"{key} takes {what} away again", lambda: display.pixels() == before)


def read_png(path):
    """Width, height and rows of RGB bytes of a picture without alpha or interlacing."""
    data = path.read_bytes()
    width, height = struct.unpack(">II", data[16:24])
    compressed, at = b"", 8
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        if kind == b"IDAT":
            compressed += data[at + 8:at + 8 + length]
        at += 12 + length
    raw, rows, above = zlib.decompress(compressed), [], bytes(3 * width)
    for y in range(height):
        begin = y * (3 * width + 1)
        row = bytearray(raw[begin + 1:begin + 1 + 3 * width])
        for i in range(3 * width):
            left = row[i - 3] if i >= 3 else 0
            up_left = above[i - 3] if i >= 3 else 0
            row[i] = (row[i] + predicted(raw[begin], left, above[i], up_left)) % 256
        above = bytes(row)
        rows.append(above)
    return width, height, rows


def predicted(kind, left, up, up_left):
    """What a PNG's filter expects of a byte."""
    if kind < 4:
        return [0, left, up, (left + up) // 2][kind]
    distances = [abs(up - up_left), abs(left - up_left), abs(left + up - 2 * up_left)]
    return [left, up, up_left][distances.index(min(distances))]


class Walk:
    """`hearth walk` in a window of the display."""

    def __init__(self, display, hearth, level, folder, *options, title=None, **environment):
        self.display, self.hearth, self.level, self.folder = display, hearth, level, folder
        self.output = folder / "output.txt"
        with self.output.open("w") as out:
            self.process = subprocess.Popen([hearth, "walk", level, *options], stdout=out, cwd=folder,
                                            env={**display.environment, **environment})
        self.window = wait_for("the window shows the level's name",
                               lambda: display.do("search", "--name", f"^{title or level.stem}$"))
        display.do("windowfocus", "--sync", self.window)
        wait_for("the first frame shows", self.has_frame)

    def has_frame(self):
        """Before its first frame, a window is of one colour."""
        rows = self.display.picture(*self.geometry())
        return any(row != rows[0] or row != row[:3] * (len(row) // 3) for row in rows)

    def geometry(self):
        text = self.display.do("getwindowgeometry", "--shell", self.window)
        values = dict(line.split("=") for line in text.splitlines())
        return [int(values[name]) for name in ("X", "Y", "WIDTH", "HEIGHT")]

    def screenshot(self):
        """Presses F12 when nothing moves; the picture's path and the options that draw it again."""
        settled(self.display)
        before = self.output.read_text()
        self.display.do("key", "F12")
        wait_for("F12 tells the name of a picture", lambda: self.output.read_text() != before)
        name, options = re.fullmatch(r"saved (\S+): (.*)\n",
                                     self.output.read_text()[len(before):]).groups()
        return self.folder / name, shlex.split(options)

    def expect_screenshot(self):
        """The saved picture is what `hearth shot` draws, and what the window shows."""
        path, options = self.screenshot()
        shot = self.folder / "shot.png"
        subprocess.run([self.hearth, "shot", self.level, "-o", shot, *options], check=True,
                       stdout=subprocess.DEVNULL)
        if path.read_bytes() != shot.read_bytes():
            sys.exit(f"FAILED: {path.name} is not what shot draws with {options}")
        left, top, *size = self.geometry()
        *png_size, rows = read_png(path)
        if size != png_size:
            sys.exit(f"FAILED: a picture of {png_size} in a window of {size}")
        wait_for("the window shows the picture that was saved, once the message is gone",
                 lambda: self.display.picture(left, top, *size) == rows)

    def leave(self):
        self.display.do("key", "Escape")
        try:
            status = self.process.wait(TIMEOUT)
        except subprocess.TimeoutExpired:
            sys.exit("FAILED: Esc leaves")
        if status != 0:
            sys.exit(f"FAILED: leaving is no error, status {status}")


def moves(display, walk):
    expect_change(display, "the Right key turns the view", lambda: hold(display, "Right"))
    wait_for("the title tells time and rate of frames", lambda: re.fullmatch(
        r"rooms - [0-9.]+ ms, [0-9]+ frames/s", turned_title(display, walk)))
    expect_change(display, "W moves the view", lambda: hold(display, "w"))
    display.do("mousemove", "--window", walk.window, "200", "200")
    display.do("click", "1")
    expect_change(display, "the mouse turns the view once a click has captured it",
                  lambda: display.do("mousemove_relative", "150", "0"))
    display.do("key", "Escape")
    time.sleep(0.5)
    if walk.process.poll() is not None:
        sys.exit("FAILED: the first Esc gives the mouse back and must not leave")
    display.do("key", "n")
    expect_change(display, "in flight Space lifts the eye", lambda: hold(display, "space"))
    display.do("key", "n")
    settled(display)


def turned_title(display, walk):
    """The title after a little more of turning: it is told once a second of drawing."""
    hold(display, "Right")
    return display.do("getwindowname", walk.window)


def loses_focus(display, walk):
    """A key that is held while another window gets the keyboard is let go of."""
    display.do("keydown", "Right")
    display.do("windowfocus", display.do("search", "--maxdepth", "0", ""))
    settled(display)
    display.do("keyup", "Right")
    display.do("windowfocus", "--sync", walk.window)


def shows(display, walk):
    walk.expect_screenshot()
    for key, what in [("2", "the textures alone"), ("3", "the light alone"),
                      ("1", "both")]:
        expect_change(display, f"{key} shows {what}", lambda key=key: display.do("key", key))
        walk.expect_screenshot()
    expect_toggle(display, "the map", "Tab")
    expect_toggle(display, "the keys", "h")


def panel_rows(display, walk):
    """Those of the screen in which white letters stand at the right."""
    left, top, width, height = walk.geometry()
    rows = display.picture(left + width // 2, top, width // 2, height)
    return [row for row in rows if b"\xff\xff\xff" * 3 in row]


# Where the tabs of the panel are, in pixels left of the right edge.
TABS = {"Light": 435, "Quality": 350, "Preferences": 206, "Bookmarks": 122}


def turn_to(display, walk, page):
    right = walk.geometry()[2]
    display.do("mousemove", "--window", walk.window, str(right - TABS[page]), "17")
    settled(display)
    display.do("click", "1")
    settled(display)


def opens_the_overlay(display, walk):
    """F1 opens a panel at the right, which has the mouse until it is closed."""
    plain = settled(display)
    expect_change(display, "F1 opens the overlay", lambda: display.do("key", "F1"))
    width = walk.geometry()[2]
    settled(display)
    rows = panel_rows(display, walk)
    turn_to(display, walk, "Preferences")
    wait_for("a click on a tab shows its page",
             lambda: len(panel_rows(display, walk)) > len(rows))
    turn_to(display, walk, "Light")
    display.do("key", "F1")
    wait_for("F1 closes it again", lambda: display.pixels() == plain)
    display.do("mousemove", "--window", walk.window, "200", "200")
    display.do("click", "1")
    expect_change(display, "the walk takes the mouse by a click", lambda: display.do("mousemove_relative", "150", "0"))
    settled(display)
    display.do("key", "F1")
    time.sleep(0.5)
    display.do("mousemove_relative", "150", "0")
    time.sleep(0.5)
    display.do("key", "F1")
    expect_change(display, "it has it again once the overlay is closed",
                  lambda: display.do("mousemove_relative", "150", "0"))
    display.do("key", "Escape")
    settled(display)
    if walk.process.poll() is not None:
        sys.exit("FAILED: Esc must not leave while the mouse is captured, as it is again")


def chooses_a_quality(display, walk):
    """A click on `draft` in the overlay draws squares of pixels, as screenshots then say."""
    display.do("key", "F1")
    settled(display)
    width = walk.geometry()[2]
    turn_to(display, walk, "Quality")
    display.do("mousemove", "--window", walk.window, str(width - 450), "87")
    settled(display)
    display.do("click", "1")
    wait_for("draft is chosen", lambda: "--pixel-size 2" in " ".join(walk.screenshot()[1]))
    display.do("key", "F1")
    walk.expect_screenshot()


def resizes(display, walk):
    for size in [(400, 300), (97, 301), (960, 600)]:
        display.do("windowsize", "--sync", walk.window, *map(str, size))
        wait_for("the window has its size", lambda size=size: walk.geometry()[2:] == [*size])
        walk.expect_screenshot()
    display.do("windowsize", walk.window, "1", "1")
    time.sleep(0.5)
    display.do("windowsize", "--sync", walk.window, "320", "200")
    display.do("key", "F11")
    wait_for("F11 fills the screen", lambda: read_png(walk.screenshot()[0])[:2] == SCREEN)
    display.do("key", "F11")
    wait_for("F11 gives the window back", lambda: read_png(walk.screenshot()[0])[:2] == (320, 200))
    display.do("windowsize", "--sync", walk.window, "640", "400")
    wait_for("the window has its size", lambda: walk.geometry()[2:] == [640, 400])
    walk.expect_screenshot()


def keeps_to_a_time(display, hearth, level, folder):
    """No processor draws in a hundredth of a millisecond: the coarsest squares are picked, and shown."""
    walk = Walk(display, hearth, level, folder, "--target-ms", "0.01")
    try:
        picked = wait_for("the walk tells what it has picked", lambda: re.match(
            r"picked (--pixel-size 4): about \S+ ms a frame, ", walk.output.read_text()))
        if picked[1] not in " ".join(walk.screenshot()[1]):
            sys.exit("FAILED: it is drawn as picked")
        walk.expect_screenshot()
        walk.leave()
    finally:
        walk.process.kill()
        walk.process.wait()


def fits_small_screens(hearth, level, folder):
    """The first window keeps its shape, or is a whole number of times as large as its picture."""
    place = folder / "small"
    place.mkdir()
    display = Display(place, (800, 480))
    try:
        for options, size in [([], [768, 480]), (["--size", "320x200"], [640, 400]),
                              (["--size", "1000x400"], [800, 320])]:
            walk = Walk(display, hearth, level, folder, *options)
            try:
                if walk.geometry() != [(800 - size[0]) // 2, (480 - size[1]) // 2, *size]:
                    sys.exit(f"FAILED: with {options} the window is {walk.geometry()}")
                walk.leave()
            finally:
                walk.process.kill()
                walk.process.wait()
    finally:
        display.close()


def heeds_the_users_settings(display, hearth, level, folder):
    """Keys are those of the user's file, of which a mistake is told over the picture."""
    config = folder / "config/hearth/config.json"
    config.parent.mkdir(parents=True)
    config.write_text('{ "keys": { "map": ["M"], "jmp": ["J"] } }')
    walk = Walk(display, hearth, level, folder, XDG_CONFIG_HOME=str(folder / "config"))
    try:
        with_note = settled(display)
        wait_for("the note about a mistake goes by itself", lambda: display.pixels() != with_note)
        expect_toggle(display, "the map", "m")
        before = settled(display)
        display.do("key", "Tab")
        time.sleep(0.5)
        if display.pixels() != before:
            sys.exit("FAILED: Tab is no longer the map's key")
        walk.leave()
    finally:
        walk.process.kill()
        walk.process.wait()


def rebinds_a_key_in_the_overlay(display, hearth, level, folder):
    """A click on a key and another key: it works at once, and the user's file says so."""
    config = folder / "rebound/hearth/config.json"
    walk = Walk(display, hearth, level, folder, XDG_CONFIG_HOME=str(folder / "rebound"))
    try:
        settled(display)
        display.do("key", "F1")
        right = walk.geometry()[2]
        turn_to(display, walk, "Preferences")
        # Takes the key of stepping to the left.
        display.do("mousemove", "--window", walk.window, str(right - 225), "174")
        settled(display)
        display.do("click", "1")
        settled(display)
        display.do("key", "j")
        wait_for("the user's file has the key", lambda: config.exists() and
                 '"stepLeft": ["J"]' in config.read_text())
        display.do("key", "F1")
        expect_change(display, "J steps to the left", lambda: hold(display, "j"))
        walk.leave()
    finally:
        walk.process.kill()
        walk.process.wait()


DOOR = """{
  "player": { "x": 2.8, "y": 2, "z": 1.6 },
  "movers": { "gate": { "sectors": "door", "part": "ceiling", "to": 2.5, "trigger": "use" } },
  "sectors": {
    "hall": { "floor": SOLID, "ceiling": { "z": 3, "texture": "#808080" },
      "loops": { "border": { "v": [0,0, 4,0, 4,4, 0,4], "walls": [SOLID, TO door, SOLID, SOLID] } } },
    "door": { "floor": SOLID, "ceiling": { "z": 0, "texture": "#808080" },
      "loops": { "border": { "v": [4,0, 5,0, 5,4, 4,4], "walls": [SOLID, TO cellar, SOLID, TO hall] } } },
    "cellar": { "floor": SOLID, "ceiling": { "z": 3, "texture": "#808080" },
      "loops": { "border": { "v": [5,0, 9,0, 9,4, 5,4], "walls": [SOLID, SOLID, SOLID, TO door] } } }
  }
}
"""


def opens_a_door(display, hearth, folder):
    """The use key starts it. Once it is open, the window shows the light of a level that is authored so."""
    level = folder / "door.json"
    walls = re.sub(r"TO (\w+)", r'{ "next": "\1", "upper": "#604020" }', DOOR)
    level.write_text(walls.replace("SOLID", '{ "texture": "#808080" }'))
    (folder / "door.lights.json").write_text('[{ "x": 2, "y": 1, "z": 2, "intensity": 200, "falloff": 0.25 }]')
    walk = Walk(display, hearth, level, folder, "--record", "door.txt")
    try:
        expect_change(display, "E opens the door", lambda: display.do("key", "e"))
        wait_for("the door is open", lambda: "gate=1" in " ".join(walk.screenshot()[1]))
        walk.expect_screenshot()
        walk.leave()
    finally:
        walk.process.kill()
        walk.process.wait()
    result = subprocess.run([hearth, "walk", level, "--replay", folder / "door.txt", "--headless"],
                            capture_output=True, text=True)
    if result.returncode != 0 or " u\n" not in (folder / "door.txt").read_text():
        sys.exit(f"FAILED: the walk through the door is replayed: {result}")


def opens_where_it_was_left(display, hearth, level, folder):
    """The window is remembered, unless a size of the picture is asked for."""
    state = {"XDG_STATE_HOME": str(folder / "state")}
    usual = [32, 84, 960, 600]
    left = [100, 60, 500, 300]
    for options, expected in [([], usual), ([], left), (["--size", "320x200"], usual), ([], left)]:
        walk = Walk(display, hearth, level, folder, *options, **state)
        try:
            wait_for(f"with {options} the window lies at {expected}",
                     lambda walk=walk, expected=expected: walk.geometry() == expected)
            if not options:
                display.do("windowsize", "--sync", walk.window, *map(str, left[2:]))
                display.do("windowmove", "--sync", walk.window, *map(str, left[:2]))
                settled(display)
            walk.leave()
        finally:
            walk.process.kill()
            walk.process.wait()


def replays(hearth, level, folder):
    result = subprocess.run([hearth, "walk", level, "--replay", folder / "walk.txt", "--headless"],
                            capture_output=True, text=True)
    if result.returncode != 0 or "as recorded, to the bit" not in result.stdout:
        sys.exit(f"FAILED: the walk is replayed: {result}")


def main():
    hearth, level = (Path(argument).resolve() for argument in sys.argv[1:])
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        display = Display(name)
        try:
            # A picture's options bring the settings that it was drawn with, too.
            walk = Walk(display, hearth, level, folder, "--record", "walk.txt",
                        "--light-filter", "nearest", "--texture-filter", "bilinear")
            try:
                moves(display, walk)
                loses_focus(display, walk)
                shows(display, walk)
                opens_the_overlay(display, walk)
                chooses_a_quality(display, walk)
                resizes(display, walk)
                walk.leave()
            finally:
                walk.process.kill()
                walk.process.wait()
            replays(hearth, level, folder)
            heeds_the_users_settings(display, hearth, level, folder)
            rebinds_a_key_in_the_overlay(display, hearth, level, folder)
            opens_where_it_was_left(display, hearth, level, folder)
            opens_a_door(display, hearth, folder)
            keeps_to_a_time(display, hearth, level, folder)
            fits_small_screens(hearth, level, folder)
        finally:
            display.close()
    print("walked in a window")


if __name__ == "__main__":
    main()
