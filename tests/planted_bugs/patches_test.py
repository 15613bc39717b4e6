"""Holds every planted bug to the tree: its patch says what it must and still applies.

usage: patches_test.py SOURCE_DIR
"""

import sys
import unittest
from pathlib import Path

import patches

SOURCE = Path()


class PlantedBugs(unittest.TestCase):
    def test_there_are_some(self):
        self.assertTrue(patches.patches(), f"no patch in {patches.FOLDER}")

    def test_each_says_what_it_is_and_what_catches_it(self):
        for patch in patches.patches():
            with self.subTest(patch.name):
                self.assertTrue(patch.description, "says nothing in words")
                self.assertTrue(patch.caught_by, "names no test after Caught-by:")
                self.assertTrue(patch.targets, "names no target after Targets:")

    def test_each_applies_to_the_tree(self):
        for patch in patches.patches():
            with self.subTest(patch.name):
                self.assertEqual("", patches.apply(patch, SOURCE, check=True))


if __name__ == "__main__":
    SOURCE = Path(sys.argv.pop(1)).resolve()
    unittest.main()
