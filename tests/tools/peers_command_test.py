"""Holds `hearth bench --peers` to what it promises; how long things take is nobody's business here.

usage: peers_command_test.py HEARTH SOURCE_DIR [GROUP]
"""

import json
import math
import os
import subprocess
import sys
import tempfile
import unittest

HEARTH = SOURCE = ""


def bench(*arguments, folder=None):
    return subprocess.run([HEARTH, "bench", *arguments], cwd=folder or SOURCE, capture_output=True,
                          text=True)


class Refused(unittest.TestCase):
    def refuse(self, result, message):
        self.assertEqual((result.returncode, result.stdout), (2, ""))
        self.assertRegex(result.stderr, message)
        self.assertEqual(result.stderr.count("\n"), 1, result.stderr)

    def test_where_the_levels_are_not(self):
        with tempfile.TemporaryDirectory() as folder:
            self.refuse(bench("--peers", folder=folder), "levels/keep.json: there is no such file")

    def test_with_what_it_does_not_take(self):
        self.refuse(bench("levels/keep.json", "--peers"), "--peers: leave out levels/keep.json")
        self.refuse(bench("--peers", "--texel", "1"), "--peers: .* leave out --texel 1$")
        self.refuse(bench("--peers", "--only", "nonsense"), "--only: no row ")
        self.refuse(bench("levels/keep.json", "--only", "frame"), "--only: ")
        self.refuse(bench(), "name a level, or give --peers")


class Some(unittest.TestCase):
    def test_rows_are_chosen_by_how_their_names_begin(self):
        result = bench("--peers", "--only", "frame-t", "--repeats", "1")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("frame-tutorial", result.stdout)
        self.assertNotIn("frame-writes", result.stdout)
        self.assertRegex(result.stdout, r"<= 0.15 +(met|short by \d+ %)\n")


class Rows(unittest.TestCase):
    def test_all_are_measured_or_say_what_to_install(self):
        result = bench("--peers", "--json", "--repeats", "1")
        self.assertEqual(result.returncode, 0, result.stderr)
        rows = json.loads(result.stdout)["rows"]
        self.assertGreater(len(rows), 5)
        for row in rows:
            with self.subTest(row=row["name"]):
                self.assertEqual(("atMost" in row) + ("atLeast" in row), 1)
                if "missing" in row:
                    self.assertRegex(row["missing"], "apt-get install|one thread")
                    continue
                for figure in [row["measured"], *row["parts"].values()]:
                    self.assertTrue(all(map(math.isfinite, figure.values())), row)
                    self.assertLessEqual(figure["min"], figure["median"])
                    self.assertLessEqual(figure["median"], figure["max"])
                self.assertGreaterEqual(row["shortfall"], 0)
                if row["shortfall"] == 0:
                    self.assertNotIn("inTheWay", row)
                elif row["name"].startswith(
                        ("doom", "embree", "frame", "model", "sprites", "start", "threads")
                ):
                    self.assertIn("inTheWay", row)


if __name__ == "__main__":
    HEARTH, SOURCE = os.path.abspath(sys.argv[1]), sys.argv[2]
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
