#!/usr/bin/env python3
"""Real currents off Tampico (temperature from elsewhere): results in a plan."""

import os
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))

from mission_test import MissionTestCase, main, shared_data


class TampicoTest(MissionTestCase):
    @classmethod
    def prepare(cls):
        data = shared_data('gom_2020')
        if data is None:
            reason = 'no shared data folder gom_2020'
            print('SKIPPED: ' + reason)  # rosunit's result omits skips.
            raise unittest.SkipTest(reason)
        cls.arguments = {'mission': 'tampico', 'data': data, 'sim': 'false'}

    def test_1_plans_every_agent_for_every_window(self):
        world, plan = self.mission.wait_for_plan()
        self.assertEqual([], list(plan.unassigned))
        self.assertEqual({agent.id for agent in world.agents},
                         {assignment.agent for assignment in plan.assignments})
        verdict = self.mission.verdict(
            lambda v: v['world_version'] == world.world_version)
        self.assert_no_violation(verdict)
        self.assertEqual(len(world.windows), verdict['windows'])

    def test_2_currents_come_from_the_file_of_the_data_argument(self):
        self.mission.wait_for_plan()
        paths = {row['path'] for row in self.mission.select(
            'SELECT ?path WHERE { ?field a ex:CurrentField ; '
            'prov:wasDerivedFrom ?f . ?f ex:path ?path }')}
        self.assertTrue(paths)
        for path in paths:
            self.assertEqual(os.path.realpath(self.arguments['data']),
                             os.path.dirname(os.path.realpath(path)))


if __name__ == '__main__':
    main('tampico', TampicoTest)
