"""The main job: solids in, verified meshes and reports out."""

import json
import math

from program import ProgramTest, main

BALL = ["--ball", "0 0 0 1"]
SPHERE = "x^2 + y^2 + z^2 - 1"


class MeshTest(ProgramTest):
    def mesh(self, *arguments, output="out.vtu"):
        """Meshes without complaint; the report, in which every promise is kept."""
        self.succeed("mesh", *arguments, "-o", output, "--json", "report.json")
        self.assertTrue((self.folder / output).exists())
        report = self.report("report.json")
        self.assertEqual((report["status"], report["exit_code"], report["guaranteed"]), ("done", 0, True))
        self.assertEqual(report["output"], output)
        if report["verify"] is not None:
            self.assertTrue(report["verify"]["ok"])
            self.assertEqual(report["verify"]["finding_count"], 0)
            self.assertGreaterEqual(report["verify"]["min_dihedral_deg"], 30 - 1e-9)
            self.assertLessEqual(report["verify"]["max_dihedral_deg"], 135 + 1e-9)
            self.assertLessEqual(report["verify"]["max_radius_edge"], math.sqrt(5) / 2 + 1e-12)
            self.assertLessEqual(report["verify"]["worst_size_ratio"], 1 + 1e-12)
        return report


class Mesh(MeshTest):
    def test_every_kind_of_domain(self):
        for kind, arguments, volume in [
            ("box", ["--box", "0 0 0 1 1 2"], 2),
            ("ball", BALL, 4 / 3 * math.pi),
            ("implicit", ["--implicit", SPHERE, "--bounds", "-2 -2 -2 2 2 2"], 4 / 3 * math.pi),
            ("surface", [self.cube()], 1),
        ]:
            with self.subTest(kind=kind):
                report = self.mesh(*arguments, "--size", "0.25")
                self.assertEqual(report["input"]["kind"], kind)
                self.assertGreater(report["quality"]["volume"], volume)
                self.assertLess(report["quality"]["volume"], 4 * volume)

    def test_every_strategy_and_format(self):
        for strategy in ["thrifty", "literal", "closure", "octree"]:
            for name in ["a.vtu", "a.msh", "a.mesh", "a.node"]:
                with self.subTest(strategy=strategy, name=name):
                    report = self.mesh(*BALL, "--size", "0.5", "--strategy", strategy, output=name)
                    self.assertEqual(report["stats"]["strategy"], strategy)
                    check = self.succeed("check", name, "--json", "-")
                    self.assertIn(f'"tets": {report["mesh"]["tets"]},', check.stdout)

    def test_default_strategy_follows_the_size(self):
        for size, strategy in [("0.5", "octree"), ("0.5 + 0.01 * x", "octree"), ("0.5 + 0.1 * x", "closure")]:
            report = self.mesh(*BALL, "--size", size)
            self.assertEqual((report["options"]["strategy"], report["stats"]["strategy"]), ("auto", strategy))

    def test_report_for_people(self):
        result = self.succeed("mesh", self.cube(), "-o", "out.vtu", "--size", "0.3")
        for word in ["cube.off", "asked", "guaranteed", "achieved", "30.00 deg", "135.00 deg", "1.1180", "size ratio",
                     "verified", "yes", "out.vtu", "memory", "time"]:
            self.assertIn(word, result.stdout)
        self.assertIn("expecting about", result.stderr)
        self.assertNotIn("\r", result.stderr, "no progress line on a pipe")

    def test_flat_surface_has_no_size_to_test(self):
        flat = self.write("flat.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
        report = self.mesh(flat, "--size", "0.2")
        self.assertIn("not tested", report["notes"][0])
        self.assertIn("not tested", self.succeed("mesh", flat, "-o", "out.vtu", "--size", "0.2").stdout)

    def test_quiet(self):
        result = self.succeed("mesh", *BALL, "-o", "out.vtu", "--size", "0.5", "--quiet")
        self.assertEqual((result.stdout, result.stderr), ("", ""))

    def test_report_on_standard_output_is_nothing_but_json(self):
        result = self.succeed("mesh", *BALL, "-o", "out.vtu", "--size", "0.5", "--json", "-")
        self.assertEqual(json.loads(result.stdout)["status"], "done")

    def test_without_verification(self):
        report = self.mesh(*BALL, "--size", "0.5", "--no-verify")
        self.assertIsNone(report["verify"])

    def test_same_bytes_always(self):
        contents = []
        for name in ["a.vtu", "b.vtu"]:
            self.mesh(self.cube(), "--size", "0.2", output=name)
            contents.append((self.folder / name).read_bytes())
        self.assertEqual(*contents)

    def test_looser_bounds_are_asked_and_guaranteed(self):
        report = self.mesh(*BALL, "--size", "0.4", "--min-angle", "20", "--max-angle", "150")
        self.assertEqual(report["options"]["min_dihedral_deg"], 20)
        self.assertEqual(report["options"]["max_dihedral_deg"], 150)


class Sizes(MeshTest):
    def test_default(self):
        report = self.mesh("--box", "0 0 0 1 1 1", "--no-verify")
        self.assertTrue(report["size"]["default"])
        self.assertAlmostEqual(report["size"]["constant"], math.sqrt(3) / 40)
        result = self.succeed("mesh", "--box", "0 0 0 1 1 1", "-o", "out.vtu", "--no-verify")
        self.assertIn("default", result.stdout)

    def test_help_tells_defaults_and_sizes_of_points(self):
        text = " ".join(self.succeed("mesh", "--help").stdout.split())
        self.assertIn("Default: 1/40 of the diagonal of the box around the surface, of --box, around the ball, "
                      "or of --bounds; with points and for refine none", text)
        self.assertIn("in .csv a column size, radius or s, or the 4th", text)

    def test_default_of_a_formula_is_that_of_its_bounds(self):
        report = self.mesh("--implicit", "x^2 + y^2 + z^2 - 1", "--bounds", "-2 -2 -2 2 2 2", "--no-verify")
        self.assertAlmostEqual(report["size"]["constant"], 4 * math.sqrt(3) / 40)

    def test_edge_length_is_a_size(self):
        factor = (math.sqrt(5) / 4) / ((3 + 2 * math.sqrt(3)) / 7)
        a = self.mesh(*BALL, "--edge-length", "0.5")
        b = self.mesh(*BALL, "--size", repr(0.5 * factor))
        self.assertAlmostEqual(a["size"]["size_per_edge_length"], factor)
        self.assertAlmostEqual(a["size"]["constant"], b["size"]["constant"])
        self.assertEqual(a["mesh"], b["mesh"])

    def test_edge_length_is_the_mean_edge(self):
        self.mesh("--box", "0 0 0 1 1 1", "--edge-length", "0.1", "--no-verify", output="out.node")
        points = [list(map(float, line.split()[1:4]))
                  for line in (self.folder / "out.node").read_text().splitlines()[1:] if not line.startswith("#")]
        edges = set()
        for line in (self.folder / "out.ele").read_text().splitlines()[1:]:
            if not line.startswith("#"):
                tet = sorted(map(int, line.split()[1:5]))
                edges |= {(p, q) for p in tet for q in tet if p < q}
        first = min(v for edge in edges for v in edge)
        mean = sum(math.dist(points[p - first], points[q - first]) for p, q in edges) / len(edges)
        self.assertAlmostEqual(mean, 0.1, delta=0.002)

    def test_formulas(self):
        fine = self.mesh(*BALL, "--size", "0.15 + 0.3 * max(x, 0)")
        coarse = self.mesh(*BALL, "--size", "0.45")
        self.assertGreater(fine["mesh"]["tets"], coarse["mesh"]["tets"])
        edges = self.mesh(*BALL, "--edge-length", "0.3 + 0.5 * max(x, 0)")
        self.assertIsNone(edges["size"]["constant"])

    def test_formula_that_is_positive_on_the_domain_alone(self):
        self.mesh(*BALL, "--size", "1.2 - sqrt(x^2 + y^2 + z^2)")

    def test_several_sizes_combine_by_minimum(self):
        both = self.mesh(*BALL, "--size", "0.3", "--edge-length", "5")
        alone = self.mesh(*BALL, "--size", "0.3")
        self.assertEqual(both["mesh"], alone["mesh"])

    def test_graded_from_the_surface(self):
        graded = self.mesh(self.cube(), "--size", "0.05", "--size-gradation", "0.5", "--size-max", "0.2")
        uniform = self.mesh(self.cube(), "--size", "0.05", "--no-verify")
        self.assertLess(graded["mesh"]["tets"], uniform["mesh"]["tets"])

    def test_gradation_limits_a_formula(self):
        steep = ["--size", "x < 0 ? 0.4 : 0.12"]
        self.assertLess(self.mesh(*BALL, *steep)["mesh"]["tets"],
                        self.mesh(*BALL, *steep, "--size-gradation", "0.1")["mesh"]["tets"])

    def test_size_mesh(self):
        corners = [(x, y, z) for x in (-3, 3) for y in (-3, 3) for z in (-3, 3)]
        tets = [(0, 1, 3, 7), (0, 1, 5, 7), (0, 2, 3, 7), (0, 2, 6, 7), (0, 4, 5, 7), (0, 4, 6, 7)]
        self.write("size.node", "8 3 0 0\n" + "".join(f"{i} {x} {y} {z}\n" for i, (x, y, z) in enumerate(corners)))
        self.write("size.ele", "6 4 0\n" + "".join(f"{i} {a} {b} {c} {d}\n" for i, (a, b, c, d) in enumerate(tets)))
        self.write("size.mtr", "8 1\n" + "0.3\n" * 8)
        field = self.mesh(*BALL, "--size-mesh", "size.node")
        constant = self.mesh(*BALL, "--size", "0.3")
        self.assertFalse(field["size"]["default"])
        self.assertAlmostEqual(field["mesh"]["tets"], constant["mesh"]["tets"],
                               delta=0.5 * constant["mesh"]["tets"])


class Caps(MeshTest):
    def test_cap_keeps_a_partial_mesh_only_when_asked(self):
        cap = ["--size", "0.05", "--max-tets", "5k"]
        self.refuse(1, "mesh", *BALL, *cap, "-o", "out.vtu")
        result = self.run_program("mesh", *BALL, *cap, "-o", "out.vtu", "--keep-partial", "--json", "report.json")
        self.assertEqual(result.returncode, 1, result.stderr)
        self.assertIn("UNFINISHED", result.stderr)
        self.assertIn("none", result.stdout)
        report = self.report("report.json")
        self.assertEqual((report["status"], report["guaranteed"], report["output"]), ("tet_cap", False, "out.vtu"))
        self.assertTrue(report["verify"]["ok"], report["verify"])
        self.assertIn(f'"tets": {report["mesh"]["tets"]},', self.run_program("check", "out.vtu", "--json", "-").stdout)


if __name__ == "__main__":
    main()
