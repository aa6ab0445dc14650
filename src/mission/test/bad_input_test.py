#!/usr/bin/env python3
"""Invalid input: each invalid update or file is rejected with one clear line,
nothing changes, and the running mission continues.
"""

import os
import sys

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))

import small_mission
from kg_msgs.msg import World
from mission_test import main
from small_mission_case import SmallMissionTestCase

AREA = [('ex:bad', 'a', 'ex:Constraint'), ('ex:bad', 'ex:kind', '"no_go"')]


def area(text):
    return AREA + [('ex:bad', 'geo:asWKT', '"%s"^^geo:wktLiteral' % text)]


# What is sent, and what the reason has to name.
BAD_UPDATES = {
    'a ring that does not close': (
        dict(add=area('POLYGON((-91 25.5, -90.5 25.5, -90.5 26))')), 'ex:bad'),
    'text that is not WKT': (dict(add=area('POLYGON(oops')), 'ex:bad'),
    'a coordinate that is not a number': (
        dict(add=area('POLYGON((nan 1, 2 2, 3 1, nan 1))')), 'ex:bad'),
    'a latitude beyond the pole': (
        dict(add=area('POLYGON((-91 95, -90 95, -90 96, -91 95))')), 'ex:bad'),
    'an agent that does not exist': (
        dict(set=[('ex:nobody', 'ex:usesPolicy', 'ex:safe')]), 'ex:nobody'),
    'a policy that does not exist': (
        dict(set=[('ex:alpha', 'ex:usesPolicy', 'ex:nonsense')]),
        'ex:usesPolicy'),
    'an unknown property': (
        dict(set=[('ex:alpha', 'ex:usesPolicies', 'ex:safe')]),
        'ex:usesPolicies'),
    'a confidence of 1.2': (
        dict(set=[('ex:w1', 'ex:confidence', '1.2')]), 'ex:confidence'),
    'two policies': (
        dict(add=[('ex:alpha', 'ex:usesPolicy', 'ex:safe')]), 'ex:usesPolicy'),
    'an unknown prefix': (
        dict(set=[('nix:alpha', 'ex:usesPolicy', 'ex:safe')]), 'nix:alpha'),
    'a term that does not end': (
        dict(set=[('ex:w1', 'ex:confidence', '"0.5')]), '"0.5'),
    'an empty subject': (
        dict(set=[('', 'ex:usesPolicy', 'ex:safe')]), 'expected'),
    'Turtle that breaks off': (
        dict(turtle='ex:w1 ex:confidence '), '1:'),
    'the removal of a fact that does not exist': (
        dict(remove=[('ex:alpha', 'ex:usesPolicy', 'ex:safe')]),
        'ex:usesPolicy'),
}


def truncated(source, path):
    with open(source, 'rb') as file:
        content = file.read()
    with open(path, 'wb') as file:
        file.write(content[:len(content) * 3 // 4])


def noise(path):
    with open(path, 'wb') as file:
        file.write(b'this is no ocean\n' * 1000)


class BadInputTest(SmallMissionTestCase):
    def _complaints(self, what, named, **lists):
        """Sends an update; list of faults in the answer or the mission."""
        before = self.mission.world.last.world_version
        report = self.mission.update(**lists)
        said = ' | '.join(report.reasons)
        checks = {
            'it was accepted': not report.accepted,
            'world_version changed': before == report.world_version and
                                     before == self._world().world_version,
            'the reason does not name %r: %r' % (named, said): named in said,
            'more than one line: %r' % said: '\n' not in said,
            'the plan is gone': self._world().plan_status == World.PLAN_OK,
            'a fact is gone': self.mission.ask(
                'ASK { ex:alpha ex:usesPolicy ex:fast }')}
        return ['%s: %s' % (what, complaint)
                for complaint, fine in checks.items() if not fine]

    def _world(self):
        return self.mission.world.last

    def test_1_refuses_facts_that_cannot_be(self):
        self.mission.wait_for_plan()
        self.assertEqual([], [
            complaint for what, (lists, named) in BAD_UPDATES.items()
            for complaint in self._complaints(what, named, **lists)])

    def test_2_refuses_files_that_cannot_be_read(self):
        self.mission.wait_for_plan()
        small_mission.write_ocean(self.file('dry.nc'), all_land=True)
        small_mission.write_ocean(self.file('no_v.nc'), without=('water_v',))
        small_mission.write_ocean(self.file('short.nc'), days=2)
        small_mission.write_ocean(self.file('no_temperature.nc'),
                                  without=('water_temp',))
        truncated(self.file('ocean.nc'), self.file('truncated.nc'))
        noise(self.file('noise.nc'))
        complaints = []
        for name, source in (
                ('dry', 'ex:currents'), ('no_v', 'ex:currents'),
                ('short', 'ex:sst'), ('truncated', 'ex:currents'),
                ('noise', 'ex:currents'), ('absent', 'ex:currents'),
                ('no_temperature', 'ex:sst')):
            complaints += self._complaints(name, name + '.nc', set=[
                (source, 'ex:file', '"%s"' % self.file(name + '.nc'))])
        self.assertEqual([], complaints)

    def test_3_a_refused_update_changes_nothing_of_its_good_part(self):
        self.mission.wait_for_plan()
        self.assertEqual([], self._complaints(
            'one good, one bad', 'ex:confidence', set=[
                ('ex:front', 'ex:value', '9.0'),
                ('ex:w1', 'ex:confidence', '7')]))
        self.assertFalse(self.mission.ask('ASK { ex:front ex:value 9.0 }'))

    def test_4_a_good_update_is_taken_after_all_these(self):
        self.mission.wait_for_plan()
        report = self.mission.update(set=[('ex:front', 'ex:value', '4.0')])
        self.assertTrue(report.accepted, report.reasons)
        self.mission.wait_for_plan(report.world_version)
        self.assert_no_violation(self.mission.verdict(
            lambda v: v['world_version'] == report.world_version))


if __name__ == '__main__':
    main('bad_input', BadInputTest)
