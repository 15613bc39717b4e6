"""Holds levels/keep.json to what its plan writes.

usage: keep_plan_test.py SOURCE_DIR HEARTH
"""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SOURCE = Path()
HEARTH = ""


class KeepPlan(unittest.TestCase):
    def test_the_level_is_what_the_plan_writes(self):
        with tempfile.TemporaryDirectory() as folder:
            written = Path(folder) / "keep.json"
            subprocess.run([sys.executable, "-B", SOURCE / "tools/levels/keep.py", written], check=True)
            subprocess.run([HEARTH, "fmt", written], check=True)
            self.assertTrue(written.read_bytes() == (SOURCE / "levels/keep.json").read_bytes(),
                            "run tools/levels/keep.py, then hearth fmt levels/keep.json")


if __name__ == "__main__":
    SOURCE, HEARTH = Path(sys.argv[1]), sys.argv[2]
    unittest.main(argv=sys.argv[:1])
