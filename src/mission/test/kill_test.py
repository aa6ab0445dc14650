#!/usr/bin/env python3
"""SIGKILL of a planner, the selector and the KG node in turn: each restarts, a
plan follows, no fact is lost, and world_version never decreases.
"""

import os
import signal
import sys

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))

from kg_msgs.msg import World
from mission_test import CHANGE_S, by_agent, main, node_pid, wait_until
from small_mission_case import SmallMissionTestCase

A_FACT = ('ex:front', 'ex:value', '3.25')
STALE_S = 10.0  # Longest time for a dead planner to show in kg/world.


class KillTest(SmallMissionTestCase):
    def _kill(self, node):
        """Kills a node; its process id and the number of messages heard."""
        pid = wait_until(lambda: node_pid(node), CHANGE_S, node)
        heard = (len(self.mission.world.messages),
                 len(self.mission.plans.messages))
        os.kill(pid, signal.SIGKILL)
        return pid, heard

    def _wait_for_successor(self, node, pid):
        wait_until(lambda: node_pid(node) not in (None, pid), CHANGE_S,
                   node + ' again')

    def _assert_nothing_lost(self, version):
        self.assertTrue(self.mission.ask('ASK { %s %s %s }' % A_FACT))
        versions = [world.world_version
                    for world in self.mission.world.messages]
        self.assertEqual(sorted(versions), versions)
        self.assertEqual(version, versions[-1])

    def _planned_with_a_fact(self):
        """World version with a plan and A_FACT set."""
        self.mission.wait_for_plan()
        report = self.mission.update(set=[A_FACT])
        self.assertTrue(report.accepted, report.reasons)
        self.mission.wait_for_plan(report.world_version)
        return report.world_version

    def _wait_for_plan_again(self, version, since):
        world = self.mission.world.wait(
            lambda w: w.plan_status == World.PLAN_OK and
            w.plan_version == version, since=since)
        plan = self.mission.plans.wait(lambda p: p.world_version == version)
        self.assertEqual({'alpha', 'bravo'}, set(by_agent(plan)))
        self.assertEqual(version, world.world_version)

    def test_1_a_planner_comes_back_and_the_plan_is_stale_meanwhile(self):
        version = self._planned_with_a_fact()
        pid, (worlds, _) = self._kill('/planner_alpha')
        self.mission.world.wait(lambda w: w.plan_status == World.PLAN_STALE,
                              STALE_S, since=worlds)
        worlds = len(self.mission.world.messages)
        self._wait_for_successor('/planner_alpha', pid)
        self._wait_for_plan_again(version, worlds)
        self._assert_nothing_lost(version)

    def test_2_the_selector_comes_back_and_serves_the_next_change(self):
        version = self._planned_with_a_fact()
        pid, (worlds, _) = self._kill('/selector')
        self._wait_for_successor('/selector', pid)
        report = self.mission.update(set=[('ex:front', 'ex:value', '2.5')])
        self.assertTrue(report.accepted, report.reasons)
        self._wait_for_plan_again(version + 1, worlds)
        self.mission.update(set=[A_FACT])
        self._wait_for_plan_again(version + 2, worlds)
        self._assert_nothing_lost(version + 2)

    def test_3_the_kg_node_comes_back_with_every_fact(self):
        version = self._planned_with_a_fact()
        pid, (worlds, _) = self._kill('/kg')
        self._wait_for_successor('/kg', pid)
        self._wait_for_plan_again(version, worlds)
        self._assert_nothing_lost(version)
        verdict = self.mission.verdict(lambda v: v['world_version'] == version)
        self.assert_no_violation(verdict)

    def test_zz_no_node_has_died(self):
        """Except the three killed: proves that deaths are detected."""
        self.mission.stop()
        killed = [line for line in self.mission.deaths()
                  if 'exit code -9' in line]
        self.assertEqual(3, len(killed), self.mission.output()[-4000:])
        self.assertEqual(killed, self.mission.deaths())


if __name__ == '__main__':
    main('kill', KillTest)
