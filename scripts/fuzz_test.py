#!/usr/bin/env python3
"""A short run of every fuzzer (long form: `make fuzz`); needs their build."""

import os
import pathlib
import re
import subprocess
import unittest

REPOSITORY = pathlib.Path(__file__).resolve().parent.parent
SECONDS = os.environ.get("FUZZ_SECONDS", "12")
FUZZERS = ("turtle", "wkt", "query", "policy_json")


class Fuzzers(unittest.TestCase):

    def test_are_those_of_the_sources(self):
        sources = {path.name.removesuffix("_fuzz.cc")
                   for path in REPOSITORY.glob("src/*/*/**/*_fuzz.cc")}
        self.assertEqual(set(FUZZERS), sources)

    def test_find_nothing_in_a_short_time(self):
        for name in FUZZERS:
            with self.subTest(fuzzer=name):
                run = subprocess.run(
                    [REPOSITORY / "scripts/fuzz.sh", SECONDS, name],
                    capture_output=True, text=True, check=False)
                self.assertEqual(0, run.returncode, run.stdout + run.stderr)
                tried = re.search(rf"{name} tried (\d+) inputs", run.stdout)
                self.assertGreater(int(tried[1]), 100)


if __name__ == "__main__":
    unittest.main()
