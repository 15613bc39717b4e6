"""Follows "Your own level" of README.md word for word, in a tree that has its level and textures only.

usage: front_page_test.py SOURCE_DIR HEARTH
"""

import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

# No bakes of other runs are found, and none are left.
os.environ["XDG_CACHE_HOME"] = os.devnull

SOURCE = Path()
HEARTH = Path()
BUILT = "build/release/tools/hearth/hearth"


def section():
    readme = (SOURCE / "README.md").read_text()
    return re.search(r"^## Your own level\n(.*?)^## ", readme, re.S | re.M)[1]


def saved_files():
    """The name and text of each file that the reader is asked to save."""
    return re.findall(r"this as `([^`]+)`.*?```json\n(.*?)```", section(), re.S)


def commands():
    return re.findall(rf"^    {BUILT} (.*)$", section(), re.M)


class FrontPage(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.tree = Path(folder.name)
        (self.tree / "levels").mkdir()
        (self.tree / "textures").symlink_to(SOURCE / "textures")
        for name, text in saved_files():
            (self.tree / name).write_text(text)

    def run_hearth(self, *arguments):
        return subprocess.run([HEARTH, *arguments], cwd=self.tree, capture_output=True, text=True)

    def messages_of_a_shot(self):
        return self.run_hearth("shot", "levels/rooms.json", "-o", "rooms.png", "--quiet").stderr

    def change(self, name, old, new):
        text = (self.tree / name).read_text()
        self.assertIn(old, text)
        (self.tree / name).write_text(text.replace(old, new, 1))

    def test_the_level_draws_without_a_complaint_before_and_after_the_change(self):
        self.assertEqual([name for name, _ in saved_files()],
                         ["levels/rooms.json", "levels/rooms.lights.json"])
        self.assertEqual(self.messages_of_a_shot(), "")
        self.change("levels/rooms.json", '"z": 2.2', '"z": 2.6')
        self.assertEqual(self.messages_of_a_shot(), "")

    def test_the_guide_says_what_lint_finds_once_the_ceiling_is_lifted(self):
        lint = ("lint", "levels/rooms.json", "--no-cache")
        self.assertEqual(self.run_hearth(*lint).stdout, "")
        self.change("levels/rooms.json", '"z": 2.2', '"z": 2.6')
        found = self.run_hearth(*lint).stdout
        self.assertNotEqual(found, "")
        self.assertIn("    " + found, (SOURCE / "tools/README.md").read_text())

    def test_the_mistake_is_reported_as_the_page_says(self):
        self.change("levels/rooms.lights.json", '"intensity"', '"intensty"')
        self.assertNotEqual(self.messages_of_a_shot(), "")
        self.assertIn("    " + self.messages_of_a_shot(), section())

    def test_the_pictures_are_kept_and_checked(self):
        self.assertEqual(len(commands()), 2)
        for command in commands():
            check = self.run_hearth(*command.split())
            self.assertEqual(check.returncode, 0, check.stderr)
        self.assertTrue((self.tree / "levels/rooms.golden/door.png").exists())


if __name__ == "__main__":
    SOURCE, HEARTH = Path(sys.argv[1]), Path(sys.argv[2])
    unittest.main(argv=sys.argv[:1])
