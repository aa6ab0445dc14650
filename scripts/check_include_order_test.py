#!/usr/bin/env python3
"""The include guard: no complaint about the tree, one about every planted
fault."""

import pathlib
import tempfile
import unittest

import check_include_order as guard

REPOSITORY = pathlib.Path(__file__).resolve().parent.parent
PACKAGES = [name for name in guard.MAY_INCLUDE if name not in guard.OPTIONAL]


class TheTree(unittest.TestCase):

    def test_keeps_every_rule(self):
        self.assertEqual([], list(guard.complaints(REPOSITORY)))


class PlantedFaults(unittest.TestCase):

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        for package in PACKAGES:
            self.plant(f"{package}/{package}/low/clean.h", "#include <map>\n")
            self.plant(f"{package}/{package}/high/clean.cc",
                       f'#include "{package}/low/clean.h"\n')
            self.plant(f"{package}/folders.txt", "low  # values\n\nhigh\n")

    def plant(self, path, text):
        file = self.root / "src" / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)

    def complaints(self):
        return list(guard.complaints(self.root))

    def complaints_after(self, path, text):
        self.plant(path, text)
        return self.complaints()

    def assert_one(self, path, text, *words):
        found = self.complaints_after(path, text)
        self.assertEqual(1, len(found), found)
        self.assertTrue(found[0].startswith(f"src/{path}:"), found)
        for word in words:
            self.assertIn(word, found[0])

    def assert_none(self, path, text):
        self.assertEqual([], self.complaints_after(path, text))


class NoFault(PlantedFaults):

    def test_is_quiet(self):
        self.assertEqual([], self.complaints())


class Packages(PlantedFaults):

    def test_must_not_include_a_package_above(self):
        for package, allowed in guard.MAY_INCLUDE.items():
            for other in guard.MAY_INCLUDE:
                if other == package or other in allowed:
                    continue
                with self.subTest(package=package, other=other):
                    self.setUp()
                    self.plant(f"{package}/folders.txt", "low\nhigh\n")
                    self.plant(f"{package}/{package}/low/a.h", "")
                    self.plant(f"{package}/{package}/high/b.h", "")
                    self.assert_one(
                        f"{package}/{package}/low/bad.h",
                        f'// first line\n  #  include "{other}/low/b.h"\n',
                        "bad.h:2:", other)

    def test_may_include_the_packages_below(self):
        for package, allowed in guard.MAY_INCLUDE.items():
            for other in allowed:
                if package not in (guard.GENERAL, *guard.OPTIONAL):
                    with self.subTest(package=package, other=other):
                        self.setUp()
                        self.assert_none(f"{package}/{package}/high/a.cc",
                                         f'#include "{other}/low/clean.h"\n')

    def test_keep_to_the_order_in_package_xml(self):
        self.assert_one("kg_engine/package.xml",
                        "<package><depend>kg_selector</depend>"
                        "<exec_depend>kg_msgs</exec_depend></package>",
                        "may not depend on kg_msgs")
        self.setUp()
        self.assert_one("kg_planner/package.xml",
                        "<package><depend> kg_compiler </depend></package>",
                        "kg_compiler")
        self.setUp()
        self.assert_none("kg_ros/package.xml",
                         "<package><depend>kg_msgs</depend>"
                         "<depend>roscpp</depend></package>")

    def test_must_all_be_there(self):
        for path in (self.root / "src/kg_core/kg_core").rglob("clean.*"):
            path.unlink()
        self.assertEqual("src/kg_core: no source file", self.complaints()[0])

    def test_must_be_in_the_table(self):
        self.plant("kg_new/folders.txt", "low\n")
        self.plant("kg_new/kg_new/low/a.h", "")
        self.assertEqual(["src/kg_new: not in the table of packages"],
                         self.complaints())

    def test_hold_all_the_cpp(self):
        self.plant("mission/scripts/fast.cc", "")
        self.assertEqual(["src/mission/scripts/fast.cc: C++ belongs in a kg_ "
                          "package"], self.complaints())


class Ros(PlantedFaults):

    HEADERS = ("ros/ros.h", "std_msgs/Header.h", "tf2_ros/buffer.h",
               "kg_msgs/World.h", "nodelet/nodelet.h", "XmlRpcValue.h")

    def test_is_included_nowhere_but_in_the_packages_for_it(self):
        for package in PACKAGES:
            if package in guard.WITH_ROS:
                continue
            for file in ("a.cc", "a_test.cc", "a_main.cc", "testing/a.h"):
                with self.subTest(package=package, file=file):
                    self.setUp()
                    found = self.complaints_after(
                        f"{package}/{package}/low/{file}",
                        "".join(f"#include <{h}>\n" for h in self.HEADERS))
                    self.assertEqual(len(self.HEADERS), len(found), found)

    def test_may_be_included_in_the_packages_for_it(self):
        self.plant("kg_rviz_plugins/folders.txt", ".\n")
        for package, folder in (("kg_ros", "low/"), ("kg_rviz_plugins", "")):
            self.plant(f"{package}/{package}/{folder}a.cc", "".join(
                f"#include <{header}>\n" for header in self.HEADERS))
        self.assertEqual([], self.complaints())


class ThePlanner(PlantedFaults):

    def test_includes_the_standard_library_and_plain_values_only(self):
        for line in ('#include "kg_base/raster/grid.h"', "#include <serd.h>",
                     '#include "absl/types/span.h"',
                     "#include <boost/graph/graph.hpp>"):
            with self.subTest(line=line):
                self.setUp()
                self.assert_one("kg_planner/kg_planner/low/a.cc", line + "\n",
                                "kg_planner may not include")
        self.setUp()
        self.assert_none("kg_planner/kg_planner/low/a_test.cc",
                         '#include "gtest/gtest.h"\n#include <vector>\n'
                         '#include "kg_base/common/units.h"\n')

    def test_has_no_word_of_a_domain(self):
        for text in ("// ... of a glider.", "double ocean_depth = 0;",
                     "class PolicyReader;", "int kSstLayer;"):
            with self.subTest(text=text):
                self.setUp()
                found = self.complaints_after("kg_planner/kg_planner/low/a.h",
                                              text + "\n")
                self.assertIn("word of a domain", found[0])
        self.setUp()
        self.assert_none("kg_planner/kg_planner/low/a.h",
                         "// seam, season, island\n")


class Folders(PlantedFaults):

    def test_must_not_include_a_folder_listed_after_them(self):
        self.assert_one("kg_engine/kg_engine/low/a.cc",
                        '\n#include "kg_engine/high/b.h"\n',
                        "a.cc:2:", "high is listed after it")

    def test_with_code_must_be_listed(self):
        found = self.complaints_after("kg_core/kg_core/low/deep/a.h", "")
        self.assertEqual(["src/kg_core/folders.txt: folder low/deep is not "
                          "listed"], found)
        self.setUp()
        found = self.complaints_after("kg_core/kg_core/a.h", "")
        self.assertEqual(["src/kg_core/folders.txt: folder . is not listed"],
                         found)

    def test_are_none_without_a_table(self):
        (self.root / "src/kg_core/folders.txt").unlink()
        self.assertEqual(2, len(self.complaints()))

    def test_that_are_listed_must_have_code(self):
        found = self.complaints_after("kg_core/folders.txt",
                                      "low\nhigh\nhigher\n")
        self.assertEqual(["src/kg_core/folders.txt: folder higher has no "
                          "code"], found)

    def test_may_be_included_in_any_order_by_tests_and_programs(self):
        for file in ("a_test.cc", "a_main.cc", "a_fuzz.cc", "testing/a.h"):
            with self.subTest(file=file):
                self.setUp()
                self.assert_none(f"kg_engine/kg_engine/low/{file}",
                                 '#include "kg_engine/high/b.h"\n')


class Circles(PlantedFaults):

    def test_of_units_are_found_with_the_way_round(self):
        low = "kg_core/kg_core/low"
        self.plant(f"{low}/a.h", "")
        self.plant(f"{low}/a.cc", '#include "kg_core/low/a.h"\n'
                                  '#include "kg_core/low/b.h"\n')
        self.plant(f"{low}/b.h", '#include "kg_core/low/c.h"\n')
        self.assert_one(f"{low}/c.h", '#include "kg_core/low/a.h"\n')
        self.assertIn("kg_core/low/a.cc:2: include circle of 3 units: "
                      "kg_core/low/a -> kg_core/low/b -> kg_core/low/c -> "
                      "kg_core/low/a", self.complaints()[0])

    def assert_one(self, path, text, *words):
        found = self.complaints_after(path, text)
        self.assertEqual(1, len(found), found)

    def test_of_units_are_found_among_testing_headers(self):
        low = "kg_core/kg_core/low/testing"
        self.plant(f"{low}/a.h", '#include "kg_core/low/testing/b.h"\n')
        self.assert_one(f"{low}/b.h", '#include "kg_core/low/testing/a.h"\n')

    def test_are_not_made_by_a_unit_alone_or_by_its_test(self):
        low = "kg_core/kg_core/low"
        self.plant(f"{low}/a.cc", '#include "kg_core/low/a.h"\n')
        self.plant(f"{low}/a.h", '#include "kg_core/low/b.h"\n')
        self.plant(f"{low}/b.h", "")
        self.assertEqual([], self.complaints_after(
            f"{low}/b_test.cc", '#include "kg_core/low/a.h"\n'))

    def test_of_folders_are_found_though_no_unit_is_in_one(self):
        self.plant("kg_core/kg_core/high/b.h", "")
        found = self.complaints_after("kg_core/kg_core/low/a.h",
                                      '#include "kg_core/high/b.h"\n')
        self.assertEqual(2, len(found), found)
        self.assertIn("high is listed after it", found[0])
        self.assertIn("include circle of 2 folders: kg_core/high -> "
                      "kg_core/low -> kg_core/high", found[1])


class TestingHeaders(PlantedFaults):

    def test_are_not_for_the_library_and_its_programs(self):
        for line in ('"kg_core/low/testing/world.h"', "<gtest/gtest.h>",
                     "<gmock/gmock.h>", "<benchmark/benchmark.h>"):
            for file in ("a.h", "a.cc", "a_main.cc"):
                with self.subTest(line=line, file=file):
                    self.setUp()
                    self.assert_one(f"kg_core/kg_core/low/{file}",
                                    f"#include {line}\n",
                                    "for tests and benchmarks only")

    def test_are_for_tests_benchmarks_and_each_other(self):
        for file in ("a_test.cc", "a_bench_main.cc", "a_fuzz.cc",
                     "testing/b.h", "testing/b.cc"):
            with self.subTest(file=file):
                self.setUp()
                self.assert_none(f"kg_core/kg_core/low/{file}",
                                 '#include "kg_core/low/testing/world.h"\n'
                                 "#include <gtest/gtest.h>\n")


if __name__ == "__main__":
    unittest.main()
