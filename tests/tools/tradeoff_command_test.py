"""Holds `hearth tradeoff` to what it prints and writes. How long things take is nobody's business here.

usage: tradeoff_command_test.py HEARTH SOURCE_DIR
"""

import csv
import io
import json
import subprocess
import sys
import tempfile
import unittest
import xml.dom.minidom
from pathlib import Path

HEARTH = ""
SOURCE = Path()


def run(*arguments):
    return subprocess.run([HEARTH, "tradeoff", *map(str, arguments)], capture_output=True, text=True)


def measure(*options):
    return run(SOURCE / "tests/levels/rooms.json", "--size", "24x15", "--repeats", "1", *options)


# A level that takes little time, for what does not depend on levels.
ROOM = {"light": 0, "shots": [{"name": "room", "camera": [0.2, 0.2, 0.6, 45, 0]}], "sectors": {"room": {
    "floor": {"z": 0, "texture": "#808080"}, "ceiling": {"z": 1, "texture": "#808080"},
    "loops": {"border": {"v": [0, 0, 1, 0, 1, 1, 0, 1], "walls": {"texture": "#808080"}}}}}}


def measure_room(*options):
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "room.json"
        path.write_text(json.dumps(ROOM))
        path.with_suffix(".lights.json").write_text('[{"x": 0.7, "y": 0.5, "z": 0.5, "intensity": 90}]')
        return run(path, "--size", "8x5", "--pixel-size", "64", "--repeats", "1", "--quiet", *options)


def rows(result):
    return list(csv.DictReader(io.StringIO(result.stdout)))


class Tradeoff(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        """Two measurements of one level, the second one with progress and page."""
        cls.first = measure("--csv", "--quiet")
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "trade.html"
            cls.second = measure("--csv", "--report", path)
            cls.page = path.read_text() if path.exists() else ""

    def refuse(self, result, message):
        self.assertEqual(result.returncode, 2)
        self.assertRegex(result.stderr, message)
        self.assertEqual(result.stdout, "")

    def test_lists_every_approximation_without_a_level(self):
        result = run("--list")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        settings = [line.split()[0] for line in result.stdout.splitlines() if line.startswith("--")]
        self.assertEqual(len(settings), len(set(settings)))
        for setting in ["--texel", "--samples", "--light-filter", "--pixel-size"]:
            self.assertIn(setting, settings)
        for path in [line.strip() for line in result.stdout.splitlines() if "engine/" in line]:
            self.assertTrue((SOURCE / path).is_file(), path)

    def test_leaves_out_what_truth_does_not_draw(self):
        direct, bounced = measure_room("--csv"), measure_room("--csv", "--bounces", "2")
        self.assertEqual(direct.stderr, "")
        self.assertRegex(bounced.stderr, "room.json: light .* that bounces is not measured")
        self.assertEqual(rows(bounced)[0]["light_rms"], rows(direct)[0]["light_rms"])

    def test_holds_light_of_areas_against_truth(self):
        first, second = [measure_room("--areas", "--csv", "--bounces", "2", "--texel", "0.0625") for _ in range(2)]
        self.assertEqual((first.returncode, first.stderr), (0, ""))
        for a, b in zip(rows(first), rows(second), strict=True):
            self.assertEqual([a[key] for key in ("settings", "slices", "light_rms", "over4")],
                             [b[key] for key in ("settings", "slices", "light_rms", "over4")])
        fine, *_, coarse, once, never = rows(first)
        self.assertGreater(int(fine["slices"]), int(coarse["slices"]))
        self.assertGreater(int(fine["places"]), 500)
        # In a closed room of one colour all errors are of rounding, ...
        for row in rows(first)[:-2]:
            self.assertLess(float(row["light_rms"]), 0.5)
        # ... and fewer bounces leave out the last, which are dimmer.
        self.assertEqual([once["settings"], never["settings"]], ["--bounces 1", "--bounces 0"])
        self.assertGreater(float(once["light_rms"]), 1)
        self.assertGreater(float(never["light_rms"]), 2 * float(once["light_rms"]))
        self.assertEqual(int(never["slices"]), 0)

    def test_writes_a_page_of_light_of_areas(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "areas.html"
            result = measure_room("--areas", "--bounces", "1", "--report", path)
            self.assertEqual((result.returncode, result.stderr), (0, ""))
            page = path.read_text()
        self.assertEqual(page.count("<svg"), 1)
        xml.dom.minidom.parseString(page[page.index("<svg"):page.index("</svg>") + 6])
        self.assertIn("--gather-error 0.25", page)

    def test_needs_areas_to_measure(self):
        self.refuse(measure_room("--areas"), "room.json: --areas: .*--bounces 1 lets it")

    def test_measures_areas_or_movers(self):
        self.refuse(measure_room("--areas", "--movers"), "--movers and --areas .* give one")

    def test_needs_a_level_to_measure(self):
        self.refuse(run(), "LEVEL is required")

    def test_needs_shots_to_look_at(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "bare.json"
            level = json.loads((SOURCE / "tests/levels/rooms.json").read_text())
            level.pop("shots")
            level["textures"] = str(SOURCE / "textures")
            level["lights"] = str(SOURCE / "tests/levels/rooms.lights.json")
            path.write_text(json.dumps(level))
            self.refuse(run(path), "bare.json: .*shots")

    def test_prints_the_same_errors_and_work_each_time(self):
        self.assertEqual((self.first.returncode, self.first.stderr), (0, ""))
        self.assertEqual(self.second.returncode, 0, self.second.stderr)
        first, second = rows(self.first), rows(self.second)
        self.assertEqual(first[0]["settings"], "", "the level's own come first")
        self.assertEqual(len(first), len({row["settings"] for row in first}))
        timed = {"front", "bake_cost", "bake_seconds", "frame_cost", "frame_ms"}
        for a, b in zip(first, second, strict=True):
            self.assertEqual({key: a[key] for key in a.keys() - timed},
                             {key: b[key] for key in b.keys() - timed})
        self.assertTrue(any(row["front"] for row in first))

    def test_prints_costs_as_shares_of_the_levels_own_settings(self):
        own, *others = rows(self.first)
        self.assertEqual((own["bake_cost"], own["frame_cost"]), ("1", "1"))
        for row in others:
            for cost, time in ("bake_cost", "bake_seconds"), ("frame_cost", "frame_ms"):
                self.assertGreater(float(row[cost]), 0)
                self.assertAlmostEqual(float(row[cost]) * float(own[time]) / float(row[time]), 1)

    def test_finds_finer_texels_nearer_to_truth(self):
        by_settings = {row["settings"]: row for row in rows(self.first)}
        coarse, fine = by_settings["--texel 1"], by_settings["--texel 0.03125"]
        self.assertGreater(float(coarse["light_rms"]), float(fine["light_rms"]))
        self.assertLess(int(coarse["texels"]), int(fine["texels"]))

    def test_takes_the_settings_that_it_is_given_for_all(self):
        texels = {row["texels"] for row in rows(measure_room("--csv", "--texel", "0.5"))
                  if "--texel" not in row["settings"]}
        self.assertEqual(len(texels), 1)

    def test_writes_a_page_that_needs_no_other_file(self):
        self.assertEqual(self.second.returncode, 0, self.second.stderr)
        self.assertIn("of", self.second.stderr, "how far it is")
        page = self.page
        self.assertEqual(page.count("<svg"), 2)
        for begin in [i for i in range(len(page)) if page.startswith("<svg", i)]:
            xml.dom.minidom.parseString(page[begin:page.index("</svg>", begin) + 6])
        self.assertNotRegex(page, r"(src|href)=")
        self.assertIn("--texel 0.0625", page)

    def test_says_when_a_page_cannot_be_written(self):
        result = measure_room("--report", "/nowhere/trade.html")
        self.assertEqual(result.returncode, 2)
        self.assertRegex(result.stderr, "/nowhere/trade.html")


if __name__ == "__main__":
    HEARTH, SOURCE = sys.argv[1], Path(sys.argv[2])
    unittest.main(argv=sys.argv[:1])
