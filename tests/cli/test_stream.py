"""Meshes in folders of plain arrays, made and judged piece by piece."""

import json
import resource
import signal
import struct
import subprocess
import time

from program import PROGRAM, ProgramTest, main

BALL = ["--ball", "0.1 0.2 0.3 1", "--size", "0.15"]
GRADED = ["--ball", "0.1 0.2 0.3 1", "--size", "0.03 + 0.1 * abs(x)", "--strategy", "octree"]
FILES = ["levels.u8", "manifest.json", "points.f64", "tets.u32"]


class StreamTest(ProgramTest):
    def stream(self, *arguments, folder="out"):
        self.succeed("mesh", *arguments, "--stream", folder, "--json", "report.json")
        return self.report("report.json")

    def contents(self, folder):
        return {path.name: path.read_bytes() for path in (self.folder / folder).iterdir()}


class Streams(StreamTest):
    def test_holds_the_mesh_of_the_arrays(self):
        for number, job in enumerate([BALL, GRADED]):
            whole = self.report_of(*job)
            for threads in ["1", "2", "3"]:
                folder = f"out{number}{threads}"
                report = self.stream(*job, "--threads", threads, folder=folder)
                self.assertEqual((report["status"], report["verified"], report["output"]), ("done", True, folder))
                self.assertEqual(report["mesh"], whole["mesh"])
                for key in ["min_dihedral_deg", "max_dihedral_deg", "max_radius_edge"]:
                    self.assertAlmostEqual(report["verify"][key], whole["verify"][key], places=12)
                quality, expected = report["quality"], whole["quality"]
                for key in ["dihedral_histogram_5_deg", "tets_below_deg", "tets_outside_30_135", "inverted"]:
                    self.assertEqual(quality[key], expected[key])
                self.assertAlmostEqual(quality["volume"], expected["volume"], places=9)
                self.assertEqual(sorted(self.contents(folder)), FILES)
                self.succeed("convert", folder, "streamed.mesh")
                self.succeed("convert", "whole.vtu", "whole.mesh")
                self.assertEqual((self.folder / "streamed.mesh").read_bytes(),
                                 (self.folder / "whole.mesh").read_bytes())
                self.assertEqual(self.contents(folder), self.contents(f"out{number}1"))

    def report_of(self, *job):
        self.succeed("mesh", *job, "-o", "whole.vtu", "--json", "report.json")
        return self.report("report.json")

    def test_converts_to_a_mesh_with_its_guarantees(self):
        self.stream(*BALL, "--min-angle", "25")
        self.succeed("convert", "out", "out.vtu")
        self.succeed("check", "out.vtu", "--json", "check.json")
        check = self.report("check.json")
        self.assertTrue(check["ours"])
        self.assertEqual(check["held_to"]["min_dihedral_deg"], 25)

    def test_manifest(self):
        report = self.stream(*BALL)
        manifest = self.report("out/manifest.json")
        self.assertEqual((manifest["version"], manifest["byte_order"]), (1, "little"))
        self.assertEqual((manifest["vertices"], manifest["tets"]),
                         (report["mesh"]["vertices"], report["mesh"]["tets"]))
        for file in manifest["files"].values():
            self.assertEqual((self.folder / "out" / file["name"]).stat().st_size, file["bytes"])

    def test_no_verify(self):
        report = self.stream(*BALL, "--no-verify")
        self.assertFalse(report["verified"])
        self.assertIsNone(report["quality"])

    def test_memory_does_not_follow_the_tetrahedra(self):
        peaks, held, tets = [], [], []
        for size in ["0.03", "0.012"]:
            report = self.stream("--ball", "0 0 0 1", "--size", size, "--threads", "1", "--no-verify",
                                 folder="out" + size)
            peaks.append(report["memory"]["peak_resident_bytes"])
            held.append(report["stats"]["peak_bytes"])
            tets.append(report["mesh"]["tets"])
        self.assertGreater(tets[1], 4_000_000)
        self.assertLess((held[1] - held[0]) / (tets[1] - tets[0]), 3)
        # Sanitizers multiply what the process holds; the tetrahedra alone would be 16 bytes each.
        self.assertLess((peaks[1] - peaks[0]) / (tets[1] - tets[0]), 12)


class Refused(StreamTest):
    def test_combinations(self):
        self.write("points.xyz", "0 0 0\n1 1 1\n0 1 0\n0 0 1\n")
        (self.folder / "there").mkdir()
        for arguments, word in [
                ([*BALL, "-o", "x.vtu"], "leave out --output"),
                ([*BALL, "--format", "vtu"], "--format"),
                ([*BALL, "--keep-partial"], "--keep-partial"),
                ([*BALL, "--strategy", "thrifty"], "octree"),
                ([*BALL, "--strategy", "closure"], "octree"),
                (["--box", "0 0 0 1 1 1", "--conform"], "--conform"),
                (["--points", "points.xyz"], "without points"),
                (["--ball", "0 0 0 1", "--size", "0.05 + 0.9 * abs(x)"], "only the octree strategy")]:
            with self.subTest(arguments=arguments):
                self.refuse(2, "mesh", *arguments, "--stream", "out", saying=[word])
        self.refuse(2, "mesh", *BALL, "--stream", "there", saying=["something of that name"])
        self.refuse(2, "mesh", *BALL, "--stream", "no/where", saying=["there is no directory no"])
        self.refuse(2, "mesh", *BALL, saying=["--output is required"])

    def test_caps_leave_nothing(self):
        self.refuse_quietly(1, *BALL, "--max-tets", "3000")
        self.refuse_quietly(1, *BALL, "--max-tets", "10")

    def refuse_quietly(self, code, *arguments):
        result = self.run_program("mesh", *arguments, "--stream", "out")
        self.assertEqual(result.returncode, code, result.stderr)
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_full_disk(self):
        result = subprocess.run([PROGRAM, "mesh", *BALL, "--stream", "out"], cwd=self.folder, text=True,
                                capture_output=True, timeout=120, check=False,
                                preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (10000, 10000)))
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assertIn("cannot write 'out.", result.stderr)
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_interrupt(self):
        run = subprocess.Popen([PROGRAM, "mesh", "--ball", "0 0 0 1", "--size", "0.008", "--stream", "out"],
                               cwd=self.folder, stderr=subprocess.PIPE, stdout=subprocess.PIPE)
        until = time.monotonic() + 60
        while not any(self.folder.glob("*.part/tets.u32")) and time.monotonic() < until:
            time.sleep(0.01)
        run.send_signal(signal.SIGINT)
        run.communicate(timeout=60)
        self.assertEqual(run.returncode, 1)
        self.assertEqual(list(self.folder.iterdir()), [])


class Check(StreamTest):
    def setUp(self):
        super().setUp()
        self.cube()
        self.stream("cube.off", "--size", "0.2")

    def patch(self, name, offset, layout, change):
        with open(self.folder / "out" / name, "r+b") as file:
            file.seek(offset)
            values = list(struct.unpack(layout, file.read(struct.calcsize(layout))))
            change(values)
            file.seek(offset)
            file.write(struct.pack(layout, *values))

    def faults(self, *arguments, mesh="out"):
        result = self.run_program("check", mesh, "--json", "check.json", "--against", "cube.off", *arguments)
        self.assertEqual(result.returncode, 1, result.stderr)
        return {finding["check"] for finding in self.report("check.json")["verify"]["findings"]}

    def test_sound(self):
        self.succeed("check", "out", "--json", "check.json", "--against", "cube.off")
        check = self.report("check.json")
        self.assertTrue(check["verify"]["ok"])
        self.assertEqual(check["tets"], sum(check["quality"]["dihedral_histogram_5_deg"]) / 6)
        self.assertIn("no fault found", self.succeed("check", "out").stdout)

    def test_swapped_corners(self):
        def swap(t):
            t[0], t[1] = t[1], t[0]
        self.patch("tets.u32", 16 * 40, "<4I", swap)
        self.assertIn("orientation", self.faults())

    def test_another_vertex(self):
        tets = self.report("out/manifest.json")["tets"]
        for tet in range(3, tets, tets // 8):
            self.setUp_again()
            self.patch("tets.u32", 16 * tet, "<4I", lambda t: t.__setitem__(2, max(t) + 1 if max(t) < 100 else 0))
            self.assertTrue(self.faults())

    def setUp_again(self):
        for path in (self.folder / "out").iterdir():
            path.unlink()
        (self.folder / "out").rmdir()
        self.stream("cube.off", "--size", "0.2")

    def test_moved_point(self):
        for step, fault in [(1e-9, "lattice"), (0.05, "lattice"), (1e300, "coordinates"),
                            (float("nan"), "coordinates")]:
            self.setUp_again()
            self.patch("points.f64", 24 * 50, "<3d", lambda p: p.__setitem__(0, p[0] + step))
            self.assertIn(fault, self.faults())

    def test_missing_tetrahedron(self):
        """Cut out of the middle, with a manifest that says so."""
        manifest = self.report("out/manifest.json")
        path = self.folder / "out" / "tets.u32"
        whole = path.read_bytes()
        middle = self.tet_near_the_middle(whole)
        path.write_bytes(whole[:16 * middle] + whole[16 * middle + 16:])
        result = self.run_program("check", "out")
        self.assertEqual(result.returncode, 2)
        self.assertIn("tets.u32", result.stderr)
        manifest["tets"] -= 1
        self.write("out/manifest.json", json.dumps(manifest))
        self.assertEqual(self.faults(), {"cover"})
        self.succeed("convert", "out", "whole.vtu")
        self.assertEqual(self.faults(mesh="whole.vtu"), {"cover"})

    def tet_near_the_middle(self, tets):
        points = list(struct.iter_unpack("<3d", (self.folder / "out" / "points.f64").read_bytes()))
        for number, tet in enumerate(struct.iter_unpack("<4I", tets)):
            if all(1 < sum(points[v][axis] for v in tet) < 3 for axis in range(3)):
                return number
        return None

    def test_twice_the_same(self):
        whole = (self.folder / "out" / "tets.u32").read_bytes()
        (self.folder / "out" / "tets.u32").write_bytes(whole[:16] + whole[:16] + whole[32:])
        self.assertIn("conformity", self.faults())

    def test_level(self):
        self.patch("levels.u8", 50, "<B", lambda level: level.__setitem__(0, level[0] + 20))
        self.assertEqual(self.faults(), {"lattice"})

    def test_stricter_limits(self):
        self.assertEqual(self.faults("--min-angle", "61"), {"dihedral"})

    def test_unreadable(self):
        manifest = (self.folder / "out" / "manifest.json").read_text()
        good = json.loads(manifest)
        bad = ["", "{", "[]", "null", "7", manifest[:100], "[" * 100000, "\xff"]
        for key in good:
            if key != "files":
                bad += [json.dumps({k: v for k, v in good.items() if k != key})]
                bad += [json.dumps({**good, key: value}) for value in [-1, 1e300, "x", [], {}]]
        bad += [json.dumps({**good, "frame": {"unit": unit, "origin": origin}})
                for unit, origin in [(0, [0, 0, 0]), (1, [0, 0]), ("1", [0, 0, 0]), (1, 3), (1e999, [0, 0, 0])]]
        bad += [json.dumps({**good, "vertices": good["vertices"] - 1})]
        for text in bad:
            with self.subTest(text=text[:200]):
                self.write("out/manifest.json", text.encode("latin-1"))
                for command in [["check", "out"], ["convert", "out", "x.vtu"]]:
                    self.refuse(2, *command, saying=["out"])
        (self.folder / "out" / "manifest.json").unlink()
        self.refuse(2, "check", "out", saying=["manifest.json", "no such file"])

    def test_convert_refuses_bad_arrays(self):
        self.patch("tets.u32", 160, "<4I", lambda t: t.__setitem__(0, 2**32 - 1))
        self.refuse(2, "convert", "out", "x.vtu", saying=["tets.u32", "tetrahedron 10"])
        self.setUp_again()
        self.patch("points.f64", 24, "<3d", lambda p: p.__setitem__(0, float("inf")))
        self.refuse(2, "convert", "out", "x.vtu", saying=["points.f64", "vertex 1"])


if __name__ == "__main__":
    main()
