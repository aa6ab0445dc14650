#!/usr/bin/env python3
"""Judges plans with the independent check, for a test that compares it with the
selector's rules.

    judge_plans.py FILE

FILE has a plan as JSON in every line:

    windows     [[begin, end], ...] [Unix s]
    separation  {m, is_hard}
    events      {IRI: {lon, lat, capacity, windows}}
    agents      {id: {track: [[time, lon, lat], ...],
                      visits: [[window, lon, lat, [event IRI, ...]], ...]}}

Prints for each the numbers of findings: separation, capacity.
"""

import json
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.realpath(__file__)),
                                '../scripts'))

import numpy as np

from mission_facts import Agent, Event, Facts, Window
from mission_record import MissionRecord, Plan, Visit
from plan_check import Field, Track

RADIUS_M = 1000.0


def calm(track_points, windows):
    """A field without flow around the points."""
    lon, lat = np.array(track_points)[:, 1:].T
    lon_deg = np.linspace(lon.min() - 0.5, lon.max() + 0.5, 30)
    lat_deg = np.linspace(lat.min() - 0.5, lat.max() + 0.5, 30)
    still = np.zeros((2, 30, 30))
    return Field(lon_deg, lat_deg, [windows[0][0], windows[-1][1]], still,
                 still)


def facts_of(plan):
    return Facts(
        world_version=1,
        windows=[Window(i, *span) for i, span in enumerate(plan['windows'])],
        agents={name: Agent('ex:' + name, name, 1.0, 1.0, 1.0)
                for name in plan['agents']},
        constraints=[],
        events={iri: Event(iri, event['lon'], event['lat'], event['capacity'],
                           RADIUS_M, set(event['windows']))
                for iri, event in plan['events'].items()},
        separation_m=plan['separation']['m'],
        separation_is_hard=plan['separation']['is_hard'])


def judge(plan):
    agents = plan['agents']
    points = [point for agent in agents.values() for point in agent['track']]
    field = calm(points, plan['windows'])
    visits = {(name, window): Visit(lon, lat, events, 0.0, 0.0, 0.0)
              for name, agent in agents.items()
              for window, lon, lat, events in agent['visits']}
    tracks = {name: Track.of(agent['track']) for name, agent in agents.items()}
    record = MissionRecord()
    record.take_plan(Plan(1, 1, tracks, visits, []), facts_of(plan),
                     dict.fromkeys(range(len(plan['windows'])), field), 0.0)
    return record.verdict()['violations']


def main():
    with open(sys.argv[1]) as file:
        for line in file:
            found = judge(json.loads(line))
            print(found['separation'], found['capacity'])


if __name__ == '__main__':
    main()
