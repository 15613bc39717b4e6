"""Holds `hearth` to what it promises when disks are full, folders missing, programs killed or files
changed: what it writes is whole or not there, and what was there before stays.

usage: faults_test.py HEARTH SOURCE_DIR [GROUP]
"""

import hashlib
import json
import os
import random
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest
from pathlib import Path

HEARTH = ""
SOURCE = Path()

# The command of each file that is written, {} its name; all but `new` replace what is there.
BAKE = ["--texel", "0.5", "--no-cache"]
WRITERS = {
    "shot.png": ["shot", "level.json", "-o", "{}", *BAKE],
    "light.bake": ["bake", "level.json", "-o", "{}", "--texel", "0.5"],
    "half.part": ["bake", "level.json", "--shard", "1/2", "-o", "{}", "--texel", "0.5"],
    "light.png": ["bake", "level.json", "-o", "{}", "--texel", "0.5"],
    "plan.svg": ["map", "level.json", "-o", "{}"],
    "other.json": ["fmt", "level.json", "-o", "{}"],
    "level.golden/ramp.png": ["check", "level.json", "--update", *BAKE],
    "check.html": ["check", "level.json", "--report", "{}", *BAKE],
    # The coarsest of a small level: its subject is the page.
    "settings.html": ["tradeoff", "cell.json", "--report", "{}", "--size", "8x5", "--repeats", "1",
                      "--texel", "1", "--pixel-size", "64"],
}
CELL = {"shots": [{"name": "cell", "camera": [0.2, 0.2, 0.6, 45, 0]}], "sectors": {"cell": {
    "floor": {"z": 0, "texture": "#808080"}, "ceiling": {"z": 1, "texture": "#808080"},
    "loops": {"border": {"v": [0, 0, 1, 0, 1, 1, 0, 1], "walls": {"texture": "#808080"}}}}}}
OLD = b"what was there before"


def command(name):
    return [HEARTH, *(part.replace("{}", name) for part in WRITERS[name])]


def digest(path):
    return hashlib.sha256(path.read_bytes()).digest()


def no_more_than(size, action):
    """For a child: files of at most so many bytes. `action` on SIGXFSZ: ignored, writing fails as on
    a full disk; by default it kills in the middle of writing."""
    def limit():
        resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))
        signal.signal(signal.SIGXFSZ, action)
    return limit


class InFolder(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name)
        self.environment = {**os.environ, "XDG_CACHE_HOME": os.devnull,
                            "XDG_CONFIG_HOME": os.devnull, "XDG_STATE_HOME": os.devnull}
        self.level = self.folder / "level.json"
        shutil.copy(SOURCE / "tests/levels/rooms.json", self.level)
        shutil.copy(SOURCE / "tests/levels/rooms.lights.json", self.folder / "level.lights.json")
        (self.folder / "cell.json").write_text(json.dumps(CELL))
        (self.folder / "cell.lights.json").write_text('[{"x": 0.7, "y": 0.5, "z": 0.5}]')
        (self.folder / "level.golden").mkdir()
        self.given = self.files()

    def files(self):
        """All below the folder, by their paths from it."""
        return {str(path.relative_to(self.folder)): path.read_bytes()
                for path in sorted(self.folder.rglob("*")) if path.is_file()}

    def run_here(self, words, **options):
        options = {"env": self.environment, "stdout": subprocess.PIPE, **options}
        return subprocess.run(words, cwd=self.folder, stderr=subprocess.PIPE, text=True, **options)

    def hearth(self, *arguments, **options):
        return self.run_here([HEARTH, *map(str, arguments)], **options)

    def clear(self):
        """Back to what setUp() left."""
        for name in set(self.files()) - set(self.given):
            (self.folder / name).unlink()

    def refused(self, result, message):
        self.assertEqual(result.returncode, 2, result.stderr)
        last = result.stderr.splitlines()[-1]  # `tradeoff` tells its progress before
        self.assertRegex(last, message)
        self.assertNotIn("terminate", result.stderr)


class CannotWrite(InFolder):
    def test_a_full_disk_leaves_what_was_there(self):
        for name in WRITERS:
            for size in (0, 100):
                with self.subTest(name=name, size=size):
                    self.clear()
                    (self.folder / name).write_bytes(OLD)
                    before = self.files()
                    result = self.run_here(command(name),
                                           preexec_fn=no_more_than(size, signal.SIG_IGN))
                    self.refused(result, f"hearth: error: .*{name}: cannot be written: File too large")
                    after = self.files()
                    self.assertEqual({file: after[file] for file in before}, before)
                    self.assertFalse([file for file in after if file.endswith(".tmp")])

    def test_a_folder_that_is_missing_or_a_file(self):
        for place, reason in (("missing", "No such file or directory"),
                              ("level.json", "Not a directory")):
            for name in WRITERS:
                if "/" in name:  # its folder is made
                    continue
                with self.subTest(name=name, place=place):
                    self.clear()
                    words = [word.replace(name, f"{place}/{name}") for word in command(name)]
                    self.refused(self.run_here(words),
                                 f"hearth: error: {place}/{name}: cannot be written: {reason}")
                    self.assertEqual(self.level.read_bytes(), self.given["level.json"])
        self.refused(self.hearth("check", "level.json", "--update", "--golden", "level.json", *BAKE),
                     "hearth: error: level.json/level.golden: cannot be made: Not a directory")

    def test_a_folder_in_place_of_the_file(self):
        for name in WRITERS:
            with self.subTest(name=name):
                self.clear()
                (self.folder / name).mkdir()
                self.refused(self.run_here(command(name)),
                             f"hearth: error: .*{name}: is not a regular file")
                self.assertTrue((self.folder / name).is_dir())
                (self.folder / name).rmdir()

    def test_a_folder_that_may_not_be_written(self):
        nobody = 65534
        user = {"user": nobody, "group": nobody, "extra_groups": []} if os.geteuid() == 0 else {}
        for folder in (self.folder / "level.golden", self.folder):
            folder.chmod(0o555)
            self.addCleanup(folder.chmod, 0o755)
        try:
            self.hearth("--help", **user)
        except PermissionError:
            self.skipTest("the program lies where other users may not look")
        for name in WRITERS:
            with self.subTest(name=name):
                self.refused(self.run_here(command(name), **user),
                             f"hearth: error: .*{name}: cannot be written: Permission denied")
        self.refused(self.hearth("new", "castle", **user),
                     "castle.lights.json: cannot be written: Permission denied")
        self.assertEqual(self.files(), self.given)

    def test_a_level_that_is_laid_out_in_place_stays(self):
        self.level.write_text('{"sectors":{}}')
        result = self.hearth("fmt", "level.json", preexec_fn=no_more_than(5, signal.SIG_IGN))
        self.refused(result, "level.json: cannot be written: File too large")
        self.assertEqual(self.level.read_text(), '{"sectors":{}}')

    def test_nothing_is_left_of_a_new_level(self):
        for size in (0, 100, 1000):  # the lights have fewer bytes than that, the level more
            with self.subTest(size=size):
                result = self.hearth("new", "castle", preexec_fn=no_more_than(size, signal.SIG_IGN))
                self.refused(result, r"castle(\.lights)?\.json: cannot be written: File too large")
                self.assertEqual(self.files(), self.given)

    def test_what_is_printed_for_nobody(self):
        for words in (["bench", "level.json", "--json", "--repeats", "1"], ["info", "level.json"],
                      ["info", "level.json", "--json", "--surfaces"], ["bake", "level.json"],
                      ["fmt", "level.json", "-o", "-"], ["fmt", "level.json", "--check"],
                      ["tradeoff", "--list"], ["tradeoff", "--list", "--csv"], ["--help"]):
            with self.subTest(words=words), open("/dev/full", "w") as full:
                self.refused(self.hearth(*words, stdout=full),
                             "hearth: error: .*cannot (write|be written)")

    def test_a_cache_that_cannot_be_written_is_passed_over(self):
        cache = self.folder / "cache"
        self.environment["XDG_CACHE_HOME"] = str(cache)
        fitting = len(self.shot_bytes("--no-cache"))
        result = self.hearth("shot", "level.json", "-o", "out.png", "--texel", "0.02",
                             preexec_fn=no_more_than(2 * fitting, signal.SIG_IGN))
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertEqual([name for name in self.files() if name.startswith("cache/")], [])

    def shot_bytes(self, *options):
        result = self.hearth("shot", "level.json", "-o", "out.png", *options)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return (self.folder / "out.png").read_bytes()


class Killed(InFolder):
    def expect_old_or(self, new, name):
        """Returns whether it is the new one. Nothing else may be left but what is being written."""
        after = self.files()
        self.assertIn(after[name], (OLD, new))
        added = set(after) - set(self.given) - {name}
        added = {file for file in added if not file.startswith("level.failed/")}
        self.assertLessEqual(added, {f"{name}.tmp"})
        return after[name] == new

    def new_of(self, name):
        """What the command writes over OLD, and how long it takes."""
        (self.folder / name).write_bytes(OLD)
        start = time.monotonic()
        result = self.run_here(command(name))
        seconds = time.monotonic() - start
        self.assertIn(result.returncode, (0, 1), result.stderr)
        return (self.folder / name).read_bytes(), seconds

    def test_in_the_middle_of_writing_leaves_the_old_file(self):
        for name in WRITERS:
            with self.subTest(name=name):
                self.clear()
                new, _ = self.new_of(name)
                (self.folder / name).write_bytes(OLD)
                result = self.run_here(command(name),
                                       preexec_fn=no_more_than(100, signal.SIG_DFL))
                self.assertEqual(result.returncode, -signal.SIGXFSZ)
                self.assertFalse(self.expect_old_or(new, name))
                # What was left is in nobody's way.
                again, _ = self.new_of(name)
                self.assertFalse([file for file in self.files() if file.endswith(".tmp")])
                if name != "settings.html":  # it has times in it
                    self.assertEqual(again, new)

    def test_at_any_time_leaves_the_old_file_or_the_new_one(self):
        moments = random.Random(20)
        for name in WRITERS:
            if name in ("settings.html", "check.html"):  # take longer, or say what was there before
                continue
            with self.subTest(name=name):
                self.clear()
                new, seconds = self.new_of(name)
                for _ in range(8):
                    (self.folder / name).write_bytes(OLD)
                    process = subprocess.Popen(command(name), cwd=self.folder, env=self.environment,
                                               stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
                    time.sleep(moments.uniform(0.5, 1.2) * seconds)
                    process.kill()
                    process.wait()
                    self.expect_old_or(new, name)

    def test_while_a_check_explains_leaves_nothing_that_stays(self):
        golden = self.folder / "level.golden/ramp.png"
        check = ["check", "level.json", *BAKE]
        self.assertEqual(self.hearth(*check, "--update").returncode, 0)
        kept = golden.read_bytes()
        self.assertEqual(self.hearth("check", "level.json", "--no-cache").returncode, 1)
        failed = self.folder / "level.failed"
        pages = {path.name for path in failed.iterdir()}
        self.assertGreater(len(pages), 3)
        for size in (0, 400, 2000, (failed / "report.html").stat().st_size - 1):
            result = self.hearth("check", "level.json", "--no-cache",
                                 preexec_fn=no_more_than(size, signal.SIG_DFL))
            self.assertEqual(result.returncode, -signal.SIGXFSZ)
            self.assertLess({path.name for path in failed.iterdir()},
                            pages | {page + ".tmp" for page in pages})
        self.assertEqual(self.hearth(*check).returncode, 0)
        self.assertFalse(failed.exists())
        self.assertEqual(golden.read_bytes(), kept)

    def test_a_new_level_is_whole_or_not_there(self):
        moments = random.Random(21)
        self.assertEqual(self.hearth("new", "castle").returncode, 0)
        whole = {name: data for name, data in self.files().items() if name.startswith("castle")}
        for _ in range(20):
            self.clear()
            process = subprocess.Popen([HEARTH, "new", "castle"], cwd=self.folder,
                                       stdout=subprocess.DEVNULL)
            time.sleep(moments.uniform(0, 0.02))
            process.kill()
            process.wait()
            left = {name: data for name, data in self.files().items()
                    if name.startswith("castle") and not name.endswith(".tmp")}
            self.assertLessEqual(left.items(), whole.items())
            # With a level there are its lights.
            self.assertIn(len(left), (0, 2) if "castle.json" in left else (0, 1))

    def test_a_bake_that_was_half_kept_is_baked_again(self):
        cache = self.folder / "cache"
        self.environment["XDG_CACHE_HOME"] = str(cache)
        draw = ["shot", "level.json", "-o", "shot.png", "--texel", "0.1"]
        self.assertEqual(self.hearth(*draw, "--no-cache").returncode, 0)
        picture = (self.folder / "shot.png").read_bytes()
        moments = random.Random(22)
        for _ in range(8):
            shutil.rmtree(cache, ignore_errors=True)
            process = subprocess.Popen([HEARTH, *draw], cwd=self.folder, env=self.environment)
            time.sleep(moments.uniform(0, 0.1))
            process.kill()
            process.wait()
            result = self.hearth(*draw)
            self.assertEqual((result.returncode, result.stderr), (0, ""))
            self.assertEqual((self.folder / "shot.png").read_bytes(), picture)


class Walk(InFolder):
    """Recordings, of walks on a display that is none."""

    def setUp(self):
        super().setUp()
        self.environment |= {"SDL_VIDEODRIVER": "dummy", "SDL_AUDIODRIVER": "dummy"}
        self.walk = [HEARTH, "walk", "level.json", "--record", "walk.txt", *BAKE]
        self.recording = self.folder / "walk.txt"
        self.recording.write_bytes(OLD)

    def end_of(self, signal_number, moment):
        """Walks until the recording is begun and for a moment more, then gives the signal."""
        process = subprocess.Popen(self.walk, cwd=self.folder, env=self.environment)
        self.addCleanup(process.kill)
        while self.recording.read_bytes() == OLD and process.poll() is None:
            time.sleep(0.005)
        time.sleep(moment)
        process.send_signal(signal_number)
        process.wait(20)
        return process.returncode

    def expect_whole(self):
        self.assertEqual(self.hearth("walk", "level.json", "--replay", "walk.txt",
                                     "--headless").returncode, 0)

    def test_a_full_disk_is_told_before_the_walk(self):
        result = self.run_here(self.walk, preexec_fn=no_more_than(20, signal.SIG_IGN), timeout=20)
        self.refused(result, "walk.txt: cannot be written: File too large")
        self.assertEqual(self.recording.read_bytes(), OLD)

    def test_that_is_asked_to_end_keeps_its_recording(self):
        self.assertEqual(self.end_of(signal.SIGTERM, 0.2), 0)
        self.expect_whole()

    def test_that_is_killed_leaves_a_whole_recording(self):
        moments = random.Random(23)
        for _ in range(5):
            self.recording.write_bytes(OLD)
            self.assertEqual(self.end_of(signal.SIGKILL, moments.uniform(0, 0.1)), -signal.SIGKILL)
            self.expect_whole()


class AtOnce(InFolder):
    def test_writers_of_one_file_wait_for_one_another(self):
        name = "light.bake"
        sizes = ["0.5", "0.1"]
        whole = []
        for texel in sizes:
            words = [texel if word == "0.5" else word for word in command(name)]
            self.assertEqual(self.run_here(words).returncode, 0)
            whole.append((self.folder / name).read_bytes())
        for _ in range(5):
            writers = [subprocess.Popen([sizes[i % 2] if word == "0.5" else word
                                         for word in command(name)],
                                        cwd=self.folder, stdout=subprocess.DEVNULL)
                       for i in range(6)]
            while any(writer.poll() is None for writer in writers):
                self.assertIn((self.folder / name).read_bytes(), whole)
            self.assertEqual([writer.returncode for writer in writers], [0] * len(writers))
            self.assertEqual(set(self.files()) - set(self.given), {name})


class ChangedWhileRead(InFolder):
    """A level that another program writes again and again, now with one room's name, now with
    another's and some hundred bytes more."""

    def setUp(self):
        super().setUp()
        text = self.level.read_text()
        self.texts = [text, text.replace('"rooms"', '"other"').replace(
            '"light"', '"//": "' + "more " * 200 + '", "light"', 1).replace("#a08060", "#60a080")]
        self.truths = []
        for text in self.texts:
            self.level.write_text(text)
            self.truths.append(self.seen())
            self.assertIsInstance(self.truths[-1][1], bytes)
        for a, b in zip(*self.truths):
            self.assertNotEqual(a, b)

    def seen(self):
        """What two commands make of the level; for each, a message where there is one."""
        info = self.hearth("info", "level.json", "--json", "--texel", "1")
        shot = self.hearth("shot", "level.json", "-o", "shot.png", "--camera", "2,2,1.5,0",
                           "--size", "64x40", *BAKE)
        features = json.loads(info.stdout) if info.returncode == 0 else info.stderr
        if info.returncode == 0:
            features = (features["name"], str(features["features"]))
        picture = digest(self.folder / "shot.png") if shot.returncode == 0 else shot.stderr
        for result in (info, shot):
            self.assertIn(result.returncode, (0, 2), result.stderr)
        return features, picture

    def run_beside(self, write, rounds):
        """What the commands have seen while `write` wrote."""
        is_over = threading.Event()

        def change():
            while not is_over.is_set():
                for text in self.texts:
                    write(text)
                    time.sleep(0.0005)

        writer = threading.Thread(target=change)
        writer.start()
        try:
            return [self.seen() for _ in range(rounds)]
        finally:
            is_over.set()
            writer.join()

    def test_by_renaming_shows_one_or_the_other(self):
        def rename(text):
            other = self.folder / "level.new"
            other.write_text(text)
            other.rename(self.level)

        for features, picture in self.run_beside(rename, 20):
            self.assertIn(features, [truth[0] for truth in self.truths])
            self.assertIn(picture, [truth[1] for truth in self.truths])

    def test_in_place_shows_one_or_the_other_or_says_what_is_wrong(self):
        for seen in self.run_beside(self.level.write_text, 20):
            for part, truth in zip(seen, zip(*self.truths)):
                if isinstance(part, str):
                    self.assertRegex(part, r"^level\.json:\d+:\d+: error: ("
                                           "was changed while it was read|not valid JSON)")
                else:
                    self.assertIn(part, truth)


if __name__ == "__main__":
    HEARTH, SOURCE = sys.argv[1], Path(sys.argv[2])
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
