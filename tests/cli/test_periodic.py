"""Periodic cells: mesh --periodic, its files, and check."""

import json
import random

from program import ProgramTest, main


class Periodic(ProgramTest):
    def mesh(self, *arguments, box="0 0 0 1 1 1", output="out.vtu"):
        self.succeed("mesh", "--periodic", "--box", box, *arguments, "-o", output, "--json", "report.json")
        report = self.report("report.json")
        self.assertEqual(report["status"], "done")
        self.assertTrue(report["input"]["periodic"] and report["verified"])
        self.assertTrue(any("Euler characteristic 0" in check for check in report["verify"]["checks"]))
        return report

    def points(self, count):
        generator = random.Random(1)
        lines = [" ".join(str(generator.uniform(-2, 3)) for _ in range(3)) for _ in range(count)]
        (self.folder / "points.xyz").write_text("\n".join(lines) + "\n")

    def test_all_strategies(self):
        for strategy in ["octree", "closure", "thrifty", "literal"]:
            with self.subTest(strategy=strategy):
                report = self.mesh("--size", "0.1 + 0.2 * abs(x - 0.5)", "--strategy", strategy)
                self.assertEqual(report["stats"]["strategy"], strategy)
                self.assertAlmostEqual(report["quality"]["volume"], 1, delta=1e-12)
                self.assertGreaterEqual(report["verify"]["min_dihedral_deg"], 30)
                self.assertLessEqual(report["verify"]["worst_size_ratio"], 1)
                self.succeed("check", "out.vtu", "--json", "check.json")
                checks = self.report("check.json")["verify"]["checks"]
                self.assertTrue(any(check.startswith("torus: the volumes add up") for check in checks))

    def test_points_from_anywhere(self):
        self.points(50)
        report = self.mesh("--points", "points.xyz", box="-1 0 0 1 1 1.5")
        self.assertEqual((report["stats"]["strategy"], report["mesh"]["input_vertices"]), ("thrifty", 50))

    def test_topology(self):
        report = self.mesh("--size", "0.2", "--topology", "torus.json", output="out.msh")
        torus = json.loads((self.folder / "torus.json").read_text())
        self.assertEqual(len(torus["tets"]), report["mesh"]["tets"])
        self.assertEqual(len(torus["tets"]), len(torus["offsets"]))
        self.assertEqual(len(torus["vertices"]) + len(torus["copies"]), report["mesh"]["vertices"])
        self.assertEqual(torus["period"], [1, 1, 1])
        homes = {copy["home"] for copy in torus["copies"]}
        self.assertLess(max(homes), len(torus["vertices"]))
        self.assertTrue(all(set(tet) <= set(range(len(torus["vertices"]))) for tet in torus["tets"]))
        self.assertIn(b"$Periodic", (self.folder / "out.msh").read_bytes())

    def test_a_damaged_file_is_found(self):
        self.mesh("--size", "0.2")
        data = (self.folder / "out.vtu").read_bytes()
        (self.folder / "bad.vtu").write_bytes(data.replace(b'Name="periodic_home"', b'Name="point_source_"'))
        self.refuse(2, "check", "bad.vtu", saying=["periodic_home"])

    def test_refusals(self):
        box = ["--box", "0 0 0 1 1 1", "-o", "out.vtu"]
        self.refuse(2, "mesh", "--periodic", "--ball", "0 0 0 1", "-o", "out.vtu", saying=["--box"])
        self.refuse(2, "mesh", "--periodic", "--conform", *box, saying=["--conform"])
        self.refuse(2, "mesh", "--topology", "t.json", *box, saying=["--topology", "--periodic"])
        self.refuse(2, "mesh", "--periodic", "--box", "0 0 0 1 1 1", "--stream", "folder", saying=["--periodic"])
        self.refuse(2, "mesh", "--periodic", "--box", "0 0 0 1 1 0.7654321", "-o", "out.vtu", saying=["One that will do"])
        self.points(3)
        self.refuse(2, "mesh", "--periodic", "--points", "points.xyz", "--strategy", "octree", *box, saying=["thrifty"])


if __name__ == "__main__":
    main()
