#!/usr/bin/env python3
"""Drones around a fire, in the wind: the same nodes with a wind field, several
waypoints per window. Runs the README's command to its end.
"""

import os
import re
import sys

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))

from mission_test import (CHANGE_S, ROOT, MissionTestCase, RunningMission,
                          by_agent, main, track_deg, wait_until)

AGENTS = {'osprey', 'kestrel', 'harrier'}
WINDOWS = 6
END_S = 200.0


def readme_arguments():
    """Launch arguments of the README's command for this mission."""
    with open(os.path.join(ROOT, 'README.md')) as file:
        line = re.search(r'^roslaunch mission bringup.launch '
                         r'(.*mission:=wildfire.*)$', file.read(), re.MULTILINE)
    return dict(item.split(':=') for item in line.group(1).split())


class WildfireTest(MissionTestCase):
    @classmethod
    def prepare(cls):
        cls.arguments = {'mission': readme_arguments()['mission'],
                         'sim': 'false'}

    def test_1_plans_several_waypoints_in_a_window(self):
        world, plan = self.mission.wait_for_plan()
        self.assertEqual([], list(plan.unassigned))
        self.assertEqual(AGENTS, set(by_agent(plan)))
        self.assertEqual(WINDOWS, len(world.windows))
        stops = 0
        for assignment in plan.assignments:
            track = track_deg(assignment)
            for visit in assignment.pathlet.visits:
                stops += len(visit.via)
                for stop in visit.via:
                    place = (57.29577951308232 * stop.lon_rad,
                             57.29577951308232 * stop.lat_rad)
                    self.assertLess(min(max(abs(place[0] - lon),
                                            abs(place[1] - lat))
                                        for lon, lat in track), 1e-6)
        self.assertGreater(stops, WINDOWS)

    def test_2_the_work_field_is_the_wind(self):
        self.assertTrue(self.mission.ask(
            'ASK { ?f a ex:WorkField ; '
            'sosa:observedProperty ex:windVelocity }'))
        self.assertFalse(self.mission.ask('ASK { ?f a ex:CurrentField }'))

    def test_3_stops_are_facts_in_their_order(self):
        walks = wait_until(lambda: self.mission.select(
            'SELECT ?edge ?order (COUNT(?stop) AS ?stops) WHERE { '
            '?edge ex:via ?stop ; ex:stopOrder ?order . '
            '?stop a ex:Waypoint ; ex:inGraph ?graph . '
            '?edge ex:inGraph ?graph } GROUP BY ?edge ?order'),
                           CHANGE_S, 'walks')
        for row in walks:
            name = row['edge'].rsplit('/', 1)[1]
            self.assertEqual(row['order'].split(), name.split('-')[1:-1])
            self.assertEqual(int(row['stops']), len(row['order'].split()))
        self.assertTrue(self.mission.ask(
            'ASK { ?x a ex:Assignment ; ex:stopsWKT ?wkt }'))

    def test_4_the_readmes_command_ends_without_a_violation(self):
        self.mission.stop()  # Only one mission per ROS master.
        arguments = readme_arguments()
        self.assertEqual('true', arguments['once'])
        mission = RunningMission(**arguments)
        self.addCleanup(mission.remove)
        self.addCleanup(mission.stop)
        mission.wait_for_end(END_S)
        verdict = mission.verdict(lambda v: True)
        self.assert_no_violation(verdict)
        self.assertEqual(AGENTS, set(verdict['agents']))
        for agent in verdict['agents'].values():
            self.assertEqual(WINDOWS, agent['waypoints'])


if __name__ == '__main__':
    main('wildfire', WildfireTest)
