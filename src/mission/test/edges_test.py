#!/usr/bin/env python3
"""One fact changed during the Gulf mission: from then on agents visit several
waypoints per window, to the end of the mission.
"""

import math
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))

import rospy
from kg_msgs.srv import Check, Why, WhyRequest

from mission_test import CHANGE_S, MissionTestCase, by_agent, main

AGENTS = ('alpha', 'bravo', 'charlie')
WINDOWS = 7
END_S = 300.0


def stops_of(plan):
    return [(assignment.agent, visit) for assignment in plan.assignments
            for visit in assignment.pathlet.visits if visit.via]


class EdgesTest(MissionTestCase):
    arguments = {'mission': 'gulf', 'sim': 'true', 'rate': '8.0',
                 'once': 'true'}

    def test_1_one_fact_makes_paths_of_several_waypoints_a_window(self):
        _, plan = self.mission.wait_for_plan()
        self.assertEqual([], stops_of(plan))
        self.mission.world.wait(lambda world: world.current_window >= 1)
        report = self.mission.update(set=[
            ('ex:gulf', 'ex:movementMode', '"edges"')])
        self.assertTrue(report.accepted, report.reasons)
        _, plan = self.mission.wait_for_plan(report.world_version)
        self.assertEqual([], list(plan.unassigned))
        self.assertGreater(len(stops_of(plan)), 0)
        self._assert_explained(plan)

    def _assert_explained(self, plan):
        """kg/why explains the value of a window with stops and the cost of its
        walk. The world version may change in the meantime."""
        why = rospy.ServiceProxy('kg/why', Why)
        why.wait_for_service(CHANGE_S)
        agent, visit = stops_of(plan)[-1]
        step = why(what=WhyRequest.ASSIGNMENT, agent=agent,
                   window=visit.window)
        self.assertTrue(step.ok, step.error)
        self.assertAlmostEqual(step.value, sum(step.contributions), places=9)
        self.assertIn('waypoint', step.text)
        visits = by_agent(plan)[agent].pathlet.visits
        place = [v.window for v in visits].index(visit.window)
        before = visits[place - 1].waypoint if place else 0
        edge = why(what=WhyRequest.EDGE, agent=agent, window=visit.window,
                   to=visit.waypoint, via=[stop.waypoint for stop in visit.via],
                   **{'from_': before})
        if step.world_version == edge.world_version == plan.world_version:
            self.assertAlmostEqual(edge.value, sum(edge.contributions),
                                   places=9)

    def test_2_its_artifacts_equal_a_full_recompilation(self):
        rospy.wait_for_service('kg/check', CHANGE_S)
        answer = rospy.ServiceProxy('kg/check', Check)()
        self.assertEqual(([], []), (answer.errors, answer.differs), answer.text)

    def test_3_ends_without_a_violation(self):
        self.mission.wait_for_end(END_S)
        verdict = self.mission.verdict(lambda v: True)
        self.assert_no_violation(verdict)
        for agent in AGENTS:
            self.assertEqual(WINDOWS, verdict['agents'][agent]['waypoints'])
            for lon, lat in verdict['agents'][agent]['positions_deg']:
                self.assertTrue(math.isfinite(lon) and math.isfinite(lat))

    def test_zz_no_node_has_died(self):
        """Except verdict, whose exit ends the launch."""
        self.mission.stop()
        others = [line for line in self.mission.deaths()
                  if '[verdict' not in line]
        self.assertEqual([], others, self.mission.output()[-4000:])


if __name__ == '__main__':
    main('edges', EdgesTest)
