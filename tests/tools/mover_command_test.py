"""Holds the commands to what they promise of levels with movers.

usage: mover_command_test.py HEARTH
"""

import json
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

# No bakes of other runs are found, and none are left.
os.environ["XDG_CACHE_HOME"] = os.devnull
os.environ["XDG_CONFIG_HOME"] = os.environ["XDG_STATE_HOME"] = os.devnull

HEARTH = ""
SOLID = {"texture": "#808080"}


def to(name):
    return {"next": name, "texture": "#604020"}


def sector(v, walls, ceiling=3):
    return {"floor": SOLID, "ceiling": SOLID | {"z": ceiling}, "loops": {"border": {"v": v, "walls": walls}}}


def level(door=0, **more):
    """A lit hall, a dark cellar, and between them a door whose ceiling is at a height."""
    return {
        "player": {"x": 1, "y": 2, "z": 1.6},
        "shots": [{"name": "shut", "camera": [1, 2, 1.5, 0, 0]},
                  {"name": "ajar", "camera": [1, 2, 1.5, 0, 0], "movers": {"gate": 0.5}},
                  {"name": "open", "camera": [1, 2, 1.5, 0, 0], "movers": {"gate": 1}}],
        "sectors": {
            "hall": sector([0, 0, 4, 0, 4, 4, 0, 4], [SOLID, to("door"), SOLID, SOLID]),
            "door": sector([4, 0, 5, 0, 5, 4, 4, 4], [SOLID, to("cellar"), SOLID, to("hall")], door),
            "cellar": sector([5, 0, 9, 0, 9, 4, 5, 4], [SOLID, SOLID, SOLID, to("door")])}} | more


GATE = {"gate": {"sectors": ["door"], "part": "ceiling", "to": 2.5, "wait": 3, "trigger": "use"},
        "lift = 1": {"sectors": ["cellar"], "part": "floor", "to": 1}}


class Movers(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name)
        self.level = self.write("level", level(movers=GATE))

    def write(self, name, content):
        path = self.folder / f"{name}.json"
        path.write_text(json.dumps(content))
        path.with_suffix(".lights.json").write_text(
            '[{"x": 2, "y": 2, "z": 2, "intensity": 220, "falloff": 0.2}]')
        return path

    def run_hearth(self, *arguments, status=0):
        done = subprocess.run([HEARTH, *map(str, arguments)], capture_output=True, text=True)
        self.assertEqual(done.returncode, status, done.stderr)
        return done

    def shot(self, *options, of=None, light="both"):
        out = self.folder / "out.png"
        self.run_hearth("shot", of or self.level, "-o", out, "--light", light, *options)
        return out.read_bytes()

    def test_are_drawn_at_their_ends_as_if_authored_there(self):
        for share, height in (0, 0), (1, 2.5):
            content = level(door=height)
            for shot in content["shots"]:
                shot.pop("movers", None)
            authored = self.write(f"authored_{share}", content)
            for light in "both", "only", "none":
                with self.subTest(share=share, light=light):
                    self.assertEqual(self.shot("--mover", f"gate={share}", light=light),
                                     self.shot(of=authored, light=light))

    def test_stand_where_a_shot_has_them_unless_an_option_says_otherwise(self):
        shut, ajar, opened = (self.shot("--mover", f"gate={share}", "--camera", "1,2,1.5,0", "--size", "320x200")
                              for share in (0, 0.5, 1))
        self.assertEqual(len({shut, ajar, opened}), 3)
        for name, picture in ("shut", shut), ("ajar", ajar), ("open", opened):
            self.assertEqual(self.shot("--shot", name), picture, name)
        self.assertEqual(self.shot("--shot", "open", "--mover", "gate=0"), shut)

    def test_have_names_with_signs_in_them(self):
        self.assertEqual(self.shot("--mover", "lift = 1=0.5", "--mover", "gate=1"),
                         self.shot("--mover", "gate=1", "--mover", "lift = 1=0.5"))

    def test_are_refused_by_place_and_remedy(self):
        for text, message in [
                ("gat=1", 'the level has no mover "gat"; did you mean "gate"?'),
                ("gate", '"gate" is not NAME=SHARE with a share from 0 to 1'),
                ("gate=1.5", '"gate=1.5" is not NAME=SHARE with a share from 0 to 1'),
                ("gate=nan", '"gate=nan" is not NAME=SHARE with a share from 0 to 1')]:
            for command in ("shot", self.level, "-o", self.folder / "x.png"), ("info", self.level), ("bench", self.level):
                done = self.run_hearth(*command, "--mover", text, status=2)
                self.assertEqual(done.stderr, f"hearth: error: --mover: {message}\n")
        self.assertFalse((self.folder / "x.png").exists())
        still = self.write("still", level() | {"shots": []})
        done = self.run_hearth("info", still, "--mover", "gate=1", status=2)
        self.assertEqual(done.stderr, "hearth: error: --mover: the level has no movers\n")

    def test_are_kept_in_golden_pictures_of_shots(self):
        self.run_hearth("check", self.level, "--update")
        pictures = {name: (self.folder / f"level.golden/{name}.png").read_bytes() for name in ("shut", "ajar", "open")}
        for name, picture in pictures.items():
            self.assertEqual(self.shot("--shot", name), picture, name)
        self.assertEqual(self.run_hearth("check", self.level).stdout, f"{self.level}: 3 as kept\n")

    def test_are_marked_on_the_plan(self):
        plan = self.folder / "plan.svg"
        self.run_hearth("map", self.level, "-o", plan)
        self.assertIn("mover gate: ceiling from 0 to 2.5</title>", plan.read_text())

    def test_are_no_part_of_a_walk_that_is_recorded_from_elsewhere(self):
        done = self.run_hearth("walk", self.level, "--record", self.folder / "walk.txt", "--mover", "gate=1", status=2)
        self.assertIn("--record: a recording begins with all movers where the level has them", done.stderr)
        done = self.run_hearth("walk", self.level, "--replay", self.folder / "walk.txt", "--mover", "gate=1", status=2)
        self.assertIn("give --replay or --mover, not both", done.stderr)
        self.assertFalse((self.folder / "walk.txt").exists())

    def test_are_listed_by_info(self):
        info = json.loads(self.run_hearth("info", self.level, "--json", "--mover", "gate=1").stdout)
        self.assertEqual(info["movers"][0], {"name": "gate", "part": "ceiling", "from": 0, "to": 2.5, "speed": 1.5,
                                             "trigger": "use", "startedByWalls": False, "sectors": 1, "share": 1, "wait": 3})
        self.assertEqual([mover["share"] for mover in info["movers"]], [1, 0])
        self.assertNotIn("blendedLight", info)
        self.assertEqual(info["features"]["mover"], 2)
        text = self.run_hearth("info", self.level).stdout
        self.assertRegex(text, r"\ngate +ceiling +0 +2.5 +1.5 +3 +use +1 +0\n")
        self.assertRegex(text, r"\nlift = 1 +floor +0 +1 +1.5 +- +none +1 +0\n")

    def test_are_said_to_be_started_by_walls(self):
        movers = {"gate": GATE["gate"] | {"trigger": "none"}}
        switched = level(movers=movers)
        switched["sectors"]["hall"]["loops"]["border"]["walls"][0] = SOLID | {"use": "gate", "on": {"#808080": "#ff0000"}}
        path = self.write("switched", switched)
        self.assertRegex(self.run_hearth("info", path).stdout, r"\ngate +ceiling +0 +2.5 +1.5 +3 +wall +1 +0\n")
        self.assertIn("wall whose texture a mover changes", self.run_hearth("info", path).stdout)
        self.assertTrue(json.loads(self.run_hearth("info", path, "--json").stdout)["movers"][0]["startedByWalls"])

    def test_have_the_error_of_their_light_told_by_info(self):
        info = json.loads(self.run_hearth("info", self.level, "--json", "--mover", "gate=0.5").stdout)["blendedLight"]
        self.assertGreater(info["texels"], 1000)
        self.assertGreater(info["rmsLevels"], 0)
        self.assertGreaterEqual(info["mostLevels"], info["rmsLevels"])
        self.assertIn(f"{info['rmsLevels']:.2f} levels RMS from a bake at these heights",
                      self.run_hearth("info", self.level, "--mover", "gate=0.5").stdout)

    def test_are_baked_in_all_states_that_are_kept(self):
        figures = self.run_hearth("bake", self.level).stdout
        self.assertRegex(figures, r"\nstates +3 more by 2 mover\(s\): [\d.]+ s, \d+ bytes; \d+ bytes kept meanwhile\n")
        self.assertIn("states    1 more by", self.run_hearth("bake", self.level, "--mover-states", 2).stdout)
        self.assertIn("states    8 more by", self.run_hearth("bake", self.level, "--mover-stages", 1).stdout)
        still = self.write("still", level() | {"shots": []})
        self.assertNotIn("states", self.run_hearth("bake", still).stdout)

    def test_have_their_light_in_a_saved_bake(self):
        saved = self.folder / "all.bake"
        self.run_hearth("bake", self.level, "-o", saved)
        for shares in (0, 0), (0.3, 0), (1, 0), (0.5, 0.2), (1, 1):
            movers = [f"--mover=gate={shares[0]}", f"--mover=lift = 1={shares[1]}"]
            self.assertEqual(self.shot(*movers, "--light-from", saved), self.shot(*movers), shares)
        self.run_hearth("bake", self.level, "-o", saved, "--mover-stages", 1)
        stage = ["--mover", "gate=0.3", "--mover-stages", 1]
        self.assertEqual(self.shot(*stage, "--light-from", saved), self.shot(*stage))

    def test_are_blended_on_the_texels_of_a_saved_bake(self):
        saved = self.folder / "fine.bake"
        self.run_hearth("bake", self.level, "-o", saved, "--texel", 0.05)
        for share in 0, 0.4, 1:
            ask = ["--mover", f"gate={share}"]
            self.assertEqual(self.shot(*ask, "--light-from", saved, light="only"),
                             self.shot(*ask, "--texel", 0.05, light="only"), share)

    def test_are_no_part_of_parts(self):
        done = self.run_hearth("bake", self.level, "--shard", "1/2", "-o", self.folder / "x.part", "--mover-states", 2,
                               status=2)
        self.assertIn("give --mover-states or --shard, not both", done.stderr)
        self.assertNotIn("states", self.run_hearth("bake", self.level, "-o", self.folder / "x.png").stdout)

    def test_are_refused_where_a_saved_bake_leaves_a_state_out(self):
        saved = self.folder / "some.bake"
        self.run_hearth("bake", self.level, "-o", saved, "--mover-states", 2)
        self.shot("--mover", "gate=1", "--light-from", saved)
        ask = ["shot", self.level, "-o", self.folder / "x.png", "--light-from", saved]
        done = self.run_hearth(*ask, "--mover", "lift = 1=1", status=2)
        self.assertRegex(done.stderr, r"some.bake was baked for other geometry .*: bake again with `\S+ bake \S+ -o \S+`")
        done = self.run_hearth(*ask, "--mover", "gate=0.5", "--mover-stages", 1, status=2)
        self.assertRegex(done.stderr, r": bake again with `\S+ bake \S+ --mover-stages 1 -o \S+`")
        self.assertFalse((self.folder / "x.png").exists())

    def test_are_lit_more_nearly_with_stages(self):
        def rms(stages):
            told = self.run_hearth("info", self.level, "--json", "--mover", "gate=0.3", "--mover-stages", stages)
            return json.loads(told.stdout)["blendedLight"]["rmsLevels"]
        self.assertLess(rms(3), 0.7 * rms(0))
        self.assertLess(rms(15), 0.3 * rms(0))
        exact = self.run_hearth("info", self.level, "--json", "--mover", "gate=0.25", "--mover-stages", 3).stdout
        self.assertNotIn("blendedLight", json.loads(exact))

    def test_are_checked_with_as_many_stages_as_asked(self):
        self.run_hearth("check", self.level, "--update", "--mover-stages", 1)
        ajar = (self.folder / "level.golden/ajar.png").read_bytes()
        self.assertEqual(ajar, self.shot("--shot", "ajar", "--mover-stages", 1))
        self.assertNotEqual(ajar, self.shot("--shot", "ajar"))


if __name__ == "__main__":
    HEARTH = sys.argv.pop(1)
    unittest.main()
