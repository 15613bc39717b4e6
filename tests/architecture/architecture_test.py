"""Holds the source tree to its own rules: layers, writable globals, sizes.

usage: architecture_test.py SOURCE_DIR ARCHIVE... [-- TEST...]
"""

import json
import re
import subprocess
import sys
import unittest
from pathlib import Path

# What each folder of engine/ and tools/ may include of the others: all of it, nothing is inherited.
LAYERS = {
    "math": [],
    "files": [],
    "image": ["files", "math"],
    "level": ["math"],
    "load": ["level", "image", "files", "math"],
    "light": ["level", "math"],
    "render": ["level", "light", "image", "math"],
    "truth": ["level", "image", "math"],
    "walk": ["level", "math"],
}
ENGINE = list(LAYERS)
LAYERS |= {
    "textures": ["image", "math"],
    "folders": [],
    "settings": ["image", "level", "light", "load", "math", "render"],
    "text": ["image", "load", "math"],
    "model": ["files", "image", "level", "load", "math", "render"],
    "inputs": ["folders", "model", "settings", "text", "files", "image", "level", "light", "load", "math", "render"],
    "lint": ["level", "light", "load", "math", "walk"],
    "import": ["folders", "text", "files", "image", "level", "load", "math"],
    "measure": ["settings", "text", "files", "image", "level", "light", "load", "math", "render", "truth"],
    "viewer": ["model", "settings", "text", *ENGINE],
    "cli": ["folders", "import", "lint", "measure", "inputs", "model", "settings", "text", "viewer", *ENGINE],
    "desktop": ["cli", "folders", "measure", "inputs", "model", "settings", "text", "viewer", *ENGINE],
    "peers": ["cli", "desktop", "folders", "import", "measure", "inputs", "settings", "viewer", *ENGINE],
}
# Of tools/, what is not a library of the program.
PROGRAMS = ["package", "levels", "models"]

# Who may see the libraries that are not ours. A header passes on what it includes, so those named
# *.cpp here are kept to the inside of their folder.
OUTSIDERS = {
    r"SDL.*": ["tools/desktop/*", "tests/tools/walk/window_test.cpp",
               "tests/tools/walk/sdl_events_test.cpp"],
    r"CLI/.*": ["tools/*/*.cpp", "tests/*/*.cpp"],
    r"nlohmann/json\.hpp": ["engine/load/json/*.cpp", "tools/*/*.cpp", "tests/*/*.cpp"],
    r"nlohmann/json_fwd\.hpp": ["tools/*/*.h"],  # parts of a tool hand JSON to one another
    r"imgui/.*": ["tools/viewer/overlay/*.cpp", "tools/viewer/overlay/imgui_values.h", "tests/*/*"],
    r"stb/.*": ["engine/image/*.cpp", "tools/*/*.cpp"],
    r"zlib\.h": ["engine/image/*.cpp", "engine/light/*.cpp", "tests/*/*.cpp"],
    r"hwy/.*": ["engine/light/*/*_kernels.cpp", "engine/light/*/*-inl.h", "engine/render/*.cpp", "engine/render/*-inl.h",
                "tests/*/*.cpp"],
    r"embree.*": ["tools/peers/embree.*", "tests/*/*"],
    r"GL/.*": ["tools/peers/llvmpipe.cpp"],
    r"gtest/.*|gmock/.*|rapidcheck.*": ["tests/*/*"],
}

# The C library's transcendental functions pick other code on other processors, so the engine has
# its own (engine/math/trig.h). Square root, fmod and rounding are exact by IEEE 754.
INEXACT = r"\bstd::(a?sinh?|a?cosh?|a?tanh?|atan2|exp2?|expm1|log(2|10|1p)?|pow|hypot|cbrt)\s*\("

# stb_image_write's tables lack a `const`; nothing writes them.
ALLOWED_GLOBALS = {"mapping", "firstmap"}

# The viewer reaches the machine only through viewer/host, so that it can run where there is no
# operating system: names of files are values there, and no call goes to the disk, a thread or a clock.
VIEWER = "tools/viewer"
SYSTEM_HEADERS = (r"SDL.*|condition_variable|mutex|shared_mutex|semaphore|thread|stop_token|future|atomic|"
                  r"chrono|ctime|time\.h|cstdio|stdio\.h|fstream|iostream|unistd\.h|fcntl\.h|sys/.*|"
                  r"files/replace_file\.h|image/image_file\.h")
SYSTEM_CALLS = (r"\b(std::filesystem|fs)::(?!path\b)\w+"
                r"|\b(readFile|replaceFile|createFile|readImage|writePng|createPng|loadLevel\w*)\s*\("
                r"|\bstd::(getenv|system|async|this_thread|ofstream|ifstream)\b")

MAX_FUNCTION_LINES = 80
MAX_FILE_LINES = 500

SOURCE = Path()
ARCHIVES = []


def sources(*folders):
    for folder in folders:
        for path in sorted((SOURCE / folder).rglob("*")):
            if path.suffix in (".h", ".cpp"):
                yield path.relative_to(SOURCE)


def code_lines(path):
    """Numbered lines without their // comments."""
    for number, line in enumerate((SOURCE / path).read_text().splitlines(), 1):
        yield number, re.sub(r"//.*", "", line)


def includes(path):
    for number, line in code_lines(path):
        match = re.match(r'\s*#\s*include\s*[<"]([^>"]+)[>"]', line)
        if match:
            yield number, match[1]


class Architecture(unittest.TestCase):
    def expect_none(self, offences):
        self.assertEqual(len(offences), 0, "\n" + "\n".join(offences))

    def test_every_folder_is_in_the_table_of_layers(self):
        folders = {path.name for root in ("engine", "tools") for path in (SOURCE / root).iterdir()
                   if path.is_dir()}
        self.assertEqual(folders - set(PROGRAMS), set(LAYERS))

    def test_no_layer_includes_one_that_includes_it(self):
        for folder, below in LAYERS.items():
            for other in below:
                self.assertNotIn(folder, LAYERS[other], other)

    def test_layers_include_only_what_lies_below_them(self):
        offences = []
        for path in sources("engine", "tools"):
            folder = path.parts[1]
            if folder in PROGRAMS:
                continue
            for number, name in includes(path):
                target = name.split("/")[0]
                if target in LAYERS and "/" in name and target not in [folder, *LAYERS[folder]]:
                    offences.append(f"{path}:{number}: {folder} must not include {name}")
        self.expect_none(offences)

    def test_folders_of_a_library_include_one_another_in_one_direction(self):
        """Its own files, which every folder may use and which use every folder, do not count."""
        below = {}
        for path in sources("engine", "tools"):
            for number, name in includes(path):
                target = Path(path.parts[0], name).parent
                if path.parts[1] == name.split("/")[0] and len(target.parts) > 2:
                    below.setdefault(path.parent, set()).add(target)
        below = {folder: targets for folder, targets in below.items() if len(folder.parts) > 2}
        self.assertGreater(len(below), 10)
        self.expect_none([f"{folder} includes {target}, which includes it"
                          for folder in sorted(below) for target in sorted(below[folder] - {folder})
                          if folder in reachable(below, target)])

    def test_headers_of_the_project_are_included_by_folder_and_name(self):
        offences = []
        for path in sources("engine", "tools"):
            for number, name in includes(path):
                if name.startswith(".") or (SOURCE / path.parent / name).exists():
                    offences.append(f"{path}:{number}: write the folder of {name}")
        self.expect_none(offences)

    def test_libraries_of_others_are_seen_only_where_they_are_used(self):
        offences = []
        for path in sources("engine", "tools", "tests"):
            for number, name in includes(path):
                for library, places in OUTSIDERS.items():
                    allowed = any(path.match(place) or path.match(place.replace("*/*", "*/*/*"))
                                  for place in places)
                    if re.fullmatch(library, name) and not allowed:
                        offences.append(f"{path}:{number}: {name} belongs to {', '.join(places)}")
        self.expect_none(offences)

    def test_the_engine_computes_the_same_on_every_processor(self):
        offences = [f"{path}:{number}: {match[0]} is not exact"
                    for path in sources("engine")
                    for number, line in code_lines(path)
                    if (match := re.search(INEXACT, line))]
        self.expect_none(offences)

    def test_the_viewer_reaches_the_machine_only_through_its_host(self):
        offences = [f"{path}:{number}: {name} is for tools/desktop"
                    for path in sources(VIEWER)
                    for number, name in includes(path) if re.fullmatch(SYSTEM_HEADERS, name)]
        offences += [f"{path}:{number}: {match[0]} is for tools/desktop"
                     for path in sources(VIEWER)
                     for number, line in code_lines(path) if (match := re.search(SYSTEM_CALLS, line))]
        self.expect_none(offences)

    def test_the_engine_has_no_writable_globals(self):
        self.assertTrue(ARCHIVES)
        offences = []
        for archive in ARCHIVES:
            table = subprocess.run(["objdump", "-t", "-C", archive], capture_output=True, text=True,
                                   check=True).stdout
            for line in table.splitlines():
                # address, flags, section, size, name: `0...0 l O .bss 0...4 frameCount`
                match = re.match(r"[0-9a-f]+ .{7} (\.\S+)\t([0-9a-f]+) +(.*)", line)
                if match and is_writable(match[1]) and int(match[2], 16) > 0:
                    name = match[3].removeprefix(".hidden ")
                    if name.split("::")[-1] not in ALLOWED_GLOBALS and not name.startswith("DW.ref."):
                        offences.append(f"{Path(archive).name}: {name} in {match[1]}")
        self.expect_none(offences)

    def test_names_in_unnamed_namespaces_are_unique_within_a_library(self):
        """Files of a library may be compiled as one (CMAKE_UNITY_BUILD)."""
        offences = []
        for library in sorted(path for root in ("engine", "tools")
                              for path in (SOURCE / root).iterdir() if path.name in LAYERS):
            if library.name == "textures":  # each image has parts of the same names; see its CMakeLists.txt
                continue
            places = {}
            for tag in ctags([path for path in library.rglob("*.cpp") if path.name != "main.cpp"]):
                if not tag.get("scope", "").split("::")[-1].startswith("__anon"):
                    continue
                if tag["kind"] == "alias" or tag["kind"] == "typedef":
                    continue  # the same twice is no mistake, and another one does not compile
                key = tag["name"] + (tag.get("signature", "") if tag["kind"] == "function" else "")
                places.setdefault(key, set()).add(tag["path"])
            offences += [f"{name}: {', '.join(sorted(paths))}"
                         for name, paths in sorted(places.items()) if len(paths) > 1]
        self.expect_none(offences)

    def test_a_type_or_constant_of_the_project_has_a_name_of_its_own(self):
        """Two definitions in one program are not told by the linker; it takes either for both."""
        places = {}
        for tag in ctags(SOURCE / path for path in sources("engine", "tools") if path.parts[1] != "textures"):
            if tag.get("scope") == "hearth" and tag["kind"] in ("class", "enum", "struct", "union", "variable"):
                places.setdefault(tag["name"], set()).add(tag["path"])
        self.assertGreater(len(places), 100, "ctags must have found them")
        self.expect_none([f"{name}: {', '.join(sorted(paths))}"
                          for name, paths in sorted(places.items()) if len(paths) > 1])

    def test_functions_fit_on_a_page(self):
        lengths = [(tag["end"] - tag["line"] + 1, f"{tag['path']}:{tag['line']}: {tag['name']}")
                   for tag in ctags(SOURCE / path for path in sources("engine", "tools"))
                   if tag["kind"] == "function" and "end" in tag]
        self.assertGreater(len(lengths), 100, "ctags must have found the functions")
        self.expect_none([f"{place} has {length} lines" for length, place in lengths
                          if length > MAX_FUNCTION_LINES])

    def test_files_stay_readable(self):
        self.expect_none([f"{path} has {length} lines" for path in sources("engine", "tools")
                          if (length := (SOURCE / path).read_text().count("\n")) > MAX_FILE_LINES])


def reachable(targets, start):
    """What a graph leads to from there."""
    found, left = set(), [start]
    while left:
        for target in targets.get(left.pop(), ()):
            if target not in found:
                found.add(target)
                left.append(target)
    return found


def ctags(paths):
    """Functions, variables and types of C++ files, as ctags finds them."""
    output = subprocess.run(
        ["ctags", "--language-force=C++", "--kinds-C++=fvscgut", "--fields=+nesSK", "--extras=-q",
         "--output-format=json", "-o", "-", *map(str, paths)],
        capture_output=True, text=True, check=True).stdout
    return [json.loads(line) for line in output.splitlines()]


def is_writable(section):
    """Data that is only written while the program is linked (.data.rel.ro) is constant."""
    return re.match(r"\.(t?data|t?bss)\b", section) and not section.startswith(".data.rel.ro")


class TheRulesThemselves(unittest.TestCase):
    """That the checks above see what they look for."""

    def test_sections(self):
        for section in [".data", ".bss", ".tbss", ".data.rel.local", ".bss._ZN6hearth5countE"]:
            self.assertTrue(is_writable(section), section)
        for section in [".data.rel.ro", ".data.rel.ro.local", ".rodata", ".text"]:
            self.assertFalse(is_writable(section), section)

    def test_inexact_functions(self):
        for line in ["x = std::sin(y);", "std::pow (a, b)", "std::atan2(a, b)"]:
            self.assertTrue(re.search(INEXACT, line), line)
        for line in ["std::sqrt(x)", "std::fmod(x, y)", "sinCosDegrees(x)", "std::log_like(x)"]:
            self.assertFalse(re.search(INEXACT, line), line)

    def test_system_headers_and_calls(self):
        for name in ["SDL_events.h", "thread", "mutex", "fstream", "chrono", "sys/resource.h", "files/replace_file.h"]:
            self.assertTrue(re.fullmatch(SYSTEM_HEADERS, name), name)
        for name in ["filesystem", "functional", "files/read_file.h", "image/image.h"]:
            self.assertFalse(re.fullmatch(SYSTEM_HEADERS, name), name)
        for line in ["if (fs::exists(file))", "std::filesystem::create_directories(folder);", "readFile(path, 9)",
                     "std::async(work)"]:
            self.assertTrue(re.search(SYSTEM_CALLS, line), line)
        for line in ["const std::filesystem::path& file", "fs::path file", "storage.read(file, 9)",
                     "namespace fs = std::filesystem;"]:
            self.assertFalse(re.search(SYSTEM_CALLS, line), line)


if __name__ == "__main__":
    arguments = sys.argv[1:]
    end = arguments.index("--") if "--" in arguments else len(arguments)
    SOURCE, ARCHIVES = Path(arguments[0]), arguments[1:end]
    unittest.main(argv=sys.argv[:1] + arguments[end + 1:])
