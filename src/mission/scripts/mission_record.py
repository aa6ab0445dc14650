"""The history of a mission: tracks and visits of all plans joined in time, the
states that agents reported, and the findings of the checks.

A new plan replaces the previous one from the begin of its tracks on; what was
flown earlier keeps the findings under the facts of its time.
"""

import collections
import dataclasses

import numpy as np

from geodesic import distance_m
from plan_check import KINDS, PlanCheck, Track, exempt_spans

OFF_TRACK_M = 500.0  # A reported state this far from its track is a finding.
MAX_LINES = 20       # Findings listed as notes.


@dataclasses.dataclass
class Visit:
    lon_deg: float
    lat_deg: float
    events: list
    reward: float
    seam_cost: float
    energy_j: float
    via: list = dataclasses.field(default_factory=list)  # (lon, lat) of stops.
    left_early: bool = False  # A newer plan left before the window's end.


@dataclasses.dataclass
class Plan:
    world_version: int
    plan_run: int
    tracks: dict      # Track by agent id.
    visits: dict      # Visit by (agent id, window).
    unassigned: list  # "id: reason".


class MissionRecord:
    def __init__(self):
        self.plan = None
        self._facts = None
        self._fields = None
        self._tracks = {}
        self._exempt = collections.defaultdict(list)  # See check_tracks().
        self._visits = {}
        self._states = collections.defaultdict(list)
        self._settled_s = -np.inf
        self._violations = dict.fromkeys(KINDS + ('off_track',), 0)
        self._lines = []
        self._points = 0
        self._states_seen = 0
        self._first_window = 0
        self._past = {}  # Visits made before this check started.

    def take_state(self, agent_id, time_s, lon_deg, lat_deg):
        """A state removes recorded states of later times: a new plan is
        followed from its begin, which may be slightly in the past."""
        states = self._states[agent_id]
        while states and states[-1][0] >= time_s:
            states.pop()
        states.append((time_s, lon_deg, lat_deg))
        self._states_seen += 1

    def take_past(self, visits):
        """Visits made before this check started: they are counted, but their
        tracks cannot be checked."""
        self._past.update(visits)

    def take_plan(self, plan, facts, fields, now_s):
        """`plan` was computed from `facts`; mission time is `now_s`."""
        if self.plan is None:
            self._first_window = min((w for _, w in plan.visits), default=0)
        else:
            begins = [track.time_s[0] for track in plan.tracks.values()
                      if len(track)]
            self._settle(min(begins + [now_s]))
        self.plan, self._facts, self._fields = plan, facts, fields
        for agent_id in facts.agents:
            self._replace_visits(agent_id, plan, now_s)
            if agent_id in plan.tracks:
                self._tracks[agent_id] = self._tracks.get(
                    agent_id, Track.of([])).followed_by(plan.tracks[agent_id])
        for pair, span in exempt_spans(plan.tracks, facts).items():
            self._exempt[pair] = [
                (begin_s, min(end_s, span[0])) for begin_s, end_s in
                self._exempt[pair] if begin_s < span[0]] + [span]

    def _replace_visits(self, agent_id, plan, now_s):
        new = {key: visit for key, visit in plan.visits.items()
               if key[0] == agent_id}
        first = min((window for _, window in new), default=None)
        for key in [key for key in self._visits if key[0] == agent_id]:
            ahead = self._facts.windows[key[1]].end_s > now_s
            if ahead if first is None else key[1] >= first:
                del self._visits[key]
            elif ahead:
                self._visits[key].left_early = True
        self._visits.update(new)

    def _settle(self, begin_s):
        """Judges what was flown until a new plan's begin by the facts of its
        time. States after it are taken back: the plan does not know them, and
        is followed from its begin."""
        check = self._checked(self._settled_s, begin_s)
        self._add(check.violations, check.lines, check.points)
        for agent_id, states in self._states.items():
            self._states[agent_id] = [state for state in states
                                      if state[0] <= begin_s]
        self._add({'off_track': self._states_off_track()}, [], 0)
        self._states.clear()
        self._settled_s = max(self._settled_s, begin_s)

    def _add(self, violations, lines, points):
        for kind, count in violations.items():
            self._violations[kind] += count
        self._lines += lines
        self._points += points

    def _checked(self, begin_s, end_s):
        check = PlanCheck(self._facts, self._fields)
        tracks = {agent_id: track for agent_id, track in self._tracks.items()
                  if agent_id in self._facts.agents}
        check.check_tracks(tracks, begin_s, end_s, self._exempt)
        return check

    def _states_off_track(self):
        """Number of states far from the planned position at their time."""
        count = 0
        for agent_id, states in self._states.items():
            track = self._tracks.get(agent_id)
            if not states or track is None or not len(track):
                continue
            time_s, lon, lat = np.array(states).T
            known = (time_s >= track.time_s[0]) & (time_s <= track.time_s[-1])
            off_m = distance_m(lon[known], lat[known], *track.at(time_s[known]))
            count += int((~(off_m <= OFF_TRACK_M)).sum())
        return count

    def complete(self):
        """Does every agent have a visit in every window?"""
        return self.plan is not None and not self.missing()

    def missing(self):
        """(agent id, window) without a visit."""
        windows = range(len(self._facts.windows))
        return [(agent_id, window) for agent_id in sorted(self._facts.agents)
                for window in windows
                if (agent_id, window) not in self._visits and
                (agent_id, window) not in self._past]

    def verdict(self):
        """All findings, past and ahead, as written to verdict.json."""
        check = self._checked(self._settled_s, np.inf)
        made = {key: visit for key, visit in self._visits.items()
                if not visit.left_early}
        check.check_visits(_places(made), self._tracks, _places(self._past))
        violations = dict(self._violations)
        for kind, count in check.violations.items():
            violations[kind] += count
        violations['off_track'] += self._states_off_track()
        return {
            'world_version': self.plan.world_version,
            'plan_run': self.plan.plan_run,
            'windows': len(self._facts.windows),
            'complete': self.complete(),
            'agents': {agent_id: self._agent(agent_id)
                       for agent_id in sorted(self._facts.agents)},
            'violations': violations,
            'checked_points': self._points + check.points,
            'checked_states': self._states_seen,
            'notes': self._notes(check.lines),
        }

    def _agent(self, agent_id):
        known = {**self._past, **self._visits}
        visits = [known[key] for key in sorted(known) if key[0] == agent_id]
        return {
            'waypoints': len(visits),
            'reward': sum(visit.reward for visit in visits),
            'cost': sum(visit.seam_cost for visit in visits),
            'energy_j': sum(visit.energy_j for visit in visits),
            'positions_deg': [[visit.lon_deg, visit.lat_deg]
                              for visit in visits],
        }

    def _notes(self, lines):
        notes = ['unassigned: ' + line for line in self.plan.unassigned]
        if self._first_window:
            notes.append('windows before %d were flown before this check '
                         'began: counted, not judged' % self._first_window)
        notes += ['%s left for window %d early' % (agent_id, window + 1)
                  for (agent_id, window), visit in sorted(self._visits.items())
                  if visit.left_early]
        found = self._lines + lines
        if len(found) > MAX_LINES:
            found = found[:MAX_LINES] + ['... %d more' %
                                         (len(found) - MAX_LINES)]
        return notes + found


def _places(visits):
    return {key: (visit.lon_deg, visit.lat_deg, visit.events, *visit.via)
            for key, visit in visits.items()}
