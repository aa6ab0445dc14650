"""Shared by the tests of a running mission: launch in a temporary state folder,
wait for conditions with a deadline, update and query facts.

    class AGulf(MissionTestCase):
        arguments = {'mission': 'gulf'}
        def test_plans(self):
            self.mission.wait_for_plan()
"""

import json
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest
import xmlrpc.client

import rosgraph
import rospkg
import rospy
import rostest
from kg_msgs.msg import (Assignments, Fact, FactUpdate, UpdateReport, World)
from kg_msgs.srv import UpdateFacts

MISSION = rospkg.RosPack().get_path('mission')
ROOT = os.path.dirname(os.path.realpath(os.path.join(MISSION, 'launch')))
sys.path.insert(0, os.path.join(MISSION, 'scripts'))

from kg_query import KgQuery  # noqa: E402

PLAN_S = 120.0     # Longest wait for a plan.
CHANGE_S = 60.0    # Longest wait for any smaller change.
STOP_S = 20.0      # Longest wait for nodes to exit.


def shared_data(folder):
    """A folder of the shared data, or None if it does not exist."""
    base = os.environ.get('KG_SHARED_DATA',
                          os.path.join(os.path.dirname(ROOT), 'shared', 'data'))
    path = os.path.join(base, folder)
    return path if os.path.isdir(path) else None


def wait_until(condition, timeout_s, what):
    """The first true value of condition(); AssertionError after timeout_s."""
    deadline = time.monotonic() + timeout_s
    while True:
        value = condition()
        if value:
            return value
        if time.monotonic() > deadline:
            raise AssertionError('%s: not within %.0f s' % (what, timeout_s))
        time.sleep(0.05)


class Heard:
    """All messages of a topic since construction."""

    def __init__(self, topic, message_type):
        self._changed = threading.Condition()
        self.topic = topic
        self.messages = []
        self._subscriber = rospy.Subscriber(topic, message_type, self._take)

    def _take(self, message):
        with self._changed:
            self.messages.append(message)
            self._changed.notify_all()

    def close(self):
        self._subscriber.unregister()

    @property
    def last(self):
        return self.messages[-1] if self.messages else None

    def wait(self, accepts=lambda message: True, timeout_s=CHANGE_S, since=0):
        """The newest accepted message, ignoring those before number `since`."""
        with self._changed:
            def found():
                return next((message for message in
                             reversed(self.messages[since:])
                             if accepts(message)), None)
            if not self._changed.wait_for(lambda: found() is not None,
                                          timeout_s):
                raise AssertionError('%s: no such message within %.0f s; last '
                                     'message:\n%s' % (self.topic, timeout_s,
                                                   str(self.last)[:2000]))
            return found()


class RunningMission:
    """One running bringup.launch."""

    def __init__(self, **arguments):
        self.folder = tempfile.mkdtemp(prefix='kg_test_')
        self.state = os.path.join(self.folder, 'state')
        self._log = open(os.path.join(self.folder, 'roslaunch.log'), 'w+')
        arguments = dict({'state': self.state, 'rviz': 'false'}, **arguments)
        self._process = subprocess.Popen(
            ['roslaunch', 'mission', 'bringup.launch'] +
            ['%s:=%s' % item for item in sorted(arguments.items())],
            stdout=self._log, stderr=subprocess.STDOUT,
            env=dict(os.environ, ROS_LOG_DIR=os.path.join(self.folder, 'log')))
        self.world = Heard('kg/world', World)
        self.plans = Heard('kg/assignments', Assignments)
        self.updates = Heard('kg/updates', UpdateReport)
        self._update = rospy.ServiceProxy('kg/update', UpdateFacts)
        self.query = KgQuery()

    def running(self):
        return self._process.poll() is None

    def output(self):
        """Output of roslaunch and the nodes so far."""
        with open(self._log.name) as log:
            return log.read()

    def deaths(self):
        """Log lines that report an abnormal exit of a node."""
        return [line for line in self.output().splitlines()
                if re.search(r'has died|exit code -|Traceback|REQUIRED process '
                             r'.* has died', line)]

    def stop(self):
        """Ends the launch and waits for its exit; idempotent."""
        for heard in (self.world, self.plans, self.updates):
            heard.close()
        if self.running():
            self._process.send_signal(signal.SIGINT)
        try:
            self._process.wait(STOP_S)
        except subprocess.TimeoutExpired:
            self._process.terminate()
            self._process.wait(STOP_S)
        self._log.close()

    def remove(self):
        shutil.rmtree(self.folder, ignore_errors=True)

    def wait_for_end(self, timeout_s):
        self._process.wait(timeout_s)

    # Facts.

    def update(self, **lists):
        """One transaction by service; lists of (subject, property, value)."""
        turtle = lists.pop('turtle', '')
        update = FactUpdate(author='test', turtle=turtle, **{
            kind: [Fact(*fact) for fact in facts]
            for kind, facts in lists.items()})
        self._update.wait_for_service(CHANGE_S)
        return self._update(update).report

    def select(self, query):
        return self.query.select(query)

    def ask(self, query):
        return self.query.ask(query)

    # Plans.

    def wait_for_plan(self, world_version=1, timeout_s=PLAN_S):
        """World and Assignments once world_version or later is planned."""
        world = self.world.wait(
            lambda world: world.plan_status == World.PLAN_OK and
            world.plan_version >= world_version, timeout_s)
        return world, self.plans.wait(
            lambda plan: plan.world_version == world.plan_version)

    def verdict(self, accepts, timeout_s=CHANGE_S):
        """verdict.json as soon as accepts(verdict) is true."""
        path = os.path.join(self.state, 'verdict.json')

        def read():
            if not os.path.isfile(path):
                return None
            with open(path) as file:
                verdict = json.load(file)
            return verdict if accepts(verdict) else None
        return wait_until(read, timeout_s, 'verdict.json')


class MissionTestCase(unittest.TestCase):
    """One mission for all tests of a class; fails if one of its nodes dies."""

    arguments = {}

    @classmethod
    def setUpClass(cls):
        cls.prepare()
        cls.mission = RunningMission(**cls.arguments)

    @classmethod
    def prepare(cls):
        """Prepares the launch; may set cls.arguments."""

    @classmethod
    def tearDownClass(cls):
        cls.mission.stop()
        cls.mission.remove()

    def test_zz_no_node_has_died(self):
        """rostest itself does not detect this."""
        self.mission.stop()
        self.assertEqual([], self.mission.deaths(),
                         self.mission.output()[-4000:])

    def assert_no_violation(self, verdict):
        self.assertTrue(verdict['complete'], verdict)
        self.assertEqual([], [item for item in verdict['violations'].items()
                              if item[1] != 0], verdict['notes'])
        self.assertGreater(verdict['checked_points'], 0)


def track_deg(assignment):
    """[(lon, lat)] of an assigned track [deg]."""
    to_deg = 57.29577951308232
    return [(point.lon_rad * to_deg, point.lat_rad * to_deg)
            for point in assignment.pathlet.track]


def by_agent(plan):
    return {assignment.agent: assignment for assignment in plan.assignments}


def node_pid(name):
    """Process id of a node, from the node itself; None if it is gone."""
    master = rosgraph.Master('/mission_test')
    try:
        uri = master.lookupNode(name)
        return xmlrpc.client.ServerProxy(uri).getPid('/mission_test')[2]
    except (rosgraph.MasterException, OSError):
        return None


def main(name, test_case):
    """Runs a test case as one rostest node and writes its result."""
    rospy.init_node(name, anonymous=True)
    rostest.rosrun('mission', name, test_case)
