"""Drives `hearth walk` in a real window: a display of its own, real key presses, real pixels.

usage: walk_window_test.py HEARTH LEVEL
"""

import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

TIMEOUT = 30  # seconds, for anything to happen


class Display:
    """An X server without a screen, whose pixels lie in a file."""

    def __init__(self, folder):
        self.pixels_file = Path(folder) / "Xvfb_screen0"
        read_end, write_end = os.pipe()
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write_end), "-screen", "0", "1024x768x24",
             "-fbdir", folder, "-nolisten", "tcp"],
            pass_fds=[write_end], stderr=subprocess.DEVNULL)
        os.close(write_end)
        with os.fdopen(read_end) as number:
            self.name = ":" + number.readline().strip()
        self.environment = {**os.environ, "DISPLAY": self.name, "SDL_VIDEODRIVER": "x11",
                            "SDL_AUDIODRIVER": "dummy"}
        self.environment.pop("WAYLAND_DISPLAY", None)

    def pixels(self):
        return self.pixels_file.read_bytes()

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


def drive(display, program):
    window = wait_for("the window shows the level's name and a frame time",
                      lambda: display.do("search", "--name", r"rooms - [0-9.]+ ms"))
    display.do("windowfocus", "--sync", window)
    expect_change(display, "the Right key turns the view", lambda: hold(display, "Right"))
    expect_change(display, "W moves the view", lambda: hold(display, "w"))
    expect_change(display, "2 shows the textures alone", lambda: display.do("key", "2"))
    display.do("mousemove", "--window", window, "200", "200")
    display.do("click", "1")
    expect_change(display, "the mouse turns the view once a click has captured it",
                  lambda: display.do("mousemove_relative", "150", "0"))

    display.do("key", "Escape")
    time.sleep(0.5)
    if program.poll() is not None:
        sys.exit("FAILED: the first Esc gives the mouse back and must not leave")
    display.do("key", "Escape")
    try:
        status = program.wait(TIMEOUT)
    except subprocess.TimeoutExpired:
        sys.exit("FAILED: the second Esc leaves")
    if status != 0:
        sys.exit(f"FAILED: leaving is no error, status {status}")


def main():
    hearth, level = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        display = Display(folder)
        program = subprocess.Popen([hearth, "walk", level], env=display.environment)
        try:
            drive(display, program)
        finally:
            program.kill()
            program.wait()
            display.close()
    print("walked in a window")


if __name__ == "__main__":
    main()
