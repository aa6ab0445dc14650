#!/usr/bin/env python3
"""Exit status of a verdict: 0 only for a new, complete plan without violations."""

import copy
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

SCRIPT = pathlib.Path(__file__).resolve().parent / "check_verdict.py"
GOOD = {
    "world_version": 3, "windows": 7, "complete": True, "notes": [],
    "began_unix_s": 1_000_000.0, "ended": True,
    "agents": {name: {"waypoints": 7, "reward": 3.5, "cost": 1.0}
               for name in ("alpha", "bravo", "charlie")},
    "violations": {"no_go": 0, "capacity": 0, "separation": 0}}
WRITTEN_S = 1_000_000.5


class CheckVerdict(unittest.TestCase):

    def judge(self, text, since_s=WRITTEN_S - 1):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "verdict.json"
            if text is not None:
                path.write_text(text)
                os.utime(path, (WRITTEN_S, WRITTEN_S))
            return subprocess.run(
                [sys.executable, SCRIPT, path, "--since", str(since_s)],
                capture_output=True, text=True, check=False)

    def assert_refused(self, change, reason):
        verdict = copy.deepcopy(GOOD)
        change(verdict)
        run = self.judge(json.dumps(verdict))
        self.assertEqual(1, run.returncode)
        self.assertIn(reason, run.stderr)
        self.assertEqual(1, len(run.stderr.splitlines()))

    def test_accepts_a_fresh_plan_without_a_violation(self):
        run = self.judge(json.dumps(GOOD))
        self.assertEqual(0, run.returncode, run.stderr)
        self.assertIn("3 agents x 7 windows", run.stdout)

    def test_refuses_the_verdict_of_an_earlier_run(self):
        for since_s in (WRITTEN_S + 0.1, float("nan")):
            self.assertEqual(1, self.judge(json.dumps(GOOD),
                                           since_s).returncode)

    def test_refuses_a_check_that_began_before_the_run(self):
        """It goes on to write: two launches on one state folder."""
        for began_s in (999_999.4, None, "1000000"):
            self.assert_refused(
                lambda verdict, began_s=began_s: verdict.update(
                    began_unix_s=began_s),
                "began before" if began_s == 999_999.4 else "lacks")

    def test_refuses_a_mission_that_has_not_ended(self):
        for ended in (False, None, "true", 1):
            self.assert_refused(
                lambda verdict, ended=ended: verdict.update(
                    ended=ended, notes=["flight: in window 1 of 7"]),
                "has not ended: not every window was flown; flight: in window")
        self.assert_refused(lambda verdict: verdict.pop("ended"), "'ended'")

    def test_refuses_a_missing_or_unreadable_file(self):
        for text in (None, "", "{", "[]", "null", '{"agents": 3}'):
            with self.subTest(text=text):
                run = self.judge(text)
                self.assertEqual(1, run.returncode)
                self.assertNotIn("Traceback", run.stderr)

    def test_refuses_any_violation(self):
        for kind in GOOD["violations"]:
            self.assert_refused(
                lambda verdict, kind=kind: verdict["violations"].update(
                    {kind: 1}), f"{kind} 1")

    def test_refuses_a_violation_that_was_not_looked_for(self):
        for kind in GOOD["violations"]:
            self.assert_refused(
                lambda verdict, kind=kind: verdict["violations"].pop(kind),
                f"not checked: {kind}")

    def test_refuses_a_violation_count_that_is_no_number(self):
        self.assert_refused(
            lambda verdict: verdict["violations"].update(no_go=None), "no_go")

    def test_refuses_an_agent_without_a_plan(self):
        self.assert_refused(
            lambda verdict: verdict["agents"]["bravo"].update(waypoints=0),
            "no plan for bravo")

    def test_refuses_a_plan_without_agents(self):
        self.assert_refused(lambda verdict: verdict["agents"].clear(),
                            "no agent has a plan")

    def test_refuses_a_plan_with_gaps_and_says_what_was_noted(self):
        self.assert_refused(
            lambda verdict: verdict.update(complete=False,
                                           notes=["alpha: no window 6"]),
            "the plan has gaps; alpha: no window 6")


if __name__ == "__main__":
    unittest.main()
