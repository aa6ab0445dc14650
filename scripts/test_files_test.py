#!/usr/bin/env python3
"""No test file is lost: the list of tests and the tree agree."""

import pathlib
import tempfile
import unittest

import test_files

REPOSITORY = pathlib.Path(__file__).resolve().parent.parent


class TheTree(unittest.TestCase):

    def test_has_every_listed_test_and_lists_every_test(self):
        self.assertEqual([], list(test_files.complaints(REPOSITORY)))


class TestFiles(unittest.TestCase):

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        for path in ("src/kg_core/kg_core/low/axis_test.cc",
                     "src/kg_core/kg_core/low/axis.cc",
                     "src/mission/test/gulf.test",
                     "src/mission/test/gulf_test.py",
                     "scripts/bench_test.py"):
            self.put(path)
        test_files.add(self.root)

    def put(self, path):
        file = self.root / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text("")

    def complaints(self):
        return list(test_files.complaints(self.root))

    def test_are_all_listed(self):
        self.assertEqual({"axis_test.cc": 1, "gulf.test": 1, "gulf_test.py": 1,
                          "bench_test.py": 1},
                         test_files.listed_tests(self.root))
        self.assertEqual([], self.complaints())

    def test_that_are_gone_are_missed_even_after_adding(self):
        (self.root / "src/kg_core/kg_core/low/axis_test.cc").unlink()
        test_files.add(self.root)
        self.assertEqual(["axis_test.cc: missing; scripts/test_files.txt lists "
                          "1, the tree has 0"], self.complaints())

    def test_may_move(self):
        (self.root / "src/kg_core/kg_core/low/axis_test.cc").unlink()
        self.put("src/kg_base/kg_base/raster/axis_test.cc")
        self.assertEqual([], self.complaints())

    def test_that_are_new_must_be_listed(self):
        self.put("src/kg_core/kg_core/low/row_test.cc")
        self.assertEqual(1, len(self.complaints()))
        self.assertIn("row_test.cc: not listed", self.complaints()[0])
        test_files.add(self.root)
        self.assertEqual([], self.complaints())

    def test_of_one_name_in_two_folders_are_both_needed(self):
        self.put("src/kg_ros/kg_ros/low/axis_test.cc")
        self.assertIn("not listed", self.complaints()[0])
        test_files.add(self.root)
        self.assertEqual([], self.complaints())
        (self.root / "src/kg_ros/kg_ros/low/axis_test.cc").unlink()
        self.assertIn("lists 2, the tree has 1", self.complaints()[0])


if __name__ == "__main__":
    unittest.main()
