#!/usr/bin/env python3
"""verdict: an independent check of every plan, written to verdict.json.

    subscribes  kg/assignments, kg/world, kg/work_fields, kg/agent_states,
                kg/candidates, kg/updates
    calls       kg/query (SPARQL SELECT: windows, agents, constraints, events)
    writes      <state>/verdict.json, replaced atomically after every plan and
                at the end of the mission
    parameters  ~state_folder
                ~once       exit when done: with ~sim at the mission's end,
                            else as soon as all windows are planned
                ~sim        do agents move?
                ~give_up_s  with ~once: the longest wait without a new plan or
                            window [s, wall clock]; then the verdict states
                            what was missing

Each rule is checked independently of the planner's code: plan_check.py.
"""

import json
import math
import os
import queue
import sys
import time

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))

import numpy as np
import rospy
import rospy.exceptions
from kg_msgs.msg import (AgentState, Assignments, Candidates, UpdateReport,
                         WorkField, World)
from rosgraph_msgs.msg import Log
from rospy.numpy_msg import numpy_msg

from executed_visits import executed_visits
from field_check import FieldCheck
from kg_query import KgQuery, QueryError
from mission_facts import FactsReader, WorldChanged
from mission_record import MissionRecord, Plan, Visit
from plan_check import KINDS, Field, Track

FIELD_BUFFER_BYTES = 1 << 26  # Subscriber buffer: fields have several MB.
STEP_S = 0.1
# The facts change while being read, or the KG node is absent: retried later.
NOT_NOW = (WorldChanged, QueryError, rospy.ServiceException,
           rospy.ROSException, rospy.exceptions.ROSInternalException, OSError)
FAILED_S = 30.0  # Longest wait for a new plan after planning failed.
UNOPENABLE_S = 15.0  # Longest wait for a mission that cannot be opened.


def to_plan(message):
    tracks, visits = {}, {}
    for assignment in message.assignments:
        pathlet = assignment.pathlet
        tracks[assignment.agent] = Track.of(
            (point.stamp.to_sec(), math.degrees(point.lon_rad),
             math.degrees(point.lat_rad)) for point in pathlet.track)
        for visit in pathlet.visits:
            visits[assignment.agent, visit.window] = Visit(
                math.degrees(visit.lon_rad), math.degrees(visit.lat_rad),
                list(visit.events), visit.reward, visit.cost.seam_cost,
                visit.cost.energy_j,
                [(math.degrees(stop.lon_rad), math.degrees(stop.lat_rad))
                 for stop in visit.via])
    return Plan(message.world_version, message.plan_run, tracks, visits,
                list(message.unassigned))


def to_field(message):
    lon_deg = np.degrees(message.grid.lon_rad)
    lat_deg = np.degrees(message.grid.lat_rad)
    shape = (len(lat_deg), len(lon_deg))
    return Field(lon_deg, lat_deg,
                 [part.stamp.to_sec() for part in message.slices],
                 [part.east_mps.reshape(shape) for part in message.slices],
                 [part.north_mps.reshape(shape) for part in message.slices])


def write_whole(path, value):
    """Replaces a file atomically: readers see the old or the new content."""
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path + '.new', 'w') as file:
        json.dump(value, file, indent=2, allow_nan=False, default=str)
        file.write('\n')
        file.flush()
        os.fsync(file.fileno())
    os.replace(path + '.new', path)


class Heard:
    """Messages received from the nodes so far."""

    def __init__(self):
        self.world = None
        self.fields = {}      # By window.
        self.hashes = {}      # Field hashes, by window.
        self.planners = {}    # World version of the last candidates, by id.
        self.plan = None      # Newest Assignments that are not checked yet.
        self.plans = 0
        self.stage_seconds = {}
        self.fatal = None     # Why kg cannot open the mission.

    def take(self, message):
        getattr(self, '_take_' + message._type.split('/')[1])(message)

    def _take_World(self, message):
        self.world = message
        self.fatal = None

    def _take_Log(self, message):
        if message.name == '/kg' and message.level == Log.FATAL:
            self.fatal = message.msg

    def _take_WorkField(self, message):
        self.fields[message.window] = to_field(message)
        self.hashes[message.window] = message.hash

    def _take_Candidates(self, message):
        self.planners[message.agent] = message.world_version
        self._take_stages(message)

    def _take_Assignments(self, message):
        self.plan = message
        self.plans += 1
        self._take_stages(message)

    def _take_UpdateReport(self, message):
        self._take_stages(message)

    def _take_stages(self, message):
        for stage in message.stages:
            self.stage_seconds[stage.stage] = stage.seconds

    def missing(self):
        """The first stage without output, in words."""
        if self.world is None:
            return 'kg: %s' % (self.fatal or 'no kg/world')
        windows = len(self.world.windows)
        if len(self.fields) < windows:
            return 'ingest: %d of %d kg/work_fields' % (len(self.fields),
                                                        windows)
        late = sorted(agent.id for agent in self.world.agents
                      if self.planners.get(agent.id, -1) <
                      self.world.world_version)
        if late and not self.plans:
            return 'plan: no kg/candidates of %s' % ', '.join(late)
        if not self.plans:
            return 'select: no kg/assignments'
        if self.world.plan_status != World.PLAN_OK:
            return 'commit: plan_status %d %s' % (self.world.plan_status,
                                                  self.world.plan_note)
        return 'flight: in window %d of %d' % (self.world.current_window,
                                               windows)


class Verdict:
    """Checks received plans, one step at a time."""

    def __init__(self, path, once, sim):
        self._path = path
        self._once = once
        self._sim = sim
        self._heard = Heard()
        self._record = MissionRecord()
        self._query = KgQuery()
        self._field_check = FieldCheck(self._query.select)
        self._field_findings = []
        self._facts = None
        self._began_unix_s = time.time()
        self._began_s = time.monotonic()
        self.progress_s = self._began_s  # Time of the last progress.
        self._window = None
        self.last = None

    def take(self, message):
        if message._type == AgentState._type:
            self._record.take_state(message.agent,
                                    message.header.stamp.to_sec(),
                                    math.degrees(message.lon_rad),
                                    math.degrees(message.lat_rad))
            return
        self._heard.take(message)
        world = self._heard.world
        if world and world.current_window != self._window:
            self._window = world.current_window
            self.progress_s = time.monotonic()

    def step(self):
        """Checks a pending plan. True when the task is finished."""
        if self._heard.plan is not None:
            self._judge(self._heard.plan)
        if not (self._once and self._done()):
            return False
        self.write()
        return True

    def _judge(self, message):
        """Checks the plan, drops it if the facts are newer, or defers it."""
        world = self._heard.world
        if world is None or not self._fields_are_here(message):
            return
        first = self._record.plan is None
        if first and world.plan_run < message.plan_run:
            return  # Not yet in the knowledge graph.
        try:
            facts = self._facts_of(message.world_version)
            findings = self._field_check.findings(self._heard.fields,
                                                  self._heard.hashes)
            past = executed_visits(self._query.select) if first else {}
        except NOT_NOW as error:
            rospy.logwarn_throttle(10.0, '[verdict] waiting for facts: %s' %
                                   error)
            return
        if facts is None:
            if world.world_version > message.world_version:
                self._heard.plan = None
            return
        self._record.take_past(past)
        self._record.take_plan(to_plan(message), facts,
                               dict(self._heard.fields),
                               world.mission_time.to_sec())
        self._field_findings = findings
        self._heard.plan = None
        self.progress_s = time.monotonic()
        self.write()

    def _fields_are_here(self, message):
        return all(visit.window in self._heard.fields
                   for assignment in message.assignments
                   for visit in assignment.pathlet.visits)

    def _facts_of(self, world_version):
        """None if the world version is a different one by now."""
        if self._facts is None or self._facts.world_version != world_version:
            self._facts = FactsReader(self._query.select).read()
        return (self._facts if self._facts.world_version == world_version
                else None)

    def _done(self):
        world = self._heard.world
        if self._heard.plan is not None or self._record.plan is None:
            return False
        if self._sim:
            return world.current_window >= len(world.windows)
        return (self._record.complete() and
                world.plan_status == World.PLAN_OK and
                world.plan_version == self._record.plan.world_version)

    def _ended(self):
        """Is every window flown, or planned if agents do not move?"""
        return self._heard.world is not None and self._done()

    def patience_s(self, give_up_s):
        """Longest wait without progress [s]."""
        if self._heard.fatal:
            return min(give_up_s, UNOPENABLE_S)
        world = self._heard.world
        failed = world is not None and world.plan_status == World.PLAN_FAILED
        return min(give_up_s, FAILED_S) if failed else give_up_s

    def write(self, why_not=None):
        verdict = self._record.verdict() if self._record.plan else {
            'world_version': 0, 'plan_run': 0, 'windows': 0, 'complete': False,
            'agents': {}, 'violations': dict.fromkeys(KINDS, 0),
            'checked_points': 0, 'checked_states': 0, 'notes': []}
        verdict['violations']['field'] = sum(
            counts for counts, _ in self._field_findings)
        verdict['notes'] += [line for _, line in self._field_findings]
        verdict['stage_seconds'] = dict(
            self._heard.stage_seconds,
            verdict=time.monotonic() - self._began_s)
        verdict['began_unix_s'] = self._began_unix_s
        verdict['ended'] = not why_not and self._ended()
        if why_not:
            verdict['complete'] = False
            verdict['notes'].insert(0, why_not)
        self.last = verdict
        write_whole(self._path, verdict)
        self._tell(verdict)

    def _tell(self, verdict):
        found = ', '.join('%s %d' % item
                          for item in sorted(verdict['violations'].items())
                          if item[1])
        waypoints = sum(agent['waypoints']
                        for agent in verdict['agents'].values())
        log = rospy.logerr if found else rospy.loginfo
        log('[verdict] plan %d of world version %d: %d waypoints, %d points '
            'and %d states checked, %s', verdict['plan_run'],
            verdict['world_version'], waypoints, verdict['checked_points'],
            verdict['checked_states'],
            'VIOLATIONS: ' + found if found else 'no violations')

    def give_up(self):
        why = 'gave up after %.0f s without progress; missing: %s' % (
            time.monotonic() - self.progress_s, self._heard.missing())
        rospy.logerr('[verdict] FAILED: %s', why)
        self.write(why)


def subscribe(inbox):
    """All messages go into one queue; one thread checks."""
    take = inbox.put
    rospy.Subscriber('kg/world', World, take)
    rospy.Subscriber('kg/work_fields', numpy_msg(WorkField), take,
                     buff_size=FIELD_BUFFER_BYTES)
    rospy.Subscriber('kg/assignments', Assignments, take)
    rospy.Subscriber('kg/candidates', Candidates, take)
    rospy.Subscriber('kg/updates', UpdateReport, take)
    rospy.Subscriber('kg/agent_states', AgentState, take)
    rospy.Subscriber('/rosout', Log, take)


def drain(inbox, verdict):
    while True:
        try:
            verdict.take(inbox.get_nowait())
        except queue.Empty:
            return


def main():
    rospy.init_node('verdict')
    once = rospy.get_param('~once', False)
    give_up_s = rospy.get_param('~give_up_s', 900.0)
    verdict = Verdict(os.path.join(rospy.get_param('~state_folder'),
                                   'verdict.json'),
                      once, rospy.get_param('~sim', True))
    inbox = queue.Queue()
    subscribe(inbox)
    while not rospy.is_shutdown():
        drain(inbox, verdict)
        if verdict.step():
            return
        if once and time.monotonic() - verdict.progress_s > verdict.patience_s(
                give_up_s):
            verdict.give_up()
            return
        time.sleep(STEP_S)


if __name__ == '__main__':
    main()
