#!/usr/bin/env python3
"""SIGKILL of the KG node and of the simulation during a mission with once:=true:
both restart, every window is flown, and the launch ends with a good verdict.
"""

import os
import signal
import subprocess
import sys
import time

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))

from mission_test import CHANGE_S, main, node_pid, wait_until
from small_mission import WINDOWS
from small_mission_case import SmallMissionTestCase

END_S = 120.0
CHECK = os.path.join(os.path.dirname(os.path.realpath(__file__)),
                     '../../../scripts/check_verdict.py')


class MissionRestartTest(SmallMissionTestCase):
    small_arguments = {'sim': 'true', 'rate': '8.0', 'once': 'true'}

    @classmethod
    def prepare(cls):
        super().prepare()
        cls.began_s = time.time()

    def _kill(self, node):
        pid = wait_until(lambda: node_pid(node), CHANGE_S, node)
        os.kill(pid, signal.SIGKILL)
        wait_until(lambda: node_pid(node) not in (None, pid), CHANGE_S,
                   node + ' again')

    def _check(self, since_s):
        """Exit status and message of check_verdict.py."""
        path = os.path.join(self.mission.state, 'verdict.json')
        run = subprocess.run([sys.executable, CHECK, path, '--since',
                              str(since_s)], capture_output=True, text=True)
        return run.returncode, run.stdout + run.stderr

    def test_1_flies_every_window_though_nodes_are_killed(self):
        self.mission.world.wait(lambda world: world.current_window == 1)
        self.mission.verdict(lambda verdict: True)
        status, message = self._check(self.began_s)
        self.assertEqual(1, status)
        self.assertIn('has not ended', message)
        self._kill('/kg')
        self._kill('/agent_sim')
        self.mission.wait_for_end(END_S)
        verdict = self.mission.verdict(lambda verdict: True)
        self.assertTrue(verdict['ended'], verdict)
        self.assert_no_violation(verdict)
        for agent in ('alpha', 'bravo'):
            self.assertEqual(WINDOWS, verdict['agents'][agent]['waypoints'])
        self.assertEqual(0, self._check(self.began_s)[0])
        self.assertEqual(1, self._check(time.time())[0])

    def test_zz_no_node_has_died(self):
        """Except the two killed, and verdict, whose exit ends the launch."""
        self.mission.stop()
        killed = [line for line in self.mission.deaths()
                  if 'exit code -9' in line]
        self.assertEqual(2, len(killed), self.mission.output()[-4000:])
        others = [line for line in self.mission.deaths()
                  if line not in killed and '[verdict' not in line]
        self.assertEqual([], others, self.mission.output()[-4000:])


if __name__ == '__main__':
    main('mission_restart', MissionRestartTest)
