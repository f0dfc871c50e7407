"""Ctrl-C and SIGTERM in the middle of a long run."""

import os
import signal
import subprocess
import time

from program import PROGRAM, ProgramTest, main

# Aim: 100 ms. The rest is for busy test machines.
PATIENCE = 1.0
LONG = ["mesh", "--ball", "0 0 0 1", "--size", "0.012", "--strategy", "thrifty", "--max-memory", "100G",
        "-o", "out.vtu"]


class Interrupt(ProgramTest):
    def interrupt(self, *arguments, with_signal=signal.SIGINT, after=1.0):
        """The exit code, stderr, and the seconds from the signal to the end."""
        process = subprocess.Popen([PROGRAM, *arguments], cwd=self.folder, text=True, stdout=subprocess.DEVNULL,
                                   stderr=subprocess.PIPE)
        time.sleep(after)
        self.assertIsNone(process.poll(), "the run was over before it could be interrupted")
        start = time.monotonic()
        process.send_signal(with_signal)
        _, errors = process.communicate(timeout=60)
        return process.returncode, errors, time.monotonic() - start

    def test_leaves_at_once_and_writes_nothing(self):
        for number in [signal.SIGINT, signal.SIGTERM]:
            with self.subTest(signal=number):
                code, errors, seconds = self.interrupt(*LONG, with_signal=number)
                self.assertEqual(code, 1, errors)
                self.assertIn("interrupted", errors)
                self.assertEqual(os.listdir(self.folder), [])
                self.assertLess(seconds, PATIENCE)

    def test_writes_the_report_when_asked(self):
        code, errors, _ = self.interrupt(*LONG, "--json", "report.json", after=2.0)
        self.assertEqual(code, 1, errors)
        report = self.report("report.json")
        self.assertEqual((report["status"], report["exit_code"], report["output"]), ("cancelled", 1, None))
        self.assertEqual(os.listdir(self.folder), ["report.json"])

    def test_keeps_a_partial_mesh_when_asked(self):
        code, errors, _ = self.interrupt(*LONG, "--keep-partial", "--json", "report.json")
        self.assertEqual(code, 1, errors)
        self.assertIn("UNFINISHED", errors)
        report = self.report("report.json")
        self.assertEqual((report["status"], report["guaranteed"]), ("cancelled", False))
        self.assertEqual(sorted(os.listdir(self.folder)), ["out.vtu", "report.json"])
        check = self.run_program("check", "out.vtu", "--json", "-", "--max-angle", "180", "--min-angle", "0",
                                 "--max-radius-edge", "inf")
        self.assertEqual(check.returncode, 0, check.stderr)


if __name__ == "__main__":
    main()
