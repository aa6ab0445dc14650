#!/usr/bin/env python3
"""A mission that cannot be opened: one clear line, a verdict with the reason,
and a start as soon as the missing file exists.
"""

import os
import sys

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))

from mission_test import CHANGE_S, RunningMission, main, wait_until
from small_mission_case import SmallMissionTestCase

END_S = 90.0


class UnopenableTest(SmallMissionTestCase):
    small_arguments = {'sim': 'false', 'once': 'true'}

    @classmethod
    def prepare(cls):
        super().prepare()
        os.rename(cls.file('ocean.nc'), cls.file('later.nc'))

    def test_1_with_once_it_ends_and_says_why(self):
        self.mission.wait_for_end(END_S)
        verdict = self.mission.verdict(lambda v: True)
        self.assertFalse(verdict['complete'])
        self.assertIn('ocean.nc', verdict['notes'][0])

    def test_2_it_starts_when_the_file_is_there(self):
        self.mission.stop()
        mission = RunningMission(**dict(self.arguments, once='false'))
        self.addCleanup(mission.remove)
        self.addCleanup(mission.stop)
        wait_until(lambda: 'ocean.nc' in mission.output(), CHANGE_S,
                   'a line that names the file')
        os.rename(self.file('later.nc'), self.file('ocean.nc'))
        mission.wait_for_plan()

    def test_zz_no_node_has_died(self):
        """Except verdict, whose exit ends the launch."""
        self.mission.stop()
        others = [line for line in self.mission.deaths()
                  if '[verdict' not in line]
        self.assertEqual([], others, self.mission.output()[-4000:])


if __name__ == '__main__':
    main('unopenable', UnopenableTest)
