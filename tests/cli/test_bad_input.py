"""Bad input and bad usage: the exit code is right, and the message names the thing."""

import json
import os
import resource
import signal

from program import CUBE_POINTS, CUBE_TRIANGLES, ProgramTest, main, off, stl

BALL = ["--ball", "0 0 0 1"]
BOX = ["--box", "0 0 0 1 1 1"]
SIZE = ["--size", "0.4"]
OUT = ["-o", "out.vtu"]


class Surfaces(ProgramTest):
    def refuse_surface(self, name, content, *saying):
        self.write(name, content)
        self.refuse(2, "mesh", name, *SIZE, *OUT, saying=[name, *saying])
        self.refuse(2, "info", name, saying=[name])

    def test_empty_file(self):
        for name in ["a.off", "a.obj", "a.stl", "a.ply"]:
            with self.subTest(name=name):
                self.refuse_surface(name, "", "empty")

    def test_nan_coordinate(self):
        points = [list(p) for p in CUBE_POINTS]
        points[3][1] = "nan"
        self.refuse_surface("nan.off", off(points, CUBE_TRIANGLES), "nan")

    def test_nan_in_binary_stl(self):
        points = [list(p) for p in CUBE_POINTS]
        points[3][1] = float("nan")
        self.refuse_surface("nan.stl", stl(points, CUBE_TRIANGLES), "nan")

    def test_truncated_binary_stl(self):
        self.refuse_surface("cut.stl", stl(CUBE_POINTS, CUBE_TRIANGLES)[:-70], "12")

    def test_index_out_of_range(self):
        self.refuse_surface("index.off", off(CUBE_POINTS, CUBE_TRIANGLES[:-1] + [(1, 2, 88)]), "88")
        self.refuse_surface("index.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 44\n", "44")

    def test_degenerate_triangles_only(self):
        self.write("flat.off", off([(0, 0, 0), (1, 0, 0), (2, 0, 0)], [(0, 1, 2), (0, 0, 1)]))
        self.refuse(2, "mesh", "flat.off", *SIZE, *OUT, saying=["area"])

    def test_points_all_alike(self):
        self.write("dot.off", off([(1, 1, 1)] * 3, [(0, 1, 2)]))
        self.refuse(2, "mesh", "dot.off", *SIZE, *OUT)

    def test_no_triangles(self):
        self.refuse_surface("none.off", off(CUBE_POINTS, []), "triangle")

    def test_wrong_content(self):
        self.refuse_surface("image.off", b"\x89PNG\r\n\x1a\n")

    def test_missing_file_and_folder(self):
        self.refuse(2, "mesh", "nowhere.stl", *OUT, saying=["nowhere.stl", "no such file"])
        (self.folder / "folder.stl").mkdir()
        self.refuse(2, "mesh", "folder.stl", *OUT, saying=["folder.stl", "directory"])

    def test_unknown_extension(self):
        self.write("cube.xyzzy", off(CUBE_POINTS, CUBE_TRIANGLES))
        self.refuse(2, "mesh", "cube.xyzzy", *OUT, saying=["cube.xyzzy"])
        self.refuse(2, "info", "cube.xyzzy", saying=["cube.xyzzy"])


class Kinds(ProgramTest):
    """A file of another kind than asked for: the command that reads it is named."""

    def test_wrong_kind(self):
        cases = [
            ("mesh", "old.vtu", "`unsliver refine old.vtu`", "--points old.vtu"),
            ("mesh", "atoms.xyz", "--points atoms.xyz"),
            ("refine", "part.stl", "`unsliver mesh part.stl`"),
            ("refine", "atoms.csv", "`unsliver mesh --points atoms.csv`"),
        ]
        for command, name, *words in cases:
            with self.subTest(command=command, name=name):
                self.write(name, "whatever")
                self.refuse(2, command, name, *OUT, saying=words)

    def test_wrong_kind_for_tools(self):
        self.write("atoms.csv", "x,y,z\n1,2,3\n")
        self.cube()
        self.refuse(2, "check", "cube.off", saying=["the extension of a surface, not of a tetrahedral mesh"])
        self.refuse(2, "check", "atoms.csv", saying=["the extension of a file of points"])
        self.refuse(2, "info", "atoms.csv", saying=["surfaces (", "meshes ("])

    def test_points_that_are_none(self):
        self.write("header.csv", "x,y,z\n")
        self.refuse(2, "mesh", "--points", "header.csv", *OUT, saying=["header.csv", "a header, but no points"])
        self.write("header.xyz", "x y z\n1 2 3\n")
        self.refuse(2, "mesh", "--points", "header.xyz", *OUT, saying=["'x y z'"])


class Shapes(ProgramTest):
    def test_zero_volume(self):
        self.refuse(2, "mesh", "--box", "0 0 0 1 0 1", *SIZE, *OUT)
        self.refuse(2, "mesh", "--box", "0 0 1 1 1 0", *SIZE, *OUT)
        self.refuse(2, "mesh", "--ball", "0 0 0 0", *SIZE, *OUT)
        self.refuse(2, "mesh", "--ball", "0 0 0 -1", *SIZE, *OUT)

    def test_box_upside_down(self):
        self.refuse(2, "mesh", "--box", "0 1 2.5 1 0 -1", *SIZE, *OUT,
                    saying=["along y, z;", 'type --box "0 0 -1 1 1 2.5"'])
        self.refuse(2, "mesh", "--box", "0 0 1 1 1 1", *SIZE, *OUT, saying=["no extent along z"])
        self.refuse(2, "mesh", "--implicit", "x", "--bounds", "1 0 0 0 1 1", *SIZE, *OUT,
                    saying=["along x;", 'type --bounds "0 0 0 1 1 1"'])

    def test_not_finite(self):
        self.refuse(2, "mesh", "--box", "0 0 0 1 1 nan", *SIZE, *OUT, saying=["nan"])
        self.refuse(2, "mesh", "--ball", "0 0 0 inf", *SIZE, *OUT, saying=["inf"])

    def test_wrong_count_or_no_number(self):
        self.refuse(2, "mesh", "--box", "0 0 0 1 1", *OUT, saying=["--box", "6", "5"])
        self.refuse(2, "mesh", "--ball", "0 0 0 r", *OUT, saying=["--ball", '"r"'])

    def test_formula(self):
        bounds = ["--bounds", "-2 -2 -2 2 2 2"]
        self.refuse(2, "mesh", "--implicit", "x^2 + * y", *bounds, *SIZE, *OUT, saying=["x^2 + * y"])
        self.refuse(2, "mesh", "--implicit", "x^2 + y^2 + z^2 + 1", *bounds, *SIZE, *OUT)

    def test_number_of_inputs(self):
        self.refuse(2, "mesh", *OUT, saying=["--box", "--ball", "--implicit"])
        self.refuse(2, "mesh", self.cube(), *BALL, *OUT, saying=["2 inputs"])
        self.refuse(2, "mesh", *BOX, *BALL, *OUT, saying=["2 inputs"])


class Sizes(ProgramTest):
    def test_not_positive(self):
        for size in ["0", "-1", "nan", "inf", "-0.0"]:
            with self.subTest(size=size):
                self.refuse(2, "mesh", *BALL, "--size", size, *OUT, saying=["--size"])
                self.refuse(2, "mesh", *BALL, "--edge-length", size, *OUT, saying=["--edge-length"])

    def test_formula_that_fails(self):
        for formula in ["x", "0 * x", "sqrt(x - 10)", "x / 0", "1 / 0"]:
            with self.subTest(formula=formula):
                self.refuse(2, "mesh", *BALL, "--size", formula, *OUT)

    def test_formula_that_reaches_zero_at_the_border(self):
        self.refuse(2, "mesh", *BOX, "--size", "x", *OUT, saying=["near (", "max(formula, smallest size)"])

    def test_formula_that_does_not_parse(self):
        for option in ["--size", "--edge-length"]:
            for formula in ["0.1 +", "0.1 * w", "", "sin 3 4"]:
                with self.subTest(option=option, formula=formula):
                    self.refuse(2, "mesh", *BALL, option, formula, *OUT)

    def test_decimal_comma(self):
        self.refuse(2, "mesh", *BALL, "--size", "0,25", *OUT, saying=['--size is "0,25": write 0.25'])

    def test_column_of_a_fault_is_the_users(self):
        caret = "\n  0.1 + * x\n        ^\n"
        for option in ["--size", "--edge-length"]:
            self.refuse(2, "mesh", *BALL, option, "0.1 + * x", *OUT, saying=[option, "column 7", caret])

    def test_caret_in_unusual_formulas(self):
        long = "1 + " * 60
        self.refuse(2, "mesh", *BALL, "--size", long + "* x + 1", *OUT,
                    saying=["\n  " + long[190:] + "* x + 1\n  " + 50 * " " + "^\n"])
        self.refuse(2, "mesh", *BALL, "--size", "1 +\n* x", *OUT, saying=["\n  1 + * x\n      ^\n"])
        self.refuse(2, "mesh", "--implicit", "x +", "--bounds", "0 0 0 1 1 1", *OUT,
                    saying=["--implicit: ", "\n  x +\n     ^\n"])

    def test_missing_size_mesh(self):
        self.refuse(2, "mesh", *BALL, "--size-mesh", "none.mesh", *OUT, saying=["none.mesh"])


class Limits(ProgramTest):
    def test_estimate_exceeds_the_cap(self):
        self.refuse(1, "mesh", *BALL, "--size", "0.01", "--max-tets", "100k", *OUT, saying=["--max-tets 100,000"])
        for memory in ["1M", "1k", "1K"]:
            self.refuse(1, "mesh", *BALL, "--size", "0.01", "--max-memory", memory, *OUT,
                        saying=["expected are", "--max-memory"])

    def test_estimate_exceeds_the_machine(self):
        for size in ["1e-5", "1e-30", "1e-300"]:
            with self.subTest(size=size):
                self.refuse(1, "mesh", *BALL, "--size", size, *OUT)

    def test_refusal_is_told_to_machines(self):
        result = self.run_program("mesh", *BALL, "--size", "0.01", "--max-tets", "1k", *OUT, "--json", "-")
        self.assertEqual(result.returncode, 1)
        report = json.loads(result.stdout)
        self.assertEqual((report["status"], report["error"]["code"], report["output"]), ("refused", "limit", None))

    def test_senseless_caps(self):
        for option in ["--max-tets", "--max-memory"]:
            for value in ["0", "-5", "many", "nan", "10Q"]:
                with self.subTest(option=option, value=value):
                    self.refuse(2, "mesh", *BALL, *SIZE, option, value, *OUT, saying=[option, value])


class Options(ProgramTest):
    def test_without_effect(self):
        cases = [
            ("--bounds", [*BALL, "--bounds", "0 0 0 1 1 1"]),
            ("--bounds", ["--implicit", "x"]),
            ("--size-gradation", [*BALL, "--size-gradation", "0.2"]),
            ("--size-max", [*BALL, *SIZE, "--size-max", "1"]),
            ("--size-max", [*BALL, "--size", "0.3 + 0.01 * x", "--size-gradation", "0.2", "--size-max", "1"]),
            ("--size-max", [self.cube(), *SIZE, "--size-max", "1"]),
            ("--ascii", [*BALL, *SIZE, "--ascii"]),
            ("--keep-partial", [*BALL, *SIZE, "--strategy", "octree", "--keep-partial"]),
        ]
        for option, case in cases:
            with self.subTest(case=case):
                self.refuse(2, "mesh", *case, *OUT, saying=[option])

    def test_stricter_than_proven(self):
        cases = [("--min-angle", "31"), ("--min-angle", "0"), ("--min-angle", "nan"), ("--max-angle", "134"),
                 ("--max-angle", "180"), ("--max-radius-edge", "1"), ("--max-radius-edge", "nan")]
        for option, value in cases:
            with self.subTest(option=option, value=value):
                self.refuse(2, "mesh", *BALL, *SIZE, option, value, *OUT, saying=[option])

    def test_unknown_choices(self):
        self.refuse(2, "mesh", *BALL, "--strategy", "lucky", *OUT, saying=["lucky"])
        self.refuse(2, "mesh", *BALL, "--format", "dxf", *OUT, saying=["dxf"])


class Typing(ProgramTest):
    """Slips of the keyboard: what was meant is named."""

    def test_mistyped_names(self):
        cases = [
            (["mehs", *BALL], '"mehs"', "did you mean mesh?"),
            (["version"], "did you mean --version?"),
            (["mesh", *BALL, *OUT, "--sise", "0.4"], "unknown option --sise; did you mean --size?"),
            (["mesh", *BALL, *OUT, "-size=0.4"], "unknown option -size; did you mean --size?"),
            (["mesh", *BALL, *OUT, "--edge", "0.4"], "did you mean --edge-length?"),
            (["mesh", *BALL, *SIZE, "--outptu", "out.vtu"], "did you mean --output?"),
            (["refine", "old.vtu", "--sise", "0.4", *OUT], "did you mean --size?", "unsliver refine --help"),
            (["mesh", *BALL, *OUT, "--strategy", "trifty"], "--strategy", "did you mean thrifty?"),
            (["mesh", *BALL, *OUT, "--format", "vtk"], "did you mean vtu?"),
            (["help", "veiw"], "did you mean view?"),
        ]
        for arguments, *words in cases:
            with self.subTest(arguments=arguments):
                self.refuse(2, *arguments, saying=words)

    def test_no_wild_guesses(self):
        for arguments in [["tessellate"], ["mesh", *BALL, *OUT, "--frobnicate"], ["mesh", *BALL, *OUT, "-q"],
                          ["mesh", *BALL, *OUT, "--strategy", "lucky"]]:
            with self.subTest(arguments=arguments):
                self.assertNotIn("did you mean", self.refuse(2, *arguments).stderr)

    def test_file_without_a_command(self):
        self.refuse(2, self.cube(), *OUT, saying=["did you mean `unsliver mesh cube.off`?"])

    def test_numbers_without_quotes(self):
        for numbers in [["0", "0", "0", "1", "1", "1"], ["-1", "-1", "-1", "1", "1", "1"]]:
            self.refuse(2, "mesh", "--box", *numbers, *OUT, saying=["in quotes"])

    def test_values(self):
        cases = [
            (["--size"], "--size needs a value"),
            (["--size", "0.4", "--size", "0.5"], "--size is given 2 times"),
            (["--min-angle", "steep"], '--min-angle: "steep" is not a number'),
            (["--size", ""], "--size: the value is empty"),
            (["--size", " "], "--size: the value is empty"),
            (["--max-tets", ""], "--max-tets: the value is empty"),
            (["--json", ""], "--json: the value is empty"),
            (["-o", ""], "--output: the value is empty"),
            ([""], "INPUT: the value is empty"),
        ]
        for arguments, words in cases:
            with self.subTest(arguments=arguments):
                self.refuse(2, "mesh", *BALL, *arguments, saying=[words])

    def test_whole_numbers(self):
        for worst in ["x", "-1", "1.5"]:
            self.refuse(2, "check", "a.vtu", "--worst", worst, saying=["--worst", "whole number"])

    def test_required(self):
        self.refuse(2, "refine", *OUT, saying=["MESH is required (mesh file"])

    def test_no_command(self):
        self.refuse(2, saying=["no command is given: mesh, refine"])

    def test_help_command(self):
        self.assertEqual(self.succeed("help").stdout, self.succeed("--help").stdout)
        self.assertEqual(self.succeed("help", "mesh").stdout, self.succeed("mesh", "--help").stdout)


class Outputs(ProgramTest):
    def test_unknown_extension(self):
        self.refuse(2, "mesh", *BALL, *SIZE, "-o", "out.doc", saying=["out.doc"])
        self.refuse(2, "mesh", *BALL, *SIZE, "-o", "out", saying=["out"])

    def test_extension_of_another_format(self):
        for name, form in [("out.vtu", "tetgen"), ("out", "tetgen"), ("out.msh", "vtu"), ("out.vtu", "msh41")]:
            with self.subTest(name=name, format=form):
                self.refuse(2, "mesh", *BALL, *SIZE, "-o", name, "--format", form, saying=[name, "--format " + form])

    def test_missing_directory(self):
        # Before the run: a size that would take hours does not matter.
        self.refuse(2, "mesh", *BALL, "--size", "1e-4", "-o", "no/such/out.vtu", saying=["no/such"])
        self.refuse(2, "mesh", *BALL, *SIZE, *OUT, "--json", "no/such.json", saying=["no/such.json"])
        self.refuse(2, "mesh", *BALL, *SIZE, "-o", "out.vtu/", saying=["out.vtu/"])

    def test_one_file_for_two_things(self):
        self.cube()
        (self.folder / "link.json").symlink_to("cube.off")
        cube = (self.folder / "cube.off").read_bytes()
        for output, report in [("out.vtu", "./cube.off"), ("out.vtu", "link.json"), ("cube.off", "report.json"),
                               ("new.vtu", f"{self.folder}/new.vtu"), ("new.node", "new.ele")]:
            with self.subTest(output=output, report=report):
                self.refuse(2, "mesh", "cube.off", *SIZE, "-o", output, "--format", "vtu", "--json", report,
                            saying=["give"])
                self.assertEqual((self.folder / "cube.off").read_bytes(), cube)

    def test_report_onto_geometry(self):
        """Not an input of this run, but hardly meant to be lost."""
        self.cube()
        self.refuse(2, "mesh", *BALL, *SIZE, *OUT, "--json", "cube.off", saying=["cube.off", "report.json"])
        self.refuse(2, "info", "cube.off", "--json", "other.vtu", saying=["other.vtu", "report.json"])

    def test_standard_output_is_named(self):
        self.refuse(2, "mesh", *BALL, *SIZE, "-o", "-", "--format", "msh22", saying=["/dev/stdout"])
        result = self.succeed("mesh", *BALL, *SIZE, "-o", "/dev/stdout", "--format", "medit", "--quiet")
        self.assertTrue(result.stdout.startswith("MeshVersionFormatted"))

    def test_name_too_long(self):
        # Before the run: a size that would take hours does not matter.
        self.refuse(2, "mesh", *BALL, "--size", "1e-4", "-o", 240 * "x" + ".vtu", saying=["too long"])

    def test_missing_directory_is_told_once(self):
        errors = self.refuse(2, "mesh", *BALL, *SIZE, *OUT, "--json", "no/such.json").stderr
        self.assertEqual(errors.count("unsliver: error: "), 1, errors)

    def test_read_only_directory(self):
        if os.geteuid() == 0:
            self.skipTest("root may write anywhere")
        (self.folder / "locked").mkdir(mode=0o500)
        self.refuse(2, "mesh", *BALL, *SIZE, "-o", "locked/out.vtu", saying=["locked"])

    def test_full_disk(self):
        for name, form in [("/dev/full", "vtu"), ("/dev/full", "msh22"), ("/dev/full", "medit")]:
            with self.subTest(format=form):
                self.refuse(2, "mesh", *BALL, *SIZE, "-o", name, "--format", form, saying=["/dev/full", "space"])
        self.refuse(2, "mesh", *BALL, *SIZE, "-o", "/dev/null", "--format", "vtu", "--json", "/dev/full",
                    saying=["/dev/full", "space"])

    def test_full_disk_leaves_the_old_file(self):
        """A limit on the size of files stands in for a disk that fills up halfway."""
        for name in ["out.vtu", "out.msh", "out.mesh", "out.node"]:
            with self.subTest(name=name):
                self.write(name, "precious")
                self.refuse(2, "mesh", *BALL, *SIZE, "-o", name, saying=["out."], preexec_fn=small_files_only)
                self.assertEqual((self.folder / name).read_text(), "precious")


def small_files_only():
    signal.signal(signal.SIGXFSZ, signal.SIG_DFL)
    resource.setrlimit(resource.RLIMIT_FSIZE, (1000, 1000))


class Meshes(ProgramTest):
    def test_unreadable(self):
        for name, content in [("a.vtu", ""), ("a.msh", "$MeshFormat\n"), ("a.mesh", "hello"), ("a.node", "")]:
            with self.subTest(name=name):
                self.write(name, content)
                self.refuse(2, "check", name, saying=["a."])
                self.refuse(2, "convert", name, "b.vtu", saying=["a."])
                self.refuse(2, "view", name, "-o", "b.png", saying=["a."])

    def test_missing(self):
        self.refuse(2, "check", "none.vtu", saying=["none.vtu", "no such file"])
        self.refuse(2, "convert", "none.vtu", "b.vtu", saying=["none.vtu"])
        self.refuse(2, "view", "none.vtu", "-o", "b.png", saying=["none.vtu"])


if __name__ == "__main__":
    main()
