#!/usr/bin/env python3
"""The independent checker itself: it must find and count violations, and report
none where the rules are kept.
"""

import os
import sys
import tempfile
import unittest

HERE = os.path.dirname(os.path.realpath(__file__))
sys.path[:0] = [HERE, os.path.join(os.path.dirname(HERE), 'scripts')]

import netCDF4
import numpy as np
import rosunit
from shapely.geometry import box

import field_check
import mask_area
import mission_facts
import small_mission
from geodesic import distance_m
from mission_facts import Agent, Constraint, Event, Facts, Window
from mission_record import MissionRecord, Plan, Visit
from plan_check import (Field, PlanCheck, Track, area_entries, closest,
                        exempt_spans, grown)

HOUR_S = 3600.0
DAY_S = 24 * HOUR_S


def field(east_mps=0.0, north_mps=0.0, land_cols=0):
    """Two days on 40 x 40 cells of 0.05 degree from 0 E, 0 N."""
    axis = 0.05 * np.arange(40)
    flow = np.ones((3, 40, 40))
    flow[:, :, :land_cols] = np.nan
    return Field(axis, axis, [0.0, DAY_S, 2 * DAY_S], east_mps * flow,
                 north_mps * flow)


def facts(**changed):
    values = dict(
        world_version=3, windows=[Window(0, 0.0, DAY_S),
                                  Window(1, DAY_S, 2 * DAY_S)],
        agents={'a': Agent('ex:a', 'a', 0.5, 0.8, 1.0),
                'b': Agent('ex:b', 'b', 0.5, 0.8, 1.0)},
        constraints=[], events={}, separation_m=0.0, separation_is_hard=True)
    return Facts(**dict(values, **changed))


def no_go(shape, windows=(), agents=()):
    return Constraint('ex:zone', shape, 0.0, set(windows), set(agents))


def judged(track, the_facts, the_field=None, other=None):
    fields = {0: the_field or field(), 1: the_field or field()}
    check = PlanCheck(the_facts, fields)
    tracks = {'a': track}
    if other is not None:
        tracks['b'] = other
    check.check_tracks(tracks, -np.inf, np.inf)
    return check.violations


# Along 1 N from 0.5 E to 0.9 E in a day: 0.515 m/s would be too fast, this is
# 0.4 degree in 30 h, 0.41 m/s.
EASTWARD = Track.of([(0.0, 0.5, 1.0), (30 * HOUR_S, 0.9, 1.0)])


class GeodesicTest(unittest.TestCase):
    def test_agrees_with_vincentys_own_example_and_an_atlas(self):
        # Flinders Peak to Buninyong (GRS80), and New York to London (WGS84).
        self.assertAlmostEqual(54972.271, float(distance_m(
            144 + 25 / 60 + 29.52440 / 3600, -(37 + 57 / 60 + 3.7203 / 3600),
            143 + 55 / 60 + 35.3839 / 3600, -(37 + 39 / 60 + 10.1561 / 3600))),
            places=3)
        self.assertAlmostEqual(5551759.400, float(
            distance_m(-73.8, 40.6, -0.5, 51.6)), places=2)
        self.assertEqual(0.0, float(distance_m(10.0, 20.0, 10.0, 20.0)))


class PlanCheckTest(unittest.TestCase):
    def test_reports_nothing_where_the_rules_are_kept(self):
        zone = no_go(box(0.6, 1.01, 0.7, 1.05))
        found = judged(EASTWARD, facts(constraints=[zone], separation_m=5e3),
                       other=Track.of([(0.0, 0.5, 1.1), (DAY_S, 0.8, 1.1)]))
        self.assertEqual({0}, set(found.values()), found)

    def test_counts_every_entry_into_an_area(self):
        comb = box(0.55, 0.9, 0.6, 1.1).union(box(0.65, 0.9, 0.7, 1.1))
        found = judged(EASTWARD, facts(constraints=[no_go(comb)]))
        self.assertEqual(2, found['no_go'])

    def test_finds_an_area_thinner_than_any_step(self):
        sliver = box(0.7001, 0.9, 0.70010001, 1.1)
        self.assertEqual(1, area_entries(EASTWARD, sliver))

    def test_touching_the_edge_of_an_area_counts(self):
        self.assertEqual(1, area_entries(EASTWARD, box(0.6, 1.0, 0.7, 1.2)))

    def test_an_area_binds_only_in_its_windows_and_for_its_agents(self):
        # Passed within the first day: at 0.7 E after 15 h.
        shape = box(0.68, 0.9, 0.72, 1.1)
        for windows, agents, expected in (([0], [], 1), ([1], [], 0),
                                          ([], ['ex:a'], 1),
                                          ([], ['ex:b'], 0)):
            found = judged(EASTWARD, facts(
                constraints=[no_go(shape, windows, agents)]))
            self.assertEqual(expected, found['no_go'], (windows, agents))

    def test_finds_a_mask_of_cells_finer_than_the_step(self):
        # One row of masked cells of 100 m, from 0.7 to 0.702 E, and a hole.
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, 'mask.nc')
            with netCDF4.Dataset(path, 'w') as file:
                for name, units, first in (('lat', 'degrees_north', 0.9),
                                           ('lon', 'degrees_east', 0.6)):
                    file.createDimension(name, 200)
                    axis = file.createVariable(name, 'f8', (name,))
                    axis.units = units
                    axis[:] = first + 0.001 * (np.arange(200) + 0.5)
                mask = file.createVariable('wall', 'f4', ('lat', 'lon'),
                                           fill_value=-1.0)
                values = np.zeros((200, 200))
                values[:, 100:102] = 1.0
                values[:50] = -1.0
                mask[:] = values
            area = mask_area.mask_area(path, 'mask.nc#wall@0')
        self.assertAlmostEqual(0.002 * 0.15, area.area, delta=1e-5)
        through = judged(EASTWARD, facts(constraints=[no_go(area)]))
        self.assertEqual(1, through['no_go'])
        south = Track.of([(0.0, 0.5, 0.94), (30 * HOUR_S, 0.9, 0.94)])
        self.assertEqual(0, judged(south, facts(
            constraints=[no_go(area)]))['no_go'])

    def test_a_path_along_the_edge_of_a_masked_cell_is_not_in_it(self):
        area = mask_area.cells_area(np.ones((4, 4), bool),
                                    0.6 + 0.05 * np.arange(5),
                                    1.0 + 0.05 * np.arange(5))
        self.assertEqual(0, judged(EASTWARD, facts(
            constraints=[no_go(area)]))['no_go'])

    def test_finds_land_and_its_buffer(self):
        coast = field(land_cols=8)  # Land up to 0.375 E.
        land = Constraint('ex:land', None, 2.0, set(), set())
        self.assertEqual(0, judged(EASTWARD, facts(), coast)['land'])
        self.assertEqual(0, judged(EASTWARD, facts(constraints=[land]),
                                   coast)['land'])
        land.buffer_cells = 3.0     # Up to 0.525 E.
        self.assertEqual(1, judged(EASTWARD, facts(constraints=[land]),
                                   coast)['land'])

    def test_the_buffer_is_euclidean(self):
        mask = np.zeros((21, 21), bool)
        mask[10, 10] = True
        row, col = np.mgrid[:21, :21]
        np.testing.assert_array_equal(
            grown(mask, 5.0), np.hypot(row - 10, col - 10) <= 5.0)

    def test_leaving_the_grid_counts_as_land(self):
        out = Track.of([(0.0, 0.0, 0.1), (10 * HOUR_S, -0.1, 0.1)])
        self.assertEqual(1, judged(out, facts())['land'])

    def test_a_following_current_explains_speed_and_calm_water_does_not(self):
        fast = Track.of([(0.0, 0.5, 1.0), (DAY_S, 1.3, 1.0)])  # 1.03 m/s.
        self.assertEqual(1, judged(fast, facts())['speed'])
        self.assertEqual(0, judged(fast, facts(),
                                   field(east_mps=0.6))['speed'])
        self.assertEqual(1, judged(fast, facts(),
                                   field(east_mps=-0.6))['speed'])

    def test_holding_station_needs_no_more_than_the_greatest_speed(self):
        still = Track.of([(0.0, 1.0, 1.0), (DAY_S, 1.0, 1.0)])
        self.assertEqual(0, judged(still, facts(),
                                   field(north_mps=0.7))['speed'])
        self.assertEqual(1, judged(still, facts(),
                                   field(north_mps=0.9))['speed'])

    def test_finds_the_closest_approach_between_samples(self):
        other = Track.of([(0.0, 0.9, 1.0), (30 * HOUR_S, 0.5, 1.0)])
        near_m, time_s = closest(EASTWARD, other, -np.inf, np.inf)
        self.assertAlmostEqual(15 * HOUR_S, time_s, delta=1.0)
        self.assertLess(near_m, 1.0)
        found = judged(EASTWARD, facts(separation_m=1e3), other=other)
        self.assertEqual(1, found['separation'])

    def test_same_place_at_another_time_is_no_conflict(self):
        later = Track.of([(31 * HOUR_S, 0.5, 1.0), (40 * HOUR_S, 0.6, 1.0)])
        found = judged(EASTWARD, facts(separation_m=1e3), other=later)
        self.assertEqual(0, found['separation'])


class SeparationTest(unittest.TestCase):
    """Agents that begin together: apart by the end of the first window."""

    @staticmethod
    def _found(one, other, **changed):
        the_facts = facts(**{'separation_m': 3e3, **changed})
        check = PlanCheck(the_facts, {0: field(), 1: field()})
        tracks = {'a': one, 'b': other}
        spans = {pair: [span] for pair, span in
                 exempt_spans(tracks, the_facts).items()}
        check.check_tracks(tracks, -np.inf, np.inf, spans)
        return check.violations['separation']

    @staticmethod
    def _eastward(*hours_lon):
        return Track.of([(hour * HOUR_S, lon, 1.0) for hour, lon in hours_lon])

    def test_apart_by_the_end_of_the_window_is_no_finding(self):
        still = self._eastward((0, 0.5), (48, 0.5))
        for hours in (1, 12, 24):
            moving = self._eastward((0, 0.5), (hours, 0.6), (48, 0.7))
            self.assertEqual(0, self._found(still, moving), hours)

    def test_together_beyond_the_window_is_found(self):
        still = self._eastward((0, 0.5), (48, 0.5))
        for hours in (25, 40):
            moving = self._eastward((0, 0.5), (24, 0.51), (hours, 0.6),
                                    (48, 0.7))
            self.assertEqual(1, self._found(still, moving), hours)

    def test_together_again_is_found_in_the_same_window(self):
        still = self._eastward((0, 0.5), (48, 0.5))
        back = self._eastward((0, 0.5), (4, 0.6), (12, 0.5), (20, 0.6),
                              (48, 0.7))
        self.assertEqual(1, self._found(still, back))

    def test_nobody_meets_at_one_place_even_if_separation_is_soft(self):
        one = self._eastward((0, 0.5), (48, 0.9))
        other = self._eastward((0, 0.9), (48, 0.5))
        for changed in (dict(separation_is_hard=False), dict(separation_m=0.0)):
            self.assertEqual(1, self._found(one, other, **changed))
        beside = Track.of([(0.0, 0.9, 1.001), (2 * DAY_S, 0.5, 1.001)])
        self.assertEqual(0, self._found(one, beside, separation_m=0.0))


class MissionRecordTest(unittest.TestCase):
    EVENT = Event('ex:e', 0.9, 1.0, 1, 2000.0, {1})

    def _plan(self, track, events, agents=('a', 'b')):
        lon, lat = track.at(2 * DAY_S)
        first = track.at(DAY_S)
        visits = {}
        for agent in agents:
            visits[agent, 0] = Visit(*first, [], 1.0, 0.25, 10.0)
            visits[agent, 1] = Visit(float(lon), float(lat), events, 2.0, 0.5,
                                     20.0)
        return Plan(3, 1, {agent: track for agent in agents}, visits, [])

    def _record(self, plan, the_facts):
        record = MissionRecord()
        record.take_plan(plan, the_facts, {0: field(), 1: field()}, 0.0)
        return record

    def test_sums_what_the_visits_say(self):
        verdict = self._record(self._plan(EASTWARD, []), facts()).verdict()
        self.assertTrue(verdict['complete'])
        self.assertEqual((2, 3.0, 0.75, 30.0), tuple(
            verdict['agents']['a'][key]
            for key in ('waypoints', 'reward', 'cost', 'energy_j')))

    def test_an_agent_without_a_visit_is_not_complete(self):
        plan = self._plan(EASTWARD, [], agents=('a',))
        self.assertFalse(self._record(plan, facts()).complete())

    def test_counts_agents_beyond_an_events_capacity(self):
        plan = self._plan(EASTWARD, ['ex:e'])
        record = self._record(plan, facts(events={'ex:e': self.EVENT}))
        self.assertEqual(1, record.verdict()['violations']['capacity'])

    def test_a_visit_outside_the_radius_is_none(self):
        far = Event('ex:e', 0.95, 1.0, 2, 2000.0, {1})
        record = self._record(self._plan(EASTWARD, ['ex:e']),
                              facts(events={'ex:e': far}))
        self.assertEqual(2, record.verdict()['violations']['capacity'])

    def test_a_waypoint_that_the_track_misses_is_found(self):
        plan = self._plan(EASTWARD, [])
        plan.visits['a', 1].lon_deg += 0.1
        record = self._record(plan, facts())
        self.assertEqual(1, record.verdict()['violations']['visits'])

    def _with_stops(self, hours, events=()):
        """EASTWARD's first window with stops at its positions at `hours`."""
        plan = self._plan(EASTWARD, [], agents=('a',))
        plan.visits['a', 0].via = [tuple(map(float, EASTWARD.at(HOUR_S * h)))
                                   for h in hours]
        plan.visits['a', 0].events = list(events)
        return plan

    def test_fast_agents_do_not_pass_between_two_samples(self):
        """Ten m/s towards each other: 1200 m in the minute between samples."""
        metre = 1.0 / 111e3
        for begin_s in np.arange(0.0, 60.0, 7.0):
            one = Track.of([(begin_s, 0.5, 1.0),
                            (begin_s + 7200.0, 0.5 + 72e3 * metre, 1.0)])
            other = Track.of([(begin_s, 0.5 + 72e3 * metre, 1.0 + 50 * metre),
                              (begin_s + 7200.0, 0.5, 1.0 + 50 * metre)])
            distance, _ = closest(one, other, 0.0, 9000.0)
            self.assertAlmostEqual(50.0, distance, delta=5.0)

    def test_a_stop_that_the_track_comes_by_is_no_finding(self):
        record = self._record(self._with_stops([3, 7.31, 20]), facts())
        self.assertEqual(0, record.verdict()['violations']['visits'])

    def test_a_stop_that_the_track_misses_is_found(self):
        plan = self._with_stops([3, 7, 20])
        lon, lat = plan.visits['a', 0].via[1]
        plan.visits['a', 0].via[1] = (lon, lat + 0.01)
        record = self._record(plan, facts())
        self.assertEqual(1, record.verdict()['violations']['visits'])

    def test_stops_in_another_order_are_found(self):
        record = self._record(self._with_stops([7, 3]), facts())
        self.assertEqual(1, record.verdict()['violations']['visits'])

    def test_a_stop_after_the_window_is_found(self):
        record = self._record(self._with_stops([28]), facts())
        self.assertEqual(1, record.verdict()['violations']['visits'])

    def test_an_event_may_be_visited_by_a_stop_on_the_way(self):
        lon, lat = map(float, EASTWARD.at(7 * HOUR_S))
        event = Event('ex:e', lon, lat, 1, 2000.0, {0})
        for hours, expected in (([7], 0), ([3], 1)):
            record = self._record(self._with_stops(hours, ['ex:e']),
                                  facts(events={'ex:e': event}))
            self.assertEqual(expected, record.verdict()['violations'][
                'capacity'])

    def test_what_was_flown_is_judged_by_the_facts_of_its_time(self):
        zone = facts(constraints=[no_go(box(0.5, 0.9, 0.6, 1.1))])
        record = self._record(self._plan(EASTWARD, []), facts())
        now_s = 12 * HOUR_S  # At 0.66 E: through, before the zone was there.
        lon = float(EASTWARD.at(now_s)[0])
        onward = Track.of([(now_s, lon, 1.0), (2 * DAY_S, 0.9, 1.0)])
        record.take_plan(self._plan(onward, []), zone,
                         {0: field(), 1: field()}, now_s)
        self.assertEqual(0, record.verdict()['violations']['no_go'])
        record = self._record(self._plan(EASTWARD, []), zone)
        self.assertEqual(2, record.verdict()['violations']['no_go'])

    def test_a_state_that_a_new_plan_takes_back_is_not_held_against_it(self):
        record = self._record(self._plan(EASTWARD, []), facts())
        now_s = 12 * HOUR_S
        for late_s in (0.0, HOUR_S):  # An hour too far, by the old plan.
            lon, lat = EASTWARD.at(now_s + late_s)
            record.take_state('a', now_s + late_s, float(lon), float(lat))
        lon = float(EASTWARD.at(now_s)[0])
        back = Track.of([(now_s, lon, 1.0), (2 * DAY_S, 0.5, 1.0)])
        record.take_plan(self._plan(back, []), facts(),
                         {0: field(), 1: field()}, now_s + HOUR_S)
        self.assertEqual(0, record.verdict()['violations']['off_track'])

    def test_a_plan_from_before_every_state_is_followed(self):
        """A restarted KG node plans from where its store ends."""
        record = self._record(self._plan(EASTWARD, []), facts())
        for hour in (13, 14):
            lon, lat = EASTWARD.at(hour * HOUR_S)
            record.take_state('a', hour * HOUR_S, float(lon), float(lat))
        lon = float(EASTWARD.at(12 * HOUR_S)[0])
        again = Track.of([(12 * HOUR_S, lon, 1.0), (2 * DAY_S, 0.9, 1.0)])
        record.take_plan(self._plan(again, []), facts(),
                         {0: field(), 1: field()}, 12 * HOUR_S)
        self.assertEqual(0, record.verdict()['violations']['off_track'])
        self.assertTrue(record.complete())

    def test_any_order_of_plans_and_states_is_judged(self):
        random = np.random.default_rng(7)
        for _ in range(30):
            record = self._record(self._plan(EASTWARD, []), facts())
            for _ in range(8):
                time_s = float(random.uniform(-0.5, 2.5)) * DAY_S
                for agent in random.choice(['a', 'b', 'c'], 2):
                    record.take_state(str(agent), time_s, 0.6, 1.0)
                agents = ('a', 'b')[:random.integers(0, 3)]
                begin_s = float(random.uniform(-0.5, 1.5)) * DAY_S
                onward = Track.of([(begin_s, 0.6, 1.0), (2 * DAY_S, 0.9, 1.0)])
                record.take_plan(self._plan(onward, [], agents), facts(),
                                 {0: field(), 1: field()},
                                 float(random.uniform(0.0, 2.0)) * DAY_S)
                self.assertIn('off_track', record.verdict()['violations'])

    def test_agents_of_one_ship_may_leave_it_in_a_plan(self):
        still = Track.of([(0.0, 0.5, 1.0), (2 * DAY_S, 0.5, 1.0)])
        plan = self._plan(EASTWARD, [])
        plan.tracks['b'] = still
        record = self._record(plan, facts(separation_m=3e3))
        self.assertEqual(0, record.verdict()['violations']['separation'])
        # They are still together when a new plan begins.
        soon = {'a': EASTWARD.between(HOUR_S, 2 * DAY_S),
                'b': still.between(HOUR_S, 2 * DAY_S)}
        again = self._plan(EASTWARD, [])
        again.tracks = soon
        record.take_plan(again, facts(separation_m=3e3),
                         {0: field(), 1: field()}, HOUR_S)
        self.assertEqual(0, record.verdict()['violations']['separation'])

    def test_a_state_off_the_track_is_found(self):
        record = self._record(self._plan(EASTWARD, []), facts())
        record.take_state('a', 15 * HOUR_S, 0.7, 1.0)
        self.assertEqual(0, record.verdict()['violations']['off_track'])
        record.take_state('a', 15 * HOUR_S, 0.7, 1.01)
        self.assertEqual(1, record.verdict()['violations']['off_track'])


class FieldCheckTest(unittest.TestCase):
    """Against a file in HYCOM's packing."""

    BEGIN_S = mission_facts.unix_seconds('2026-06-01T12:00:00Z')

    def _difference(self, change=0.0, late_s=0.0):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, 'ocean.nc')
            small_mission.write_ocean(path)
            with netCDF4.Dataset(path) as file:
                u = file['water_u'][:].filled(np.nan)
                v = file['water_v'][:].filled(np.nan)
                u[2, 10, 30] += change
                times = (self.BEGIN_S + late_s +
                         DAY_S * np.arange(small_mission.DAYS))
                ours = Field(file['lon'][:], file['lat'][:], times, u, v)
            return field_check.difference(
                {'window': '0', 'u': path + '#water_u@0..4',
                 'v': path + '#water_v@0..4', 'path': path}, ours)

    def test_finds_nothing_where_nothing_differs(self):
        self.assertIsNone(self._difference())

    def test_finds_one_wrong_value_and_a_wrong_time(self):
        self.assertIn('time step 2', self._difference(change=0.01))
        self.assertIn('no such time', self._difference(late_s=HOUR_S))


LON = 10.0 + 0.1 * np.arange(6)
LAT = 50.0 + 0.1 * np.arange(4)
HOURS = 6.0 * np.arange(3)


class GriddedFileTest(unittest.TestCase):
    """Files of many forms that all have 0.1 m/s, and in their second step 0.1
    m/s more for each column."""

    SPEED = np.stack([np.full((4, 6), 0.1), 0.1 + 0.1 * np.tile(
        np.arange(6), (4, 1)), np.full((4, 6), 0.1)])

    def _check(self, write, lon=LON, speed=SPEED, hours=HOURS):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, 'ocean.nc')
            with netCDF4.Dataset(path, 'w') as file:
                name = write(file)
            ours = Field(lon, LAT, FieldCheckTest.BEGIN_S + HOUR_S * hours,
                         speed, speed)
            return field_check.difference(
                {'window': '0', 'u': '%s#%s@0..2' % (path, name),
                 'v': '%s#%s@0..2' % (path, name), 'path': path}, ours)

    @staticmethod
    def _axes(file, lon=LON, lat=LAT, hours=HOURS, **of_time):
        for name, values, unit in (
                ('time', hours, 'hours since 2026-06-01 12:00:00'),
                ('lat', lat, 'degrees_north'), ('lon', lon, 'degreesE')):
            file.createDimension(name, len(values))
            axis = file.createVariable(name, 'f8', (name,))
            axis[:], axis.units = values, unit
        file['time'].setncatts(of_time)

    @staticmethod
    def _put(file, values, dimensions=('time', 'lat', 'lon'), kind='f4',
             name='u', **attributes):
        variable = file.createVariable(name, kind, dimensions)
        variable.set_auto_maskandscale(False)
        variable.setncatts(attributes)
        variable[:] = values
        return name

    def _write(self, file, values=SPEED, of_axes=None, **more):
        self._axes(file, **(of_axes or {}))
        return self._put(file, values, **more)

    def test_reads_plain_files_and_sees_what_differs(self):
        self.assertIsNone(self._check(self._write))
        for speed in (self.SPEED + 0.01, self.SPEED[[1, 0, 2]],
                      self.SPEED[:, :, ::-1]):
            self.assertIn('values differ',
                          self._check(self._write, speed=speed))

    def test_reads_times_in_any_order_and_the_last_of_equal_ones(self):
        for hours, order in (((12, 6, 0), (2, 1, 0)),
                             ((0, 6, 6, 12), (0, 0, 1, 2)),
                             ((0, 12, 6, 12), (0, 0, 1, 2))):
            self.assertIsNone(self._check(lambda file: self._write(
                file, self.SPEED[list(order)], {'hours': hours})), hours)

    def test_reads_units_and_packed_values(self):
        for unit, factor in (('cm s-1', 100.0), ('cm/s', 100.0), ('m.s-1', 1),
                             ('km/h', 3.6), ('meters per second', 1),
                             ('knots', 3600 / 1852.0), ('m s**-1', 1)):
            self.assertIsNone(self._check(lambda file: self._write(
                file, factor * self.SPEED, units=unit)), unit)
        packed = np.round(self.SPEED * 1000 + 40000).astype('u2').view('i2')
        packed[:, 3, 5] = -1
        speed = self.SPEED.copy()
        speed[:, 3, 5] = np.nan
        self.assertIsNone(self._check(lambda file: self._write(
            file, packed, kind='i2', _Unsigned='true', scale_factor=0.001,
            add_offset=-40.0, missing_value=np.int16(-1)), speed=speed))

    def test_reads_fills_as_text_and_impossible_values_as_no_data(self):
        values, speed = self.SPEED.copy(), self.SPEED.copy()
        values[:, 1, 1], values[:, 2, 2] = -9999.0, 11.0
        speed[:, 1, 1] = speed[:, 2, 2] = np.nan
        self.assertIsNone(self._check(lambda file: self._write(
            file, values, missing_value='-9999'), speed=speed))

    def test_finds_the_middles_of_periods(self):
        def write(file, method):
            self._axes(file, hours=HOURS + 3.0, bounds='b')
            file.createDimension('two', 2)
            self._put(file, np.stack([HOURS - 3.0, HOURS + 3.0], 1),
                      ('time', 'two'), 'f8', 'b')
            return self._put(file, self.SPEED, cell_methods=method)
        self.assertIsNone(self._check(lambda file: write(file, 'time: mean')))
        self.assertIn('no such time', self._check(
            lambda file: write(file, 'time: point')))

    def test_reads_the_level_at_the_surface(self):
        for levels, surface, attributes in (
                ((40.0, 0.5), 1, {'standard_name': 'depth'}),
                ((-0.5, -40.0), 0, {'positive': 'up'}),
                ((-1.0, 0.0), 1, {'standard_name': 'ocean_sigma_coordinate'}),
                ((1.0, 20.0), 1,
                 {'standard_name': 'height_above_sea_floor'})):
            def write(file):
                self._axes(file)
                file.createDimension('z', 2)
                self._put(file, levels, ('z',), 'f8', 'z', units='m',
                          **attributes)
                values = np.stack([0 * self.SPEED] * 2, 1)
                values[:, surface] = self.SPEED
                return self._put(file, values, ('time', 'z', 'lat', 'lon'))
            self.assertIsNone(self._check(write), attributes)

    def test_reads_holes_groups_and_longitudes_of_any_range(self):
        hole = np.concatenate([LON[:3], LON[3:] + 0.5])
        ours = 10.0 + 0.1 * np.arange(11)
        speed = np.full((3, 4, 11), np.nan)
        speed[:, :, [0, 1, 2, 8, 9, 10]] = self.SPEED
        self.assertIsNone(self._check(
            lambda file: self._write(file, of_axes={'lon': hole}), ours, speed))
        self.assertIn('values where the file has no data', self._check(
            lambda file: self._write(file, of_axes={'lon': hole}), ours,
            np.nan_to_num(speed)))
        self.assertIn('coordinates differ', self._check(
            lambda file: self._write(file, of_axes={'lon': LON + 0.05})))
        self.assertIsNone(self._check(
            lambda file: self._write(file, of_axes={'lon': LON + 350.0}),
            LON - 10.0))
        self.assertIsNone(self._check(lambda file: 'deep/' + self._write(
            file.createGroup('deep'))))

    def test_reads_two_dimensional_coordinates_of_a_regular_grid(self):
        def write(file):
            for name, size in (('time', 3), ('y', 4), ('x', 6)):
                file.createDimension(name, size)
            self._put(file, HOURS, ('time',), 'f8', 'time',
                      units='hours since 2026-06-01 12:00:00')
            for name, values in zip(('nav_lon', 'nav_lat'),
                                    np.meshgrid(LON, LAT)):
                self._put(file, values, ('y', 'x'), 'f8', name)
            return self._put(file, self.SPEED, ('time', 'y', 'x'))
        self.assertIsNone(self._check(write))


class FactsTest(unittest.TestCase):
    def test_reads_durations_and_geometries_with_a_prefix(self):
        self.assertEqual(2 * DAY_S + 90.0,
                         mission_facts.duration_s('P2DT1M30S'))
        shape = mission_facts.geometry(
            '<http://www.opengis.net/def/crs/OGC/1.3/CRS84> '
            'POLYGON((0 0, 1 0, 1 1, 0 1, 0 0))')
        self.assertEqual(1.0, shape.area)

    def test_an_event_is_active_until_it_expires(self):
        every = [Window(i, i * DAY_S, (i + 1) * DAY_S) for i in range(4)]
        for named, expires, expected in (
                ([every[1]], 'P2D', [1, 2]), ([every[1]], None, [1]),
                ([every[0], every[3]], 'P1D', [0]),
                ([every[2]], '1970-01-03T00:00:00Z', [])):
            active = mission_facts._active(named, every, expires)
            self.assertEqual(expected, [window.index for window in active])


if __name__ == '__main__':
    rosunit.unitrun('mission', 'plan_check', 'plan_check_test')
