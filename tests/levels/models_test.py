"""Holds levels/models to what its generator writes, and that to what models are to be: closed surfaces
that face outwards, on the ground, in images of the tree, and listed in the guide.

usage: models_test.py SOURCE_DIR
"""

import collections
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SOURCE = Path()


class Model:
    """The points of an OBJ file, and its faces as numbers of points."""

    def __init__(self, path):
        self.name = path.stem
        lines = [line.split() for line in path.read_text().splitlines()]
        self.points = [tuple(map(float, words[1:])) for words in lines if words[0] == "v"]
        self.faces = [[int(corner.split("/")[0]) - 1 for corner in words[1:]] for words in lines if words[0] == "f"]
        self.materials = {words[1] for words in lines if words[0] == "usemtl"}

    def edges(self):
        """How often each edge is walked, in the sense in which faces run."""
        return collections.Counter((face[i - 1], face[i]) for face in self.faces for i in range(len(face)))

    def shells(self):
        """The faces of each connected part."""
        part = list(range(len(self.points)))

        def find(i):
            while part[i] != i:
                part[i] = i = part[part[i]]
            return i

        for face in self.faces:
            for corner in face[1:]:
                part[find(corner)] = find(face[0])
        shells = collections.defaultdict(list)
        for face in self.faces:
            shells[find(face[0])].append(face)
        return list(shells.values())

    def volume(self, faces):
        """In cubic metres; negative if the faces look inwards."""
        six = 0
        for face in faces:
            (ax, ay, az), *others = (self.points[corner] for corner in face)
            for (bx, by, bz), (cx, cy, cz) in zip(others, others[1:]):
                six += ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx)
        return six / 6


class Models(unittest.TestCase):
    def models(self):
        paths = sorted((SOURCE / "levels/models").glob("*.obj"))
        self.assertTrue(paths)
        return [Model(path) for path in paths]

    def test_are_what_their_generator_writes(self):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([sys.executable, "-B", SOURCE / "tools/models/models.py", folder], check=True)
            written = {path.name: path.read_bytes() for path in Path(folder).iterdir()}
        kept = {path.name: path.read_bytes() for path in (SOURCE / "levels/models").iterdir()}
        self.assertEqual(set(written), set(kept), "run tools/models/models.py, and remove what it does not write")
        for name in written:
            self.assertTrue(written[name] == kept[name], f"{name}: run tools/models/models.py")

    def test_are_closed(self):
        for model in self.models():
            edges = model.edges()
            open_ones = [edge for edge, count in edges.items() if count != 1 or edges[edge[::-1]] != 1]
            self.assertEqual(open_ones, [], model.name)

    def test_face_outwards(self):
        for model in self.models():
            for shell in model.shells():
                self.assertGreater(model.volume(shell), 0, model.name)

    def test_stand_on_the_ground_about_their_origin(self):
        for model in self.models():
            lowest, highest = (tuple(map(pick, zip(*model.points))) for pick in (min, max))
            self.assertGreaterEqual(lowest[1], 0, model.name)
            self.assertLess(lowest[1], 0.005, model.name)
            for axis in (0, 2):
                self.assertLessEqual(lowest[axis], 0, model.name)
                self.assertGreaterEqual(highest[axis], 0, model.name)

    def test_wear_each_material_of_their_library_and_no_other(self):
        worn = set().union(*(model.materials for model in self.models()))
        library = SOURCE / "levels/models/castle.mtl"
        self.assertEqual(worn, set(re.findall(r"newmtl (\S+)", library.read_text())))
        for image in re.findall(r"map_Kd (\S+)", library.read_text()):
            self.assertTrue((library.parent / image).exists(), image)

    def test_are_listed_with_their_sizes_and_triangles(self):
        guide = (SOURCE / "levels/README.md").read_text()
        row = r"^\| `(\S+)` \| .* \| ([\d.]+) x ([\d.]+) x ([\d.]+) \| ([\d,]+) \|$"
        listed = re.findall(row, guide, re.MULTILINE)
        of_models = []
        for model in self.models():
            x, z, y = (f"{max(values) - min(values):.2f}" for values in zip(*model.points))
            triangles = sum(len(face) - 2 for face in model.faces)
            of_models.append((model.name, x, y, z, f"{triangles:,}"))
        self.assertEqual(listed, of_models)


if __name__ == "__main__":
    SOURCE = Path(sys.argv[1])
    unittest.main(argv=sys.argv[:1])
