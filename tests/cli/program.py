"""Runs the program under test and makes small inputs for it."""

import json
import os
import struct
import subprocess
import tempfile
import unittest
from pathlib import Path

PROGRAM = os.environ["UNSLIVER"]

CUBE_POINTS = [(x, y, z) for z in (0.0, 1.0) for y in (0.0, 1.0) for x in (0.0, 1.0)]
# Outward, by the right hand.
CUBE_TRIANGLES = [(0, 2, 1), (1, 2, 3), (4, 5, 6), (5, 7, 6), (0, 1, 4), (1, 5, 4),
                  (2, 6, 3), (3, 6, 7), (0, 4, 2), (2, 4, 6), (1, 3, 5), (3, 7, 5)]


def off(points, triangles):
    lines = ["OFF", f"{len(points)} {len(triangles)} 0"]
    lines += [" ".join(map(str, p)) for p in points]
    lines += ["3 " + " ".join(map(str, t)) for t in triangles]
    return "\n".join(lines) + "\n"


def medit(points, tets):
    lines = ["MeshVersionFormatted 2", "Dimension 3", "Vertices", str(len(points))]
    lines += [" ".join(map(str, p)) + " 0" for p in points]
    lines += ["Tetrahedra", str(len(tets))]
    lines += [" ".join(str(v + 1) for v in t) + " 1" for t in tets]
    return "\n".join(lines + ["End", ""])


def stl(points, triangles):
    """Binary; normals are left zero, as many programs do."""
    data = b"made by a test".ljust(80) + struct.pack("<I", len(triangles))
    for triangle in triangles:
        data += struct.pack("<3f", 0, 0, 0)
        for v in triangle:
            data += struct.pack("<3f", *points[v])
        data += b"\0\0"
    return data


class ProgramTest(unittest.TestCase):
    """Each test has an empty folder of its own as `self.folder`, in which the program runs."""

    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name)

    def write(self, name, content):
        path = self.folder / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return name

    def cube(self, name="cube.off"):
        return self.write(name, off(CUBE_POINTS, CUBE_TRIANGLES))

    def run_program(self, *arguments, **keywords):
        return subprocess.run([PROGRAM, *map(str, arguments)], cwd=self.folder, text=True, capture_output=True,
                              timeout=120, check=False, **keywords)

    def succeed(self, *arguments):
        result = self.run_program(*arguments)
        self.assertEqual(result.returncode, 0, f"{arguments}\n{result.stdout}\n{result.stderr}")
        return result

    def refuse(self, code, *arguments, saying=(), **keywords):
        """The program ends with `code`, names each of `saying` on stderr, and leaves no new file behind."""
        before = set(os.listdir(self.folder))
        result = self.run_program(*arguments, **keywords)
        told = f"{arguments}\n{result.stdout}\n{result.stderr}"
        self.assertEqual(result.returncode, code, told)
        self.assertIn("unsliver: error: ", result.stderr, told)
        for word in saying:
            self.assertIn(word, result.stderr, told)
        self.assertEqual(set(os.listdir(self.folder)), before, told)
        return result

    def report(self, name):
        return json.loads((self.folder / name).read_text())


def main():
    unittest.main()
