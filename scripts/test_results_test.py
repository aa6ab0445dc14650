#!/usr/bin/env python3
"""Counting of results: no case twice, no test ignored, no failure hidden."""

import contextlib
import io
import pathlib
import subprocess
import sys
import tempfile
import unittest

import test_results

SCRIPTS = pathlib.Path(__file__).resolve().parent

GTEST = """<testsuites tests="4"><testsuite name="Axis" tests="4">
<testcase name="Finds" status="run" classname="Axis"/>
<testcase name="Refuses" status="run" classname="Axis">
  <failure message="axis_test.cc:7&#x0A;expected 1"/></testcase>
<testcase name="Waits" status="notrun" classname="Axis"/>
<testcase name="NeedsData" status="run" classname="Axis">
  <skipped message="no data folder"/></testcase>
</testsuite></testsuites>"""
ROSUNIT = """<testsuite tests="1"><testcase classname="__main__.Mission"
 name="test_plans"/><system-out>fine</system-out></testsuite>"""
ROSTEST = """<testsuite tests="1"><testcase classname="rostest.runner.RosTest"
 name="testmission"/></testsuite>"""


class TestResults(unittest.TestCase):

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        self.results = self.root / "build/test_results"
        self.put("src/kg_base/kg_base/raster/axis_test.cc", "")
        self.put("src/mission/test/mission.test",
                 '<launch><test test-name="mission" pkg="mission" '
                 'type="mission_test.py"/></launch>')
        self.put("src/mission/test/mission_test.py", "  def test_plans(self): 1")
        self.result("kg_base/gtest-kg_base_axis_test.xml", GTEST)
        self.result("mission/rosunit-mission.xml", ROSUNIT)
        self.result("mission/rostest-test_mission.xml", ROSTEST)

    def put(self, path, text):
        file = self.root / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)

    def result(self, path, text):
        self.put(f"build/test_results/{path}", text)

    def count(self):
        return test_results.count_results(self.root, self.results)

    def test_counts_a_case_once_whoever_reports_it(self):
        count = self.count()
        self.assertEqual(2, len(count.passed))
        self.assertEqual(["kg_base/gtest-kg_base_axis_test.xml: Axis.Refuses"],
                         list(count.failed))
        self.assertEqual(["disabled", "no data folder"],
                         list(count.skipped.values()))

    def test_fails_for_a_test_that_wrote_nothing(self):
        (self.results / "kg_base/gtest-kg_base_axis_test.xml").unlink()
        self.assertEqual(["kg_base/gtest-kg_base_axis_test.xml"],
                         list(self.count().failed))

    def test_fails_for_a_ros_test_that_wrote_nothing(self):
        (self.results / "mission/rosunit-mission.xml").unlink()
        self.assertIn("mission/rosunit-mission.xml", self.count().failed)

    def test_fails_for_a_result_that_is_cut_off(self):
        for text in ("", GTEST[:100]):
            self.result("kg_base/gtest-kg_base_axis_test.xml", text)
            failed = self.count().failed
            self.assertEqual(["kg_base/gtest-kg_base_axis_test.xml"],
                             list(failed))

    def test_fails_for_a_result_without_a_case(self):
        self.result("mission/rosunit-mission.xml", '<testsuite tests="0"/>')
        self.assertIn("mission/rosunit-mission.xml", self.count().failed)

    def test_takes_a_printed_reason_for_a_result_without_a_case(self):
        self.result("mission/rosunit-mission.xml", "<testsuite><system-out>a\n"
                    "SKIPPED: no shared data\n</system-out></testsuite>")
        count = self.count()
        self.assertEqual("no shared data",
                         count.skipped["mission/rosunit-mission.xml"])
        self.assertNotIn("mission/rosunit-mission.xml", count.failed)

    def test_fails_for_a_failure_that_only_rostest_saw(self):
        self.result("mission/rostest-test_mission.xml", ROSTEST.replace(
            '"/>', '"><failure>time is up</failure></testcase>'))
        self.assertIn("mission/rostest-test_mission.xml: "
                      "rostest.runner.RosTest.testmission", self.count().failed)

    def test_fails_for_a_python_test_that_no_launch_file_names(self):
        self.put("src/mission/test/lost_test.py", "  def test_it(self): 1")
        self.assertIn("src/mission/test/lost_test.py", self.count().failed)

    def test_takes_what_other_tests_import_for_a_library(self):
        self.put("src/mission/test/base_test.py", "  def test_it(self): 1")
        self.put("src/mission/test/mission_test.py",
                 "from base_test import Base\n  def test_plans(self): 1")
        self.assertNotIn("src/mission/test/base_test.py", self.count().failed)

    def report(self):
        told = io.StringIO()
        with contextlib.redirect_stdout(told):
            bad = test_results.report(self.count())
        return bad, told.getvalue().splitlines()

    def test_ends_with_the_count_and_a_status_true_to_it(self):
        bad, lines = self.report()
        self.assertTrue(bad)
        self.assertEqual("2 passed, 1 failed", lines[-1])
        self.assertIn("Axis.Refuses: axis_test.cc:7 | expected 1", lines[-2])
        self.result("kg_base/gtest-kg_base_axis_test.xml",
                    GTEST.replace("<failure", "<system-err"))
        self.assertEqual((False, "3 passed, 0 failed"),
                         (self.report()[0], self.report()[1][-1]))

    def test_does_not_call_nothing_a_success(self):
        for path in list(self.root.glob("src")) + [self.results]:
            subprocess.run(["rm", "-r", path], check=True)
        bad, lines = self.report()
        self.assertTrue(bad)
        self.assertEqual("0 passed, 1 failed", lines[-1])


class TheRunnerOfUnitTests(unittest.TestCase):

    def run_file(self, text):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            (folder / "src").mkdir()
            (folder / "scripts").mkdir()
            (folder / "scripts/a_test.py").write_text("import unittest\n" + text)
            run = subprocess.run(
                [sys.executable, SCRIPTS / "run_unittest.py",
                 folder / "scripts/a_test.py",
                 folder / "results/scripts/a_test.xml"],
                capture_output=True, check=False)
            return run.returncode, test_results.count_results(
                folder, folder / "results")

    def test_reports_every_kind_of_end(self):
        status, count = self.run_file(
            "class A(unittest.TestCase):\n"
            "  def test_ok(self): pass\n"
            "  def test_bad(self): self.fail('no <good>')\n"
            "  def test_ugly(self): raise OSError\n"
            "  def test_sub(self):\n"
            "    for i in (1, 2):\n"
            "      with self.subTest(i=i): self.assertEqual(i, 1)\n"
            "  @unittest.skip('late')\n"
            "  def test_skip(self): pass\n")
        self.assertEqual(1, status)
        self.assertEqual((1, 3, 1), (len(count.passed), len(count.failed),
                                     len(count.skipped)))

    def test_reports_a_class_that_cannot_be_set_up(self):
        status, count = self.run_file(
            "class A(unittest.TestCase):\n"
            "  @classmethod\n"
            "  def setUpClass(cls): raise OSError('no disk')\n"
            "  def test_ok(self): pass\n")
        self.assertEqual((1, 0, 1), (status, len(count.passed),
                                     len(count.failed)))

    def test_that_cannot_be_loaded_leaves_a_missing_result(self):
        status, count = self.run_file("import nothing_of_that_name\n")
        self.assertEqual((1, 0, 1), (status, len(count.passed),
                                     len(count.failed)))


if __name__ == "__main__":
    unittest.main()
