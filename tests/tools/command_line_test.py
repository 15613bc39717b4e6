"""Holds `hearth` to what it promises on the command line: statuses, messages, files.

usage: command_line_test.py HEARTH SOURCE_DIR [THREADS]
"""

import json
import re
import struct
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

HEARTH = ""
SOURCE = Path()
COMMANDS = ["walk", "shot", "bake", "check", "info"]


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
        pictures = {}
        for options in [(), ("--light", "none"), ("--light", "only")] + [
                ("--channel", name) for name in
                "sector surface depth uv normal light overdraw world camera depthspace screen".split()]:
            result = self.shot("--camera", "1,2,1.5,10", *options)
            self.assertEqual(result.returncode, 0, result.stderr)
            pictures[options] = self.out.read_bytes()
        self.assertEqual(len(set(pictures.values())), len(pictures))


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
                (("--bounces", "1"), "--bounces"),
                (("--threads", "0"), "--threads"),
                (("--light", "some"), "--light.*both.none.only"),
                (("--channel", "heat"), "--channel"),
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
            "loops": {"border": {"v": [5e8, 0, 5e8 + 4, 0, 5e8 + 4, 4, 5e8, 4],
                                 "walls": {"texture": "#808080"}}}}}}))
        self.refuse(run("info", far), "--texel.*from the origin")

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

    def test_a_bake_is_written_as_a_picture_only(self):
        self.refuse(run("bake", self.level, "-o", self.folder / "out.bake"), "-o: .*png")

    def test_a_mistyped_command(self):
        self.refuse(run("shoot", self.level), 'no command "shoot".*walk, shot, bake, check, info')
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


class NoDisplay(InFolder):
    def test_no_window_without_a_display(self):
        for display in [{}, {"DISPLAY": ":4711"}, {"SDL_VIDEODRIVER": "x11"}]:
            with self.subTest(display=display):
                result = run("walk", self.level, env={"PATH": "/usr/bin:/bin", **display}, timeout=20)
                self.refuse(result, "no window.*hearth shot")


class Bake(InFolder):
    def test_prints_its_figures_and_writes_the_lightmaps(self):
        result = run("bake", self.level, "-o", self.out, "--samples", "4", "--texel", "0.25")
        self.assertEqual(result.returncode, 0, result.stderr)
        for word in ["surfaces", "texels", "rays/s", "bytes", "time"]:
            self.assertIn(word, result.stdout)
        self.assertGreater(png_size(self.out)[0], 16)

    def test_takes_samples_as_needed(self):
        result = run("bake", self.level, "--samples", "auto")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("samples where shadows' edges need them", result.stdout)


class Info(InFolder):
    def test_json_counts_what_the_level_holds(self):
        result = run("info", self.level, "--json")
        self.assertEqual(result.returncode, 0, result.stderr)
        info = json.loads(result.stdout)
        self.assertEqual((info["sectors"], info["lights"], info["interfaces"]), (4, 2, 1))
        self.assertEqual(info["features"]["stack"], 2)
        self.assertEqual(info["features"]["slope floor"], 1)
        self.assertEqual(info["features"]["closed door"], 0)

    def test_the_tutorial_shows_every_feature_of_the_format(self):
        result = run("info", SOURCE / "levels/tutorial.json", "--json")
        self.assertEqual(result.returncode, 0, result.stderr)
        features = json.loads(result.stdout)["features"]
        self.assertEqual([name for name, count in features.items() if count == 0], [])


class Help(unittest.TestCase):
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
                              if command in commands.split() or commands.strip() == "all"}
                self.assertEqual(helped - {"--help"}, documented)


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
