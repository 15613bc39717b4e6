"""Holds what `cmake --install` and `cpack` leave to what it promises: a program and a library that need
nothing of the folders that they were built in.

usage: install_test.py BUILD_DIR SOURCE_DIR COMPILER [GROUP]
"""

import gzip
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

# No bakes of other runs are found, and none are left.
os.environ["XDG_CACHE_HOME"] = os.devnull
os.environ["XDG_CONFIG_HOME"] = os.environ["XDG_STATE_HOME"] = os.devnull

BUILD, SOURCE, COMPILER = Path(), Path(), ""


def run(*command, **options):
    result = subprocess.run(list(map(str, command)), capture_output=True, text=True, **options)
    if result.returncode != 0:
        raise AssertionError(f"{command}: status {result.returncode}\n{result.stdout}{result.stderr}")
    return result.stdout


class Installed(unittest.TestCase):
    """What is installed, in a folder of its own."""

    @classmethod
    def setUpClass(cls):
        scratch = tempfile.TemporaryDirectory()
        cls.addClassCleanup(scratch.cleanup)
        cls.folder = Path(scratch.name)
        cls.prefix = cls.folder / "prefix"
        run("cmake", "--install", BUILD, "--prefix", cls.prefix)
        cls.hearth = cls.prefix / "bin/hearth"
        cls.level = cls.prefix / "share/hearth/levels/tutorial.json"

    def files(self, pattern):
        found = sorted(path for path in self.prefix.rglob(pattern) if path.is_file())
        self.assertTrue(found, pattern)
        return found


class Library(Installed):
    def build(self, source, flags=""):
        """The folder in which a project that uses the installed engine was built."""
        build = self.folder / (source.name + "-build")
        run("cmake", "-S", source, "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
            "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON", f"-DCMAKE_CXX_COMPILER={COMPILER}",
            f"-DCMAKE_CXX_FLAGS={flags}", f"-DCMAKE_PREFIX_PATH={self.prefix}")
        run("cmake", "--build", build)
        return build

    def build_example(self):
        source = self.folder / "example"
        shutil.copytree(self.prefix / "share/doc/hearth/example", source, dirs_exist_ok=True)
        return self.build(source)

    def test_the_example_draws_what_the_program_draws(self):
        example = self.build_example() / "example"
        shot = json.loads(self.level.read_text())["shots"][0]["name"]
        pictures = [self.folder / "example.png", self.folder / "program.png"]
        run(example, self.level, pictures[0], cwd=self.folder)
        run(self.hearth, "shot", self.level, "--shot", shot, "-o", pictures[1], cwd=self.folder)
        self.assertEqual(*(picture.read_bytes() for picture in pictures))

    def test_the_readme_shows_lines_of_the_example(self):
        shown = re.search(r"```cpp\n(.*?)```", (SOURCE / "README.md").read_text(), re.DOTALL)[1]
        example = (self.prefix / "share/doc/hearth/example/example.cpp").read_text().splitlines()
        lines = iter(example)
        self.assertTrue(all(line in lines for line in shown.splitlines()), "all, and in this order")

    def test_the_example_is_built_without_our_warnings_and_folders(self):
        commands = (self.build_example() / "compile_commands.json").read_text()
        self.assertNotRegex(commands, " -W")
        for folder in [BUILD, SOURCE]:
            self.assertFalse(f"{folder}/" in commands, commands)

    def test_public_headers_include_only_public_headers(self):
        root = self.prefix / "include/hearth"
        included = [(header, name) for header in self.files("include/hearth/*/*.h")
                    for name in re.findall(r'#\s*include\s*"(.*)"', header.read_text())]
        self.assertTrue(included)
        for header, name in included:
            self.assertTrue((root / name).exists(), f"{header.relative_to(root)} includes {name}")
        others = {name for header in self.files("include/hearth/*/*.h")
                  for name in re.findall(r"#\s*include\s*<(.*[/.].*)>", header.read_text())}
        self.assertEqual(others, {"tl/expected.hpp"}, "beside the standard library's")

    def test_inline_code_is_not_contracted_in_programs_for_newer_processors(self):
        source = self.folder / "inline"
        source.mkdir()
        code = source / "inline.cpp"
        code.write_text('#include "math/vec.h"\n'
                        "double product(hearth::Vec2 a, hearth::Vec2 b) { return dot(a, b); }\n")
        (source / "CMakeLists.txt").write_text(
            "cmake_minimum_required(VERSION 3.25)\nproject(inline LANGUAGES CXX)\n"
            "find_package(hearth REQUIRED)\nadd_library(inline STATIC inline.cpp)\n"
            "target_link_libraries(inline PRIVATE hearth::engine)\n")
        fused = r"\bvfn?m"
        self.assertNotRegex(run("objdump", "-d", self.build(source, "-mfma") / "libinline.a"), fused)
        contracted = self.folder / "contracted.o"
        run(COMPILER, "-std=c++20", "-O2", "-mfma", "-ffp-contract=fast",
            f"-I{self.prefix}/include/hearth", "-c", code, "-o", contracted)
        self.assertRegex(run("objdump", "-d", contracted), fused, "it would be, without the engine's option")


class Program(Installed):
    def test_no_file_names_the_folders_it_was_built_in(self):
        for path in self.files("*"):
            for folder in [BUILD, SOURCE]:
                self.assertFalse(f"{folder}/".encode() in path.read_bytes(), f"{path} names {folder}")

    def test_the_guides_link_to_files_that_are_installed(self):
        links = [(guide, link) for guide in self.files("*.md")
                 for link in re.findall(r"\]\(([^)#:]+)(?:#[^)]*)?\)", guide.read_text())]
        self.assertTrue(links)
        for guide, link in links:
            self.assertTrue((guide.parent / link).exists(), f"{guide.name} links to {link}")

    def test_every_level_is_there_with_its_lights_and_textures(self):
        levels = {path.name for path in (SOURCE / "levels").glob("*.json")}
        self.assertEqual({path.name for path in self.files("share/hearth/levels/*.json")}, levels)
        for path in self.files("share/hearth/levels/*.json"):
            if (path.parent / (path.stem + ".lights.json")).exists():
                out = self.folder / "out.png"
                run(self.hearth, "shot", path, "--size", "64x40", "--texel", "1", "-o", out)

    def test_walks_an_installed_level(self):
        recording = SOURCE / "tests/walk_tour/tutorial-on-foot.txt"
        run(self.hearth, "walk", self.level, "--replay", recording, "--headless", cwd=self.folder)


class Manual(Installed):
    def setUp(self):
        self.page = self.prefix / "share/man/man1/hearth.1"
        self.text = self.page.read_text().replace("\\-", "-").replace("\\%", "")

    def commands(self):
        """Every command with its options, from the program's help."""
        names = re.findall(r"^  ([a-z]+)  ", run(self.hearth, "--help"), re.MULTILINE)
        self.assertIn("walk", names)
        return {name: set(re.findall(r"^  (-o|--[a-z-]+)", run(self.hearth, name, "--help"), re.MULTILINE))
                for name in names}

    def test_has_every_command_with_its_options(self):
        for name, options in self.commands().items():
            takes = re.search(rf"^\.B hearth {name} .*\n.*\nTakes (.*)\.$", self.text, re.MULTILINE)
            self.assertTrue(takes, name)
            taken = set() if takes[1] == "no options" else set(takes[1].split(", "))
            self.assertEqual(taken, options, name)

    def test_has_every_option_with_its_commands(self):
        takers = {}
        for name, options in self.commands().items():
            for option in options:
                takers.setdefault(option, set()).add(name)
        described = re.findall(r"^\.B (-\S+) .*\n.*\n\((.*)\)$", self.text, re.MULTILINE)
        self.assertEqual({option: set(names.split(", ")) for option, names in described}, takers)

    def test_groff_finds_no_fault(self):
        faults = subprocess.run(["groff", "-man", "-ww", "-Tutf8", "-z", self.page],
                                capture_output=True, text=True)
        self.assertEqual((faults.returncode, faults.stderr), (0, ""))


class Package(unittest.TestCase):
    """Debian's packages, unpacked."""

    @classmethod
    def setUpClass(cls):
        scratch = tempfile.TemporaryDirectory()
        cls.addClassCleanup(scratch.cleanup)
        cls.folder = Path(scratch.name)
        run("cpack", "-G", "DEB", "-B", cls.folder / "packages", cwd=BUILD, umask=0o077)
        cls.packages = {path.name.split("_")[0]: path for path in (cls.folder / "packages").glob("*.deb")}
        for package in cls.packages.values():
            run("dpkg-deb", "-x", package, cls.folder)

    def field(self, package, name):
        return run("dpkg-deb", "--field", self.packages[package], name).strip()

    def test_are_the_program_and_the_library(self):
        self.assertEqual(set(self.packages), {"hearth", "libhearth-dev"})
        self.assertEqual(self.field("hearth", "Section"), "games")
        self.assertEqual(self.field("libhearth-dev", "Section"), "libdevel")

    def test_may_be_read_by_all_whoever_packed_them(self):
        for package in self.packages.values():
            modes = {line.split()[0] for line in run("dpkg-deb", "-c", package).splitlines()}
            self.assertLessEqual(modes, {"drwxr-xr-x", "-rw-r--r--", "-rwxr-xr-x"})

    def test_depend_on_the_libraries_that_they_need(self):
        depends = self.field("hearth", "Depends")
        for library in ["libc6 (>=", "libstdc++6 (>=", "libsdl2-2.0-0 (>=", "libfmt9 (>=", "libhwy1 (>=", "zlib1g (>="]:
            self.assertIn(library, depends)
        self.assertEqual(self.field("libhearth-dev", "Depends"), "libexpected-dev, libfmt-dev, libhwy-dev, zlib1g-dev")

    def test_are_of_the_version_that_the_changelog_begins_with(self):
        for package in self.packages:
            changelog = gzip.open(self.folder / "usr/share/doc" / package / "changelog.gz", "rt").read()
            self.assertTrue(changelog.startswith(f"hearth ({self.field(package, 'Version')}) "), package)

    def test_have_the_licence_and_a_compressed_manual(self):
        licence = (SOURCE / "LICENSE").read_text()
        for package in self.packages:
            copyright_file = self.folder / "usr/share/doc" / package / "copyright"
            self.assertEqual(copyright_file.read_text(), licence)
        self.assertIn(".TH HEARTH 1", gzip.open(self.folder / "usr/share/man/man1/hearth.1.gz", "rt").read())

    def test_the_packaged_program_draws_the_packaged_level_as_the_build_does(self):
        pictures = [self.folder / "packaged.png", self.folder / "built.png"]
        run(self.folder / "usr/bin/hearth", "shot", self.folder / "usr/share/hearth/levels/tutorial.json",
            "-o", pictures[0], cwd=self.folder)
        run(BUILD / "hearth", "shot", SOURCE / "levels/tutorial.json", "-o", pictures[1])
        self.assertEqual(*(picture.read_bytes() for picture in pictures))


if __name__ == "__main__":
    BUILD, SOURCE = (Path(folder).resolve() for folder in sys.argv[1:3])
    COMPILER = sys.argv[3]
    unittest.main(argv=sys.argv[:1] + sys.argv[4:])
