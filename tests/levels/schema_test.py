"""Holds the schemas of level and lights files against the loader: what editors check by them is what
the program takes.

usage: schema_test.py HEARTH SOURCE_DIR
"""

import copy
import json
import random
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import jsonschema

HEARTH = ""
SOURCE = Path()

# Files of tests/load/bad with a mistake that no schema can tell, as it lies in how parts fit
# together, in geometry, in other files or in what a JSON parser makes of the text.
BEYOND_SCHEMAS = frozenset("""
    bake_samples ceiling_below_floor closed_door_without_texture flat_missing flat_portal_ring
    flat_without_texture
    grid_beside_its_hall grid_blank_shows grid_ceiling_below_floor grid_character_is_a_comment
    grid_character_unknown grid_ends_in_air grid_flat_without_texture grid_next_unknown grid_rows_ragged
    grid_sector_of_a_taken_name grid_step_without_texture grid_texture_missing
    grid_texture_missing_in_an_unused_entry grid_too_far grid_without_air
    interface_areas_differ interface_heights_differ interface_members_overlap
    interface_members_overlap_by_a_corner interface_unknown_sector interface_without_lower_side
    json_duplicate_key json_duplicate_sector light_above_a_ceiling light_curve_falls
    light_in_another_sector light_in_two_sectors light_outside lights_file_missing loop_closed_twice
    loop_crosses_itself loop_is_a_bow_tie loop_is_hardly_wider_than_noise loop_leaves_the_border
    loop_leaves_the_border_where_it_touches loop_odd_coordinates loop_repeats_a_vertex
    loop_repeats_an_earlier_vertex loop_spike loop_too_few_walls loop_too_many_walls loop_touches_itself
    loop_without_area loops_are_equal loops_cross loops_leave_no_area loops_nest
    loops_nest_where_they_touch loops_of_one_name mesh_above_the_ceiling mesh_broken_twice
    mesh_file_missing mesh_file_missing_far mesh_image_broken mesh_image_missing
    mesh_image_without_extension mesh_in_line
    mesh_is_a_folder mesh_materials_missing mesh_of_an_unknown_sector mesh_of_an_unknown_vertex
    mesh_of_nan mesh_outside mesh_texture_missing mesh_too_far mesh_too_small mesh_without_faces
    mover_below_the_floor mover_of_a_flat_that_moves mover_of_a_slope mover_of_sky mover_sector_unknown
    mover_shows_a_step_without_texture mover_starts_at_two_heights mover_takes_air_from_a_shot
    mover_takes_air_from_a_thing mover_takes_height_from_a_stack mover_unknown_at_a_wall
    mover_unknown_in_a_shot movers_show_a_step_without_texture
    next_unknown_but_there next_unknown_far
    next_unknown_near next_unknown_near_its_own player_eye_above_the_body player_in_a_slope
    player_in_another_sector player_of_an_unknown_sector player_outside
    portal_five_centimetres_off_along_the_wall portal_misses_a_vertex portal_of_a_turned_loop
    portal_off_the_wall portal_on_the_wrong_wall portal_to_the_wrong_sector portal_to_the_wrong_side
    portal_two_millimetres_off sectors_of_one_name sectors_of_one_name_referred_to
    shot_above_the_ceiling shot_in_two_sectors shots_of_one_name sidewall_without_texture
    sky_without_texture slope_in_line slope_in_line_of_three slope_is_no_plane
    slope_null_below_the_floor slope_of_three_heights slope_passes_the_ceiling slopes_pass_each_other
    spot_inner_beyond_outer
    sprite_image_broken sprite_image_missing sprite_image_with_a_scale sprite_image_with_extension
    sprite_outside_its_sector sprite_view_missing
    switch_in_a_stack_that_leads_nowhere switch_of_a_texture_that_it_has_not
    switch_with_a_missing_image
    stack_z_above_the_ceiling stack_z_does_not_rise stack_z_missing stack_z_on_the_last
    step_down_without_texture step_in_a_stack_without_texture step_up_without_texture
    texture_broken_image texture_meant_for_a_colour texture_missing_far texture_missing_near
    texture_missing_twice texture_of_2_to_the_31_pixels texture_scale_zero texture_too_large
    texture_with_extension texture_with_extension_misspelled textures_folder_missing
    thing_above_the_ceiling thing_below_the_floor thing_in_another_sector thing_in_two_sectors
    thing_in_two_sectors_without_z thing_of_an_unknown_sector thing_outside thing_outside_with_z
""".split())


def schema(name):
    validator = jsonschema.Draft202012Validator(json.loads((SOURCE / f"levels/{name}.schema.json").read_text()))
    validator.check_schema(validator.schema)
    return validator


def refuse(constant):
    raise ValueError(constant)


def parsed(path):
    """What the file holds; none where it is no JSON (Python takes NaN, which is none)."""
    try:
        return json.loads(path.read_bytes().decode(), parse_constant=refuse)
    except ValueError:
        return None


def lights_of(level):
    return level.with_name(level.stem + ".lights.json")


class Schemas(unittest.TestCase):
    def setUp(self):
        self.level = schema("level")
        self.lights = schema("lights")

    def takes(self, level):
        """Whether the schemas take a level's files."""
        files = [(self.level, level)]
        if lights_of(level).exists():
            files.append((self.lights, lights_of(level)))
        values = [(validator, parsed(path)) for validator, path in files]
        return all(value is not None and validator.is_valid(value) for validator, value in values)

    def test_take_the_good_files(self):
        levels = [path for folder in ("levels", "tests/levels") for path in (SOURCE / folder).glob("*.json")
                  if not path.name.endswith((".lights.json", ".schema.json"))]
        self.assertGreater(len(levels), 2)
        for level in levels:
            with self.subTest(level=level.name):
                self.assertTrue(self.takes(level))

    def test_take_of_the_bad_files_those_whose_mistake_they_cannot_tell(self):
        taken = set()
        for expected in (SOURCE / "tests/load/bad").glob("*.expected"):
            if self.takes(expected.with_suffix(".json")) and ": error: " in expected.read_text():
                taken.add(expected.stem)
        self.assertEqual(taken, BEYOND_SCHEMAS)

    def test_refuse_nothing_that_loads(self):
        for expected in (SOURCE / "tests/load/bad").glob("*.expected"):
            if ": error: " not in expected.read_text():  # but a warning
                with self.subTest(level=expected.stem):
                    self.assertTrue(self.takes(expected.with_suffix(".json")))

    def test_describe_every_key(self):
        for validator in self.level, self.lights:
            for key, value in keys_of(validator.schema):
                with self.subTest(key=key):
                    self.assertTrue(value.get("description") or value.get("$ref") in PARTS, value)
                    shown = {"default", "examples", "oneOf", "items", "properties"} & set(value)
                    self.assertTrue(shown or value.get("$ref") in PARTS, value)


# Definitions of objects and lists, which have descriptions and examples of their own.
PARTS = {f"#/$defs/{name}" for name in
         ("version", "player", "shot", "flat", "slope", "texture", "flatTexture", "middle", "on",
          "lights", "emit", "bake")}


def keys_of(value):
    """The properties that a schema describes, wherever they are."""
    if isinstance(value, dict):
        for key, child in value.get("properties", {}).items():
            if isinstance(child, dict) and "const" not in child and child != {"$ref": "#/$defs/solidFlat"}:
                yield key, child
        for child in value.values():
            yield from keys_of(child)
    elif isinstance(value, list):
        for child in value:
            yield from keys_of(child)


def places_in(value, path=()):
    """Paths of everything in a JSON value."""
    yield path
    children = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, child in children:
        if not str(key).startswith(("$", "//")):
            yield from places_in(child, path + (key,))


def at(value, path):
    for key in path:
        value = value[key]
    return value


class Changes(unittest.TestCase):
    """Of a good level that is changed at random, the loader refuses whatever the schemas refuse."""

    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name)
        self.good = {"level": json.loads((SOURCE / "tests/levels/rooms.json").read_text()),
                     "lights": json.loads((SOURCE / "tests/levels/rooms.lights.json").read_text())}
        self.good["level"]["things"] = [
            {"name": "lamp", "sprite": "#ffd0a0", "x": 2, "y": 2, "z": 1, "sector": "hall", "angle": 90,
             "facing": "angle", "size": [0.2, 0.3], "offset": [0, 0.1], "bright": True},
            {"frames": [["#ff8040", "#c06030"], "#ffa060"], "fps": 4, "x": 1, "y": 2, "radius": 0.2, "height": 0.5},
            {"name": "tent", "mesh": "tent.obj", "x": 2, "y": 1, "z": 0.5, "sector": "hall", "angle": 30,
             "scale": [1, 0.5, 1], "texture": "#c0a080", "twoSided": True, "solid": False, "shadow": False},
            {"mesh": "tent.obj", "x": 1, "y": 1, "scale": 0.5}]
        (self.folder / "tent.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 1\nf 1 2 3\n")
        self.schemas = {"level": schema("level"), "lights": schema("lights")}

    def load(self, changed):
        """Of levels, by their names, those that load. In one run: most of its time is the start."""
        levels = {}
        for name, files in changed.items():
            level = self.folder / f"{name}.json"
            level.write_text(json.dumps(files["level"]))
            lights_of(level).write_text(json.dumps(files["lights"]))
            levels[name] = level
        result = subprocess.run([HEARTH, "check", *levels.values(), "--update", "--no-cache", "--texel", "1"],
                                capture_output=True, text=True)
        wrong = {place.removesuffix(".lights") for place in
                 re.findall(rf"^{self.folder}/([^/]+)\.json:\d+:\d+: error: ", result.stderr, re.MULTILINE)}
        self.assertEqual(result.returncode, 2 if wrong else 0, result.stderr)
        self.assertLessEqual(wrong, set(levels))
        return set(levels) - wrong

    def change(self, files, generator):
        """Changes one place, and says how."""
        which = generator.choice(["level", "lights"])
        value = files[which]
        path = generator.choice([path for path in places_in(value) if path])
        parent = at(value, path[:-1])
        kind = generator.choice(["type", "unknown key", "gone", "number"])
        if kind == "unknown key" and isinstance(parent, dict):
            parent["bogus"] = 1
        elif kind == "gone" and isinstance(parent, dict):
            del parent[path[-1]]
        elif kind == "number" and isinstance(parent[path[-1]], (int, float)):
            parent[path[-1]] = generator.choice([-1, -1e-9, 0, 2, 1e8, 1e40])
        else:
            kind = "type"
            others = [other for other in ({}, [], "x", True, None, 3.5)
                      if type(other) is not type(parent[path[-1]])]
            parent[path[-1]] = generator.choice(others)
        return f"{kind} at {which} {path}: {json.dumps(parent)[:200]}"

    def test_of_a_good_level_are_refused_by_the_loader_where_a_schema_refuses_them(self):
        self.assertTrue(self.load({"good": self.good}))
        refused, how = {}, {}
        for seed in range(160):
            files = copy.deepcopy(self.good)
            what = self.change(files, random.Random(seed))
            if all(self.schemas[name].is_valid(value) for name, value in files.items()):
                continue
            refused[f"level{seed}"] = files
            how[f"level{seed}"] = what
        self.assertGreater(len(refused), 80)
        self.assertEqual([how[name] for name in self.load(refused)], [])

    def test_that_only_misspell_a_key_or_type_are_refused_by_a_schema_where_the_loader_refuses_them(self):
        misspelt, how = {}, {}
        for seed in range(160):
            files = copy.deepcopy(self.good)
            what = self.change(files, random.Random(seed))
            if what.startswith("unknown key"):
                misspelt[f"level{seed}"] = files
                how[f"level{seed}"] = what
        for name in set(misspelt) - self.load(misspelt):
            valid = all(self.schemas[which].is_valid(value) for which, value in misspelt[name].items())
            self.assertFalse(valid, how[name])


if __name__ == "__main__":
    HEARTH, SOURCE = sys.argv[1], Path(sys.argv[2])
    unittest.main(argv=sys.argv[:1])
