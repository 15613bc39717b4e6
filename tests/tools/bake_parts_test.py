"""Holds `hearth bake --shard` and `--join` to what they promise: any parts in any order are the whole
bake, what is no part of it is refused by name, and resuming is running again.

usage: bake_parts_test.py HEARTH SOURCE_DIR [GROUP]
"""

import random
import re
import shutil
import subprocess
import sys
import tempfile
import time
import unittest
import zlib
from pathlib import Path

HEARTH = ""
SOURCE = Path()


class PartsTest(unittest.TestCase):
    options = ["--texel", "0.4"]

    def setUp(self):
        self.folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)
        for name in ["rooms.json", "rooms.lights.json"]:
            shutil.copy(SOURCE / "tests/levels" / name, self.folder)
        self.level = self.folder / "rooms.json"

    def hearth(self, *arguments, options=None):
        options = self.options if options is None else options
        return subprocess.run([HEARTH, "bake", self.level, *options, *arguments], cwd=self.folder,
                              capture_output=True, text=True)

    def bake_part(self, part, parts, name=None, options=None):
        path = self.folder / (name or f"{part}-{parts}.part")
        done = self.hearth("--shard", f"{part}/{parts}", "-o", path, options=options)
        self.assertEqual(done.returncode, 0, done.stderr)
        return path

    def join(self, parts, options=None):
        return self.hearth("-o", "joined.bake", "--join", *parts, options=options)

    def assert_whole(self, parts, options=None):
        self.assertEqual(self.hearth("-o", "whole.bake", options=options).returncode, 0)
        done = self.join(parts, options)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual((self.folder / "joined.bake").read_bytes(),
                         (self.folder / "whole.bake").read_bytes())

    def assert_refused(self, parts, *says, options=None):
        done = self.join(parts, options)
        self.assertEqual(done.returncode, 2, done.stdout)
        self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
        for words in says:
            self.assertIn(words, done.stderr)
        self.assertFalse((self.folder / "joined.bake").exists(), "nothing is written")


class Join(PartsTest):
    def test_parts_in_any_order_are_the_whole_bake(self):
        order = random.Random(1)
        for parts, options in [(1, []), (3, ["--samples", "4", "--lambert"]), (7, ["--samples", "auto"])]:
            options = self.options + options
            paths = [self.bake_part(part, parts, options=options) for part in range(1, parts + 1)]
            order.shuffle(paths)
            self.assert_whole(paths, options)

    def test_the_same_part_twice_counts_once(self):
        paths = [self.bake_part(part, 2) for part in (1, 2)]
        self.assert_whole([*paths, shutil.copy(paths[0], self.folder / "again.part")])

    def test_a_picture_of_the_lightmaps_can_be_joined_too(self):
        paths = [self.bake_part(part, 2) for part in (1, 2)]
        self.hearth("-o", "whole.png")
        self.assertEqual(self.hearth("-o", "joined.png", "--join", *paths).returncode, 0)
        self.assertEqual((self.folder / "joined.png").read_bytes(), (self.folder / "whole.png").read_bytes())

    def test_a_finished_part_is_left_as_it_is(self):
        path = self.bake_part(2, 3)
        before = path.stat()
        done = self.hearth("--shard", "2/3", "-o", path)
        self.assertEqual((done.returncode, done.stdout), (0, "part      2 of 3, which was finished\n"))
        self.assertEqual((path.stat().st_mtime_ns, path.stat().st_ino), (before.st_mtime_ns, before.st_ino))

    def test_a_part_of_an_earlier_level_is_baked_again(self):
        path = self.bake_part(1, 2)
        lights = self.folder / "rooms.lights.json"
        lights.write_text(lights.read_text().replace("220", "120"))
        done = self.hearth("--shard", "1/2", "-o", path)
        self.assertEqual(done.returncode, 0)
        self.assertIn("was baked with other lights than the level has now, and is baked again", done.stderr)
        self.assert_whole([path, self.bake_part(2, 2)])


class Refused(PartsTest):
    def test_missing_parts_are_told_as_a_list_for_schedulers(self):
        paths = [self.bake_part(part, 9) for part in (1, 5, 6)]
        self.assert_refused(paths, "parts 2-4,7-9 of 9 are missing", "--texel 0.4 --shard K/9 -o K.part")

    def test_parts_of_other_inputs(self):
        good = self.bake_part(1, 2)
        coarse = self.bake_part(2, 2, options=["--texel", "0.5"])
        self.assert_refused([good, coarse], "2-2.part was baked with other settings", "--texel 0.5", "--texel 0.4")
        coarse.unlink()
        level = self.level.read_text()
        self.level.write_text(level.replace('"z": 5', '"z": 5.25'))
        self.assertNotEqual(self.level.read_text(), level)
        other = self.bake_part(2, 2)
        self.level.write_text(level)
        self.assert_refused([good, other], "2-2.part was baked for other geometry than the level has now")

    def test_parts_of_another_number(self):
        self.assert_refused([self.bake_part(1, 2), self.bake_part(2, 3)],
                            "2-3.part is part 2/3, but others are of 2")

    def test_parts_that_differ(self):
        paths = [self.bake_part(part, 2) for part in (1, 2)]
        other = self.folder / "other.part"
        bytes = bytearray(paths[0].read_bytes())
        # Another sum, and the checksum that belongs to it.
        bytes[-9] ^= 1
        bytes[-4:] = zlib.crc32(bytes[:-4]).to_bytes(4, "little")
        other.write_bytes(bytes)
        self.assert_refused([*paths, other], "1-2.part and ", "other.part are both part 1/2, and differ")

    def test_cut_short_altered_and_foreign_files(self):
        paths = [self.bake_part(part, 2) for part in (1, 2)]
        bytes = paths[1].read_bytes()
        for damaged, says in [(bytes[:-20], "is cut short"), (bytes[:99] + b"?" + bytes[100:], "was altered"),
                              (b"a text", "is no part of a bake"), (b"", "is cut short")]:
            paths[1].write_bytes(damaged)
            self.assert_refused(paths, "2-2.part " + says, "--shard K/N")
        paths[1].unlink()
        self.assert_refused(paths, "2-2.part")

    def test_another_part_is_not_written_over(self):
        path = self.bake_part(1, 2)
        before = path.read_bytes()
        done = self.hearth("--shard", "2/2", "-o", path)
        self.assertEqual(done.returncode, 2)
        self.assertIn("1-2.part is part 1/2 of this bake: give part 2/2 a file of its own", done.stderr)
        self.assertEqual(path.read_bytes(), before)

    def test_command_lines_that_say_no_part(self):
        for arguments, says in [(["--shard", "3/2", "-o", "x.part"], '"3/2" is no K/N'),
                                (["--shard", "0/2", "-o", "x.part"], '"0/2" is no K/N'),
                                (["--shard", "1", "-o", "x.part"], '"1" is no K/N'),
                                (["--shard", "1/2"], "give the part a file with -o X.part"),
                                (["--shard", "1/2", "-o", "x.bake"], "a part of a bake is written as a .part"),
                                (["--join", "a.part", "-o", "x.part"], "light is written as a .bake"),
                                (["--join", "a.part", "--shard", "1/2", "-o", "x.part"], "not both"),
                                (["--time-budget", "1", "--shard", "1/2", "-o", "x.part"], "not both"),
                                (["--join"], "--join")]:
            done = self.hearth(*arguments)
            self.assertEqual(done.returncode, 2, arguments)
            self.assertIn(says, done.stderr)
            self.assertEqual([path.name for path in self.folder.glob("x.*")], [])


class Killed(PartsTest):
    options = ["--texel", "0.1", "--samples", "16", "--threads", "1"]

    def test_a_hundred_kills_cost_no_finished_part(self):
        chance = random.Random(7)
        parts = 8
        begin = time.monotonic()
        self.bake_part(1, parts, "timed.part")
        seconds = time.monotonic() - begin
        finished = {}
        kills = 0
        while kills < 100 or len(finished) < parts:
            # A scheduler runs parts in any order, finished ones too.
            part = chance.randint(1, parts)
            path = self.folder / f"{part}.part"
            bake = subprocess.Popen([HEARTH, "bake", self.level, *self.options, "--shard", f"{part}/{parts}",
                                     "-o", path], cwd=self.folder, stdout=subprocess.PIPE,
                                    stderr=subprocess.PIPE, text=True)
            # At the end no more is killed, so that it ends.
            wait = chance.uniform(0, 1.2 * seconds) if kills < 100 else None
            try:
                printed, errors = bake.communicate(timeout=wait)
            except subprocess.TimeoutExpired:
                bake.kill()
                bake.communicate()
                kills += 1
                printed = None
            if part in finished:
                self.assertEqual(path.stat().st_mtime_ns, finished[part], "a finished part is baked again")
            elif printed is None:
                # Killed between the rename and the end, it is finished.
                if path.exists():
                    finished[part] = path.stat().st_mtime_ns
            else:
                self.assertEqual(bake.returncode, 0, errors)
                self.assertIsNotNone(re.match(rf"part      {part} of {parts}\n", printed), printed)
                finished[part] = path.stat().st_mtime_ns
            if kills < 100 and len(finished) == parts:
                # Lost with a node: all but one.
                for lost in list(finished)[1:]:
                    (self.folder / f"{lost}.part").unlink()
                    del finished[lost]
        self.assert_whole([self.folder / f"{part}.part" for part in finished])


if __name__ == "__main__":
    HEARTH = sys.argv[1]
    SOURCE = Path(sys.argv[2])
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
