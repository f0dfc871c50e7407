"""What the reports claim: estimates, limits, guarantees."""

import random

from program import ProgramTest, main, medit

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


class Limits(ProgramTest):
    LOOSE = ["--min-angle", "15", "--max-angle", "150", "--max-radius-edge", "1.5"]

    def held_to(self, name, *arguments, code=0):
        result = self.run_program("check", name, *arguments, "--json", "check.json")
        self.assertEqual(result.returncode, code, result.stdout + result.stderr)
        return tuple(self.report("check.json")["held_to"].values()), result.stdout

    def test_check_judges_a_mesh_by_what_it_was_made_for(self):
        generator = random.Random(5)
        self.write("points.csv", "".join("{},{},{}\n".format(*(generator.random() for _ in "xyz")) for _ in range(60)))
        self.succeed("mesh", "--points", "points.csv", *self.LOOSE, "-o", "out.vtu")
        limits, table = self.held_to("out.vtu")
        self.assertEqual(limits, (15, 150, 1.5))
        self.assertIn("held to: dihedral angles of 15 degrees or more", table)
        self.succeed("convert", "out.vtu", "again.vtu")
        self.assertEqual(self.held_to("again.vtu")[0], (15, 150, 1.5))
        self.assertEqual(self.held_to("out.vtu", "--min-angle", "14")[0], (14, 150, 1.5))
        self.held_to("out.vtu", "--min-angle", "30", code=1)
        self.succeed("convert", "out.vtu", "out.mesh")
        self.succeed("refine", "out.vtu", *self.LOOSE, "-o", "twice.vtu")

    def test_strictest_by_default(self):
        self.succeed("mesh", *BALL, "--size", "0.4", "-o", "out.vtu")
        self.assertEqual(self.held_to("out.vtu")[0], (30, 135, 5 ** 0.5 / 2))

    def test_unfinished_mesh_promises_nothing_in_its_file(self):
        self.run_program("mesh", *BALL, "--size", "0.05", "--max-tets", "5k", "--keep-partial", "-o", "out.vtu")
        self.assertNotIn(b"unsliver_limits", (self.folder / "out.vtu").read_bytes())

    def test_only_what_was_asked_for(self):
        self.write("corner.mesh", medit([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], [(0, 1, 2, 3)]))
        limits, table = self.held_to("corner.mesh", "--min-angle", "10")
        self.assertEqual(limits, (10, None, None))
        self.assertIn("held to: dihedral angles of 10 degrees or more\n", table)


class Claims(ProgramTest):
    def report_of(self, *arguments):
        result = self.run_program(*arguments, "-o", "out.vtu", "--json", "report.json")
        return self.report("report.json"), result.stdout

    def test_verified(self):
        report, table = self.report_of("mesh", *BALL, "--size", "0.4")
        self.assertEqual((report["guaranteed"], report["verified"]), (True, True))
        self.assertIn("achieved", table)
        self.assertNotIn("not verified", table)

    def test_nothing_is_claimed_without_verification(self):
        report, table = self.report_of("mesh", *BALL, "--size", "0.4", "--no-verify")
        self.assertFalse(report["verified"])
        self.assertEqual(table.count("not verified"), 3)
        self.assertIn("measured", table)
        self.assertNotIn("achieved", table)

    def test_limits_that_are_met_print_as_they_are(self):
        """On the ball 60 and 90 degrees are attained, and most doubles miss them."""
        report, _ = self.report_of("mesh", *BALL, "--size", "0.1")
        self.succeed("check", "out.vtu", "--json", "check.json")
        for measured in [report["quality"], report["verify"], self.report("check.json")["quality"],
                         self.report("check.json")["verify"], *report["quality"]["worst"]]:
            self.assertEqual((measured["min_dihedral_deg"], measured["max_dihedral_deg"]), (60, 90))

    def test_never_beyond_what_was_kept(self):
        self.write("points.csv", "0.1,0.2,0.3\n0.9,0.8,0.8\n0.2,0.9,0.1\n0.6,0.4,0.7\n")
        for arguments in [["--points", "points.csv"], [*BALL, "--size", "0.1 + 0.2 * (x + 1)"]]:
            report, _ = self.report_of("mesh", *arguments)
            for measured in [report["quality"], report["verify"]]:
                self.assertGreaterEqual(measured["min_dihedral_deg"], report["options"]["min_dihedral_deg"])
                self.assertLessEqual(measured["max_dihedral_deg"], report["options"]["max_dihedral_deg"])
                self.assertLessEqual(measured["max_radius_edge"], report["options"]["max_radius_edge"])

    def test_options_of_a_failed_run(self):
        report, _ = self.report_of("mesh", *BALL, "--min-angle", "40")
        self.assertIsNone(report["options"])
        report, _ = self.report_of("mesh", "none.stl", "--min-angle", "20")
        self.assertEqual((report["options"]["min_dihedral_deg"], report["options"]["max_radius_edge"]),
                         (20, 5 ** 0.5 / 2))

    def test_no_infinities_in_tables(self):
        self.write("flat.mesh", medit([(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0)], [(0, 1, 2, 3)]))
        table = self.run_program("check", "flat.mesh").stdout.split("Checked")[0]
        self.assertIn("largest radius-edge ratio unbounded", table)
        self.assertNotIn("inf", table)
        _, table = self.report_of("mesh", *BALL, "--size", "0.4", "--max-radius-edge", "inf")
        self.assertIn("unbounded", table)
        self.assertNotIn("inf", table)


if __name__ == "__main__":
    main()
