"""The mistakes beside this file: patches to the tree, each with what it is and which tests catch it.

A patch NAME.patch begins with a description in plain English, and then two lines:

    Caught-by: the tests that fail with it, as a regular expression for `ctest -R`
    Targets: what ninja has to build for them
"""

import os
import re
import subprocess
from pathlib import Path
from shutil import which

FOLDER = Path(__file__).resolve().parent


class Patch:
    def __init__(self, path):
        self.path = path
        self.name = path.stem
        header = path.read_text().partition("\n--- ")[0]
        fields = dict(re.findall(r"^(Caught-by|Targets): (.+)$", header, re.MULTILINE))
        self.description = header.partition("Caught-by:")[0].strip()
        self.caught_by = fields.get("Caught-by", "")
        self.targets = fields.get("Targets", "").split()


def patches():
    return [Patch(path) for path in sorted(FOLDER.glob("*.patch"))]


def apply(patch, tree, *, check=False):
    """Applies the patch to a tree, or only checks that it applies. Returns what is wrong, or "".

    Git would take paths as those of a repository around the tree and skip what lies outside.
    """
    if which("git"):
        command = ["git", "apply", *(["--check"] if check else []), str(patch.path)]
    else:
        command = ["patch", "-p1", "--force", "--fuzz=0", *(["--dry-run"] if check else []), "-i", str(patch.path)]
    surroundings = dict(os.environ, GIT_CEILING_DIRECTORIES=str(tree.parent))
    done = subprocess.run(command, cwd=tree, env=surroundings, capture_output=True, text=True)
    return "" if done.returncode == 0 else done.stdout + done.stderr
