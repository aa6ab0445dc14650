#!/usr/bin/env python3
"""Our SPARQL engine and rdflib give the same answers to random queries (short form
of `make second_opinion`)."""

import json
import pathlib
import subprocess
import sys
import unittest

REPOSITORY = pathlib.Path(__file__).resolve().parent.parent
PROGRAM = REPOSITORY / "devel/lib/kg_core/random_cases"
COMPARE = REPOSITORY / "scripts/second_opinion.py"
CASES = 800


def compare(lines):
    return subprocess.run([sys.executable, COMPARE, "rdflib"], input=lines,
                          capture_output=True, text=True, check=False)


class TwoEngines(unittest.TestCase):

    @classmethod
    def setUpClass(cls):
        cls.lines = subprocess.run([PROGRAM, str(CASES)], capture_output=True,
                                   text=True, check=True).stdout

    def test_answer_alike(self):
        run = compare(self.lines)
        self.assertEqual(0, run.returncode, run.stdout[:3000] + run.stderr)
        self.assertEqual(f"cases {CASES}, differences 0",
                         run.stdout.splitlines()[-1])

    def test_would_be_told_apart(self):
        cases = [json.loads(line) for line in self.lines.splitlines()[:40]]
        answered = [case for case in cases if case["rows"]]
        answered[0]["rows"].pop()
        run = compare(json.dumps(answered[0]))
        self.assertEqual(1, run.returncode)
        self.assertIn("theirs only", run.stdout)


if __name__ == "__main__":
    unittest.main()
