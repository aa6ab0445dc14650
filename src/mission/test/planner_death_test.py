#!/usr/bin/env python3
"""A planner that dies again and again: SIGKILL of the planner of bravo whenever
it has connected to the selector. The team plans without it, long before the
selector's deadline, and says why; when it lives, it is planned for again.
"""

import os
import re
import signal
import sys
import threading
import xmlrpc.client

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))

import rosgraph
from kg_msgs.msg import World
from mission_test import (CHANGE_S, PLAN_S, MissionTestCase, by_agent, main,
                          node_pid)

NODE = '/planner_bravo'
DEADLINE_S = 600  # Of the selector: longer than this test.


def selector_hears(node):
    """Is the node subscribed to the selector's requests?"""
    try:
        uri = rosgraph.Master('/planner_death').lookupNode('/selector')
        bus = xmlrpc.client.ServerProxy(uri).getBusInfo('/planner_death')[2]
    except (rosgraph.MasterException, OSError):
        return False
    return any(link[1] == node and link[4] == '/kg/round_requests'
               for link in bus)


class Killer(threading.Thread):
    """Kills each process of the node as soon as it has connected."""

    def __init__(self, node):
        super().__init__(daemon=True)
        self._node = node
        self._stopped = threading.Event()
        self.pids = []

    def run(self):
        while not self._stopped.wait(0.05):
            pid = node_pid(self._node)
            if pid is None or pid in self.pids or not selector_hears(self._node):
                continue
            try:
                os.kill(pid, signal.SIGKILL)
                self.pids.append(pid)
            except ProcessLookupError:
                pass

    def stop(self):
        self._stopped.set()
        self.join()


class PlannerDeathTest(MissionTestCase):
    arguments = {'mission': 'gulf', 'sim': 'false', 'deadline_s': DEADLINE_S}

    @classmethod
    def setUpClass(cls):
        cls.killer = Killer(NODE)
        cls.killer.start()
        super().setUpClass()

    @classmethod
    def tearDownClass(cls):
        cls.killer.stop()
        super().tearDownClass()

    def _wait_for_plan_without_bravo(self, version):
        plan = self.mission.plans.wait(
            lambda plan: plan.world_version >= version, PLAN_S)
        self.assertEqual({'alpha', 'charlie'}, set(by_agent(plan)))
        self.assertEqual(1, len(plan.unassigned))
        died = re.fullmatch(r'bravo: planner for bravo died (\d+) times '
                            r'\(respawned\), planned without it',
                            plan.unassigned[0])
        self.assertTrue(died, plan.unassigned)
        self.assertGreaterEqual(int(died.group(1)), 2)
        world = self.mission.world.wait(
            lambda world: world.plan_version == plan.world_version)
        self.assertEqual(World.PLAN_FAILED, world.plan_status)
        self.assertEqual(plan.unassigned[0], world.plan_note)
        return plan

    def test_1_the_others_are_planned_and_the_reason_is_known(self):
        self._wait_for_plan_without_bravo(1)
        self.assertGreaterEqual(len(self.killer.pids), 2)
        lines = [line for line in self.mission.output().splitlines()
                 if 'planner for bravo (/planner_bravo) died' in line]
        last = next(line for line in lines if '2 of 2 times' in line)
        self.assertIn(': planned without it until it answers; last input: ',
                      last)
        folder = re.search(r'exit code in (\S+)/roslaunch-\*\.log', last)
        logs = [name for name in os.listdir(folder.group(1))
                if re.fullmatch(r'roslaunch-.*\.log', name)]
        self.assertTrue(logs, os.listdir(folder.group(1)))

    def test_2_the_next_cycle_does_not_wait_for_it_either(self):
        report = self.mission.update(set=[('ex:gulf', 'ex:separationWeight',
                                           '0.5')])
        self.assertTrue(report.accepted, report.reasons)
        self._wait_for_plan_without_bravo(report.world_version)

    def test_3_it_is_planned_for_again_when_it_lives(self):
        self.killer.stop()
        plan = self.mission.plans.wait(
            lambda plan: not plan.unassigned, PLAN_S)
        self.assertEqual({'alpha', 'bravo', 'charlie'}, set(by_agent(plan)))
        self.mission.world.wait(
            lambda world: world.plan_status == World.PLAN_OK, CHANGE_S)

    def test_zz_no_node_has_died(self):
        """Except those killed."""
        self.mission.stop()
        killed = [line for line in self.mission.deaths()
                  if 'exit code -9' in line and 'planner_bravo' in line]
        self.assertGreaterEqual(len(killed), 2)
        self.assertEqual(killed, self.mission.deaths())


if __name__ == '__main__':
    main('planner_death', PlannerDeathTest)
