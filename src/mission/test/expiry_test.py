#!/usr/bin/env python3
"""Facts with an end of validity, in a running mission: a closed area opens at
its time, and what other facts refer to stays; kg/validate predicts both.
"""

import os
import sys

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))

import rospy
from kg_msgs.msg import Fact, FactUpdate, UpdateReport
from kg_msgs.srv import Validate
from mission_test import Heard, main
from small_mission_case import SmallMissionTestCase

END_S = 60.0
AREA = ('"POLYGON((-91.2 25.2, -91.0 25.2, -91.0 25.4, -91.2 25.4, '
        '-91.2 25.2))"')
FIRING = ('ex:firing a ex:Constraint ; ex:kind "no_go" ; geo:asWKT %s ; '
          'ex:validUntil "2026-06-03T12:00:00Z"^^xsd:dateTime .' % AREA)


class ExpiryTest(SmallMissionTestCase):
    small_arguments = {'sim': 'true', 'rate': '2.0'}

    def test_1_validate_foresees_what_would_be_refused(self):
        self.mission.wait_for_plan()
        rospy.wait_for_service('kg/validate', 10.0)
        validate = rospy.ServiceProxy('kg/validate', Validate)
        bad = validate(FactUpdate(set=[Fact('ex:w1', 'ex:confidence', '1.2')]))
        self.assertFalse(bad.conforms)
        self.assertEqual(1, len(bad.violations))
        for said in ('ex:w1 ex:confidence: ', 'not 1.2', 'ex:TimeWindowShape'):
            self.assertIn(said, bad.violations[0])
        for said in ('sh:conforms false', 'sh:focusNode ex:w1',
                     'sh:resultPath ex:confidence', 'sh:value 1.2'):
            self.assertIn(said, bad.report)
        good = validate(FactUpdate(turtle=FIRING))
        self.assertTrue(good.conforms, good.violations)
        self.assertIn('sh:conforms true', good.report)
        self.assertFalse(self.mission.ask('ASK { ex:firing ?p ?o }'))

    def test_2_a_closed_area_opens_at_its_time(self):
        self.mission.wait_for_plan()
        reports = Heard('kg/updates', UpdateReport)
        self.addCleanup(reports.close)
        closed = self.mission.update(turtle=FIRING)
        self.assertTrue(closed.accepted, closed.reasons)
        opened = reports.wait(lambda report: report.id == 'expiry', END_S)
        self.assertTrue(opened.accepted, opened.reasons)
        self.assertEqual('kg', opened.author)
        self.assertGreater(opened.world_version, closed.world_version)
        self.assertFalse(self.mission.ask('ASK { ex:firing ?p ?o }'))
        self.assertTrue(self.mission.ask(
            'ASK { GRAPH graph:log { ?c ex:ofSubject ex:firing ; '
            'ex:oldValue "no_go" ; ex:inUpdate ?u } ?u ex:author "kg" }'))
        self.mission.wait_for_plan(opened.world_version)


if __name__ == '__main__':
    main('expiry', ExpiryTest)
