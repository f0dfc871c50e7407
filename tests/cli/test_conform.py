"""Boxes filled exactly, and the threads of the octree strategy."""

from program import ProgramTest, main

GRADED = ["--ball", "0.1 0.2 0.3 1", "--size", "0.03 + 0.1 * abs(x)", "--strategy", "octree"]


class Threads(ProgramTest):
    def mesh(self, *arguments, output="out.vtu"):
        self.succeed("mesh", *arguments, "-o", output, "--json", "report.json")
        return self.report("report.json")

    def test_every_number_gives_the_same_bytes(self):
        files = []
        for threads in ["1", "2", "3", None]:
            asked = ["--threads", threads] if threads else []
            report = self.mesh(*GRADED, *asked, "--no-verify", output=f"{threads}.vtu")
            self.assertEqual(report["options"]["threads"], int(threads or 0))
            self.assertTrue(threads is None or report["stats"]["threads"] == int(threads))
            self.assertGreater(report["mesh"]["tets"], 20_000)
            files.append((self.folder / f"{threads}.vtu").read_bytes())
        self.assertTrue(all(file == files[0] for file in files))

    def test_strategies_without_threads_say_so(self):
        for strategy in ["thrifty", "literal"]:
            report = self.mesh("--ball", "0 0 0 1", "--size", "0.5", "--strategy", strategy, "--threads", "2")
            self.assertEqual((report["stats"]["strategy"], report["stats"]["threads"]), (strategy, 1))

    def test_senseless_numbers(self):
        for threads in ["0", "-1", "2000", "1.5", "many"]:
            self.refuse(2, "mesh", *GRADED, "--threads", threads, "-o", "out.vtu", saying=["--threads"])


class Conform(ProgramTest):
    def fill(self, box, *arguments, output="out.vtu"):
        self.succeed("mesh", "--box", box, "--conform", *arguments, "-o", output, "--json", "report.json")
        report = self.report("report.json")
        self.assertEqual((report["status"], report["stats"]["strategy"]), ("done", "octree"))
        self.assertTrue(report["input"]["conform"] and report["verified"])
        self.assertTrue(any(check.startswith("box: ") for check in report["verify"]["checks"]))
        return report

    def test_fills_the_box_exactly(self):
        for size in ["0.11", "0.02 + 0.1 * abs(x)", "0.03 + 2 * abs(z - 0.5)"]:
            with self.subTest(size=size):
                report = self.fill("-0.5 0 0.25 1 2 1", "--size", size)
                self.assertAlmostEqual(report["quality"]["volume"], 1.5 * 2 * 0.75, delta=1e-10)
                self.assertGreaterEqual(report["verify"]["min_dihedral_deg"], 30)
                self.assertLessEqual(report["verify"]["max_dihedral_deg"], 135)
                self.assertLessEqual(report["verify"]["worst_size_ratio"], 1)
                self.assertGreater(report["mesh"]["boundary_triangles"], 100)

    def test_every_format_holds_the_marked_faces(self):
        counts = set()
        for name in ["a.vtu", "a.msh", "a.mesh", "a.node"]:
            for more in [[], ["--format", "msh22"], ["--ascii"]] if name == "a.msh" else [[]]:
                with self.subTest(name=name, more=more):
                    report = self.fill("0 0 0 1 1 2", "--size", "0.3", *more, output=name)
                    self.succeed("info", name, "--json", "info.json")
                    info = self.report("info.json")
                    self.assertEqual(info["triangle_labels"], [1, 2, 3, 4, 5, 6])
                    self.assertEqual(info["triangles"], report["mesh"]["boundary_triangles"])
                    counts.add(info["triangles"])
                    self.succeed("check", name)
        self.assertEqual(len(counts), 1)

    def test_every_number_of_threads_gives_the_same_bytes(self):
        files = set()
        for threads in ["1", "2", "3"]:
            self.fill("0 0 0 1 1 1", "--size", "0.02 + 0.1 * x", "--threads", threads)
            files.add((self.folder / "out.vtu").read_bytes())
        self.assertEqual(len(files), 1)

    def test_tells_how_much_finer_than_asked(self):
        notes = self.fill("0 0 0 1 1 1", "--size", "0.1")["notes"]
        self.assertIn("radius 0.0698771 where 0.1 was asked, so the mesh is 1.43 times as fine", " ".join(notes))
        self.assertEqual(self.fill("0 0 0 1 1 1", "--size", "0.07")["notes"], [])

    def test_proposes_a_box_that_fits(self):
        refused = self.refuse(2, "mesh", "--box", "0 0 0 0.3 0.6 0.3", "--conform", "-o", "out.vtu",
                              saying=["no equal cubes fill", "One that will do"])
        proposed = refused.stderr.split('is "')[1].split('"')[0]
        self.fill(proposed, "--size", "0.1")
        self.refuse(2, "mesh", "--box", "0 0 0 1 1 0.00001", "--conform", "-o", "out.vtu", saying=["too thin"])
        self.refuse(1, "mesh", "--box", "0 0 0 1 1 0.0001220703125", "--conform", "-o", "out.vtu",
                    saying=["67108864", "limit"])

    def test_refuses_what_contradicts_it(self):
        box = ["--box", "0 0 0 1 1 1", "--conform", "-o", "out.vtu"]
        for strategy in ["thrifty", "literal", "closure"]:
            self.refuse(2, "mesh", *box, "--strategy", strategy, saying=[f"--strategy {strategy}", "octree"])
        points = self.write("points.xyz", "0.1 0.2 0.3\n")
        self.refuse(2, "mesh", *box, "--points", points, saying=["--conform", "--points"])
        self.refuse(2, "mesh", *box, "--keep-partial", saying=["--keep-partial"])
        self.refuse(2, "mesh", "--ball", "0 0 0 1", "--conform", "-o", "out.vtu", saying=["--conform", "--box"])
        self.refuse(2, "mesh", "--points", points, "--conform", "-o", "out.vtu", saying=["--box"])


if __name__ == "__main__":
    main()
