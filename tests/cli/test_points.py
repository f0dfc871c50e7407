"""Points that become vertices: `unsliver mesh --points`."""

import math
import random

from program import CUBE_POINTS, ProgramTest, main, medit

BOX = ["--box", "0 0 0 1 1 1"]


def rows(points):
    return "".join(",".join(map(repr, p)) + "\n" for p in points)


def scattered(count, seed, scale=(1.0, 1.0, 1.0)):
    generator = random.Random(seed)
    return [tuple(s * generator.random() for s in scale) for _ in range(count)]


class PointsTest(ProgramTest):
    def mesh_file(self, name, *arguments):
        """Meshes to TetGen files; the report, in which every promise is kept."""
        self.succeed("mesh", "--points", name, *arguments, "-o", "out.node", "--json", "report.json")
        report = self.report("report.json")
        self.assertTrue(report["guaranteed"] and report["verify"]["ok"])
        self.assertGreaterEqual(report["verify"]["min_dihedral_deg"], report["options"]["min_dihedral_deg"] - 1e-9)
        self.assertLessEqual(report["verify"]["max_dihedral_deg"], report["options"]["max_dihedral_deg"] + 1e-9)
        self.assertLessEqual(report["verify"]["max_radius_edge"], report["options"]["max_radius_edge"])
        return report

    def mesh(self, points, *arguments):
        """... and the first vertices are the points, bit for bit, equal ones merged."""
        report = self.mesh_file(self.write("points.csv", rows(points)), *arguments)
        distinct = list(dict.fromkeys(p[:3] for p in points))
        self.assertEqual(self.vertices()[:len(distinct)], distinct)
        self.assertEqual((report["points"]["count"], report["mesh"]["input_vertices"]), (len(points), len(distinct)))
        return report

    def vertices(self):
        lines = (self.folder / "out.node").read_text().splitlines()[1:]
        return [tuple(map(float, line.split()[1:4])) for line in lines if not line.startswith("#")]


class Points(PointsTest):
    def test_random(self):
        for count in [1, 2, 3, 4, 10, 100]:
            with self.subTest(count=count):
                report = self.mesh(scattered(count, seed=count))
                self.assertEqual(report["input"]["kind"], "points")
                self.assertEqual(report["options"]["max_radius_edge"], 1.368)
                self.assertTrue(any(check.startswith("inputs: ") for check in report["verify"]["checks"]))

    def test_literal_counts_subcases(self):
        stats = self.mesh(scattered(30, seed=7), "--strategy", "literal")["stats"]
        self.assertEqual(stats["figure_8"]["1.1.3"], 0)
        self.assertGreater(sum(stats["figure_8"].values()), 0)
        self.assertEqual(stats["candidates"], 0)

    def test_thrifty_counts_candidates(self):
        self.assertGreater(self.mesh(scattered(30, seed=7))["stats"]["candidates"], 0)

    def test_every_domain(self):
        for domain in [BOX, ["--ball", "0.5 0.5 0.5 1"], [self.cube()],
                       ["--implicit", "x^2 + y^2 + z^2 - 1", "--bounds", "-2 -2 -2 2 2 2"]]:
            with self.subTest(domain=domain):
                report = self.mesh(scattered(20, seed=3), *domain, "--size", "0.3")
                self.assertLessEqual(report["verify"]["worst_size_ratio"], 1 + 1e-12)

    def test_demands_that_are_looser_cost_fewer_vertices(self):
        points = scattered(100, seed=11)
        loose = self.mesh(points, "--min-angle", "15", "--max-angle", "150", "--max-radius-edge", "1.5")
        self.assertLess(loose["mesh"]["vertices"], self.mesh(points)["mesh"]["vertices"])

    def test_check_holds_the_file_to_the_bound_beside_points(self):
        self.write("points.csv", rows(scattered(30, seed=2)))
        self.succeed("mesh", "--points", "points.csv", "-o", "out.vtu")
        self.succeed("check", "out.vtu", "--json", "check.json")
        self.assertEqual(self.report("check.json")["held_to"]["max_radius_edge"], 1.368)

    def test_same_bytes_always(self):
        name = self.write("points.csv", rows(scattered(50, seed=5)))
        for output in ["a.vtu", "b.vtu"]:
            self.succeed("mesh", "--points", name, "-o", output)
        self.assertEqual((self.folder / "a.vtu").read_bytes(), (self.folder / "b.vtu").read_bytes())

    def test_report_for_people(self):
        name = self.write("points.csv", rows(scattered(10, seed=1)))
        result = self.succeed("mesh", "--points", name, "-o", "out.vtu")
        for word in ["10 from points.csv", "none: as large as", "1.3680", "thrifty"]:
            self.assertIn(word, result.stdout)

    def test_unfinished_mesh_has_the_points(self):
        name = self.write("points.csv", rows(scattered(200, seed=4)))
        cap = ["--points", name, "--max-tets", "2k", "-o", "out.vtu"]
        self.refuse(1, "mesh", *cap, saying=["--max-tets 2,000"])
        for more in [], ["--strategy", "octree", "--size", "0.1"]:
            with self.subTest(more=more):
                result = self.run_program("mesh", *cap, *more, "--keep-partial", "--json", "report.json")
                self.assertEqual(result.returncode, 1, result.stderr)
                report = self.report("report.json")
                self.assertEqual((report["status"], report["mesh"]["input_vertices"]), ("tet_cap", 200))
                self.assertTrue(report["verify"]["ok"], report["verify"])


class Files(PointsTest):
    def test_every_format(self):
        points = scattered(5, seed=6)
        text = "".join("{!r} {!r} {!r}\n".format(*p) for p in points)
        node = "5 3 0 0\n" + "".join(f"{i} {line}\n" for i, line in enumerate(text.splitlines()))
        ply = ("ply\nformat ascii 1.0\nelement vertex 5\nproperty double x\nproperty double y\n"
               "property double z\nend_header\n" + text)
        for name, content in [("a.xyz", text), ("a.csv", rows(points)), ("a.node", node), ("a.ply", ply),
                              ("a.mesh", medit(points, [(0, 1, 2, 3)]))]:
            with self.subTest(name=name):
                self.mesh_file(self.write(name, content))
                self.assertEqual(self.vertices()[:5], points)

    def test_radii_are_sizes(self):
        atoms = "".join(f"ATOM {i} C MET 1 {i}.0 {i % 2}.0 0.5 0.1 {radius}\n"
                        for i, radius in enumerate([0.2, 2.0, 1.5]))
        report = self.mesh_file(self.write("a.pqr", atoms), "--box", "-1 -1 -1 3 3 3")
        self.assertTrue(report["points"]["with_sizes"])
        self.assertIn("gradation 0.3", report["size"]["description"])
        self.assertGreater(report["verify"]["worst_size_ratio"], 0)


class Sizes(PointsTest):
    SIZED = [(*p, 0.05) for p in scattered(5, seed=8)]

    def count(self, points, *arguments):
        return self.mesh(points, *BOX, *arguments)["mesh"]["vertices"]

    def test_column_of_sizes(self):
        self.assertGreater(self.count(self.SIZED), self.count([p[:3] for p in self.SIZED]))

    def test_gradation_and_cap(self):
        default = self.count(self.SIZED)
        self.assertGreater(default, self.count(self.SIZED, "--size-gradation", "1"))
        self.assertLess(default, self.count(self.SIZED, "--size-max", "0.06"))

    def test_constant_grows_from_points(self):
        points = [p[:3] for p in self.SIZED]
        constant = self.count(points, "--size", "0.1")
        self.assertLess(self.count(points, "--size", "0.1", "--size-gradation", "0.5"), constant)

    def test_without_effect(self):
        name = self.write("points.csv", rows(scattered(5, seed=8)))
        for option in ["--size-gradation", "--size-max"]:
            self.refuse(2, "mesh", "--points", name, option, "0.5", "-o", "out.vtu", saying=[option, "no effect"])


class Hostile(PointsTest):
    def refuse_points(self, content, *saying, arguments=()):
        name = self.write("points.csv", content)
        return self.refuse(2, "mesh", "--points", name, *arguments, "-o", "out.vtu", saying=saying)

    def test_no_points(self):
        self.refuse_points("", "points.csv", "empty")
        self.refuse_points("x,y,z\n", "points.csv")
        self.refuse(2, "mesh", "--points", "none.csv", "-o", "out.vtu", saying=["none.csv", "no such file"])

    def test_not_finite(self):
        for value in ["nan", "inf", "-inf", "1e999"]:
            with self.subTest(value=value):
                self.refuse_points(f"0,0,0\n0,{value},1\n", "points.csv:2")

    def test_duplicates_become_one_vertex(self):
        points = scattered(10, seed=9)
        report = self.mesh(points + points[::2])
        self.assertIn("5 of 15 points repeat an earlier one", " ".join(report["notes"]))

    def test_all_identical(self):
        report = self.mesh([(3.0, 4.0, 5.0)] * 5)
        self.assertIn("no volume", " ".join(report["input"]["notes"]))
        self.mesh([(3e20, 0.0, -3e20)])

    def test_flat_and_straight(self):
        for scale in [(1.0, 1.0, 0.0), (0.0, 1.0, 1.0), (0.0, 1.0, 0.0), (1.0, 1.0, 1e-12), (1.0, 1.0, 1e-40)]:
            with self.subTest(scale=scale):
                self.mesh(scattered(15, seed=10, scale=scale))
        self.mesh([(x, y, 0.5 * x - 2 * y) for x, y, _ in scattered(15, seed=12)])
        self.mesh([(0.1 * i, 0.2 * i, 0.3 * i) for i in range(10)])

    def test_on_the_boundary_of_the_domain(self):
        points = CUBE_POINTS + [(0.5, 0.5, 0.0), (0.25, 1.0, 0.75), (0.0, 0.3, 0.0)]
        for domain in [BOX, [self.cube()]]:
            with self.subTest(domain=domain):
                self.mesh(points, *domain)

    def test_outside_the_domain(self):
        report = self.mesh([(5.0, 0.5, 0.5), (0.5, 0.5, 0.5), (-3.0, 1.0, 2.0)], *BOX, "--size", "0.4")
        self.assertIn("2 of 3 input vertices lie outside the domain", " ".join(report["notes"]))

    def test_structured(self):
        self.mesh([(float(x), float(y), float(z)) for x in range(4) for y in range(4) for z in range(3)])
        self.mesh([(math.cos(t), math.sin(t), 0.2 * t) for t in range(20)])

    def test_close_pairs(self):
        self.mesh([(x + d, y, z) for x, y, z in scattered(5, seed=13) for d in (0, 1e-9)])

    def test_too_close(self):
        points = rows([(0.0, 0.0, 0.0), (1.0, 1.0, 1.0), (1e-13, 0.0, 0.0)])
        self.refuse_points(points, "Points 0 at", "2 at", "1e-11")
        self.run_program("mesh", "--points", "points.csv", "-o", "out.vtu", "--json", "report.json")
        error = self.report("report.json")["error"]
        self.assertEqual((error["code"], sorted(error["ids"])), ("bad_input", [0, 2]))

    def test_out_of_range(self):
        self.refuse_points(rows([(1e308, 0.0, 0.0), (-1e308, 1.0, 1.0)]))

    def test_stricter_than_proven(self):
        self.refuse_points(rows(scattered(5, seed=1)), "--max-radius-edge", "1.368",
                           arguments=["--max-radius-edge", "1.2"])
        self.refuse_points(rows(scattered(5, seed=1)), "closure", arguments=["--strategy", "closure"])

    def test_output_over_the_points(self):
        self.write("points.node", "1 3 0 0\n0 0 0 0\n")
        self.refuse(2, "mesh", "--points", "points.node", "-o", "points.ele", saying=["overwrite"])


if __name__ == "__main__":
    main()
