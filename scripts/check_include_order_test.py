#!/usr/bin/env python3
"""The guard of the include order: quiet on the tree, loud on planted faults."""

import pathlib
import tempfile
import unittest

import check_include_order as guard

REPOSITORY = pathlib.Path(__file__).resolve().parent.parent


class TheTree(unittest.TestCase):

    def test_keeps_the_include_order_and_the_planner_general(self):
        self.assertEqual([], list(guard.complaints(REPOSITORY)))


class PlantedFaults(unittest.TestCase):

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        for package in guard.HOUSE:
            self.plant(f"{package}/{package}/clean.cc",
                       f'#include "{package}/clean.h"\n#include <vector>\n')

    def plant(self, path, text):
        file = self.root / "src" / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)

    def complaints_about(self, path, text):
        self.assertEqual([], list(guard.complaints(self.root)))
        self.plant(path, text)
        found = list(guard.complaints(self.root))
        self.assertTrue(all(line.startswith(f"src/{path}:") for line in found))
        return found

    def test_are_found_where_an_include_points_upstream(self):
        for floor, package in enumerate(guard.HOUSE):
            for above in guard.HOUSE[floor + 1:]:
                with self.subTest(package=package, above=above):
                    self.setUp()
                    found = self.complaints_about(
                        f"{package}/{package}/deep/a.h",
                        f'// first line\n  #  include "{above}/b.h"\n')
                    self.assertEqual(1, len(found))
                    self.assertIn("a.h:2:", found[0])
                    self.assertIn(above, found[0])

    def test_are_found_where_ros_comes_into_a_library(self):
        for header in ("ros/ros.h", "std_msgs/Header.h", "tf2_ros/buffer.h",
                       "kg_msgs/World.h", "nodelet/nodelet.h"):
            for package in guard.HOUSE[:-1]:
                with self.subTest(header=header, package=package):
                    self.setUp()
                    self.assertEqual(1, len(self.complaints_about(
                        f"{package}/{package}/a.cc",
                        f"#include <{header}>\n")))

    def test_are_found_where_the_planner_includes_more_than_the_standard(self):
        for line in ('#include "kg_core/geo/lon_lat.h"', "#include <netcdf.h>",
                     '#include "absl/types/span.h"',
                     "#include <boost/graph/graph.hpp>"):
            with self.subTest(line=line):
                self.setUp()
                found = self.complaints_about(
                    "kg_planner/kg_planner/a.cc", line + "\n")
                self.assertIn("kg_planner may not include", found[0])

    def test_are_found_where_the_planner_knows_a_domain(self):
        for text in ("// ... of a glider.", "double ocean_depth = 0;",
                     "class PolicyReader;", "int kSstLayer;"):
            with self.subTest(text=text):
                self.setUp()
                self.assertNotEqual([], self.complaints_about(
                    "kg_planner/kg_planner/a.h", text + "\n"))

    def test_are_found_where_a_package_has_no_source_at_all(self):
        (self.root / "src/kg_core/kg_core/clean.cc").unlink()
        self.assertEqual(["src/kg_core: no source file"],
                         list(guard.complaints(self.root)))

    def test_are_not_seen_where_everything_is_allowed(self):
        self.plant("kg_ros/kg_ros/node.cc",
                   "#include <ros/ros.h>\n#include \"kg_selector/a.h\"\n")
        self.plant("kg_rviz_plugins/src/display.cc",
                   "#include <rviz/display.h>\n#include <kg_msgs/World.h>\n")
        self.plant("kg_planner/kg_planner/a_test.cc",
                   '#include "gtest/gtest.h"\n// seam, season, island\n')
        self.assertEqual([], list(guard.complaints(self.root)))


if __name__ == "__main__":
    unittest.main()
