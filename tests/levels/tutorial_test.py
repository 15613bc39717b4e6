"""Follows levels/TUTORIAL.md word for word, in a tree that has nothing but the textures: runs every
command, makes every change of a file, and compares every message.

usage: tutorial_test.py SOURCE_DIR HEARTH
"""

import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

# Finds no bakes of other runs, and leaves none.
os.environ["XDG_CACHE_HOME"] = os.devnull
os.environ["XDG_CONFIG_HOME"] = os.environ["XDG_STATE_HOME"] = os.devnull

SOURCE = Path()
HEARTH = Path()
BUILT = "build/release/hearth "
FILES = ["levels/rooms.json", "levels/rooms.lights.json", "levels/dungeon.json"]


def steps():
    """In the order of the page: the changes of files, as diffs, and the indented lines, which are
    commands and messages. The last section needs an editor with a window."""
    page, drawn, _ = (SOURCE / "levels/TUTORIAL.md").read_text().partition("\n## Draw a level in a Doom")
    assert drawn
    for change, line in re.findall(r"^```diff\n(.*?)^```|^    (\S[^\n]*)$", page, re.S | re.M):
        yield ("change", change) if change else ("line", line)


class Tutorial(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.tree = Path(folder.name)
        (self.tree / "levels").mkdir()
        (self.tree / "textures").symlink_to(SOURCE / "textures")
        self.level = FILES[0]  # in the window
        self.messages = []  # printed by the program, and not yet found on the page

    def run_hearth(self, *arguments):
        return subprocess.run([HEARTH, *arguments], cwd=self.tree, capture_output=True, text=True)

    def show(self):
        """Keeps the messages that a window would show over the level."""
        shot = self.run_hearth("shot", self.level, "-o", "rooms.png", "--quiet")
        self.messages = shot.stderr.splitlines()

    def change(self, diff):
        lines = [line for line in diff.splitlines() if line]
        old = "".join(line[1:] + "\n" for line in lines if line[0] in " -")
        new = "".join(line[1:] + "\n" for line in lines if line[0] in " +")
        texts = {name: (self.tree / name).read_text() for name in FILES if (self.tree / name).exists()}
        self.assertEqual(sum(text.count(old) for text in texts.values()), 1, old)
        for name, text in texts.items():
            if old in text:
                (self.tree / name).write_text(text.replace(old, new))
        self.show()

    def obey(self, command):
        if command.startswith("tools/run "):
            self.level = command.split()[1]
            return self.show()
        result = self.run_hearth(*command.removeprefix(BUILT).split())
        if not command.startswith(BUILT + "lint"):
            self.assertEqual((result.returncode, result.stderr), (0, ""))
            return
        self.messages = result.stdout.splitlines()
        self.assertNotEqual(self.messages, [])

    def test_leads_to_three_rooms_and_quotes_every_message(self):
        for kind, text in steps():
            if kind == "line" and text.startswith("levels/"):
                self.assertEqual(text, self.messages.pop(0))
                continue
            self.assertEqual(self.messages, [], "not on the page")
            if kind == "change":
                self.change(text)
            else:
                self.obey(text)
        self.assertEqual(self.messages, [])
        for level in FILES[0], self.level:
            self.assertEqual(self.run_hearth("lint", level).stdout, "")
        level = (self.tree / FILES[0]).read_text()
        self.assertTrue(all(f'"{room}": {{' in level for room in ("hall", "study", "stair", "loft")))
        kept = {picture.name for picture in (self.tree / "levels/rooms.golden").iterdir()}
        self.assertEqual(kept, {"hall.png", "stair.png"})

    def test_the_guide_to_lint_quotes_a_message_of_the_tutorial(self):
        guide = (SOURCE / "tools/README.md").read_text()
        shown = re.findall(r"^    (levels/rooms\.json:.*)$", guide, re.M)
        self.assertEqual(len(shown), 1)
        self.assertIn(("line", shown[0]), list(steps()))


if __name__ == "__main__":
    SOURCE, HEARTH = Path(sys.argv[1]), Path(sys.argv[2])
    unittest.main(argv=sys.argv[:1])
