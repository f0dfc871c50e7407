"""embed: a surface's vertices in the tetrahedra of a mesh."""

import ast
import struct
import zipfile

from program import CUBE_POINTS, CUBE_TRIANGLES, ProgramTest, main, medit, off


def load(path):
    """What numpy.load does, for arrays of 8-byte numbers: rows by name."""
    arrays = {}
    with zipfile.ZipFile(path) as archive:
        assert archive.testzip() is None
        for name in archive.namelist():
            data = archive.read(name)
            assert data[:8] == b"\x93NUMPY\x01\x00"
            start = 10 + struct.unpack("<H", data[8:10])[0]
            assert start % 64 == 0
            head = ast.literal_eval(data[10:start].decode())
            rows, columns = (*head["shape"], 1)[:2]
            code = {"<f8": "d", "<i8": "q"}[head["descr"]]
            numbers = struct.unpack(f"<{rows * columns}{code}", data[start:])
            arrays[name.removesuffix(".npy")] = [numbers[i:i + columns] for i in range(0, len(numbers), columns)]
    return arrays


class Embed(ProgramTest):
    def test_a_surface_in_its_own_mesh(self):
        self.cube()
        self.succeed("mesh", "cube.off", "-o", "cube.mesh", "--size", "0.3")
        self.succeed("embed", "cube.off", "cube.mesh", "-o", "rig.npz")
        rig = load(self.folder / "rig.npz")
        self.assertEqual(rig["points"], CUBE_POINTS)
        self.assertEqual(rig["triangles"], CUBE_TRIANGLES)
        text = (self.folder / "cube.mesh").read_text().split()
        start = text.index("Vertices") + 2
        vertices = [tuple(map(float, text[start + 4 * i:start + 4 * i + 3])) for i in range(int(text[start - 1]))]
        for point, corners, weights in zip(CUBE_POINTS, rig["vertices"], rig["weights"]):
            self.assertAlmostEqual(sum(weights), 1, 14)
            self.assertGreaterEqual(min(weights), 0)
            for axis in range(3):
                self.assertAlmostEqual(sum(w * vertices[v][axis] for v, w in zip(corners, weights)), point[axis], 13)

    def test_vtu_holds_the_surface(self):
        self.cube()
        self.succeed("mesh", "cube.off", "-o", "cube.vtu", "--size", "0.4")
        result = self.succeed("embed", "cube.off", "cube.vtu", "-o", "rig.vtu")
        self.assertIn("8 vertices", result.stdout)
        head = (self.folder / "rig.vtu").read_bytes()
        for words in [b'NumberOfPoints="8" NumberOfCells="12"', b'Name="weights" NumberOfComponents="4"', b'Name="tets"']:
            self.assertIn(words, head)

    def test_refusals(self):
        self.cube()
        self.write("far.off", off([(x + 9, y, z) for x, y, z in CUBE_POINTS], CUBE_TRIANGLES))
        self.write("one.mesh", medit([(0, 0, 0), (9, 0, 0), (0, 9, 0), (0, 0, 9)], [(0, 1, 2, 3)]))
        self.refuse(2, "embed", "far.off", "one.mesh", "-o", "rig.npz", saying=["7 of 8 points", "point 1 at (10, 0, 0)"])
        self.refuse(2, "embed", "cube.off", "one.mesh", "-o", "rig.txt", saying=[".npz"])
        self.refuse(2, "embed", "cube.off", "none.mesh", "-o", "rig.npz", saying=["none.mesh"])
        self.refuse(2, "embed", "one.mesh", "cube.off", "-o", "rig.npz", saying=["one.mesh"])
        self.refuse(2, "embed", "cube.off", "one.mesh", saying=["--output"])


if __name__ == "__main__":
    main()
