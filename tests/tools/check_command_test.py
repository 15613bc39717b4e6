"""Holds `hearth check` to what it promises: what it sees, says, writes and leaves alone.

usage: check_command_test.py HEARTH GROUP
"""

import base64
import json
import os
import re
import resource
import shlex
import signal
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib
from html.parser import HTMLParser
from pathlib import Path

# No bakes of other runs are found, and none are left.
os.environ["XDG_CACHE_HOME"] = os.devnull
os.environ["XDG_CONFIG_HOME"] = os.environ["XDG_STATE_HOME"] = os.devnull

HEARTH = ""
PNG_START = b"\x89PNG\r\n\x1a\n"


def write_png(path, rows):
    """`rows` are bytes of RGB, one row each."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", len(rows[0]) // 3, len(rows), 8, 2, 0, 0, 0)
    packed = zlib.compress(b"".join(b"\0" + bytes(row) for row in rows))
    path.write_bytes(PNG_START + chunk(b"IHDR", header) + chunk(b"IDAT", packed) + chunk(b"IEND", b""))


def read_png(path):
    """The rows of an RGB picture of 8 bits."""
    data, at, packed = path.read_bytes(), 8, b""
    assert data[:8] == PNG_START
    width, height = struct.unpack(">II", data[16:24])
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        if kind == b"IDAT":
            packed += data[at + 8:at + 8 + length]
        at += 12 + length
    raw, rows, above = zlib.decompress(packed), [], bytearray(3 * width)
    for y in range(height):
        begin = y * (3 * width + 1)
        kind, row = raw[begin], bytearray(raw[begin + 1:begin + 1 + 3 * width])
        for i in range(3 * width):
            a, b, c = (row[i - 3] if i > 2 else 0), above[i], (above[i - 3] if i > 2 else 0)
            paeth = min((a, b, c), key=lambda value: abs(a + b - c - value))
            row[i] = (row[i] + [0, a, b, (a + b) // 2, paeth][kind]) % 256
        rows.append(row)
        above = row
    return rows


def level_text(offset=0, shots=("north", "south")):
    """A room of 4 m whose northern wall has a texture; the others are white."""
    white = {"texture": "#ffffff"}
    angles = {"north": 90, "south": 270}
    return json.dumps({
        "textures": ".",
        "shots": [{"name": name, "camera": [2, 2, 1.5, angles.get(name, 0), 0], "size": [64, 40]}
                  for name in shots],
        "sectors": {"room": {
            "floor": {"z": 0, **white}, "ceiling": {"z": 3, **white},
            "loops": {"border": {"v": [0, 0, 4, 0, 4, 4, 0, 4], "walls": [
                white, white, {"texture": f"noise 4,3 {offset},0"}, white]}}}}})


def lights_text(intensity):
    return json.dumps([{"x": 2, "y": 2, "z": 1.5, "intensity": intensity}])


class InFolder(unittest.TestCase):
    """A folder with one level whose pictures are kept."""

    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name)
        self.level = self.folder / "room.json"
        self.golden = self.folder / "room.golden"
        self.failed = self.folder / "room.failed"
        write_png(self.folder / "noise.png",
                  [bytes((x * 37 + y * 101 + c * 53) % 256 for x in range(16) for c in range(3))
                   for y in range(16)])
        self.write_level()
        self.assertEqual(self.check("--update").returncode, 0)

    def write_level(self, name="room", intensity=100, **changes):
        (self.folder / f"{name}.lights.json").write_text(lights_text(intensity))
        (self.folder / f"{name}.json").write_text(level_text(**changes))
        return self.folder / f"{name}.json"

    def check(self, *options, levels=None, **how):
        return subprocess.run([HEARTH, "check", *map(str, levels or [self.level]), *map(str, options)],
                              capture_output=True, text=True, cwd=self.folder, **how)

    def files(self):
        """Everything below the folder, with its bytes."""
        return {str(path.relative_to(self.folder)): path.read_bytes() if path.is_file() else None
                for path in self.folder.rglob("*")}

    def change_pixel(self, name, levels):
        rows = read_png(self.golden / f"{name}.png")
        rows[30][3 * 20 + 1] ^= levels
        write_png(self.golden / f"{name}.png", rows)

    def expect_failure(self, message, *options):
        """Status 1, and not a byte of the golden pictures changed."""
        before = {name: data for name, data in self.files().items() if ".golden" in name}
        result = self.check(*options)
        self.assertEqual((result.returncode, result.stderr), (1, ""), result.stdout)
        self.assertRegex(result.stdout, message)
        self.assertEqual({name: data for name, data in self.files().items() if ".golden" in name},
                         before)
        return result.stdout


class Differences(InFolder):
    def test_nothing_differs_in_one_line_and_writes_nothing(self):
        before = self.files()
        result = self.check()
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertEqual(result.stdout, f"{self.level}: 2 as kept\n")
        self.assertEqual(self.files(), before)

    def test_one_wrong_pixel(self):
        self.change_pixel("north", 1)
        self.expect_failure(
            r"room\.json: north: 1 of 2560 pixels differ, 0 by more than 2 levels, 0 by more than 8; "
            r"largest difference 1 of 255, largest patch 1 pixel")
        self.assertEqual(sorted(path.name for path in self.failed.iterdir()),
                         ["north.actual.png", "north.difference.png", "north.expected.png",
                          "report.html"])
        lit = [(x, y) for y, row in enumerate(read_png(self.failed / "north.difference.png"))
               for x in range(64) if any(row[3 * x:3 * x + 3])]
        self.assertEqual(lit, [(20, 30)])

    def test_a_texture_shifted_by_one_texel(self):
        self.write_level(offset=1)
        output = self.expect_failure(r"north: \d+ of 2560 pixels differ")
        self.assertIn("1 as kept, 1 not", output)

    def test_three_levels_of_brightness(self):
        self.write_level(intensity=103)
        self.expect_failure(r"south: 2560 of 2560 pixels differ, 2560 by more than 2 levels, 0 by "
                            r"more than 8; largest difference 3 of 255, largest patch 2560 pixel")

    def test_a_missing_golden(self):
        (self.golden / "south.png").unlink()
        self.expect_failure(r"south: there is no .*room\.golden/south\.png")
        self.assertEqual(sorted(path.name for path in self.failed.iterdir()),
                         ["report.html", "south.actual.png"])

    def test_no_golden_at_all(self):
        for path in self.golden.iterdir():
            path.unlink()
        self.golden.rmdir()
        output = self.expect_failure("north: there is no .*north.png, --update makes it\n")
        self.assertIn("0 as kept, 2 not", output)
        [command] = re.findall("^    (.*)$", output, re.MULTILINE)  # which makes both
        self.assertEqual(shlex.split(command), [HEARTH, "check", str(self.level), "--update"])
        self.assertFalse(self.golden.exists())

    def test_a_golden_without_a_shot(self):
        self.write_level(shots=["north"])
        self.expect_failure(r"south: no shot draws .*room\.golden/south\.png")
        self.assertEqual(sorted(path.name for path in self.failed.iterdir()),
                         ["report.html", "south.expected.png"])

    def test_a_golden_of_another_size(self):
        write_png(self.golden / "south.png", [bytes(3 * 40)] * 64)
        self.expect_failure(r"south: .*south\.png has 40x64 pixels, the shot 64x40")

    def test_a_damaged_golden(self):
        file = self.golden / "south.png"
        file.write_bytes(file.read_bytes()[:-30])
        self.expect_failure(r"south: .*south\.png: is damaged")

    def test_a_light_that_is_baked_otherwise(self):
        self.assertEqual(self.check("--texel", "0.125", "--no-lambert").returncode, 0)
        self.expect_failure("south: .* pixels differ", "--lambert")

    def test_the_printed_command_draws_the_actual_picture(self):
        name = "it's -o \"<b>&\" $HOME é"
        self.write_level(shots=[name])
        self.check("--update")
        output = self.expect_failure("differ", "--texel", "0.3", "--lambert")
        command = shlex.split(next(line for line in output.splitlines() if " shot " in line))
        subprocess.run(command, cwd=self.folder, check=True)
        self.assertEqual((self.folder / f"{name}.png").read_bytes(),
                         (self.failed / f"{name}.actual.png").read_bytes())

    def test_the_printed_command_accepts(self):
        output = self.expect_failure("differ", "--lambert", "--texel", "0.3")
        command = shlex.split(next(line for line in output.splitlines() if "--update" in line))
        subprocess.run(command, cwd=self.folder, check=True, capture_output=True)
        self.assertEqual(self.check("--lambert", "--texel", "0.3").returncode, 0)

    def test_a_later_check_takes_away_its_own_files_only(self):
        self.change_pixel("north", 4)
        self.expect_failure("north")
        (self.failed / "notes.txt").write_text("mine")
        self.assertEqual(self.check("--update").returncode, 0)
        self.assertEqual([path.name for path in self.failed.iterdir()], ["notes.txt"])
        (self.failed / "notes.txt").unlink()
        self.assertEqual(self.check().returncode, 0)
        self.assertFalse(self.failed.exists())

    def test_a_place_where_nothing_can_be_written_still_shows_the_figures(self):
        self.change_pixel("north", 4)
        self.failed.write_text("a file where the folder would be")
        result = self.check()
        self.assertEqual(result.returncode, 2)
        self.assertRegex(result.stderr, r"hearth: error: .*room\.failed.*\n$")
        self.assertRegex(result.stdout, "north: 1 of 2560 pixels differ")
        self.assertNotIn("look at", result.stdout)
        self.assertEqual(self.failed.read_text(), "a file where the folder would be")


class Update(InFolder):
    def test_says_what_changed_and_touches_nothing_else(self):
        self.write_level(shots=["north", "south", "east"])
        self.change_pixel("north", 8)
        (self.golden / "old.png").write_bytes((self.golden / "south.png").read_bytes())
        south = (self.golden / "south.png").stat()
        result = self.check("--update")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        north, south_line, east, old = result.stdout.splitlines()
        self.assertRegex(north, r"room\.json: north: changed: 1 of 2560 pixels differ, .* 8 of 255")
        self.assertRegex(south_line, r": south: unchanged$")
        self.assertRegex(east, r": east: new$")
        self.assertRegex(old, r": old: removed: no shot draws ")
        after = (self.golden / "south.png").stat()
        self.assertEqual((after.st_ino, after.st_mtime_ns), (south.st_ino, south.st_mtime_ns))
        self.assertEqual(sorted(path.name for path in self.golden.iterdir()),
                         ["east.png", "north.png", "south.png"])
        self.assertEqual(self.check().returncode, 0)

    def test_replaces_other_sizes_and_damaged_files(self):
        write_png(self.golden / "south.png", [bytes(3 * 40)] * 64)
        (self.golden / "north.png").write_bytes(b"no picture")
        self.assertEqual(self.check("--update").returncode, 0)
        self.assertEqual(self.check().returncode, 0)

    def limited(self, is_killed):
        """An update of changed pictures of which no more than 100 bytes can be written."""
        self.write_level(intensity=50)
        before = self.files()

        def limit():
            resource.setrlimit(resource.RLIMIT_FSIZE, (100, 100))
            signal.signal(signal.SIGXFSZ, signal.SIG_DFL if is_killed else signal.SIG_IGN)

        result = self.check("--update", preexec_fn=limit)
        after = self.files()
        self.assertEqual({name: after[name] for name in before}, before)
        return result, sorted(set(after) - set(before))

    def test_killed_while_writing_leaves_the_old_picture_whole(self):
        result, added = self.limited(is_killed=True)
        self.assertEqual(result.returncode, -signal.SIGXFSZ)
        self.assertEqual(added, ["room.golden/north.png.tmp"])
        self.assertEqual(self.check("--update").returncode, 0)
        self.assertEqual(sorted(path.name for path in self.golden.iterdir()),
                         ["north.png", "south.png"])

    def test_a_full_disk_leaves_the_old_picture_whole(self):
        result, added = self.limited(is_killed=False)
        self.assertEqual(result.returncode, 2)
        self.assertRegex(result.stderr, r"hearth: error: .*north\.png: cannot be written")
        self.assertEqual(added, [])

    def test_a_folder_that_cannot_be_made(self):
        (self.folder / "file").write_text("")
        result = self.check("--update", "--golden", self.folder / "file")
        self.assertEqual(result.returncode, 2)
        self.assertRegex(result.stderr, r"hearth: error: .*file/room\.golden: cannot be made")
        self.assertEqual((self.folder / "file").read_text(), "")


class Levels(InFolder):
    def test_several_are_checked_in_one_run(self):
        attic = self.write_level("attic")
        self.assertEqual(self.check("--update", levels=[self.level, attic]).returncode, 0)
        result = self.check(levels=[self.level, attic])
        self.assertEqual((result.returncode, result.stdout),
                         (0, f"{self.level}: 2 as kept\n{attic}: 2 as kept\n"))
        self.write_level("attic", intensity=90)
        result = self.check(levels=[attic, self.level])
        self.assertEqual(result.returncode, 1)
        self.assertIn(f"{self.level}: 2 as kept\n", result.stdout)
        self.assertTrue((self.folder / "attic.failed/report.html").exists())
        self.assertFalse(self.failed.exists())

    def test_a_bad_one_does_not_stop_the_others(self):
        self.change_pixel("north", 1)
        bad = self.folder / "bad.json"
        bad.write_text("{")
        for levels in [bad, self.level], [self.level, bad]:
            result = self.check("--report", self.folder / "all.html", levels=levels)
            self.assertEqual(result.returncode, 2)
            self.assertRegex(result.stderr, r"^.*bad\.json:\d+:\d+: error: ")
            self.assertIn("room.json: north: 1 of", result.stdout)
            page = (self.folder / "all.html").read_text()
            self.assertIn("could not be checked", page)
            self.assertIn("1 of 2560", page)

    def test_a_folder_of_golden_folders(self):
        attic = self.write_level("attic")
        kept = self.folder / "kept"
        for options in ["--update"], []:
            result = self.check("--golden", kept, *options, levels=[self.level, attic])
            self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(sorted(str(path.relative_to(kept)) for path in kept.rglob("*.png")),
                         ["attic.golden/north.png", "attic.golden/south.png",
                          "room.golden/north.png", "room.golden/south.png"])
        (kept / "attic.golden/north.png").unlink()
        self.assertEqual(self.check("--golden", kept, levels=[attic]).returncode, 1)
        self.assertTrue((kept / "attic.failed/report.html").exists())

    def test_two_that_would_share_their_pictures_are_refused(self):
        before = self.files()
        result = self.check("--update", levels=[self.level, "./room.json"])
        self.assertEqual(result.returncode, 2)
        self.assertRegex(result.stderr, r"room\.json would share .*room\.golden")
        self.assertEqual(self.files(), before)

    def test_lights_files_beside_their_levels_and_schemas_are_passed_over(self):
        attic = self.write_level("attic")
        (self.folder / "level.schema.json").write_text("{}")
        self.assertEqual(self.check("--update", levels=[attic]).returncode, 0)
        levels = sorted(self.folder.glob("*.json"))
        self.assertEqual(len(levels), 5)
        result = self.check(levels=levels)
        self.assertEqual((result.returncode, result.stderr), (0, ""))


class Refused(InFolder):
    """Status 2, a reason on stderr, and nothing written."""

    def refuse(self, message, *options, **how):
        before = self.files()
        for more in [], ["--update"]:
            result = self.check(*options, *more, **how)
            self.assertEqual((result.returncode, result.stdout), (2, ""), result.stderr)
            self.assertRegex(result.stderr, message)
            self.assertEqual(self.files(), before)

    def test_bad_usage(self):
        self.refuse("--samples.*square", "--samples", "8")
        self.refuse("not both", "--lambert", "--no-lambert")
        self.refuse("frobnicate", "--frobnicate")
        self.refuse("--report: .*html", "--report", self.level)
        result = subprocess.run([HEARTH, "check"], capture_output=True, text=True)
        self.assertEqual(result.returncode, 2)
        self.assertRegex(result.stderr, "LEVEL")

    def test_a_bad_level(self):
        self.level.write_text(level_text().replace('"sectors"', '"sektors"'))
        self.refuse(r"room\.json:\d+:\d+: error: .*sektors")
        self.refuse(r"room\.json:\d+:\d+: error: ", "--report", self.folder / "out.html")

    def test_a_level_without_shots_checks_nothing(self):
        self.write_level(shots=[])
        self.refuse(r"room\.json: .*no shots")

    def test_a_shot_that_would_leave_its_folder(self):
        for name in ["../room", "a/b", ".", ".hidden", "a\nb"]:
            with self.subTest(name=name):
                self.write_level(shots=["north", name])
                shown = re.escape(json.dumps(name))
                self.refuse(rf"^hearth: error: .*the shot {shown} cannot name a file.*\n$")


class PageParser(HTMLParser):
    VOID = {"meta", "img", "input"}

    def __init__(self, text):
        super().__init__(convert_charrefs=True)
        self.open, self.elements, self.words = [], [], ""
        self.feed(text)
        self.close()

    def handle_starttag(self, tag, attributes):
        self.elements.append((tag, dict(attributes)))
        if tag not in self.VOID:
            self.open.append(tag)

    def handle_endtag(self, tag):
        assert self.open.pop() == tag, tag

    def handle_data(self, data):
        self.words += data


class Page(InFolder):
    def setUp(self):
        super().setUp()
        self.page = self.folder / "out.html"

    def parse(self, path):
        text = path.read_text()
        self.assertTrue(text.startswith("<!DOCTYPE html>"))
        page = PageParser(text)
        self.assertEqual(page.open, [])
        return text, page

    def pictures(self, page):
        return [base64.b64decode(attributes["src"].removeprefix("data:image/png;base64,"), validate=True)
                for tag, attributes in page.elements if tag == "img"]

    def test_needs_no_other_file(self):
        self.change_pixel("north", 1)
        (self.golden / "old.png").write_bytes((self.golden / "south.png").read_bytes())
        self.check()
        text, page = self.parse(self.failed / "report.html")
        self.assertNotRegex(text, r"https?:|url\(|@import|//")
        for tag, attributes in page.elements:
            self.assertNotIn(tag, ["link", "script", "iframe", "object", "base"])
            self.assertNotIn("href", attributes)
            if "src" in attributes:
                self.assertTrue(attributes["src"].startswith("data:image/png;base64,"))

    def test_shows_expected_actual_and_difference_with_a_slider(self):
        self.change_pixel("north", 1)
        output = self.check().stdout
        text, page = self.parse(self.failed / "report.html")
        expected = [(self.failed / f"north.{kind}.png").read_bytes()
                    for kind in ["expected", "actual", "difference"]]
        self.assertEqual(self.pictures(page), expected + [(self.golden / "south.png").read_bytes()])
        self.assertEqual(expected[0], (self.golden / "north.png").read_bytes())
        sliders = [attributes for tag, attributes in page.elements if tag == "input"]
        self.assertEqual([slider["type"] for slider in sliders], ["range"])
        self.assertTrue(sliders[0]["aria-label"])
        self.assertIn("1 of 2560 pixels differ", page.words)
        for command in re.findall(r"^    (hearth .*)$", output, re.MULTILINE):
            self.assertIn(command, page.words)

    def test_goes_where_the_report_is_asked_for(self):
        self.change_pixel("north", 1)
        self.assertIn(f"look at {self.failed}/report.html\n", self.expect_failure("north"))
        self.assertIn(f"look at {self.page}\n", self.expect_failure("north", "--report", self.page))
        self.assertIn("1 of 2560", self.page.read_text())
        self.assertFalse((self.failed / "report.html").exists())

    def test_shows_the_shots_when_all_are_as_kept(self):
        result = self.check("--report", self.page)
        self.assertEqual((result.returncode, result.stdout), (0, f"{self.level}: 2 as kept\n"))
        _, page = self.parse(self.page)
        self.assertEqual(self.pictures(page), [(self.golden / f"{name}.png").read_bytes()
                                               for name in ["north", "south"]])
        self.assertFalse(self.failed.exists())

    def test_shows_what_was_accepted(self):
        self.write_level(shots=["north", "east"])
        self.assertEqual(self.check("--update", "--report", self.page).returncode, 0)
        _, page = self.parse(self.page)
        self.assertEqual(self.pictures(page), [(self.golden / f"{name}.png").read_bytes()
                                               for name in ["north", "east"]])
        self.assertIn("south: removed", page.words)

    def test_names_are_text_and_nothing_else(self):
        name = "<b onclick=x>&amp;\"'"
        self.write_level(shots=[name])
        self.check("--report", self.page)
        _, page = self.parse(self.page)
        self.assertNotIn("b", [tag for tag, _ in page.elements])
        self.assertIn(name, page.words)

    def test_that_cannot_be_written(self):
        result = self.check("--report", self.folder / "missing/out.html")
        self.assertEqual(result.returncode, 2)
        self.assertRegex(result.stderr, r"hearth: error: .*missing/out\.html: cannot be written")


if __name__ == "__main__":
    HEARTH = os.path.abspath(sys.argv[1])
    unittest.main(argv=sys.argv[:1] + sys.argv[2:])
