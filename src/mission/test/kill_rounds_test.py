#!/usr/bin/env python3
"""SIGKILL of the KG node at random times during a stream of updates, repeatedly
on one store: every acknowledged update is present afterwards, no transaction is
present in part, world_version never decreases. Parameter `rounds`: number of
kills.
"""

import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import threading

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))

import rospkg
import rospy
from kg_msgs.msg import Fact, FactUpdate
from kg_msgs.srv import UpdateFacts
from mission_test import CHANGE_S, main, wait_until
from kg_query import KgQuery
import small_mission
import unittest

# Both are always set to the same value.
PAIR = (('ex:front', 'ex:value'), ('ex:mission', 'ex:separationWeight'))
LATEST_KILL_S = 0.6                # After the first fact of a round.
CLIENTS = 2
SEED = 7


def kg_node_program():
    found = rospkg.RosPack().get_path('kg_ros')
    name = subprocess.run(['catkin_find', '--first-only', 'kg_ros', 'kg_node'],
                          capture_output=True, text=True, check=False)
    return name.stdout.strip() or os.path.join(found, 'kg_node')


class Client(threading.Thread):
    """Sends pairs of facts as fast as they are decided, until the node dies."""

    def __init__(self, numbers):
        super().__init__(daemon=True)
        self._numbers = numbers
        self.acknowledged = []        # (world_version, value)
        self.asked = []               # All values sent.
        self.refused = []             # Reasons of rejection.
        self.first = threading.Event()

    def run(self):
        update = rospy.ServiceProxy('kg/update', UpdateFacts, persistent=True)
        try:
            while True:
                value = next(self._numbers)
                self.asked.append(value)
                report = update(FactUpdate(author='client', set=[
                    Fact(subject, property_, '%d' % value)
                    for subject, property_ in PAIR])).report
                if not report.accepted:
                    self.refused = report.reasons
                    return
                self.acknowledged.append((report.world_version, value))
                self.first.set()
        except (rospy.ServiceException, rospy.ROSException):
            pass                      # The node was killed.


class Numbers:
    """A counter shared by several threads."""

    def __init__(self):
        self._lock = threading.Lock()
        self._last = 0

    def __next__(self):
        with self._lock:
            self._last += 1
            return self._last


class KillRoundsTest(unittest.TestCase):

    def setUp(self):
        self.folder = tempfile.mkdtemp(prefix='kg_kill_')
        self.addCleanup(shutil.rmtree, self.folder, True)
        small_mission.write_mission(self.folder)
        rospy.set_param('/kg', {
            'mission_folder': self.folder, 'data_folder': '',
            'state_folder': os.path.join(self.folder, 'state'),
            'view_window': -1})
        self.log = open(os.path.join(self.folder, 'kg.log'), 'a+')
        self.addCleanup(self.log.close)
        self.random = random.Random(SEED)
        self.numbers = Numbers()
        self.query = KgQuery()
        self.acknowledged = 0
        self.version = 0

    def start(self):
        self.node = subprocess.Popen([kg_node_program(), '__name:=kg'],
                                     stdout=self.log, stderr=self.log)
        self.addCleanup(self.node.kill)
        wait_until(self.serves, CHANGE_S, 'kg/query')
        rospy.wait_for_service('kg/update', CHANGE_S)

    def serves(self):
        self.assertIsNone(self.node.poll(), 'kg ended by itself')
        try:
            return self.query.ask('ASK { ?m a ex:Mission }')
        except (rospy.ServiceException, rospy.ROSException):
            return False

    def values(self):
        rows = self.query.select(
            'SELECT ?a ?b { %s %s ?a . %s %s ?b }' % (PAIR[0] + PAIR[1]))
        self.assertEqual(1, len(rows))
        return rows.world_version, float(rows[0]['a']), float(rows[0]['b'])

    def check(self, clients):
        """The stored value is the last acknowledged or the last requested."""
        version, one, other = self.values()
        self.assertEqual(one, other, 'half a transaction')
        sure = max((pair for client in clients
                    for pair in client.acknowledged), default=(0, None))
        self.assertGreaterEqual(version, sure[0])
        self.assertGreaterEqual(version, self.version)
        in_doubt = {client.asked[-1] for client in clients if client.asked}
        self.assertIn(one, in_doubt | {sure[1]})
        if one == sure[1]:
            self.assertEqual(sure[0], version)
        logged = self.query.select(
            'SELECT ?v { GRAPH graph:log { ?c ex:inUpdate ?u ; '
            'ex:ofSubject %s ; ex:ofProperty %s ; ex:newValue ?v } }' % PAIR[0])
        known = {float(row['v']) for row in logged}
        for client in clients:
            for _, value in client.acknowledged:
                self.assertIn(value, known, 'an acknowledged fact is lost')
            self.acknowledged += len(client.acknowledged)
        self.version = version

    def test_nothing_acknowledged_is_lost_and_nothing_is_there_by_half(self):
        rounds = rospy.get_param('/rounds')
        self.start()
        for _ in range(rounds):
            clients = [Client(self.numbers) for _ in range(CLIENTS)]
            for client in clients:
                client.start()
            wait_until(lambda: any(client.first.is_set() or client.refused
                                   for client in clients), CHANGE_S, 'a fact')
            delay_s = self.random.uniform(0.0, LATEST_KILL_S)
            threading.Event().wait(delay_s)   # Drawn at random.
            self.node.send_signal(signal.SIGKILL)
            self.node.wait()
            for client in clients:
                client.join(CHANGE_S)
                self.assertFalse(client.is_alive())
                self.assertEqual([], client.refused)
            self.start()
            self.check(clients)
        print('%d rounds, %d facts acknowledged, 0 lost'
              % (rounds, self.acknowledged))
        self.assertGreater(self.acknowledged, rounds)


if __name__ == '__main__':
    main('kill_rounds', KillRoundsTest)
