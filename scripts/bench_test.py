#!/usr/bin/env python3
"""The benchmark programs in their short form: each exits with 0 and prints a line
for every target that does not depend on size. The values are not checked here."""

import os
import pathlib
import re
import subprocess
import unittest

REPOSITORY = pathlib.Path(__file__).resolve().parent.parent
DATA = pathlib.Path(os.environ.get(
    "KG_SHARED_DATA", REPOSITORY.parent / "shared/data"))
PROGRAMS = sorted((REPOSITORY / "devel/lib").glob("*/*_bench"))
TARGET = re.compile(
    r"^target (\d+) +\S.* goal (?:>=|<=) [\d.e+-]+ .*"
    r"measured (?:[\d.e+-]+|inf|nan) .*(?:met|missed)$", re.MULTILINE)


def quick(program):
    environment = dict(os.environ, KG_STORE_BENCH_PEERS="",
                       KG_SHARED_DATA=str(DATA))
    return subprocess.run(
        [str(program), "--quick"], capture_output=True, text=True, check=False,
        cwd=REPOSITORY, env=environment, stdin=subprocess.DEVNULL, timeout=120)


class TheBenchmarks(unittest.TestCase):

    @classmethod
    def setUpClass(cls):
        cls.runs = {program.name: quick(program) for program in PROGRAMS}

    def test_run_to_their_end(self):
        self.assertTrue(self.runs, "no program *_bench in devel/lib")
        for name, run in self.runs.items():
            with self.subTest(name):
                self.assertEqual(0, run.returncode, run.stdout + run.stderr)

    def test_have_a_line_for_each_target(self):
        lines = "".join(run.stdout for run in self.runs.values())
        measured = {int(number) for number in TARGET.findall(lines)}
        wanted = {2, 3, 4, 5, 7, 8, 9, 10, 11, 13, 15}
        if DATA.is_dir():
            wanted |= {6, 12}  # Of real currents; of a public benchmark.
        self.assertLessEqual(wanted, measured, lines)

    def test_write_every_target_in_one_form(self):
        for name, run in self.runs.items():
            for line in run.stdout.splitlines():
                if line.startswith("target "):
                    with self.subTest(name):
                        self.assertRegex(line, TARGET)


if __name__ == "__main__":
    unittest.main()
