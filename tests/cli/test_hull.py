"""The convex hull of points as the domain: `unsliver mesh --points FILE --hull`."""

import math
import random

from program import CUBE_POINTS, ProgramTest, main


def rows(points):
    return "".join(",".join(map(repr, p)) + "\n" for p in points)


def scattered(count, seed, scale=(1.0, 1.0, 1.0)):
    generator = random.Random(seed)
    return [tuple(s * generator.random() for s in scale) for _ in range(count)]


def on_sphere(count, seed):
    return [tuple(x / math.dist(p, (0, 0, 0)) for x in p)
            for p in [tuple(c - 0.5 for c in q) for q in scattered(count, seed)]]


class Hull(ProgramTest):
    def mesh(self, points, *arguments, output="out.node"):
        """The report, in which every promise is kept; TetGen's file begins with the points, bit for bit."""
        name = self.write("points.csv", rows(points))
        self.succeed("mesh", "--points", name, *arguments, "-o", output, "--json", "report.json")
        report = self.report("report.json")
        self.assertTrue(report["guaranteed"] and report["verified"])
        if output.endswith(".node"):
            lines = (self.folder / output).read_text().splitlines()[1:len(points) + 1]
            self.assertEqual([tuple(map(float, line.split()[1:4])) for line in lines], [p[:3] for p in points])
        return report

    def test_report(self):
        report = self.mesh(CUBE_POINTS + scattered(20, seed=1), "--hull")
        told = report["input"]
        self.assertEqual((told["kind"], told["label"]), ("hull", "convex hull of points.csv"))
        self.assertEqual((told["points"], told["triangles"], told["notes"]), (8, 12, []))
        self.assertIn("convex hull of 28 points, 12 triangles", told["domain"])
        self.assertEqual(told["bounds"], {"lo": [0, 0, 0], "hi": [1, 1, 1]})
        self.assertEqual(report["notes"], [])
        self.assertIn("convex hull of points.csv", self.succeed("mesh", "--points", "points.csv", "--hull", "-o",
                                                                "out.vtu").stdout)

    def test_smaller_than_the_box(self):
        points = on_sphere(100, seed=2)
        box = self.mesh(points)
        hull = self.mesh(points, "--hull")
        self.assertLess(hull["verify"]["volume"], box["verify"]["volume"])
        self.assertLess(hull["mesh"]["tets"], box["mesh"]["tets"])
        self.assertEqual(hull["input"]["triangles"], 2 * 100 - 4)

    def test_many_points_in_the_faces(self):
        for step in [0.25, 0.1]:
            with self.subTest(step=step):
                grid = [(step * x, step * y, step * z) for x in range(4) for y in range(4) for z in range(4)]
                report = self.mesh(grid, "--hull")
                self.assertEqual((report["input"]["notes"], report["notes"]), ([], []))
                turned = [(0.8 * x - 0.6 * y, 0.6 * x + 0.8 * y, z + 0.3 * x) for x, y, z in grid]
                self.assertEqual(self.mesh(turned, "--hull")["notes"], [])

    def test_sizes(self):
        points = [(*p, 0.2) for p in scattered(10, seed=3)]
        for arguments in [[], ["--size", "0.15"], ["--size", "0.1", "--size-gradation", "0.5"]]:
            with self.subTest(arguments=arguments):
                self.assertGreater(self.mesh(points, "--hull", *arguments)["verify"]["worst_size_ratio"], 0)

    def test_thin_but_not_flat(self):
        for scale in [(1.0, 1.0, 1e-8), (1e-8, 1.0, 1e-8)]:
            with self.subTest(scale=scale):
                self.mesh(scattered(15, seed=4, scale=scale), "--hull")

    def test_same_bytes_always(self):
        for output in ["a.vtu", "b.vtu"]:
            self.mesh(scattered(40, seed=5), "--hull", output=output)
        self.assertEqual((self.folder / "a.vtu").read_bytes(), (self.folder / "b.vtu").read_bytes())


class Refused(ProgramTest):
    def test_without_volume(self):
        for points, words in [([(1.0, 2.0, 3.0)], "single point"),
                              ([(1.0, 2.0, 3.0)] * 4, "at one place"),
                              ([(0.1 * i, 0.2 * i, 0.3 * i) for i in range(10)], "on a line"),
                              ([(x, y, 0.5 * x - 2 * y) for x, y, _ in scattered(15, seed=6)], "in a plane")]:
            with self.subTest(words=words):
                name = self.write("points.csv", rows(points))
                self.refuse(2, "mesh", "--points", name, "--hull", "-o", "out.vtu",
                            saying=["points.csv", words, "no volume", "without --hull their bounding box is meshed"])

    def test_where_it_means_nothing(self):
        name = self.write("points.csv", rows(scattered(10, seed=7)))
        self.refuse(2, "mesh", self.cube(), "--hull", "-o", "out.vtu", saying=["--hull", "needs --points"])
        self.refuse(2, "mesh", "--hull", "-o", "out.vtu", saying=["--hull", "needs --points"])
        for domain in [["--box", "0 0 0 1 1 1"], ["--ball", "0 0 0 1"], [self.cube()]]:
            with self.subTest(domain=domain):
                self.refuse(2, "mesh", *domain, "--points", name, "--hull", "-o", "out.vtu", saying=["leave it out"])


if __name__ == "__main__":
    main()
