#!/usr/bin/env python3
"""An interrupted mission resumes where it was: same facts, same executed
windows, and one verdict on the whole mission.
"""

import os
import sys

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))

from mission_test import RunningMission, main
from small_mission import WINDOWS
from small_mission_case import SmallMissionTestCase

END_S = 90.0


class ResumeTest(SmallMissionTestCase):
    small_arguments = {'sim': 'true', 'rate': '8.0'}

    def test_goes_on_where_it_was_interrupted(self):
        self.mission.world.wait(lambda world: world.current_window == 1)
        report = self.mission.update(set=[
            ('ex:alpha', 'ex:usesPolicy', 'ex:safe')])
        self.assertTrue(report.accepted, report.reasons)
        self.mission.world.wait(lambda world: world.current_window == 2)
        self.mission.stop()
        self.assertEqual([], self.mission.deaths(),
                         self.mission.output()[-4000:])
        again = RunningMission(**dict(self.arguments, state=self.mission.state,
                             once='true'))
        self.addCleanup(again.remove)
        self.addCleanup(again.stop)
        world = again.world.wait()
        self.assertEqual(2, world.current_window)
        self.assertEqual(report.world_version, world.world_version)
        self.assertTrue(again.ask('ASK { ex:alpha ex:usesPolicy ex:safe }'))
        again.wait_for_end(END_S)
        verdict = self.mission.verdict(lambda v: True)
        self.assert_no_violation(verdict)
        for agent in ('alpha', 'bravo'):
            self.assertEqual(WINDOWS, verdict['agents'][agent]['waypoints'])


if __name__ == '__main__':
    main('resume', ResumeTest)
