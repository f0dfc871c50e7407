"""What the reports claim: estimates, limits, guarantees."""

import random

from program import ProgramTest, main

BALL = ["--ball", "0 0 0 1"]


class Estimates(ProgramTest):
    def made(self, *arguments):
        """Estimated and made, in tetrahedra."""
        self.succeed(*arguments, "-o", "out.vtu", "--json", "report.json")
        report = self.report("report.json")
        return report["estimate"]["tets"], report["mesh"]["tets"]

    def test_near_what_is_made(self):
        generator = random.Random(3)
        self.write("points.csv", "".join("{},{},{}\n".format(*(generator.random() for _ in "xyz")) for _ in range(300)))
        self.succeed("mesh", *BALL, "--size", "0.2", "-o", "ball.vtu")
        loose = ["--min-angle", "15", "--max-angle", "150", "--max-radius-edge", "1.5"]
        for arguments in [["mesh", "--box", "0 0 0 2 1 1", "--size", "0.1"], ["mesh", *BALL, "--size", "0.1"],
                          ["mesh", "--points", "points.csv"], ["mesh", "--points", "points.csv", *loose],
                          ["refine", "ball.vtu"], ["refine", "ball.vtu", *loose]]:
            with self.subTest(arguments=arguments):
                estimated, made = self.made(*arguments)
                self.assertLess(estimated, 1.5 * made)
                self.assertGreater(1.5 * estimated, made)

    def test_refused_only_when_surely_too_many(self):
        """Past the limit by the estimate alone a run starts, and the limit itself decides."""
        estimated, _ = self.made("mesh", *BALL, "--size", "0.1")
        for share, status in [(0.45, "refused"), (0.55, "tet_cap"), (1.5, "done")]:
            with self.subTest(share=share):
                self.run_program("mesh", *BALL, "--size", "0.1", "--max-tets", int(share * estimated), "-o", "out.vtu",
                                 "--json", "report.json")
                self.assertEqual(self.report("report.json")["status"], status)


if __name__ == "__main__":
    main()
