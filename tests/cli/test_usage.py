"""Help, version, and commands that make no sense."""

import subprocess

from program import PROGRAM, ProgramTest, main

SUBCOMMANDS = ["mesh", "check", "convert", "embed", "info", "view", "prove"]


class Usage(ProgramTest):
    def test_help_has_examples(self):
        for topic in [[], *([name] for name in SUBCOMMANDS)]:
            with self.subTest(topic=topic):
                result = self.succeed(*topic, "--help")
                self.assertIn("Examples:\n  unsliver ", result.stdout)
                self.assertEqual(result.stderr, "")

    def test_help_names_every_subcommand(self):
        text = self.succeed("--help").stdout
        for name in SUBCOMMANDS:
            self.assertRegex(text, rf"(?m)^  {name} ")

    def test_version(self):
        self.assertRegex(self.succeed("--version").stdout, r"^unsliver \d+\.\d+\.\d+\n$")

    def test_help_states_the_relation_of_edges_and_sizes(self):
        # sqrt(5)/4 over the mean of 3 edges of length 1 and 4 of length sqrt(3)/2.
        self.assertIn(f"{(5 ** 0.5 / 4) / ((3 + 4 * 3 ** 0.5 / 2) / 7):.5f}", self.succeed("mesh", "--help").stdout)

    def test_nonsense(self):
        self.refuse(2, saying=["--help"])
        self.refuse(2, "tesselate", saying=["tesselate"])
        self.refuse(2, "mesh", "--frobnicate", "-o", "a.vtu", saying=["--frobnicate", "unsliver mesh --help"])
        self.refuse(2, "mesh", "--box", "0 0 0 1 1 1", saying=["--output"])

    def test_results_that_do_not_arrive_are_an_error(self):
        with open("/dev/full", "w") as full:
            result = subprocess.run([PROGRAM, "info", self.cube()], cwd=self.folder, stdout=full,
                                    stderr=subprocess.PIPE, text=True, check=False)
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assertIn("standard output", result.stderr)


if __name__ == "__main__":
    main()
