"""Follows "Your own level" of README.md word for word, in a tree that has its textures only: every
command, every change of a file, and every message that comes of them.

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
os.environ["XDG_CONFIG_HOME"] = os.environ["XDG_STATE_HOME"] = os.devnull

SOURCE = Path()
HEARTH = Path()
BUILT = "build/release/hearth "
FILES = ["levels/rooms.json", "levels/rooms.lights.json"]


def section():
    readme = (SOURCE / "README.md").read_text()
    return re.search(r"^## Your own level\n(.*?)^## ", readme, re.S | re.M)[1]


def parts():
    """In their order: changes of files, as diffs, and lines that stand apart: commands and messages."""
    for change, line in re.findall(r"^```diff\n(.*?)^```|^    (\S[^\n]*)$", section(),
                                   re.S | re.M):
        yield ("change", change) if change else ("line", line)


class FrontPage(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.tree = Path(folder.name)
        (self.tree / "levels").mkdir()
        (self.tree / "textures").symlink_to(SOURCE / "textures")
        self.messages = []  # that the program has given, and the page has not shown yet

    def run_hearth(self, *arguments):
        return subprocess.run([HEARTH, *arguments], cwd=self.tree, capture_output=True, text=True)

    def show(self):
        """What a window would have to say of the level."""
        shot = self.run_hearth("shot", FILES[0], "-o", "rooms.png", "--quiet")
        self.messages = shot.stderr.splitlines()

    def change(self, diff):
        lines = [line for line in diff.splitlines() if line]
        old = "".join(line[1:] + "\n" for line in lines if line[0] in " -")
        new = "".join(line[1:] + "\n" for line in lines if line[0] in " +")
        texts = {name: (self.tree / name).read_text() for name in FILES}
        self.assertEqual(sum(text.count(old) for text in texts.values()), 1, old)
        for name, text in texts.items():
            if old in text:
                (self.tree / name).write_text(text.replace(old, new))
        self.show()

    def obey(self, command):
        if command.startswith("tools/run "):
            return self.show()
        result = self.run_hearth(*command.removeprefix(BUILT).split())
        if not command.startswith(BUILT + "lint"):
            self.assertEqual((result.returncode, result.stderr), (0, ""))
            return
        self.messages = result.stdout.splitlines()
        self.assertNotEqual(self.messages, [])

    def test_leads_to_three_rooms_and_every_message_on_the_way_is_on_the_page(self):
        for kind, text in parts():
            if kind == "line" and text.startswith("levels/"):
                self.assertEqual(text, self.messages.pop(0))
                continue
            self.assertEqual(self.messages, [], "not on the page")
            if kind == "change":
                self.change(text)
            else:
                self.obey(text)
        self.assertEqual(self.messages, [])
        self.assertEqual(self.run_hearth("lint", FILES[0]).stdout, "")
        level = (self.tree / FILES[0]).read_text()
        self.assertTrue(all(f'"{room}": {{' in level for room in ("hall", "study", "stair", "loft")))
        kept = {picture.name for picture in (self.tree / "levels/rooms.golden").iterdir()}
        self.assertEqual(kept, {"hall.png", "stair.png"})

    def test_the_guide_to_lint_shows_a_line_of_the_page(self):
        guide = (SOURCE / "tools/README.md").read_text()
        shown = re.findall(r"^    (levels/rooms\.json:.*)$", guide, re.M)
        self.assertEqual(len(shown), 1)
        self.assertIn(("line", shown[0]), list(parts()))


if __name__ == "__main__":
    SOURCE, HEARTH = Path(sys.argv[1]), Path(sys.argv[2])
    unittest.main(argv=sys.argv[:1])
