"""check, convert, info and view."""

import json
import os
import struct
import zlib

from program import CUBE_POINTS, CUBE_TRIANGLES, ProgramTest, main, medit, off

# One tetrahedron with right angles at its first corner.
CORNER = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]


class Tools(ProgramTest):
    def mesh(self, name="ball.vtu", size="0.4"):
        self.succeed("mesh", "--ball", "0 0 0 1", "--size", size, "-o", name, "--quiet")
        return name

    def told(self, *arguments, code=0):
        result = self.run_program(*arguments, "--json", "-")
        self.assertEqual(result.returncode, code, result.stdout + result.stderr)
        return json.loads(result.stdout)


class Check(Tools):
    def test_ours_keeps_its_guarantees(self):
        report = self.told("check", self.mesh())
        self.assertTrue(report["ours"])
        self.assertEqual(report["held_to"]["min_dihedral_deg"], 30)
        self.assertTrue(report["verify"]["ok"])
        self.assertEqual(report["quality"]["tets_outside_30_135"], 0)

    def test_ours_when_spoilt(self):
        """A vertex moved onto its neighbour by hand."""
        self.mesh("ball.mesh")
        lines = (self.folder / "ball.mesh").read_text().splitlines()
        first = lines.index("Vertices") + 2
        tet = list(map(int, lines[lines.index("Tetrahedra") + 2].split()))
        victim = first + tet[0] - 1
        target = lines[first + tet[1] - 1].split()
        lines[victim] = " ".join([*target[:3], lines[victim].split()[3]])
        self.write("ball.mesh", "\n".join(lines) + "\n")
        self.refuse(1, "check", "ball.mesh", saying=["ball.mesh", "finding"])

    def test_anybodys_mesh(self):
        self.write("corner.mesh", medit(CORNER, [(0, 1, 2, 3)]))
        result = self.succeed("check", "corner.mesh")
        for word in ["54.73", "90.0", "tetrahedron 0", "(1, 0, 0)", "no fault found", "#", "outside [30, 135]"]:
            self.assertIn(word, result.stdout)
        report = self.told("check", "corner.mesh")
        self.assertFalse(report["ours"])
        self.assertIsNone(report["held_to"])
        self.assertEqual(sum(report["quality"]["dihedral_histogram_5_deg"]), 6)
        self.assertAlmostEqual(report["quality"]["volume"], 1 / 6)

    def test_poor_angles_are_a_fault_only_when_held_to_better(self):
        self.write("sliver.mesh", medit([(0, 0, 0), (1, 0, 0.01), (1, 1, 0), (0, 1, 0.01)], [(0, 1, 2, 3)]))
        sliver = self.told("check", "sliver.mesh", "--worst", "1")
        self.assertEqual(sliver["quality"]["tets_below_deg"]["5"], 1)
        self.refuse(1, "check", "sliver.mesh", "--min-angle", "10")
        self.refuse(2, "check", "sliver.mesh", "--min-angle", "80", saying=["--min-angle"])

    def test_faults_of_others(self):
        self.write("inverted.mesh", medit(CORNER, [(0, 2, 1, 3)]))
        self.refuse(1, "check", "inverted.mesh", saying=["inverted.mesh"])
        self.write("double.mesh", medit(CORNER, [(0, 1, 2, 3), (0, 1, 2, 3)]))
        self.refuse(1, "check", "double.mesh")

    def test_against_a_surface(self):
        self.succeed("mesh", self.cube(), "--size", "0.3", "-o", "cube.vtu", "--quiet")
        self.assertTrue(self.told("check", "cube.vtu", "--against", "cube.off")["verify"]["ok"])
        moved = [(x + 3, y, z) for x, y, z in CUBE_POINTS]
        self.write("moved.off", off(moved, CUBE_TRIANGLES))
        self.refuse(1, "check", "cube.vtu", "--against", "moved.off")
        self.refuse(2, "check", "cube.vtu", "--worst", "-1", saying=["--worst"])
        self.refuse(2, "check", "cube.vtu", "--json", "cube.vtu", saying=["cube.vtu", "overwrite"])
        self.refuse(2, "check", "cube.vtu", "--against", "none.off", saying=["none.off"])


class Convert(Tools):
    def test_around_every_format(self):
        self.mesh("a.vtu")
        whole = self.told("check", "a.vtu")
        previous = "a.vtu"
        for name, form in [("b.msh", "msh22"), ("c.msh", "msh41"), ("d.mesh", "medit"), ("e.node", "tetgen"),
                           ("f.vtu", "vtu")]:
            with self.subTest(name=name, format=form):
                self.succeed("convert", previous, name, "--format", form)
                again = self.told("check", name)
                self.assertEqual((again["vertices"], again["tets"], again["bounds"]),
                                 (whole["vertices"], whole["tets"], whole["bounds"]))
                self.assertAlmostEqual(again["quality"]["volume"], whole["quality"]["volume"], places=12)
                previous = name

    def test_text_is_for_gmsh(self):
        self.mesh("a.vtu")
        self.succeed("convert", "a.vtu", "a.msh", "--ascii")
        self.refuse(2, "convert", "a.vtu", "a.mesh", "--ascii", saying=["--ascii"])

    def test_onto_itself(self):
        mesh = self.folder / self.mesh("a.vtu")
        (self.folder / "soft.vtu").symlink_to("a.vtu")
        os.link(mesh, self.folder / "hard.vtu")
        before = mesh.read_bytes()
        for name in ["a.vtu", "./a.vtu", mesh, "soft.vtu", "hard.vtu"]:
            with self.subTest(name=name):
                self.refuse(2, "convert", "a.vtu", name, saying=["would overwrite an input"])
        self.assertEqual(mesh.read_bytes(), before)

    def test_counts_of_one(self):
        self.write("corner.mesh", medit(CORNER, [(0, 1, 2, 3)]))
        self.assertIn(": 4 vertices, 1 tetrahedron\n", self.succeed("convert", "corner.mesh", "b.vtu").stdout)

    def test_boundary_for_tetgen(self):
        self.write("corner.mesh", medit(CORNER, [(0, 1, 2, 3)]))
        self.succeed("convert", "corner.mesh", "b.node")
        lines = (self.folder / "b.face").read_text().splitlines()
        self.assertEqual(lines[0], "4 1")
        self.assertTrue(all(line.endswith(" 1") for line in lines[1:]))

    def test_onto_a_surface_format(self):
        self.refuse(2, "convert", self.mesh(), "a.stl", saying=["a.stl"])


class Info(Tools):
    def test_surface(self):
        report = self.told("info", self.cube())
        self.assertEqual((report["kind"], report["points"], report["triangles"], report["clean"]),
                         ("surface", 8, 12, True))
        self.assertEqual(report["bounds"], {"lo": [0, 0, 0], "hi": [1, 1, 1]})
        self.assertAlmostEqual(report["signed_volume"], 1)
        self.assertTrue(report["notes"])
        text = self.succeed("info", "cube.off").stdout
        self.assertIn("12 triangles", text)
        self.assertRegex(text, r"clean +yes\n")
        self.assertIn("(0, 0, 0) to (1, 1, 1)", text)

    def test_surface_that_is_repaired(self):
        """What is found in the file and what meshing makes of it are told apart."""
        triangles = [CUBE_TRIANGLES[0][::-1], *CUBE_TRIANGLES[1:]]
        self.write("turned.off", off(CUBE_POINTS, triangles))
        text = self.succeed("info", "turned.off").stdout
        self.assertRegex(text, r"clean +no; found in the file:\n  - inconsistent edges +3;")
        self.assertRegex(text, r"meshed as .*clean after repairs\n  - note +1 triangle was turned")

    def test_surface_that_cannot_be_meshed(self):
        self.write("flat.off", off([(0, 0, 0), (1, 0, 0), (2, 0, 0)], [(0, 1, 2)]))
        report = self.told("info", "flat.off")
        self.assertEqual(report["defects"]["degenerate_triangles"]["count"], 1)
        self.assertIn("cannot be meshed", report["notes"][0])

    def test_defects(self):
        self.write("open.off", off(CUBE_POINTS, CUBE_TRIANGLES[1:]))
        report = self.told("info", "open.off")
        self.assertFalse(report["clean"])
        self.assertEqual(report["defects"]["boundary_edges"]["count"], 3)
        self.assertIn("boundary edges", self.succeed("info", "open.off").stdout)

    def test_mesh(self):
        report = self.told("info", self.mesh())
        self.assertEqual(report["kind"], "tetrahedral mesh")
        self.assertTrue(report["lattice_levels"])


class View(Tools):
    def pixels(self, name):
        """Width, height and rows of a PNG, its checksums verified."""
        data = (self.folder / name).read_bytes()
        self.assertEqual(data[:8], b"\x89PNG\r\n\x1a\n")
        position, packed, size = 8, b"", None
        while position < len(data):
            length, = struct.unpack(">I", data[position:position + 4])
            body = data[position + 4:position + 8 + length]
            self.assertEqual(zlib.crc32(body), struct.unpack(">I", data[position + 8 + length:position + 12 + length])[0])
            if body[:4] == b"IHDR":
                size = struct.unpack(">IIBB", body[4:14])
            if body[:4] == b"IDAT":
                packed += body[4:]
            position += 12 + length
        raw, stride = zlib.decompress(packed), 3 * size[0] + 1
        self.assertEqual((size[2:], len(raw)), ((8, 2), stride * size[1]))
        return size[0], size[1], [raw[y * stride + 1:(y + 1) * stride] for y in range(size[1])]

    def test_picture(self):
        self.mesh("ball.vtu", "0.3")
        self.succeed("view", "ball.vtu", "-o", "ball.png", "--size", "400x300")
        width, height, rows = self.pixels("ball.png")
        self.assertEqual((width, height), (400, 300))
        background, middle = rows[2][:3], rows[150][3 * 140:3 * 140 + 3]
        self.assertNotEqual(background, middle)
        self.assertGreater(len({bytes(row[3 * x:3 * x + 3]) for row in rows for x in range(width)}), 50)

    def test_cuts_differ(self):
        self.mesh()
        pictures = []
        for cut in ["auto", "none", "1 1 0 0.2", "-1 0 0 0.3"]:
            self.succeed("view", "ball.vtu", "-o", "a.png", "--size", "300x240", "--cut", cut)
            pictures.append((self.folder / "a.png").read_bytes())
        self.assertEqual(len(set(pictures)), 4)

    def test_bad_usage(self):
        self.mesh()
        self.refuse(2, "view", "ball.vtu", "-o", "a.jpg", saying=["a.jpg", ".png"])
        self.refuse(2, "view", "ball.vtu", "-o", "a.png", "--size", "10", saying=["--size"])
        self.refuse(2, "view", "ball.vtu", "-o", "a.png", "--size", "300x", saying=["--size"])
        self.refuse(2, "view", "ball.vtu", "-o", "a.png", "--cut", "1 0 0", saying=["--cut"])
        self.refuse(2, "view", "ball.vtu", "-o", "a.png", "--cut", "0 0 0 1", saying=["--cut"])
        self.refuse(2, "view", "ball.vtu", "-o", "a.png", "--cut", "0 0 1 50", saying=["--cut", "misses", "between"])
        self.refuse(2, "view", "ball.vtu", "-o", "no/a.png", saying=["no/a.png"])


if __name__ == "__main__":
    main()
