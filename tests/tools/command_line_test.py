"""Holds `hearth` to what it promises on the command line: statuses, messages, files.

usage: command_line_test.py HEARTH SOURCE_DIR [THREADS]
"""

import json
import math
import os
import re
import resource
import shlex
import signal
import struct
import subprocess
import sys
import tempfile
import time
import unittest
import xml.etree.ElementTree
import zlib
from pathlib import Path

# No bakes of other runs are found, and none are left.
os.environ["XDG_CACHE_HOME"] = os.devnull
os.environ["XDG_CONFIG_HOME"] = os.environ["XDG_STATE_HOME"] = os.devnull

HEARTH = ""
SOURCE = Path()
COMMANDS = ["new", "import", "fmt", "walk", "shot", "bake", "check", "lint", "info", "map", "bench", "tradeoff"]


def run(*arguments, **options):
    return subprocess.run([HEARTH, *map(str, arguments)], capture_output=True, text=True, **options)


def png_size(path):
    data = path.read_bytes()
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    return struct.unpack(">II", data[16:24])


class InFolder(unittest.TestCase):
    def setUp(self):
        self.scratch = tempfile.TemporaryDirectory()
        self.addCleanup(self.scratch.cleanup)
        self.folder = Path(self.scratch.name)
        self.level = SOURCE / "tests/levels/rooms.json"
        self.out = self.folder / "out.png"

    def shot(self, *options, out=None):
        return run("shot", self.level, "-o", out or self.out, *options)

    def stand_a_tile(self, **thing):
        """From now on the level is a copy of the rooms, with a square mesh."""
        (self.folder / "tile.obj").write_text("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n")
        tile = {"mesh": "tile.obj", "texture": "#808080", "x": 1, "y": 2} | thing
        text = self.level.read_text().replace('"sectors"', f'"things": [{json.dumps(tile)}], "sectors"', 1)
        self.level = self.folder / "level.json"
        self.level.write_text(text)

    def refuse(self, result, message):
        """Status 2, one line on stderr that matches, and no picture."""
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assertRegex(result.stderr, message)
        self.assertEqual(result.stderr.count("\n"), 1, result.stderr)
        self.assertFalse(self.out.exists())


class Shot(InFolder):
    def test_draws_320x200_from_the_players_eye_by_default(self):
        result = self.shot()
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertEqual(png_size(self.out), (320, 200))

    def test_needs_no_display(self):
        environment = {"PATH": "/usr/bin:/bin"}
        result = run("shot", self.level, "-o", self.out, env=environment)
        self.assertEqual(result.returncode, 0, result.stderr)

    def test_leaves_nothing_but_the_picture(self):
        self.shot()
        self.assertEqual([path.name for path in self.folder.iterdir()], ["out.png"])

    def test_a_shot_brings_its_size_and_the_command_line_overrides_it(self):
        self.assertEqual(self.shot("--shot", "ramp").returncode, 0)
        self.assertEqual(png_size(self.out), (64, 40))
        self.assertEqual(self.shot("--shot", "ramp", "--size", "31x17").returncode, 0)
        self.assertEqual(png_size(self.out), (31, 17))

    def test_a_camera_may_have_negative_numbers_and_a_pitch(self):
        result = self.shot("--camera", "2,2,1.5,-30.5,-20", "--sector", "hall")
        self.assertEqual(result.returncode, 0, result.stderr)

    def test_every_kind_of_picture_differs_from_the_others(self):
        (self.folder / "level.lights.json").write_text(
            (SOURCE / "tests/levels/rooms.lights.json").read_text())
        self.stand_a_tile(x=2, y=2.5, twoSided=True)
        pictures = {}
        for options in [(), ("--light", "none"), ("--light", "only")] + [
                ("--channel", name) for name in
                ("grid outlines holes vertices sector surface faces depth uv normal backs light overdraw "
                 "wireframe world camera depthspace screen spaces").split()]:
            result = self.shot("--camera", "1,2,1.5,10", *options)
            self.assertEqual(result.returncode, 0, result.stderr)
            pictures[options] = self.out.read_bytes()
        self.assertEqual(len(set(pictures.values())), len(pictures))


    def test_every_setting_of_drawing_draws_something_else(self):
        pictures = set()
        for options in [(), ("--texture-filter", "bilinear"), ("--texture-filter", "mipmapped"),
                        ("--light-filter", "nearest"), ("--pixel-size", "2")]:
            result = run("shot", SOURCE / "levels/tutorial.json", "-o", self.out, "--texel", "1",
                         "--size", "80x50", *options)
            self.assertEqual(result.returncode, 0, result.stderr)
            pictures.add(self.out.read_bytes())
        self.assertEqual(len(pictures), 5)


class Model(InFolder):
    """A model alone."""

    BOX = ("v -1 0 -1\nv 1 0 -1\nv 1 0 1\nv -1 0 1\nv -1 2 -1\nv 1 2 -1\nv 1 2 1\nv -1 2 1\n"
           "f 1 5 6 2\nf 2 6 7 3\nf 3 7 8 4\nf 4 8 5 1\nf 8 7 6 5\nf 1 2 3 4\n")

    def setUp(self):
        super().setUp()
        self.level = self.folder / "crate.obj"
        self.level.write_text(self.BOX)

    def test_is_drawn_and_leaves_nothing_but_the_picture(self):
        result = self.shot()
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertEqual(png_size(self.out), (320, 200))
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), ["crate.obj", "out.png"])

    def test_is_drawn_from_where_its_shot_is_and_from_a_camera(self):
        pictures = []
        camera = ("--camera", "0,8,1,270")
        for options in [(), ("--shot", "front"), camera, ("--fov", "40"), ("--fov", "20"), (*camera, "--fov", "40")]:
            self.assertEqual(self.shot(*options).returncode, 0)
            pictures.append(self.out.read_bytes())
        self.assertEqual(pictures[0], pictures[1])
        self.assertEqual(pictures[0], pictures[3])
        self.assertEqual(pictures[2], pictures[5])
        self.assertEqual(len(set(pictures)), 3)

    def test_is_named_in_any_case_and_from_any_folder(self):
        other = self.folder / "CRATE.OBJ"
        self.level.rename(other)
        result = run("shot", "CRATE.OBJ", "-o", "out.png", cwd=self.folder)
        self.assertEqual((result.returncode, result.stderr), (0, ""))

    def test_is_refused_with_the_lines_of_its_file(self):
        self.level.write_text("v 0 0 0\nv 1 0 0\nf 1 2 3\n")
        self.refuse(self.shot(), r"^\S*/crate\.obj:3:1: error: ")
        self.level.unlink()
        self.refuse(self.shot(), r"^\S*/crate\.obj:1:1: error: .*name an OBJ file$")
        self.level.mkdir()
        self.refuse(self.shot(), r"^\S*/crate\.obj:1:1: error: ")

    def test_is_no_walk_to_be_recorded(self):
        for options in [("--record", "walk.txt"), ("--replay", "walk.txt"), ("--replay", "walk.txt", "--headless")]:
            self.refuse(run("walk", self.level, *options), f"{options[0]}: .*crate.obj is a model.*the option out$")

    def test_is_measured_as_a_level_is(self):
        info = run("info", self.level)
        self.assertEqual((info.returncode, info.stderr), (0, ""))
        self.assertRegex(info.stdout, r"12  faces of meshes")
        for command in ["bake", "lint"]:
            result = run(command, self.level)
            self.assertEqual(result.returncode, 0, result.stdout + result.stderr)

    def test_is_not_blamed_for_the_lights_that_are_made_for_it(self):
        # A floor, which the light from below does not reach.
        self.level.write_text("v 0 0 0\nv 0 0 1\nv 1 0 1\nv 1 0 0\nf 1 2 3 4\n")
        result = run("lint", self.level)
        self.assertEqual((result.returncode, result.stdout, result.stderr), (0, "", "no findings\n"))

    def test_has_golden_pictures_of_its_own(self):
        self.assertEqual(run("check", self.level, "--update").returncode, 0)
        self.assertTrue((self.folder / "crate.obj.golden/front.png").exists())
        self.assertEqual(run("check", self.level).returncode, 0)


class Mistakes(InFolder):
    def test_options_out_of_range(self):
        for options, message in [
                (("--size", "0x200"), "--size.*1..16384"),
                (("--size", "16385x1"), "--size.*1..16384"),
                (("--size", "320"), "--size.*WIDTHxHEIGHT"),
                (("--fov", "180"), "--fov.*1..179"),
                (("--fov", "nan"), "--fov"),
                (("--texel", "0"), "--texel"),
                (("--texel", "-1"), "--texel"),
                (("--samples", "1.5"), "--samples.*whole"),
                (("--samples", "8"), "--samples.*square.* 9"),
                (("--samples", "some"), "--samples.*no number"),
                (("--soft-samples", "60"), "--soft-samples.*square.* 64"),
                (("--cut-off", "-1"), "--cut-off.*outside"),
                (("--bounces", "17"), "--bounces.*0..16"),
                (("--threads", "0"), "--threads"),
                (("--light", "some"), "--light.*both.none.only"),
                (("--channel", "heat"), "--channel"),
                (("--pixel-size", "0"), "--pixel-size.*1..64"),
                (("--pixel-size", "65"), "--pixel-size.*1..64"),
                (("--light", "none", "--channel", "uv"), "not both"),
                (("--lambert", "--no-lambert"), "not both"),
                (("--camera", "1,2,3"), "--camera.*X,Y,Z,ANGLE"),
                (("--camera", "2,2,1.5,0,61"), "--camera.*-60..60"),
                (("--camera", "2,2,inf,0"), "--camera"),
                (("--shot", "ramp", "--camera", "2,2,1.5,0"), "not both"),
                (("--shot", "nowhere"), "--shot.*ramp"),
                (("--sector", "hal", "--camera", "2,2,1.5,0"), '"hall"'),
                (("--frobnicate",), "frobnicate")]:
            with self.subTest(options=options):
                self.refuse(self.shot(*options), "hearth: error: .*" + message)

    def test_an_eye_outside_its_sector_names_the_one_that_holds_it(self):
        self.refuse(self.shot("--camera", "6,2,1,0", "--sector", "hall"), '--camera.*"garden"')

    def test_texels_that_would_fill_the_memory(self):
        self.refuse(self.shot("--texel", "1e-6"), "--texel.*texels")

    def test_texels_too_small_to_be_counted_far_from_the_origin(self):
        far = self.folder / "far.json"
        far.write_text(json.dumps({"light": 1, "sectors": {"room": {
            "floor": {"texture": "#808080"}, "ceiling": {"texture": "#808080"},
            "loops": {"border": {"v": [9e6, 0, 9e6 + 1, 0, 9e6 + 1, 1, 9e6, 1],
                                 "walls": {"texture": "#808080"}}}}}}))
        self.refuse(run("info", far, "--texel", "0.008"), "--texel.*from the origin")

    def test_a_picture_that_cannot_be_written(self):
        self.refuse(self.shot(out=self.folder / "missing" / "out.png"), "missing/out.png")

    def test_a_level_that_is_not_there(self):
        self.refuse(run("info", self.folder / "none.json"), "none.json:1:1: error: ")

    def test_limits_name_the_option_that_raises_them(self):
        level = SOURCE / "levels/tutorial.json"
        for option in ["--max-file-bytes", "--max-vertices", "--max-lights", "--max-image-pixels"]:
            with self.subTest(option=option):
                result = run("info", level, option, "1")
                self.assertEqual(result.returncode, 2, result.stderr)
                self.assertRegex(result.stderr, f"tutorial.*error: .*{option}")

    def test_the_limit_of_cells_of_grids_names_its_option(self):
        result = run("info", SOURCE / "levels/maze.json", "--max-grid-cells", "1")
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assertRegex(result.stderr, r"maze.json:\d+:\d+: error: .*--max-grid-cells")

    def test_the_limit_of_images_of_sprites_names_its_option(self):
        level = self.folder / "level.json"
        level.write_text((SOURCE / "tests/levels/rooms.json").read_text().replace(
            '"sectors"', '"things": [{"sprite": ["#808080", "#404040"], "x": 1, "y": 2}], "sectors"', 1))
        result = run("info", level, "--max-sprite-images", "1")
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assertRegex(result.stderr, r"level.json:\d+:\d+: error: .*--max-sprite-images")

    def test_the_limit_of_faces_of_meshes_names_its_option(self):
        self.stand_a_tile()
        result = run("info", self.level, "--max-mesh-faces", "1")
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assertRegex(result.stderr, r"error: .*--max-mesh-faces")

    def test_a_picture_is_not_called_what_it_is_not(self):
        for ending in ["jpg", "jpeg", "bmp", "tga", "gif", "webp", "JPG"]:
            with self.subTest(ending=ending):
                self.refuse(self.shot(out=self.folder / f"a.b.{ending}"),
                            rf"-o: \S*a\.b\.{ending}: pictures are written as PNG: name it \S*/a\.b\.png$")
        self.assertEqual(list(self.folder.iterdir()), [])
        for name in ["jpg", ".jpg", "out", "out.tmp", "out.PNG", "out.jpg.part"]:
            with self.subTest(name=name):
                self.assertEqual(self.shot(out=self.folder / name).returncode, 0)
                self.assertEqual(png_size(self.folder / name), (320, 200))

    def test_a_bake_is_written_as_a_picture_or_to_be_used_again(self):
        self.refuse(run("bake", self.level, "-o", self.folder / "out.jpg"), r"-o: .*\.bake.*\.png")
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_a_lights_file_for_the_level(self):
        lights = SOURCE / "levels/tutorial.lights.json"
        result = run("lint", lights)
        self.assertEqual((result.returncode, result.stdout), (2, ""))
        self.assertEqual(result.stderr, f"{lights}:1:1: error: a lights file instead of a level, "
                                        "name the level that it belongs to\n")

    def test_a_mistyped_command(self):
        self.refuse(run("shoot", self.level), 'no command "shoot".*walk, shot, bake, check, lint, info')
        self.refuse(run(), "name a command")
        self.refuse(run("--frobnicate"), "hearth: error")

    def test_mistakes_in_the_level_have_their_place(self):
        text = self.level.read_text().replace('"next": "ramp"', '"next": "rampp"')
        wrong = self.folder / "wrong.json"
        wrong.write_text(text)
        result = run("info", wrong)
        self.assertEqual(result.returncode, 2)
        line = 1 + text[:text.index('"rampp"')].count("\n")
        self.assertRegex(result.stderr, rf"wrong\.json:{line}:\d+: error: .*rampp")


class Memory(InFolder):
    def test_too_little_of_it_is_an_error_like_others(self):
        def limit():
            resource.setrlimit(resource.RLIMIT_AS, (192 << 20, 192 << 20))
        for threads in [1, 2]:
            with self.subTest(threads=threads):
                result = run("shot", self.level, "-o", self.out, "--size", "16384x16384", "--texel",
                             "0.5", "--threads", threads, preexec_fn=limit)
                self.refuse(result, "hearth: error: not enough memory")
                result = run("bake", self.level, "-o", self.out, "--texel", "0.00026", "--threads",
                             threads, preexec_fn=limit)
                self.refuse(result, "hearth: error: not enough memory")


class NoDisplay(InFolder):
    def test_no_window_without_a_display(self):
        for display in [{}, {"DISPLAY": ":4711"}, {"SDL_VIDEODRIVER": "x11"}]:
            with self.subTest(display=display):
                result = run("walk", self.level, env={"PATH": "/usr/bin:/bin", **display}, timeout=20)
                self.refuse(result, "no window.*hearth shot")


    def test_a_walk_takes_its_light_from_a_file_too(self):
        bake = self.folder / "rooms.bake"
        bake.write_text("{}")
        result = run("walk", self.level, "--light-from", bake, timeout=20,
                     env={"PATH": "/usr/bin:/bin", "SDL_VIDEODRIVER": "dummy"})
        self.refuse(result, r"rooms\.bake is no saved bake")


    def test_a_recording_that_cannot_be_written_is_refused_before_the_walk(self):
        result = run("walk", self.level, "--record", self.folder / "missing" / "walk.txt", timeout=20,
                     env={"PATH": "/usr/bin:/bin", "SDL_VIDEODRIVER": "dummy"})
        self.refuse(result, r"missing/walk\.txt")


class Walk(InFolder):
    """The parts of `hearth walk` that need no window."""

    def setUp(self):
        super().setUp()
        self.recording = self.folder / "walk.txt"
        # Half a second of standing where the player starts, and an end that nobody reaches.
        self.write(["hearth-walk 1", f"start {self.hexed(1, 2, 1.6, 0, 0)} hall", "32 0 0 0 0 0 -",
                    f"end {self.hexed(*[0] * 9)} - hall"])

    def hexed(self, *numbers):
        return " ".join(float(number).hex().replace("0x", "") for number in numbers)

    def write(self, lines):
        self.recording.write_text("\n".join(lines) + "\n")

    def replay(self, *options):
        return run("walk", self.level, "--replay", self.recording, "--headless", *options)

    def test_a_replay_that_ends_elsewhere_says_so(self):
        result = self.replay()
        self.assertEqual((result.returncode, result.stderr), (1, ""))
        self.assertRegex(result.stdout, r"32 ticks, end: sector hall, feet 1,2,0, angle 0, pitch 0\n"
                                        r"not as recorded: sector hall, feet 0,0,0,")

    def test_a_broken_recording_has_its_place(self):
        lines = self.recording.read_text().splitlines()
        lines[2] = "32 0 0 0 0 0"
        self.write(lines)
        self.refuse(self.replay(), r"walk\.txt:3:1: ")
        self.recording.unlink()
        self.refuse(self.replay(), r"walk\.txt: no such file")

    def test_a_recording_of_another_level_is_refused(self):
        text = self.recording.read_text()
        self.recording.write_text(text.replace(" hall", " ballroom"))
        self.refuse(self.replay(), 'a sector "ballroom" that the level does not have')
        self.recording.write_text(text.replace(self.hexed(1, 2, 1.6), self.hexed(1, 2, 99)))
        self.refuse(self.replay(), 'starts outside of its sector "hall"')

    def test_options_that_exclude_each_other(self):
        self.refuse(self.replay("--start", "1,2,1.6,0"), "--replay or --start, not both")
        self.refuse(self.replay("--record", self.out), "--replay or --record, not both")
        self.refuse(run("walk", self.level, "--headless"), "--headless: give --replay")
        self.refuse(run("walk", self.level, "--start", "1,2,1.6,0", "--shot", "ramp"),
                    "--start, or a camera by other options, not both")

    def test_a_start_is_four_numbers_inside_the_level(self):
        self.refuse(run("walk", self.level, "--start", "1,2,1.6"), "is not X,Y,Z,ANGLE")
        self.refuse(run("walk", self.level, "--start", "1,2,1.6,0,0"), "is not X,Y,Z,ANGLE")
        self.refuse(run("walk", self.level, "--start", "1,2,99,0"), "--start: .*")

    def test_help_lists_the_keys_as_they_are_documented(self):
        walking, _, turning = run("walk", "--help").stdout.partition("Keys:\n")[2].partition("Keys with a model:\n")
        for keys, begin, end in [(walking, "### Walking", "Keys are"), (turning, "**In the window**", "A key does")]:
            rows = re.findall(r"^\| (.+?) \| (.+?) \|$", (SOURCE / "tools/README.md").read_text()
                              .partition(begin)[2].partition(end)[0], re.MULTILINE)
            self.assertGreater(len(rows), 12)
            self.assertEqual([line.split() for line in keys.splitlines() if line],
                             [(names + " " + does).split() for names, does in rows[2:]])

    def test_help_lists_the_users_keys_and_the_file_that_names_them_is_documented(self):
        folder = self.folder / "hearth"
        folder.mkdir()
        environment = {**os.environ, "XDG_CONFIG_HOME": str(self.folder)}
        text = (SOURCE / "tools/README.md").read_text().partition("#### Settings of your own")[2]
        (folder / "config.json").write_text(re.search(r"```json\n(.*?)```", text, re.DOTALL)[1])
        keys = run("walk", "--help", env=environment).stdout
        self.assertRegex(keys, r"(?m)^  Q S, Up Down +walk$")
        self.assertRegex(keys, r"(?m)^  Space, Keypad 0 +jump; in flight: up$")
        actions = re.search(r"Actions are (.*?)\. Keys", text, re.DOTALL)[1]
        for name in re.findall(r"`(\w+)`", actions):
            (folder / "config.json").write_text(json.dumps({"keys": {name: ["F9"]}}))
            help_text = run("walk", "--help", env=environment).stdout
            self.assertRegex(help_text, r"\bF9\b", name)


class Bake(InFolder):
    def test_picks_settings_that_fit_a_time_and_bakes_with_them(self):
        saved = self.folder / "light.bake"
        result = run("bake", self.level, "--time-budget", "100", "-o", saved)
        self.assertEqual(result.returncode, 0, result.stderr)
        picked = re.search(r"^picked +(--texel (\S+) .*): about \S+ s, light off by about \S+ levels",
                           result.stdout, re.MULTILINE)
        self.assertEqual(picked[2], "0.03125", "time for the finest there is")
        self.assertRegex(result.stdout, "texels +[0-9]+ of 0.03125 m")
        again = self.folder / "again.bake"
        self.assertEqual(run("bake", self.level, "-o", again, *picked[1].split()).returncode, 0)
        self.assertEqual(saved.read_bytes(), again.read_bytes())

    def test_takes_a_time_or_settings(self):
        for options in [("--texel", "1"), ("--samples", "4"), ("--quality", "high")]:
            self.refuse(run("bake", self.level, "--time-budget", "1", *options),
                        f"give --time-budget or {options[0]}, not both")

    def test_prints_its_figures_and_writes_the_lightmaps(self):
        result = run("bake", self.level, "-o", self.out, "--samples", "4", "--texel", "0.25")
        self.assertEqual(result.returncode, 0, result.stderr)
        for word in ["surfaces", "texels", "rays/s", "bytes", "time"]:
            self.assertIn(word, result.stdout)
        self.assertGreater(png_size(self.out)[0], 16)

    def test_is_quiet_when_asked(self):
        result = run("bake", self.level, "-o", self.out, "--quiet")
        self.assertEqual((result.returncode, result.stdout, result.stderr), (0, "", ""))
        self.assertTrue(self.out.exists())

    def test_quiet_keeps_errors_and_warnings(self):
        dark = self.folder / "dark.json"
        dark.write_text(self.level.read_text())
        (self.folder / "dark.lights.json").write_text("[]")
        self.assertRegex(run("bake", dark, "--quiet").stderr, "dark.json:1:1: warning: no light")
        self.refuse(run("bake", self.level, "--samples", "8", "--quiet"), "--samples.*square")

    def test_of_no_light_is_done_and_warned_of(self):
        dark = self.folder / "dark.json"
        dark.write_text((SOURCE / "tests/levels/rooms.json").read_text())
        reaches = "warning: no light reaches any surface"
        for light, warning in [("", "warning: no lights are given"),
                               ('{"x": 2, "y": 3, "z": 2, "intensity": 0}', reaches),
                               ('{"x": 2, "y": 3, "z": 2, "curve": [[0, 255], [0.001, 0]]}', reaches)]:
            (self.folder / "dark.lights.json").write_text(f"[{light}]")
            for command in [["bake"], ["shot", "--no-cache", "-o", self.out]]:
                result = run(*command, dark)
                self.assertEqual(result.returncode, 0, result.stderr)
                self.assertIn(warning, result.stderr)

    def test_of_light_out_of_view_warns_of_nothing(self):
        view = "2,2,1,180"  # from the dark west of two rooms
        level = self.folder / "rooms.json"
        level.write_text((SOURCE / "tests/levels/rooms.json").read_text())
        (self.folder / "rooms.lights.json").write_text(
            '[{"x": 5, "y": 2, "z": 0.2, "curve": [[0, 255], [0.5, 0]]}]')
        result = run("shot", level, "--no-cache", "--camera", view, "-o", self.out)
        self.assertEqual((result.returncode, result.stderr), (0, ""))

    def test_takes_samples_as_needed(self):
        result = run("bake", self.level, "--samples", "auto")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("samples where shadows' edges need them", result.stdout)


class SavedBake(InFolder):
    """A bake of texels of half a metre, and what is drawn with it."""

    def setUp(self):
        super().setUp()
        self.bake = self.folder / "rooms.bake"
        self.bake_again("--texel", "0.5")

    def bake_again(self, *options):
        # Without the lines that tell of a bake of more than a second, as any may be on a busy machine.
        result = run("bake", self.level, "-o", self.bake, "--quiet", *options)
        self.assertEqual((result.returncode, result.stderr), (0, ""))

    def copy_level(self, old="", new=""):
        """The level with a change to its text, and its lights with half the intensity."""
        text = self.level.read_text()
        self.assertIn(old, text)
        level = self.folder / "copy.json"
        level.write_text(text.replace(old, new, 1))
        lights = self.level.with_suffix(".lights.json").read_text()
        (self.folder / "copy.lights.json").write_text(lights.replace("220", "110"))
        return level

    def draw(self, *options, level=None):
        result = run("shot", level or self.level, "-o", self.out, *options)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return self.out.read_bytes()

    def refuse_bake(self, message, *options):
        self.refuse(self.shot("--light-from", self.bake, *options), "hearth: error: .*" + message)

    def test_draws_what_a_bake_draws(self):
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), ["rooms.bake"])
        saved = self.draw("--light-from", self.bake)
        self.assertEqual(saved, self.draw("--light-from", self.bake, "--threads", "1"))
        self.assertEqual(saved, self.draw("--texel", "0.5"))
        self.assertNotEqual(saved, self.draw())

    def test_is_the_same_file_for_any_number_of_threads(self):
        before = self.bake.read_bytes()
        self.bake_again("--texel", "0.5", "--threads", "7")
        self.assertEqual(self.bake.read_bytes(), before)

    def test_is_light_whatever_the_lights_are_now(self):
        dimmed = self.copy_level()
        self.assertNotEqual(self.draw("--texel", "0.5", level=dimmed), self.draw("--texel", "0.5"))
        self.assertEqual(self.draw("--light-from", self.bake, level=dimmed),
                         self.draw("--texel", "0.5"))

    def test_is_refused_once_the_geometry_has_changed(self):
        # By so little that no texel moves.
        self.level = self.copy_level('"v": [0,4, 4,4, 4,8, 0,8]', '"v": [0,4, 4,4, 4,7.9999, 0,7.9999]')
        self.refuse_bake(r"rooms\.bake was baked for other geometry than the level has now, with the "
                         r'settings "--texel 0\.5 --samples 1 --soft-samples 36 --cut-off 0 '
                         r'--gather-error 1 --bounces 0 --no-lambert": '
                         r"bake again with `\S*hearth bake \S*copy\.json -o \S*rooms\.bake`")
        self.bake_again()
        self.draw("--light-from", self.bake)

    def test_is_refused_beside_options_of_a_bake(self):
        for options in [("--texel", "0.5"), ("--samples", "4"), ("--soft-samples", "16"),
                        ("--cut-off", "1"), ("--gather-error", "2"), ("--bounces", "0"), ("--lambert",),
                        ("--no-lambert",)]:
            with self.subTest(options=options):
                self.refuse_bake(f"--light-from: .*baked already; leave out {' '.join(options)}$",
                                 *options)

    def test_is_refused_when_it_is_not_what_was_written(self):
        data = self.bake.read_bytes()
        for wrong, message in [(data[:-1], "is cut short: "), (data + b"x", "goes on for 1 bytes"),
                               (data[:99] + b"x" + data[100:], "was altered: "),
                               (b"", "is cut short: "), (b"{}", "is no saved bake")]:
            self.bake.write_bytes(wrong)
            self.refuse_bake(message + ".*: bake again with `\\S*hearth bake ")

    def test_is_refused_unread_when_it_is_no_file_or_too_long(self):
        self.bake_again("--texel", "0.03125")
        self.assertGreater(self.bake.stat().st_size, 3000)
        self.refuse_bake(r"rooms\.bake: \d+ bytes are more than 3000: .*--max-file-bytes",
                         "--max-file-bytes", "3000")
        self.bake_again("--texel", "0.25")
        self.assertLess(self.bake.stat().st_size, 3000)
        self.refuse_bake(r"rooms\.bake has lightmaps of \d+ bytes, more than 3000: raise the limit with "
                         "--max-file-bytes$", "--max-file-bytes", "3000")
        self.bake.unlink()
        self.refuse_bake(r"rooms\.bake: no such file")
        os.mkfifo(self.bake)
        self.refuse_bake(r"rooms\.bake: not a regular file")

    def test_that_cannot_be_written_is_an_error(self):
        for place in [self.folder / "missing/out.bake", self.level / "out.bake"]:
            result = run("bake", self.level, "-o", place)
            self.assertEqual(result.returncode, 2)
            self.assertRegex(result.stderr, r"hearth: error: .*out\.bake: cannot be written")

    def write_100_bytes(self, is_killed):
        """A bake over the old one, of which no more can be written; the old one stays."""
        def limit():
            resource.setrlimit(resource.RLIMIT_FSIZE, (100, 100))
            signal.signal(signal.SIGXFSZ, signal.SIG_DFL if is_killed else signal.SIG_IGN)

        before = self.bake.read_bytes()
        result = run("bake", self.level, "-o", self.bake, preexec_fn=limit)
        self.assertEqual(self.bake.read_bytes(), before)
        return result

    def test_killed_while_it_is_written_leaves_the_old_one(self):
        self.assertEqual(self.write_100_bytes(is_killed=True).returncode, -signal.SIGXFSZ)
        self.bake_again()

    def test_a_full_disk_leaves_the_old_one(self):
        result = self.write_100_bytes(is_killed=False)
        self.assertEqual(result.returncode, 2)
        self.assertRegex(result.stderr, r"rooms\.bake: cannot be written")
        self.assertEqual([path.name for path in self.folder.iterdir()], ["rooms.bake"])

    def test_is_what_a_check_draws_with(self):
        level = self.copy_level()
        check = ["check", level, "--golden", self.folder, "--light-from", self.bake]
        self.assertEqual(run(*check, "--update").returncode, 0)
        self.assertEqual(run(*check).returncode, 0)
        result = run("check", level, "--golden", self.folder)
        self.assertEqual(result.returncode, 1, "the level's own light is another")
        self.bake.write_bytes(self.bake.read_bytes()[:-1])
        result = run(*check)
        self.assertEqual(result.returncode, 2)
        self.assertRegex(result.stderr, r"hearth: error: .*rooms\.bake is cut short")

    def test_a_failed_check_prints_a_command_that_draws_with_it(self):
        level = self.copy_level()
        check = ["check", level, "--golden", self.folder]
        self.assertEqual(run(*check, "--update").returncode, 0)
        result = run(*check, "--light-from", self.bake)
        self.assertEqual(result.returncode, 1)
        self.assertRegex(result.stdout, r"hearth shot .* --light-from \S*rooms\.bake -o ramp\.png")


def short(number):
    """LEB128."""
    more, byte = number >> 7, number & 0x7f
    return bytes([byte | 0x80]) + short(more) if more else bytes([byte])


def folded(number):
    return short(2 * number if number >= 0 else -2 * number - 1)


def neighbour(texels, k, width, channels):
    """Of the byte k of a lightmap: the one above it, in the first row the one to its left."""
    row = width * channels
    return texels[k - row] if k >= row else texels[k - channels] if k >= channels else 0


def lit(bake, surface, light):
    """The texels of a surface; `light(point)` gives the channels of one."""
    i0, j0, width, height = surface["texels"]
    return b"".join(
        bytes(light([origin + bake["texelMetres"] * ((i + 0.5) * s + (j + 0.5) * t) for origin, s, t in
                     zip(surface["origin"], surface["axisS"], surface["axisT"])]))
        for j in range(j0, j0 + height) for i in range(i0, i0 + width))


def write_bake(bake, texels_of):
    """A saved bake by its description alone, with the texels of each surface."""
    maps = b""
    for surface in bake["surfaces"]:
        i0, j0, width, height = surface["texels"]
        texels = texels_of(surface)
        channels = len(texels) // (width * height)
        maps += short(surface["surface"]) + folded(i0) + folded(j0)
        maps += short(width) + short(height) + short(channels)
        maps += bytes((texel - neighbour(texels, k, width, channels)) % 256
                      for k, texel in enumerate(texels))
    settings = b"a test"
    packed = zlib.compress(maps)
    whole = b"\x89HEARTH\n" + struct.pack(
        "<IIQQdIQ", 5, len(settings), 52 + len(settings) + len(packed) + 4, int(bake["geometry"], 16),
        bake["texelMetres"], len(bake["surfaces"]), len(maps)) + settings + packed
    return whole + struct.pack("<I", zlib.crc32(whole))


def read_bake(data):
    """The texels of a saved bake by the number of their surface."""
    settings_bytes, = struct.unpack_from("<I", data, 12)
    maps = zlib.decompress(data[52 + settings_bytes:-4])
    at = 0

    def take_short():
        nonlocal at
        byte = maps[at]
        at += 1
        return byte if byte < 0x80 else byte - 0x80 + 0x80 * take_short()

    texels_of = {}
    while at < len(maps):
        surface, _, _, width, height, channels = [take_short() for _ in range(6)]
        texels = bytearray()
        for k in range(width * height * channels):
            texels.append((maps[at + k] + neighbour(texels, k, width, channels)) % 256)
        texels_of[surface] = bytes(texels)
        at += len(texels)
    return texels_of


class KeptBakes(InFolder):
    def setUp(self):
        super().setUp()
        self.cache = self.folder / "cache"
        self.environment = {**os.environ, "XDG_CACHE_HOME": str(self.cache)}

    def kept(self):
        return sorted((self.cache / "hearth").glob("*"))

    def draw(self, *options, level=None, **environment):
        result = run("shot", level or self.level, "-o", self.out, *options,
                     env={**self.environment, **environment})
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return self.out.read_bytes()

    def test_show_what_is_baked_for_one_picture_alone(self):
        for options in [(), ("--pixel-size", "5"), ("--light-filter", "nearest"), ("--samples", "auto"),
                        ("--channel", "light"), ("--channel", "light", "--pixel-size", "50")]:
            self.assertEqual(self.draw("--no-cache", *options), self.draw(*options), options)

    def test_are_drawn_with_instead_of_baking(self):
        picture = self.draw()
        [kept] = self.kept()
        self.assertEqual(kept.suffix, ".bake")
        # Light of another level in its place shows.
        other = self.folder / "rooms.json"
        other.write_text(self.level.read_text())
        (self.folder / "rooms.lights.json").write_text('[{ "x": 2, "y": 3, "z": 2 }]')
        self.assertEqual(run("bake", other, "-o", self.folder / "other.bake").returncode, 0)
        (self.folder / "other.bake").replace(kept)
        self.assertNotEqual(self.draw(), picture)
        self.assertEqual(self.draw("--no-cache"), picture)

    def test_are_baked_anew_in_silence_where_they_are_damaged(self):
        picture = self.draw()
        [kept] = self.kept()
        whole = kept.read_bytes()
        for damaged in (b"", whole[:100], whole[:-1], whole[:50] + b"x" + whole[51:], whole + b"x"):
            kept.write_bytes(damaged)
            self.assertEqual(self.draw(), picture)
            self.assertEqual(kept.read_bytes(), whole)

    def test_are_none_of_other_settings(self):
        pictures = {self.draw("--texel", texel) for texel in ("0.125", "0.5", "1")}
        self.assertEqual(len(pictures), 3)
        self.assertEqual(len(self.kept()), 3)

    def test_are_none_of_another_program(self):
        self.draw()
        program = bytearray(Path(HEARTH).read_bytes())
        id_at = program.index(b"\3\0\0\0GNU\0") + 8  # of the note that holds the build id
        copy = self.folder / "hearth"
        for change, kept in (0, 1), (1, 2):
            program[id_at] ^= change
            copy.write_bytes(program)
            copy.chmod(0o755)
            subprocess.run([copy, "shot", self.level, "-o", self.out], env=self.environment, check=True)
            self.assertEqual(len(self.kept()), kept)

    def test_leave_nothing_where_none_are_wanted(self):
        self.draw("--no-cache")
        self.assertFalse(self.cache.exists())

    def test_lie_in_the_home_folder_by_default(self):
        self.draw(XDG_CACHE_HOME="", HOME=str(self.folder))
        self.draw(XDG_CACHE_HOME="relative", HOME=str(self.folder))
        self.assertEqual(len(list((self.folder / ".cache/hearth").glob("*.bake"))), 1)

    def test_are_safe_with_many_programs_at_once(self):
        picture = self.draw("--no-cache")
        outs = [self.folder / f"{i}.png" for i in range(12)]
        programs = [subprocess.Popen([HEARTH, "shot", self.level, "-o", out], env=self.environment)
                    for out in outs]
        self.assertEqual([program.wait() for program in programs], [0] * len(outs))
        self.assertEqual({out.read_bytes() for out in outs}, {picture})
        self.assertEqual([file.suffix for file in self.kept()], [".bake"])

    def test_survive_programs_that_are_killed(self):
        picture = self.draw("--no-cache")
        for milliseconds in range(0, 60, 4):
            program = subprocess.Popen([HEARTH, "shot", self.level, "-o", self.folder / "killed.png"],
                                       env=self.environment)
            time.sleep(milliseconds / 1000)
            program.kill()
            program.wait()
            self.assertEqual(self.draw(), picture)
            for kept in self.kept():
                if kept.suffix == ".bake" and milliseconds % 8:
                    kept.unlink()


class LightOfAnother(InFolder):
    """Bakes of a program that knows only what `hearth info` says and what is documented."""

    def setUp(self):
        super().setUp()
        self.level = self.folder / "rooms.json"
        self.level.write_text((SOURCE / "tests/levels/rooms.json").read_text())
        (self.folder / "rooms.lights.json").write_text(
            '[{"x": 2, "y": 3, "z": 2.5, "intensity": 220, "falloff": 0.4}]')
        info = run("info", self.level, "--json", "--surfaces", "--texel", "0.17")
        self.assertEqual((info.returncode, info.stderr), (0, ""))
        self.bake = json.loads(info.stdout)["bake"]

    def draw(self, light, *options):
        return self.draw_texels(lambda surface: lit(self.bake, surface, light), *options)

    def draw_texels(self, texels_of, *options):
        file = self.folder / "another.bake"
        file.write_bytes(write_bake(self.bake, texels_of))
        result = self.shot("--light-from", file, *options)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return self.out.read_bytes()

    def test_of_full_light_everywhere_shows_the_textures(self):
        self.assertEqual(self.draw(lambda point: [255]), self.draw(lambda point: [0], "--light", "none"))

    def test_in_three_channels_of_one_level_is_white_light(self):
        self.assertEqual(self.draw(lambda point: [90, 90, 90]), self.draw(lambda point: [90]))
        self.assertNotEqual(self.draw(lambda point: [90, 90, 80]), self.draw(lambda point: [90]))

    def test_is_where_it_was_put(self):
        # The level's lamp, on a wall that sees all of it.
        def lamp(point):
            distance = sum((a - b) ** 2 for a, b in zip(point, (2, 3, 2.5))) ** 0.5
            return [math.floor(220 / (0.4 * distance + 1) + 0.5)]

        camera = ["--camera", "2,1,1.5,270,0", "--light", "only", "--fov", "40"]
        another = self.draw(lamp, *camera)
        self.assertEqual(self.shot("--texel", "0.17", *camera).returncode, 0)
        self.assertEqual(another, self.out.read_bytes())

    def test_that_is_a_copy_of_a_bake_draws_the_same(self):
        lights = [{"x": 2, "y": 3, "z": 2.5, "color": "#ff8040"}, {"x": 1, "y": 6, "z": 1}]
        (self.folder / "rooms.lights.json").write_text(json.dumps(lights))
        saved = self.folder / "hearth.bake"
        self.assertEqual(run("bake", self.level, "--texel", "0.17", "-o", saved).returncode, 0)
        texels_of = read_bake(saved.read_bytes())
        self.bake["surfaces"] = [surface for surface in self.bake["surfaces"] if surface["surface"] in texels_of]
        self.assertEqual(len(self.bake["surfaces"]), len(texels_of))
        camera = ["--camera", "2,1,1.5,60,0", "--light", "only"]
        copied = self.draw_texels(lambda surface: texels_of[surface["surface"]], *camera)
        self.assertEqual(self.shot("--light-from", saved, *camera).returncode, 0)
        self.assertEqual(copied, self.out.read_bytes())

    def test_of_another_size_of_texels_is_refused(self):
        self.bake["texelMetres"] = 0.16
        file = self.folder / "another.bake"
        file.write_bytes(write_bake(self.bake, lambda surface: lit(self.bake, surface, lambda point: [0])))
        self.refuse(self.shot("--light-from", file), "other geometry .* settings \"a test\"")


class New(InFolder):
    def test_writes_a_level_that_draws_without_a_word(self):
        for name in ("castle", "keep.json", "two words", "quo\"ted", "d\u00f6rf.v2"):
            with self.subTest(name=name):
                result = run("new", self.folder / name)
                self.assertEqual((result.returncode, result.stderr), (0, ""))
                level = self.folder / (name if name.endswith(".json") else name + ".json")
                self.assertIn(str(level), result.stdout)
                drawn = run("shot", level, "--shot", "hall", "-o", self.out)
                self.assertEqual((drawn.returncode, drawn.stderr), (0, ""))
                info = json.loads(run("info", level, "--json").stdout)
                self.assertEqual(info["name"], level.stem)
                self.assertEqual((info["sectors"], info["lights"]), (2, 2))
                self.assertGreater(level.read_text().count('"//"'), 4)

    def test_writes_a_grid(self):
        result = run("new", "--grid", self.folder / "dungeon")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        level = self.folder / "dungeon.json"
        for file in level, level.with_suffix(".lights.json"):
            self.assertEqual(run("fmt", "--check", file).returncode, 0, file)
        self.assertEqual(lint(level).stdout, "")
        drawn = run("shot", level, "--shot", "hall", "-o", self.out)
        self.assertEqual((drawn.returncode, drawn.stderr), (0, ""))
        self.assertEqual(json.loads(run("info", level, "--json").stdout)["features"]["grid"], 1)

    def test_takes_images_from_where_its_comment_says(self):
        run("new", self.folder / "castle")
        level = self.folder / "castle.json"
        text = level.read_text().replace('"texture": "#6e5a46"', '"texture": "planks"')
        self.assertIn(r'write \"textures\": \"FOLDER\", below \"name\" at the top', text)
        level.write_text(text.replace('  "name": "castle",\n',
                                      '  "name": "castle",\n  "textures": "images",\n'))
        images = self.folder / "images"
        images.mkdir()
        drawn = run("shot", level, "-o", self.out)
        self.refuse(drawn, r'castle\.json:18:\d+: error: there is no image "planks"')
        (images / "planks.png").write_bytes((SOURCE / "levels/keep.golden/arrival.png").read_bytes())
        drawn = run("shot", level, "-o", self.out)
        self.assertEqual((drawn.returncode, drawn.stderr), (0, ""))

    def test_tells_the_sizes_of_the_player(self):
        run("new", self.folder / "castle")
        level = json.loads((self.folder / "castle.json").read_text())
        sizes = "0.6 m wide and 1.8 m high, 0.9 m when crouching, and climbs steps of 0.4 m"
        self.assertIn(sizes, level["player"]["//"])
        self.assertIn(sizes, " ".join((SOURCE / "levels/TUTORIAL.md").read_text().split()))

    def test_says_how_to_walk_it(self):
        result = run("new", self.folder / "two words")
        command = result.stdout.splitlines()[-1]
        self.assertEqual(shlex.split(command), [HEARTH, "walk", f"{self.folder}/two words.json"])

    def test_never_touches_a_file_that_is_there(self):
        for there in ("castle.json", "castle.lights.json"):
            with self.subTest(there=there):
                file = self.folder / there
                file.write_text("mine")
                result = run("new", self.folder / "castle")
                self.assertEqual((result.returncode, result.stdout), (2, ""))
                self.assertRegex(result.stderr, f"{there}: is there already; choose another name")
                self.assertEqual([f.name for f in self.folder.glob("castle*")], [there])
                self.assertEqual(file.read_text(), "mine")
                file.unlink()

    def test_leaves_nothing_where_it_cannot_write(self):
        result = run("new", self.folder / "missing" / "castle")
        self.assertEqual(result.returncode, 2)
        self.assertRegex(result.stderr, "castle.lights.json: cannot be written: No such file")
        full = subprocess.run(["bash", "-c", 'ulimit -f 1; trap "" XFSZ; "$0" new "$1"', HEARTH,
                               self.folder / "castle"], capture_output=True, text=True)
        self.assertEqual(full.returncode, 2)
        self.assertRegex(full.stderr, "castle.json: cannot be written: File too large")
        self.assertEqual(list(self.folder.glob("castle*")), [])


class Import(InFolder):
    WAD = Path("/usr/share/games/doom/freedoom2.wad")

    def setUp(self):
        super().setUp()
        self.assertTrue(self.WAD.exists(), "tools/setup test installs the package freedoom")

    def run_import(self, *arguments):
        return run("import", self.WAD, *arguments, "-o", self.folder / "maps")

    def test_makes_a_level_that_draws_without_a_word(self):
        result = self.run_import("MAP01")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertRegex(result.stdout, r"map01.json: \d+ sectors of 198, \d+ walls of 1069 lines, ")
        drawn = run("shot", self.folder / "maps/map01.json", "-o", self.out)
        self.assertEqual((drawn.returncode, drawn.stderr), (0, ""))

    def test_lists_the_maps_of_a_wad(self):
        result = run("import", self.WAD)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        lines = result.stdout.splitlines()
        self.assertEqual([line.split(":")[0] for line in lines], [f"MAP{i:02}" for i in range(1, 33)])
        self.assertRegex(lines[0], r"^MAP01: 198 sectors, 1069 lines, \d+ things$")
        listed = json.loads(run("import", self.WAD, "--json").stdout)
        self.assertEqual([f"{map['map']}: {map['sectors']} sectors, {map['lines']} lines, "
                          f"{map['things']} things" for map in listed], lines)

    def test_lists_maps_that_it_cannot_read_with_the_reason(self):
        maps = self.folder / "broken.wad"
        directory = b"".join(struct.pack("<ii8s", 0, 0, name) for name in (b"MAP07", b"THINGS"))
        maps.write_bytes(b"PWAD" + struct.pack("<ii", 2, 12) + directory)
        result = run("import", maps)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertEqual(result.stdout, "MAP07: there is no VERTEXES\n")
        [listed] = json.loads(run("import", maps, "--json").stdout)
        self.assertEqual(listed, {"map": "MAP07", "error": "MAP07: there is no VERTEXES"})

    def test_lists_nothing_of_a_wad_without_maps(self):
        maps = self.folder / "empty.wad"
        maps.write_bytes(b"PWAD" + struct.pack("<ii", 0, 12))
        self.refuse(run("import", maps), "empty.wad: there are no maps of Doom's own format in it")

    def test_reports_as_json_what_it_reports_as_text(self):
        text = self.run_import("MAP20").stdout
        for file in (self.folder / "maps").glob("*.json"):
            file.unlink()
        [made] = json.loads(self.run_import("MAP20", "--json").stdout)
        self.assertIn(f"{made['sectors']} sectors of {made['of']['sectors']}, ", text)
        self.assertIn(f"{made['walls']} walls of {made['of']['lines']} lines, "
                      f"{made['sprites']} sprites of {made['of']['things']} things, "
                      f"{made['lights']} lights, {made['textures']} textures, ", text)
        self.assertIn(f" textures, {made['emitters']} emitters, {made['movers']} movers that "
                      f"{made['starters']} lines start; ", text)
        for reason, count in made["leftOut"].items():
            self.assertRegex(text, f"  {count} lines? left out: {reason}\n")
        self.assertGreater(len(made["leftOut"]), 2)
        self.assertEqual(len(made["findings"]) + len(made["leftOut"]), text.count("\n") - 1)
        for finding in made["findings"]:
            self.assertIn(f"{finding['outcome']}: {finding['what']}\n", text)

    def test_never_touches_a_level_that_is_there(self):
        (self.folder / "maps").mkdir()
        for name in ("map01.json", "map01.lights.json"):
            with self.subTest(name=name):
                file = self.folder / "maps" / name
                file.write_text("mine")
                self.refuse(self.run_import("MAP01"), " is there already: remove it, or give ano")
                self.assertEqual([f.name for f in file.parent.glob("*.json")], [name])
                self.assertEqual(file.read_text(), "mine")
                file.unlink()

    def test_takes_what_a_wad_of_maps_lacks_from_that_of_the_game(self):
        game = self.WAD.read_bytes()
        count, at = struct.unpack("<ii", game[4:12])
        entries = [struct.unpack("<ii8s", game[at + 16 * i:at + 16 * i + 16]) for i in range(count)]
        first = [name.rstrip(b"\0") for _, _, name in entries].index(b"MAP01")
        lumps = [(name, game[begin:begin + size]) for begin, size, name in entries[first:first + 11]]
        body, directory = b"", b""
        for name, data in lumps:
            directory += struct.pack("<ii8s", 12 + len(body), len(data), name)
            body += data
        maps = self.folder / "mine.wad"
        maps.write_bytes(b"PWAD" + struct.pack("<ii", len(lumps), 12 + len(body)) + body + directory)
        result = run("import", maps, "MAP01", "-o", self.folder / "maps")
        self.refuse(result, "PLAYPAL.*--iwad")
        result = run("import", maps, "MAP01", "--iwad", self.WAD, "-o", self.folder / "maps")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.run_import_into("theirs")
        for file in ("map01.json", "map01.lights.json"):
            self.assertEqual((self.folder / "maps" / file).read_text(),
                             (self.folder / "theirs" / file).read_text())

    def run_import_into(self, folder):
        result = run("import", self.WAD, "MAP01", "-o", self.folder / folder)
        self.assertEqual(result.returncode, 0, result.stderr)

    def test_doors_move_or_stay_open_or_closed(self):
        ways = ("open", "closed", "moving")
        for way in ways:
            run("import", self.WAD, "MAP01", "--doors", way, "-o", self.folder / way)
        levels = [json.loads((self.folder / way / "map01.json").read_text()) for way in ways]
        opened = [name for name, sector in levels[0]["sectors"].items()
                  if sector["ceiling"]["z"] > levels[1]["sectors"][name]["ceiling"]["z"]]
        self.assertGreater(len(opened), 3)
        self.assertEqual(["movers" in level for level in levels], [False, False, True])
        self.run_import_into("usual")
        self.assertEqual(json.loads((self.folder / "usual/map01.json").read_text()), levels[2])

    def test_takes_things_of_the_game_that_is_asked_for(self):
        def names(*options):
            self.assertEqual(self.run_import("MAP02", *options).returncode, 0)
            file = self.folder / "maps/map02.json"
            level = json.loads(file.read_text())
            for made in (file, self.folder / "maps/map02.lights.json"):
                made.unlink()
            return [thing["name"] for thing in level["things"]]

        usual = names()
        self.assertNotIn("imp", usual)
        self.assertEqual(names("--skill", "3"), usual)
        self.assertGreater(len(names("--multiplayer")), len(usual))
        with_monsters = names("--monsters")
        self.assertEqual([name for name in with_monsters if name in usual], usual)
        self.assertIn("imp", with_monsters)
        self.assertLess(len(names("--monsters", "--skill", "1")), len(with_monsters))
        self.refuse(self.run_import("MAP02", "--skill", "6"), "--skill")

    def test_takes_a_table_of_what_shines(self):
        table = self.folder / "table.json"
        table.write_text('{"things": {"1": {"color": "#123456"}}}')
        self.run_import("MAP01", "--light-table", table)
        lights = json.loads((self.folder / "maps/map01.lights.json").read_text())["lights"]
        self.assertEqual([light["color"] for light in lights], ["#123456"])

    def test_lets_areas_shine(self):
        [made] = json.loads(self.run_import("MAP01", "--area-lights", "--json").stdout)
        lights = json.loads((self.folder / "maps/map01.lights.json").read_text())
        self.assertEqual(len(lights["emit"]), made["emitters"])
        self.assertEqual(len(lights["lights"]), made["lights"])
        self.assertGreater(made["emitters"], 5)
        self.assertEqual(len(lights["suns"]), 1)
        self.assertGreater(lights["sky"]["intensity"], 0)

    def test_says_what_is_wrong(self):
        table = self.folder / "table.json"
        table.write_text('{"things": {"1": {"colour": 1}}}')
        self.refuse(self.run_import("MAP99"), "freedoom2.wad: there is no map MAP99; those of the WAD"
                                              ": MAP01, MAP02, ")
        self.refuse(run("import", self.WAD, "MAP01"), "-o is required with the name of a map")
        self.refuse(self.run_import("MAP01", "--light-table", table),
                    "table.json: /things/1/colour: there is no such key")
        self.refuse(run("import", self.level, "MAP01", "-o", self.folder), "not a WAD")
        self.assertFalse((self.folder / "maps").exists())


class Fmt(InFolder):
    PACKED = '{"light":1.50,"//":"a","//":"b","sectors":{"hall":{"floor":{"z":0}}}}'
    LAID_OUT = """{
  "light": 1.50,
  "//": "a",
  "//": "b",
  "sectors": {
    "hall": {
      "floor": { "z": 0 }
    }
  }
}
"""

    def setUp(self):
        super().setUp()
        self.level = self.folder / "level.json"
        self.level.write_text(self.PACKED)

    def test_keeps_the_rows_of_a_grid_below_one_another(self):
        self.level.write_text('{"grid":{"rows":["##","#."],"legend":{}}}')
        self.expect(run("fmt", self.level))
        self.assertEqual(self.level.read_text(), """{
  "grid": {
    "rows": [
      "##",
      "#."
    ],
    "legend": {}
  }
}
""")

    def expect(self, result, status=0, stdout="", stderr=""):
        self.assertEqual((result.returncode, result.stdout, result.stderr), (status, stdout, stderr))

    def test_replaces_the_file_and_keeps_its_permissions(self):
        self.level.chmod(0o640)
        self.expect(run("fmt", self.level))
        self.assertEqual(self.level.read_text(), self.LAID_OUT)
        self.assertEqual(self.level.stat().st_mode & 0o777, 0o640)
        self.assertEqual(list(self.folder.iterdir()), [self.level])

    def test_does_not_touch_a_file_that_is_laid_out(self):
        self.level.write_text(self.LAID_OUT)
        before = self.level.stat()
        self.expect(run("fmt", self.level))
        after = self.level.stat()
        self.assertEqual((after.st_ino, after.st_mtime_ns), (before.st_ino, before.st_mtime_ns))

    def test_keeps_a_link_and_replaces_what_it_names(self):
        link = self.folder / "link.json"
        link.symlink_to("level.json")
        self.expect(run("fmt", link))
        self.assertTrue(link.is_symlink())
        self.assertEqual(self.level.read_text(), self.LAID_OUT)

    def test_writes_elsewhere(self):
        other = self.folder / "other.json"
        self.expect(run("fmt", self.level, "-o", other))
        self.assertEqual(other.read_text(), self.LAID_OUT)
        self.expect(run("fmt", self.level, "-o", "-"), stdout=self.LAID_OUT)
        self.assertEqual(self.level.read_text(), self.PACKED)

    def test_check_writes_nothing_and_tells_by_its_status(self):
        self.expect(run("fmt", "--check", self.level), 1,
                    f"{self.level}: not as `hearth fmt` lays it out\n")
        self.assertEqual(self.level.read_text(), self.PACKED)
        self.level.write_text(self.LAID_OUT)
        self.expect(run("fmt", "--check", self.level))
        self.expect(run("fmt", "--check", self.level, "-o", "-"), 2,
                    stderr="hearth: error: --check writes nothing; give it or -o, not both\n")

    def test_what_is_not_json_stays_as_it_is(self):
        for text, message in [
                ('{\n  "a": 1,,\n}', "level.json:2:10: error: not valid JSON: "),
                ('{"a": 1, "a": 2}', 'level.json:1:10: error: the key "a" is given twice'),
                ("[" * 65 + "]" * 65, "level.json:1:65: error: more than 64 arrays"),
                ('{"a": 1e999}', "level.json:1:7: error: the number 1e999 is too large"),
                ('{"//": 01}', "level.json:1:10: error: not valid JSON"),
                ("", "level.json:1:1: error: not valid JSON")]:
            with self.subTest(text=text):
                self.level.write_text(text)
                for options in [(), ("--check",), ("-o", self.out)]:
                    self.refuse(run("fmt", self.level, *options), re.escape(message))
                self.assertEqual(self.level.read_text(), text)

    def test_says_when_it_would_grow_past_the_limit(self):
        self.refuse(run("fmt", self.level, "--max-file-bytes", len(self.PACKED)),
                    "laid out, it has more than .* bytes: raise the limit with --max-file-bytes")
        self.refuse(run("fmt", self.level, "--max-file-bytes", "10"), "bytes are more than 10")

    def test_says_when_nobody_takes_what_it_prints(self):
        with open("/dev/full", "w") as full:
            result = subprocess.run([HEARTH, "fmt", self.level, "-o", "-"], stdout=full,
                                    stderr=subprocess.PIPE, text=True)
        self.assertEqual((result.returncode, result.stderr),
                         (2, "hearth: error: standard output cannot be written\n"))

    def test_has_nothing_to_do_in_a_new_level(self):
        self.assertEqual(run("new", self.folder / "castle").returncode, 0)
        for name in ("castle.json", "castle.lights.json"):
            self.expect(run("fmt", "--check", self.folder / name))


class Map(InFolder):
    SVG = "{http://www.w3.org/2000/svg}"

    def plan(self, level):
        out = self.folder / "plan.svg"
        result = run("map", level, "-o", out, "--quiet")
        self.assertEqual((result.returncode, result.stdout), (0, ""))
        return xml.etree.ElementTree.parse(out).getroot()

    def titles(self, plan):
        return [title.text for title in plan.iter(self.SVG + "title")]

    def test_names_all_sectors_lights_and_shots(self):
        for name in ("tutorial", "keep"):
            with self.subTest(level=name):
                level = json.loads((SOURCE / f"levels/{name}.json").read_text())
                lights = json.loads((SOURCE / f"levels/{name}.lights.json").read_text())["lights"]
                titles = self.titles(self.plan(SOURCE / f"levels/{name}.json"))
                for sector in level["sectors"]:
                    self.assertTrue(any(t.startswith(f"{sector}: floor ") for t in titles), sector)
                for shot in level["shots"]:
                    self.assertTrue(any(t.startswith(f"shot {shot['name']} at z") for t in titles))
                self.assertEqual(sum(t.startswith("light at z ") for t in titles), len(lights))
                self.assertTrue(any(t.startswith("player at z ") for t in titles))

    def test_writes_the_names_of_shots_beside_them(self):
        for name in ("tutorial", "keep"):
            with self.subTest(level=name):
                plan = self.plan(SOURCE / f"levels/{name}.json")
                shots = json.loads((SOURCE / f"levels/{name}.json").read_text())["shots"]
                names = [text for text in plan.iter(self.SVG + "text") if text.get("class") == "shotname"]
                self.assertEqual([text.text for text in names], [shot["name"] for shot in shots])
                for text, eye in zip(names, self.eyes(plan, "shot")):
                    away = math.dist(eye, (float(text.get("x")), float(text.get("y"))))
                    self.assertLess(away, 60 + 4 * len(text.text))

    def eyes(self, plan, style):
        """Where the dots of signs are; the last is that of the key."""
        return [(float(dot.get("cx")), float(dot.get("cy"))) for sign in plan.iter(self.SVG + "g")
                if sign.get("class") == style for dot in sign.iter(self.SVG + "circle")]

    def test_a_view_opens_from_the_eye_into_its_direction(self):
        run("new", self.folder / "castle")  # of 9 m width; its shot looks from (0.5, 3.5) by -25 degrees
        plan = self.plan(self.folder / "castle.json")
        sign = next(sign for sign in plan.iter(self.SVG + "g") if sign.get("class") == "shot")
        x, y = self.eyes(plan, "shot")[0]
        self.assertAlmostEqual(x, 40 + 0.5 * 1600 / 9, delta=0.01)
        self.assertAlmostEqual(y, 40 + 3.5 * 1600 / 9, delta=0.01)
        path = sign.find(self.SVG + "path").get("d")
        left, eye, right = [tuple(map(float, corner.split(","))) for corner in re.split("[ML]", path)[1:]]
        self.assertEqual(eye, (x, y))
        ahead = math.atan2(left[1] + right[1] - 2 * y, left[0] + right[0] - 2 * x)
        self.assertAlmostEqual(math.degrees(ahead), -25, delta=0.1)

    def test_has_a_key_of_its_signs(self):
        plan = self.plan(self.level)
        words = [text.text for text in plan.iter(self.SVG + "text") if text.get("class") == "key"]
        self.assertTrue({"light", "sun, and the way it shines", "player", "sprite", "shot: from the dot, into the angle"} <= set(words), words)
        shots = json.loads(self.level.read_text())["shots"]
        self.assertEqual(len(self.eyes(plan, "shot")), len(shots) + 1)
        self.assertEqual(len(self.eyes(plan, "player")), 2)

    def test_has_suns_on_the_side_from_which_they_shine(self):
        plan = self.plan(SOURCE / "levels/gaol.json")
        titles = [title.text for title in plan.iter(self.SVG + "title")]
        self.assertIn("sun towards angle 101, pitch 50, intensity 230, size 0 degrees", titles)

    def test_tells_walls_steps_openings_and_one_way_portals_apart(self):
        drawn = {path.get("class"): path.get("d", "").count("M")
                 for path in self.plan(SOURCE / "levels/tutorial.json").iter(self.SVG + "path")
                 if path.get("d", "").count("L") == path.get("d", "").count("M") > 0}
        self.assertEqual(set(drawn), {"solid", "step", "opening", "oneway"})
        self.assertEqual(drawn["oneway"], 1)
        self.assertGreater(drawn["solid"], 60)

    def test_holds_whatever_a_name_may_be(self):
        text = self.level.read_text().replace('"garden"', '"<b>&\\"garden\'"')
        level = self.folder / "rooms.json"
        level.write_text(text)
        (self.folder / "rooms.lights.json").write_text("[]")
        titles = self.titles(self.plan(level))
        self.assertTrue(any(t.startswith("<b>&\"garden': floor ") for t in titles), titles)

    def test_marks_sprites_and_the_bodies_of_solid_ones(self):
        level = self.folder / "rooms.json"
        level.write_text((SOURCE / "tests/levels/rooms.json").read_text().replace("\"sectors\"", """"things": [
            {"name": "a <lamp>", "sprite": "#808080", "x": 1, "y": 1, "z": 2},
            {"sprite": "#404040", "x": 3, "y": 1, "radius": 0.4, "height": 1.5}], "sectors\"""", 1))
        plan = self.plan(level)
        titles = [title for title in self.titles(plan) if title.startswith("sprite ")]
        self.assertEqual(titles, ["sprite a <lamp> at z 2", "sprite #404040 at z 0, solid, 1.5 m high"])
        bodies = [circle for circle in plan.iter(self.SVG + "circle") if circle.get("class") == "body"]
        self.assertEqual(len(bodies), 1)
        diamonds = [path for path in plan.iter(self.SVG + "path") if path.get("class") == "sprite"]
        self.assertEqual(len(diamonds), 3, "one of them in the key")

    def test_leaves_what_is_far_larger_out_of_the_frame(self):
        plan = self.plan(SOURCE / "levels/keep.json")  # with a lake of 2 km
        _, _, width, height = map(float, plan.get("viewBox").split())
        self.assertLess(max(width, height), 2000)
        names = [text.text for text in plan.iter(self.SVG + "text")]
        self.assertTrue({"courtyard", "lake"} <= set(names))
        self.assertNotIn("end-1", names)  # of the far shore

    def test_says_what_it_wrote(self):
        out = self.folder / "plan.svg"
        for options, said in ([], f"{out} written\n"), (["--quiet"], ""):
            result = run("map", self.level, "-o", out, *options)
            self.assertEqual((result.returncode, result.stdout, result.stderr), (0, "", said))

    def test_is_written_as_svg_or_not_at_all(self):
        result = run("map", self.level, "-o", self.folder / "plan.png")
        self.assertEqual((result.returncode, result.stdout), (2, ""))
        self.assertRegex(result.stderr, "plan.png: the plan is written as a .svg")
        broken = self.folder / "broken.json"
        broken.write_text("{")
        kept = self.folder / "kept.svg"
        kept.write_text("kept")
        self.assertEqual(run("map", broken, "-o", kept).returncode, 2)
        self.assertEqual(kept.read_text(), "kept")


class Info(InFolder):
    def test_json_counts_what_the_level_holds(self):
        result = run("info", self.level, "--json")
        self.assertEqual(result.returncode, 0, result.stderr)
        info = json.loads(result.stdout)
        self.assertEqual((info["sectors"], info["lights"], info["interfaces"]), (4, 2, 1))
        self.assertEqual(info["features"]["stack"], 2)
        self.assertEqual(info["features"]["slope floor"], 1)
        self.assertEqual(info["features"]["closed door"], 0)
        texels = sum(texture["width"] * texture["height"] for texture in info["textures"])
        self.assertEqual(info["requires"]["textureBytes"], 4 * texels, "as the renderer keeps them")

    def test_counts_sprites_by_what_they_are(self):
        level = self.folder / "rooms.json"
        level.write_text((SOURCE / "tests/levels/rooms.json").read_text().replace("\"sectors\"", """"things": [
            {"sprite": "#808080", "x": 1, "y": 1, "facing": "flat"},
            {"sprite": "#404040", "x": 3, "y": 1, "radius": 0.4, "height": 1.5}], "sectors\"""", 1))
        info = json.loads(run("info", level, "--json").stdout)
        self.assertEqual(info["sprites"], 2)
        self.assertEqual(info["surfaces"]["flat sprite"], 1)
        self.assertEqual(info["features"]["sprite that faces the camera"], 1)
        self.assertEqual(info["features"]["solid sprite"], 1)
        text = run("info", level).stdout
        for line in ("2  sprites", "1  sprite that lies flat", "1  solid sprite"):
            self.assertRegex(text, rf"(?m)^ +{line}$")

    def test_surfaces_are_printed_as_json_only(self):
        self.refuse(run("info", self.level, "--surfaces"), "--surfaces: .*--json")
        bakes = [json.loads(run("info", self.level, "--json", *more).stdout)["bake"]
                 for more in [[], ["--surfaces"]]]
        surfaces = bakes[1].pop("surfaces")
        self.assertEqual(bakes[0], bakes[1])
        self.assertRegex(bakes[0]["geometry"], "^[0-9a-f]{16}$")
        self.assertIn(("sloped floor", "ramp"), {(row["kind"], row["sector"]) for row in surfaces})

    def test_json_says_what_the_level_pays_for_and_what_is_left_out(self):
        info = json.loads(run("info", self.level, "--json", "--texel", "0.5").stdout)
        counted = ["bare", "unfaced", "unreached", "oneChannel", "threeChannels"]
        kinds = info["light"]["kinds"]
        for kind, count in info["surfaces"].items():
            self.assertEqual(sum(kinds[kind][key] for key in counted), count, kind)
        for key, total in info["light"]["all"].items():
            self.assertEqual(sum(kind[key] for kind in kinds.values()), total, key)
        self.assertGreater(info["light"]["all"]["bare"], 0)
        self.assertEqual(info["requires"]["lightmapBytes"], info["light"]["all"]["bytes"])
        self.assertEqual(info["light"]["points"]["rays"], info["requires"]["rays"])
        for feature, used, of in (("sectors with a slope", 1, 4), ("lights with a radius", 0, 2)):
            models = info["models"][feature]
            self.assertEqual((models["used"], models["of"]), (used, of))
            self.assertRegex(models["rest"], "^are ")

    def test_its_bytes_and_rays_are_those_of_the_bake_that_is_asked_for(self):
        for options in [(), ("--texel", "0.5"), ("--samples", "4"), ("--lambert",)]:
            with self.subTest(options=options):
                info = json.loads(run("info", self.level, "--json", *options).stdout)
                bake = run("bake", self.level, *options).stdout
                self.assertRegex(bake, rf"bytes +{info['requires']['lightmapBytes']}\n")
        samples = [json.loads(run("info", self.level, "--json", "--samples", count).stdout)
                   ["light"]["points"]["samples"] for count in (1, 4)]
        self.assertEqual(4 * samples[0], samples[1])

    def test_says_the_same_every_time_for_any_number_of_threads(self):
        for options in [(), ("--json",)]:
            texts = {run("info", self.level, "--threads", count, *options).stdout
                     for count in (1, 2, 7, 7)}
            self.assertEqual(len(texts), 1)
            self.assertIn("rays", texts.pop())

    def features_of(self, level):
        result = run("info", SOURCE / "levels" / level, "--json")
        self.assertEqual(result.returncode, 0, result.stderr)
        return json.loads(result.stdout)["features"]

    def test_the_tutorial_shows_every_feature_of_the_format_but_those_of_gaol_maze_things_and_movers(self):
        unused = [name for name, count in self.features_of("tutorial.json").items()
                  if count == 0 and not re.search("sprite|mesh|grid|mover", name)]
        self.assertEqual(unused, ["middle texture", "light with a spot", "sun", "light of the sky", "emitter"])
        self.assertGreater(self.features_of("gaol.json")["middle texture"], 0)
        self.assertGreater(self.features_of("gaol.json")["sun"], 0)
        self.assertGreater(self.features_of("gaol.json")["light of the sky"], 0)
        self.assertGreater(self.features_of("gaol.json")["emitter"], 0)
        self.assertGreater(self.features_of("maze.json")["grid"], 0)
        self.assertGreater(self.features_of("maze.json")["light with a spot"], 0)


def lint(level):
    return run("lint", level, "--no-cache")


class LintOfShipped(unittest.TestCase):
    def test_finds_nothing_in_the_levels_that_are_shipped(self):
        levels = [file for file in (SOURCE / "levels").glob("*.json")
                  if not re.search(r"\.(lights|schema)\.json$", file.name)]
        self.assertGreaterEqual(len(levels), 2)
        meant = {"tutorial.json": ["one-way-portal"]}  # which it shows
        for level in levels:
            with self.subTest(level=level.name):
                kinds = re.findall(r"\[([a-z-]+)\]$", lint(level).stdout, re.MULTILINE)
                self.assertEqual(kinds, meant.get(level.name, []))


class Lint(InFolder):
    def test_finds_in_a_level_with_sprites_what_it_finds_without(self):
        text = (SOURCE / "tests/levels/rooms.json").read_text()
        things = '"things": [{"sprite": "#808080", "x": 1, "y": 1, "facing": "flat", "size": [1, 1]}, ' \
                 '{"sprite": "#404040", "x": 3, "y": 1, "size": [1, 2], "radius": 0.4, "height": 1.5}], "sectors"'
        found = []
        for each in (text, text.replace('"sectors"', things, 1)):
            level = self.folder / "rooms.json"
            level.write_text(each)
            result = lint(level)
            found.append((result.returncode, re.findall(r"at (\S+), .*\[([a-z-]+)\]$", result.stdout, re.MULTILINE)))
        self.assertEqual(found[0], found[1])

    def test_finds_nothing_in_a_new_level(self):
        run("new", self.folder / "castle")
        result = lint(self.folder / "castle.json")
        self.assertEqual((result.returncode, result.stdout, result.stderr), (0, "", "no findings\n"))
        result = run("lint", self.folder / "castle.json", "--no-cache", "--quiet")
        self.assertEqual((result.returncode, result.stdout, result.stderr), (0, "", ""))

    def test_prints_a_line_for_each_mistake_as_the_loader_does(self):
        run("new", self.folder / "castle")
        level = self.folder / "castle.json"
        text = level.read_text()
        level.write_text(text.replace('{ "z": 0.2, "texture"', '{ "z": 0.5, "texture"')
                         .replace('"light": 0.1', '"light": 0'))
        lights = self.folder / "castle.lights.json"
        lights.write_text(lights.read_text().replace('"intensity": 210', '"intensity": 0'))
        result = lint(level)
        self.assertEqual((result.returncode, result.stderr),
                         (1, 'on foot the player comes to 1 of 2 sectors, not to "study"\n'))
        lines = result.stdout.splitlines()
        for line in lines:
            self.assertRegex(line, r"^\S+\.json:\d+:\d+: warning: .+, at /\S+, .+ \[[a-z-]+\]$")
        step = text.splitlines().index(next(l for l in text.splitlines() if "the doorway" in l)) + 1
        self.assertTrue(lines[0].startswith(f"{level}:{step}:13: warning: the step to sector "
                                            '"study" is 0.5 m high'), lines[0])
        self.assertTrue(lines[0].endswith("make two of it [high-step]"), lines[0])
        self.assertIn(f"{lights}:8:5: warning: the light in sector \"study\" reaches no surface, at "
                      "/lights/1, ", result.stdout)

    def test_names_the_side_of_a_grids_wall_whose_image_jumps(self):
        level = self.folder / "grid.json"
        level.write_text(json.dumps({
            "light": 0.5, "textures": str(SOURCE / "textures"),
            "player": {"x": 3, "y": 3, "z": 1.6},
            "grid": {"cell": 2, "rows": ["########", "#..+...#", "#..#...#", "########"], "legend": {
                "#": {"wall": "plaster", "walls": {"s": "mossy 2,2"}},
                ".": {"floor": {"texture": "stone"}, "ceiling": {"z": 2.6, "texture": "wood"}},
                "+": {"floor": {"texture": "stone"}, "ceiling": {"z": 2.1, "texture": "wood"},
                      "upper": "dressed 2,2"}}}}))
        # Once: what mends the image in one room mends it in all.
        self.assertRegex(lint(level).stdout, r'^\S+: warning: "mossy" jumps .*, at /grid/legend/#/walls/s, '
                                             r'write "s": \{ .*"zref": 2.6 \} \[texture-jump\]\n$')

    def test_counts_what_the_loader_warns_of(self):
        run("new", self.folder / "castle")
        level = self.folder / "castle.json"
        level.write_text(level.read_text().replace('"next": "hall"', '"texture": "#969ba0"'))
        result = lint(level)
        self.assertEqual((result.returncode, result.stderr), (1, ""))
        self.assertRegex(result.stdout, r'warning: a one-way portal to sector "study": wall \d of .*, give that '
                                        r'wall "next": "hall" if it is to lead back \[one-way-portal\]\n')

    def test_help_lists_the_kinds_of_all_warnings_of_the_loader(self):
        helped = run("lint", "--help").stdout
        for expected in (SOURCE / "tests/load/bad").glob("*.expected"):
            for line in expected.read_text().splitlines():
                if ": warning: " in line:
                    self.assertIn(f"\n  {re.search(r'.([a-z-]+).$', line)[1]} ", helped, line)

    def test_refuses_a_level_that_does_not_load(self):
        level = self.folder / "broken.json"
        level.write_text("{ }")
        result = lint(level)
        self.assertEqual((result.returncode, result.stdout), (2, ""))
        self.assertIn("broken.json:1:1: error:", result.stderr)

    def test_finds_the_same_in_light_that_was_kept(self):
        run("new", self.folder / "castle")
        level = self.folder / "castle.json"
        level.write_text(level.read_text().replace('"light": 0.1', '"light": 0'))
        lights = self.folder / "castle.lights.json"
        lights.write_text(lights.read_text().replace('"intensity": 230', '"intensity": 2300'))
        environment = {**os.environ, "XDG_CACHE_HOME": str(self.folder)}
        first = run("lint", level, env=environment)
        # The level's own light, and the same dimmed, in which brightness beyond 255 can be told.
        self.assertEqual(len(list(self.folder.glob("hearth/*.bake"))), 2)
        self.assertIn("[overexposed]", first.stdout)
        self.assertEqual(run("lint", level, env=environment).stdout, first.stdout)

    def test_help_lists_the_kinds_that_the_guide_explains(self):
        guide = (SOURCE / "tools/README.md").read_text().split("### hearth lint")[1]
        explained = re.findall(r"^\| `([a-z-]+)` \|", guide, re.MULTILINE)
        listed = re.findall(r"^  ([a-z]+(?:-[a-z]+)*)  +", run("lint", "--help").stdout, re.MULTILINE)
        self.assertEqual(listed[-len(explained):], explained)


class Help(unittest.TestCase):
    def test_of_the_script_that_builds_and_walks_is_its_own(self):
        script = SOURCE / "tools/run"
        result = subprocess.run([script, "--help"], capture_output=True, text=True)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertTrue(result.stdout.startswith("usage: tools/run [LEVEL]\n"), result.stdout)
        result = subprocess.run([script, "--frobnicate"], capture_output=True, text=True)
        self.assertEqual((result.returncode, result.stdout), (2, ""))
        self.assertTrue(result.stderr.startswith("tools/run: takes one level; "), result.stderr)

    def test_is_no_mistake_and_lists_the_commands(self):
        result = run("--help")
        self.assertEqual(result.returncode, 0)
        for command in COMMANDS:
            self.assertIn(command, result.stdout)

    def test_the_documented_options_are_those_of_each_command(self):
        text = (SOURCE / "tools/README.md").read_text()
        for command in COMMANDS:
            with self.subTest(command=command):
                helped = set(re.findall(r"--[a-z-]+|(?<=\s)-o\b", run(command, "--help").stdout))
                rows = re.findall(r"^\| `(-[-a-z]+)[^|]*\|[^|]*\|([^|]*)\|", text, re.MULTILINE)
                documented = {option for option, commands in rows
                              if command in commands.split() or
                              (commands.strip() == "all" and command != "new")}
                self.assertEqual(helped - {"--help"}, documented)


class Called(InFolder):
    """What the program prints to be typed can be typed, by whatever name it was called."""

    def setUp(self):
        super().setUp()
        self.program = self.folder / "my build" / "hearth"
        self.program.parent.mkdir()
        self.program.symlink_to(Path(HEARTH).resolve())

    def call(self, *arguments):
        return subprocess.run(["my build/hearth", *map(str, arguments)], executable=self.program,
                              cwd=self.folder, capture_output=True, text=True)

    def typed(self, result, pattern="^    (.*)$"):
        text = re.search(pattern, result.stdout + result.stderr, re.MULTILINE)[1]
        self.assertTrue(text.startswith("'my build/hearth' "), text)
        return text

    def test_commands_are_printed_with_its_name(self):
        made = self.call("new", "castle")
        self.assertRegex(self.typed(made), " walk castle.json$")
        accept = self.typed(self.call("check", "castle.json"), r"^    (.* --update)$")
        subprocess.run(["sh", "-c", accept], cwd=self.folder, check=True, capture_output=True)
        self.assertEqual(self.call("check", "castle.json").returncode, 0)

    def test_so_are_those_of_mistakes(self):
        for arguments in [], ["shot"], ["tradeoff"]:
            with self.subTest(arguments=arguments):
                helped = self.typed(self.call(*arguments), "see `(.*)`$")
                subprocess.run(["sh", "-c", helped], cwd=self.folder, check=True, capture_output=True)
        saved = self.folder / "light.bake"
        saved.write_text("{}")
        again = self.typed(self.call("shot", self.level, "-o", "x.png", "--light-from", saved),
                           "bake again with `(.*)`$")
        subprocess.run(["sh", "-c", again], cwd=self.folder, check=True, capture_output=True)


class Threads(InFolder):
    def test_any_number_of_threads_draws_the_same_bytes(self):
        pictures = set()
        for count in [1, 2, 7]:
            result = self.shot("--threads", count)
            self.assertEqual(result.returncode, 0, result.stderr)
            pictures.add(self.out.read_bytes())
        self.assertEqual(len(pictures), 1)


if __name__ == "__main__":
    HEARTH, SOURCE = sys.argv[1], Path(sys.argv[2])
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
