#!/usr/bin/env python3
"""A mission run to its end with once:=true: the launch ends by itself, with a
verdict on the executed tracks, and no node dies.
"""

import os
import sys

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))

from mission_test import main
from small_mission import WINDOWS
from small_mission_case import SmallMissionTestCase

END_S = 90.0


class MissionEndTest(SmallMissionTestCase):
    small_arguments = {'sim': 'true', 'rate': '8.0', 'once': 'true',
                       'record': 'true'}

    def test_1_ends_by_itself_with_a_verdict_on_what_was_flown(self):
        self.mission.world.wait(lambda world: world.current_window == 1)
        report = self.mission.update(set=[
            ('ex:alpha', 'ex:usesPolicy', 'ex:safe')])  # During the mission.
        self.assertTrue(report.accepted, report.reasons)
        self.mission.wait_for_end(END_S)
        verdict = self.mission.verdict(lambda v: True)
        self.assert_no_violation(verdict)
        self.assertEqual(report.world_version, verdict['world_version'])
        for agent in ('alpha', 'bravo'):
            self.assertEqual(WINDOWS, verdict['agents'][agent]['waypoints'])
        self.assertGreater(verdict['checked_states'], 50)

    def test_2_recorded_the_mission(self):
        self.mission.wait_for_end(END_S)
        bags = [name for name in os.listdir(self.mission.state)
                if name.startswith('mission') and '.bag' in name]
        self.assertEqual(1, len(bags), os.listdir(self.mission.state))

    def test_zz_no_node_has_died(self):
        """Except verdict, whose exit ends the launch."""
        self.mission.stop()
        others = [line for line in self.mission.deaths()
                  if '[verdict' not in line]
        self.assertEqual([], others, self.mission.output()[-4000:])


if __name__ == '__main__':
    main('mission_end', MissionEndTest)
