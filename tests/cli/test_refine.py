"""Slivers out of existing meshes: `unsliver refine`."""

import random

from program import ProgramTest, main, medit

# A cube's corners in binary order, as six tetrahedra around a diagonal.
CORNERS = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
SIX = [(0, 1, 3, 7), (0, 3, 2, 7), (0, 2, 6, 7), (0, 6, 4, 7), (0, 4, 5, 7), (0, 5, 1, 7)]
SLIVER = [(0.0, 0.0, 0.0), (1.0, 0.0, 0.02), (1.0, 1.0, 0.0), (0.0, 1.0, 0.02)]


def block(side, jitter=0.0, seed=1):
    """A cube of side^3 cubes, each cut in six; inner vertices moved at random."""
    generator = random.Random(seed)
    step, count = 1 / side, side + 1
    index = lambda i, j, k: (k * count + j) * count + i
    points, tets = [], []
    for k in range(count):
        for j in range(count):
            for i in range(count):
                inner = all(0 < c < side for c in (i, j, k))
                points.append(tuple(step * (c + inner * jitter * (generator.random() - 0.5)) for c in (i, j, k)))
    for k in range(side):
        for j in range(side):
            for i in range(side):
                cube = [index(i + x, j + y, k + z) for x, y, z in CORNERS]
                tets += [tuple(cube[c] for c in tet) for tet in SIX]
    return points, tets


class RefineTest(ProgramTest):
    def refine(self, points, tets, *arguments):
        """Refines to TetGen files; the report, in which every promise is kept."""
        self.write("in.mesh", medit(points, tets))
        self.succeed("refine", "in.mesh", *arguments, "-o", "out.node", "--json", "report.json")
        report = self.report("report.json")
        self.assertEqual((report["command"], report["status"], report["guaranteed"]), ("refine", "done", True))
        self.assertTrue(report["verify"]["ok"])
        self.assertGreaterEqual(report["verify"]["min_dihedral_deg"], report["options"]["min_dihedral_deg"] - 1e-9)
        self.assertLessEqual(report["verify"]["max_dihedral_deg"], report["options"]["max_dihedral_deg"] + 1e-9)
        self.assertLessEqual(report["verify"]["max_radius_edge"], report["options"]["max_radius_edge"])
        return report

    def vertices(self):
        lines = (self.folder / "out.node").read_text().splitlines()[1:]
        return [tuple(map(float, line.split()[1:4])) for line in lines if not line.startswith("#")]


class Refine(RefineTest):
    def test_slivers_go_and_vertices_stay(self):
        points, tets = block(3, jitter=0.9)
        report = self.refine(points, tets)
        self.assertEqual((report["before"]["vertices"], report["before"]["tets"]), (len(points), len(tets)))
        self.assertGreater(report["before"]["quality"]["tets_below_deg"]["20"], 0)
        self.assertEqual(set(report["quality"]["tets_below_deg"].values()), {0})
        self.assertEqual(self.vertices()[:len(points)], points)
        self.assertGreaterEqual(report["quality"]["volume"], 1 - 1e-9)

    def test_report_for_people(self):
        self.write("in.mesh", medit(*block(2, jitter=0.5)))
        result = self.succeed("refine", "in.mesh", "-o", "out.vtu")
        for word in ["before", "after", "below 5 deg", "below 30 deg", "growth", "27 from in.mesh"]:
            self.assertIn(word, result.stdout)
        quiet = self.succeed("refine", "in.mesh", "-o", "out.vtu", "--quiet")
        self.assertEqual((quiet.stdout, quiet.stderr), ("", ""))

    def test_every_format(self):
        points, tets = block(2)
        self.write("in.mesh", medit(points, tets))
        counts = set()
        for name in ["a.vtu", "a.msh", "a.mesh", "a.node"]:
            with self.subTest(name=name):
                self.succeed("convert", "in.mesh", name)
                self.succeed("refine", name, "-o", "out.vtu", "--json", "report.json")
                counts.add(self.report("report.json")["mesh"]["tets"])
        self.assertEqual(len(counts), 1)

    def test_own_result_again(self):
        self.write("in.mesh", medit(*block(2, jitter=0.5)))
        self.succeed("refine", "in.mesh", "-o", "once.vtu")
        self.succeed("refine", "once.vtu", "-o", "twice.vtu")

    def test_looser_bounds_and_literal(self):
        mesh = block(2, jitter=0.8)
        loose = ["--min-angle", "15", "--max-angle", "150", "--max-radius-edge", "1.5"]
        counts = [self.refine(*mesh, *arguments)["mesh"]["vertices"]
                  for arguments in [loose, [], ["--strategy", "literal"]]]
        self.assertEqual(counts, sorted(counts))

    def test_sizes(self):
        coarse = self.refine(*block(1))
        fine = self.refine(*block(1), "--size", "0.05")
        graded = self.refine(*block(1), "--size", "0.05", "--size-gradation", "0.5")
        self.assertGreater(fine["mesh"]["vertices"], graded["mesh"]["vertices"])
        self.assertGreater(graded["mesh"]["vertices"], coarse["mesh"]["vertices"])
        self.assertLessEqual(fine["verify"]["worst_size_ratio"], 1 + 1e-12)

    def test_hole_stays_empty(self):
        points, tets = block(3)
        middle = tets[6 * 13:6 * 14]
        report = self.refine(points, [tet for tet in tets if tet not in middle])
        self.assertEqual(report["input"]["triangles"], 12 * 9 + 12)


class Odd(RefineTest):
    def test_one_sliver(self):
        report = self.refine(SLIVER, [(0, 1, 2, 3)])
        self.assertEqual(report["before"]["quality"]["tets_below_deg"]["5"], 1)

    def test_inverted_and_flat(self):
        points, tets = block(2)
        a, b, c, d = tets[7]
        tets[7] = (a, c, b, d)
        square = [0, 1, 3, 4]  # on the lower side
        report = self.refine(points, tets + [tuple(square)])
        self.assertIn("1 of 49 tetrahedra are inverted, 1 flat", " ".join(report["input"]["notes"]))

    def test_only_flat(self):
        report = self.refine([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], [(0, 1, 2, 3)])
        self.assertEqual(report["before"]["quality"]["flat"], 1)

    def test_unused_vertices_are_left_out(self):
        points, tets = block(2)
        report = self.refine([(9.0, 9.0, 9.0)] + points, [tuple(v + 1 for v in tet) for tet in tets])
        self.assertIn("left out: 1 of 28 vertices", " ".join(report["input"]["notes"]))
        self.assertEqual(self.vertices()[:len(points)], points)

    def test_ids_in_errors_are_those_of_the_file(self):
        points, tets = block(1)
        near = (1e-13, 0.0, 0.0)
        self.write("in.mesh", medit([(9, 9, 9)] + points + [near],
                                    [tuple(v + 1 for v in tet) for tet in tets] + [(9, 2, 4, 8)]))
        self.refuse(2, "refine", "in.mesh", "-o", "out.vtu", saying=["1e-11", "1, 9"])

    def test_regions_are_not_kept(self):
        text = medit(*block(1)).replace("\n1 2 4 8 1\n", "\n1 2 4 8 5\n")
        self.write("in.mesh", text)
        self.assertIn("no regions", self.succeed("refine", "in.mesh", "-o", "out.vtu").stdout)

    def test_apart(self):
        points, tets = block(1)
        moved = [(x + 3, y, z) for x, y, z in points]
        self.refine(points + moved, tets + [tuple(v + len(points) for v in tet) for tet in tets])


class Refused(ProgramTest):
    def test_no_mesh(self):
        self.write("empty.mesh", "")
        self.write("nan.mesh", medit([(0, 0, "nan"), (1, 0, 0), (0, 1, 0), (0, 0, 1)], [(0, 1, 2, 3)]))
        self.write("none.mesh", medit([(0, 0, 0)], []))
        for name in ["empty.mesh", "nan.mesh", "none.mesh", "missing.mesh", self.cube()]:
            with self.subTest(name=name):
                self.refuse(2, "refine", name, "-o", "out.vtu", saying=[name])

    def test_options(self):
        self.write("in.mesh", medit(SLIVER, [(0, 1, 2, 3)]))
        for arguments, word in [(["--max-radius-edge", "1.2"], "1.368"), (["--strategy", "closure"], "closure"),
                                (["--box", "0 0 0 1 1 1"], "--box"), (["--size", "-1"], "--size")]:
            with self.subTest(arguments=arguments):
                self.refuse(2, "refine", "in.mesh", *arguments, "-o", "out.vtu", saying=[word])
        self.refuse(2, "refine", "in.mesh", "-o", "in.mesh", saying=["overwrite"])


if __name__ == "__main__":
    main()
