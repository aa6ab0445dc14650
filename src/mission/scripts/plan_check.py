"""Checks a plan against the rules from tracks and facts alone, with libraries
that the planner does not use: shapely for areas, Vincenty's geodesics, numpy.

A track is an agent's position over time: arrays of unix seconds and WGS84
lon/lat [deg], linear between its points. Every leg is sampled so that
neighbouring samples are at most a tenth of a cell apart.

    separation  two agents nearer than ex:minimumSeparationKm at the same time;
                if that is soft or 0, at the same place at the same time. Agents
                that begin a plan nearer than that (launched from one ship)
                must be apart by the end of the window in which they begin
    no_go       entries into a no_go area of that window and agent, including
                contact with its edge
    land        entries into cells without field data or into the land buffer
    capacity    agents rewarded by an event beyond ex:capacity, and invalid
                visits (no stop of the window within the radius, or the event
                is not active in that window)
    speed       legs that need more speed through the medium than the agent has
    visits      waypoints that the track does not reach in their window, and
                stops that it does not pass in order
"""

import dataclasses

import numpy as np
import shapely.vectorized
from shapely.geometry import LineString

from geodesic import distance_m

KINDS = ('no_go', 'land', 'capacity', 'separation', 'speed', 'visits')
SAMPLES_PER_CELL = 10
SPEED_TOLERANCE = 0.02     # Relative, of the speed through the medium.
SEPARATION_STEP_S = 60.0   # Sampling of a pair; refined at the minimum.
SEPARATION_STEP_M = 200.0  # Greatest motion between two samples.
DISTANCE_TOLERANCE_M = 1.0  # Of separation; rounding of positions.
SAME_PLACE_M = 1.0         # Least separation, even if it is soft or 0.
VISIT_TOLERANCE_M = 50.0   # Between a waypoint and the track at that time.
STOP_STEP_S = 20.0         # Sampling for stops, besides the track's points.


@dataclasses.dataclass
class Track:
    time_s: np.ndarray
    lon_deg: np.ndarray
    lat_deg: np.ndarray

    @classmethod
    def of(cls, points):
        """From (unix seconds, lon, lat) triples; drops repeated times."""
        table = np.array(sorted(points), float).reshape(-1, 3)
        keep = np.ones(len(table), bool)
        keep[1:] = np.diff(table[:, 0]) > 0.0
        return cls(*table[keep].T)

    def __len__(self):
        return len(self.time_s)

    def at(self, time_s):
        return (np.interp(time_s, self.time_s, self.lon_deg),
                np.interp(time_s, self.time_s, self.lat_deg))

    def between(self, begin_s, end_s):
        """The part inside [begin, end], cut at both, possibly empty."""
        if not len(self):
            return self
        begin_s = max(begin_s, self.time_s[0])
        end_s = min(end_s, self.time_s[-1])
        if end_s < begin_s:
            return Track(*np.empty((3, 0)))
        inside = (self.time_s > begin_s) & (self.time_s < end_s)
        times = np.unique(np.concatenate(
            ([begin_s], self.time_s[inside], [end_s])))
        return Track(times, *self.at(times))

    def followed_by(self, other):
        """This track until the other begins, then the other."""
        if not len(other):
            return self
        if not len(self):
            return other
        before = self.time_s < other.time_s[0]
        return Track(*(np.concatenate((mine[before], theirs)) for mine, theirs
                       in ((self.time_s, other.time_s),
                           (self.lon_deg, other.lon_deg),
                           (self.lat_deg, other.lat_deg))))

    def densified(self, step_deg):
        """Resampled so that neighbouring points are at most step_deg apart."""
        if len(self) < 2:
            return self
        jump = np.maximum(np.abs(np.diff(self.lon_deg)) / step_deg[0],
                          np.abs(np.diff(self.lat_deg)) / step_deg[1])
        parts = np.maximum(1, np.ceil(jump)).astype(int)
        leg = np.repeat(np.arange(len(parts)), parts)
        first = np.concatenate(([0], np.cumsum(parts)[:-1]))
        share = (np.arange(len(leg)) - first[leg]) / parts[leg]
        times = self.time_s[leg] + share * np.diff(self.time_s)[leg]
        return Track(*(np.concatenate((column, last)) for column, last in zip(
            (times, *self.at(times)),
            ([self.time_s[-1]], [self.lon_deg[-1]], [self.lat_deg[-1]]))))


class Field:
    """The work field of one window on a lon/lat grid, in time slices.

    Bilinear between cell centres, linear in time; a missing corner counts as
    no flow, and a position in a cell without data has none (NaN).
    """

    def __init__(self, lon_deg, lat_deg, time_s, east_mps, north_mps):
        self.lon_deg = np.asarray(lon_deg, float)
        self.lat_deg = np.asarray(lat_deg, float)
        self.time_s = np.asarray(time_s, float)
        velocity_mps = np.stack([np.asarray(east_mps, np.float32),
                                 np.asarray(north_mps, np.float32)])
        self.land = np.isnan(velocity_mps).any(axis=(0, 1))
        self._flow_mps = np.nan_to_num(velocity_mps)

    def components(self):
        """East and north, each time x row x column; 0 where no data."""
        return self._flow_mps

    def step_deg(self):
        return (np.diff(self.lon_deg).min() / SAMPLES_PER_CELL,
                np.diff(self.lat_deg).min() / SAMPLES_PER_CELL)

    def cells(self, lon_deg, lat_deg):
        """Row, column, and whether the position is on the grid."""
        col, in_cols = _nearest(self.lon_deg, lon_deg)
        row, in_rows = _nearest(self.lat_deg, lat_deg)
        return row, col, in_rows & in_cols

    def sample(self, lon_deg, lat_deg, time_s):
        """East and north velocity [m/s] at positions and times."""
        later = np.clip(np.searchsorted(self.time_s, time_s), 1,
                        max(1, len(self.time_s) - 1))
        earlier = later - 1
        later = np.minimum(later, len(self.time_s) - 1)
        span = np.where(later > earlier,
                        self.time_s[later] - self.time_s[earlier], 1.0)
        share = np.clip((time_s - self.time_s[earlier]) / span, 0.0, 1.0)
        first = self._bilinear(earlier, lon_deg, lat_deg)
        second = self._bilinear(later, lon_deg, lat_deg)
        velocity = first + share * (second - first)
        row, col, on_grid = self.cells(lon_deg, lat_deg)
        velocity[:, self.land[row, col] | ~on_grid] = np.nan
        return velocity

    def _bilinear(self, index, lon_deg, lat_deg):
        col, u = _interval(self.lon_deg, lon_deg)
        row, v = _interval(self.lat_deg, lat_deg)
        corner = self._flow_mps
        return (corner[:, index, row, col] * (1 - v) * (1 - u) +
                corner[:, index, row, col + 1] * (1 - v) * u +
                corner[:, index, row + 1, col] * v * (1 - u) +
                corner[:, index, row + 1, col + 1] * v * u)


def _nearest(centres, values):
    middle = (centres[1:] + centres[:-1]) / 2.0
    low = centres[0] - (centres[1] - centres[0]) / 2.0
    high = centres[-1] + (centres[-1] - centres[-2]) / 2.0
    return (np.searchsorted(middle, values),
            (values >= low) & (values <= high))


def _interval(centres, values):
    """Index of the interval between centres and the fraction in it, 0 to 1."""
    index = np.clip(np.searchsorted(centres, values) - 1, 0, len(centres) - 2)
    share = (values - centres[index]) / (centres[index + 1] - centres[index])
    return index, np.clip(share, 0.0, 1.0)


def grown(mask, cells):
    """Cells whose centre is within `cells` (Euclidean) of a set cell's."""
    out = mask.copy()
    reach = int(np.floor(cells))
    rows, cols = mask.shape
    for dr in range(-reach, reach + 1):
        for dc in range(-reach, reach + 1):
            if dr * dr + dc * dc > cells * cells:
                continue
            to = (slice(max(0, dr), rows + min(0, dr)),
                  slice(max(0, dc), cols + min(0, dc)))
            of = (slice(max(0, -dr), rows + min(0, -dr)),
                  slice(max(0, -dc), cols + min(0, -dc)))
            out[to] |= mask[of]
    return out


def entries(inside):
    """Number of false-to-true transitions of a sequence of booleans."""
    inside = np.asarray(inside, bool)
    return int(inside[0]) + int((inside[1:] & ~inside[:-1]).sum()) if len(
        inside) else 0


def area_entries(track, area):
    """Entries of a (densely sampled) track into an area or onto its edge."""
    if not len(track):
        return 0
    path = np.column_stack((track.lon_deg, track.lat_deg))
    shape = LineString(path if len(path) > 1 else np.repeat(path, 2, axis=0))
    if not area.intersects(shape):
        return 0
    return max(1, entries(shapely.vectorized.contains(
        area, track.lon_deg, track.lat_deg)))


def land_entries(track, field, forbidden):
    if not len(track):
        return 0
    row, col, on_grid = field.cells(track.lon_deg, track.lat_deg)
    return entries(forbidden[row, col] | ~on_grid)


def closest(a, b, begin_s, end_s):
    """Minimum distance of two tracks in [begin, end] [m], its time; or None."""
    begin_s = max(begin_s, a.time_s[0], b.time_s[0])
    end_s = min(end_s, a.time_s[-1], b.time_s[-1])
    if end_s < begin_s:
        return None
    step_s = min(SEPARATION_STEP_S,
                 SEPARATION_STEP_M / max(_fastest_mps(a), _fastest_mps(b), 0.1))
    times = np.append(np.arange(begin_s, end_s, step_s), end_s)
    best = times[np.argmin(distance_m(*a.at(times), *b.at(times)))]
    near = np.arange(max(begin_s, best - step_s),
                     min(end_s, best + step_s) + 0.5)
    distance = distance_m(*a.at(near), *b.at(near))
    return float(distance.min()), float(near[distance.argmin()])


def hard_separation_m(facts):
    """Distance that two agents must keep [m]."""
    return max(SAME_PLACE_M,
               facts.separation_m if facts.separation_is_hard else 0.0)


def exempt_span(one, other, limit_m, windows):
    """(begin, end) in which two tracks of a plan may be nearer than limit_m
    [s]: from their common begin until they are apart, at the latest until the
    end of that window. None if they have no common time."""
    begin_s = max(one.time_s[0], other.time_s[0])
    last_s = min(one.time_s[-1], other.time_s[-1])
    ends = [window.end_s for window in windows if window.end_s > begin_s]
    if not ends or last_s < begin_s:
        return None
    stop_s = min(ends[0], last_s)
    corners = np.concatenate((one.time_s, other.time_s))
    times = np.unique(np.concatenate(([begin_s, stop_s], corners[
        (corners > begin_s) & (corners < stop_s)])))
    apart = distance_m(*one.at(times), *other.at(times)) >= limit_m
    return begin_s, (times[apart.argmax()] if apart.any() else ends[0])


def exempt_spans(tracks, facts):
    """{(agent id, agent id): (begin, end)} of the tracks of one plan."""
    ids = sorted(agent for agent, track in tracks.items() if len(track))
    limit_m = hard_separation_m(facts)
    spans = {(one, other): exempt_span(tracks[one], tracks[other], limit_m,
                                       facts.windows)
             for i, one in enumerate(ids) for other in ids[i + 1:]}
    return {pair: span for pair, span in spans.items() if span}


def _without(begin_s, end_s, exempt):
    """Spans of [begin, end] outside of the sorted exempt spans; they end a
    second before these, in which agents begin together."""
    spans = []
    for from_s, until_s in exempt:
        if begin_s < from_s:
            spans.append((begin_s, min(end_s, from_s - 1.0)))
        begin_s = max(begin_s, until_s)
    return [(a, b) for a, b in spans + [(begin_s, end_s)] if a <= b]


def needed_speed_mps(track, field, boost_gain):
    """Mean speed through water that each leg needs, and its way over ground.

    What the currents give is averaged along the leg as it is flown; a mean is
    never larger than the largest, so a feasible leg is never accused.
    """
    dense = track.densified(field.step_deg())
    velocity = field.sample(dense.lon_deg, dense.lat_deg, dense.time_s)
    step_s = np.diff(dense.time_s)
    carried = np.concatenate((np.zeros((2, 1)), np.cumsum(
        (velocity[:, 1:] + velocity[:, :-1]) / 2.0 * step_s, axis=1)), axis=1)
    at_points = np.searchsorted(dense.time_s, track.time_s)
    current_mps = np.diff(carried[:, at_points]) / np.diff(track.time_s)
    ground_mps = _ground_velocity(track)
    return (np.hypot(*(ground_mps - boost_gain * current_mps)),
            np.hypot(*ground_mps))


def _fastest_mps(track):
    if len(track) < 2:
        return 0.0
    return float(np.hypot(*_ground_velocity(track)).max())


def _ground_velocity(track):
    lat = (track.lat_deg[1:] + track.lat_deg[:-1]) / 2.0
    east = distance_m(track.lon_deg[:-1], lat, track.lon_deg[1:], lat)
    north = distance_m(0.0, track.lat_deg[:-1], 0.0, track.lat_deg[1:])
    return (np.stack((np.sign(np.diff(track.lon_deg)) * east,
                      np.sign(np.diff(track.lat_deg)) * north)) /
            np.diff(track.time_s))


def too_fast(track, field, agent):
    """Number of legs infeasible for the agent, under way or holding station."""
    if len(track) < 2:
        return 0
    speed, ground = needed_speed_mps(track, field, agent.boost_gain)
    limit = np.where(ground > 0.0, agent.cruise_mps, agent.max_mps)
    return int((~(speed <= limit * (1.0 + SPEED_TOLERANCE))).sum())


class PlanCheck:
    """Checks tracks and visits of a team against one version of the facts."""

    def __init__(self, facts, fields):
        self._facts = facts
        self._fields = fields  # By window index.
        self.violations = dict.fromkeys(KINDS, 0)
        self.lines = []        # One human-readable line per finding.
        self.points = 0        # Samples checked.

    def _found(self, kind, count, line):
        self.violations[kind] += count
        if count:
            self.lines.append('%s: %s' % (kind, line))

    def check_tracks(self, tracks, begin_s, end_s, exempt=None):
        """`tracks` by agent id, checked inside [begin, end]. `exempt`: sorted
        spans by (agent id, agent id) without the rule of separation."""
        for agent_id, track in sorted(tracks.items()):
            for window in self._facts.windows:
                part = track.between(max(begin_s, window.begin_s),
                                     min(end_s, window.end_s))
                if len(part):
                    self._check_part(self._facts.agents[agent_id], window,
                                     part)
        self._check_separation(tracks, begin_s, end_s, exempt or {})

    def _check_part(self, agent, window, part):
        field = self._fields[window.index]
        dense = part.densified(field.step_deg())
        self.points += len(dense)
        where = '%s in window %d' % (agent.id, window.index)
        self._check_areas(agent, window, dense)
        count = land_entries(dense, field, self._no_land(agent, window, field))
        self._found('land', count, '%s enters land or its buffer' % where)
        count = too_fast(part, field, agent)
        self._found('speed', count, '%s is too fast on %d of %d legs' %
                    (where, count, len(part) - 1))

    def _check_areas(self, agent, window, dense):
        for constraint in self._facts.constraints:
            if constraint.area is None or not constraint.applies(
                    agent.iri, window.index):
                continue
            count = area_entries(dense, constraint.area)
            self._found('no_go', count, '%s in window %d enters %s' %
                        (agent.id, window.index, constraint.iri))

    def _no_land(self, agent, window, field):
        buffers = [constraint.buffer_cells
                   for constraint in self._facts.constraints
                   if constraint.area is None and constraint.applies(
                       agent.iri, window.index)]
        return grown(field.land, max(buffers, default=0.0))

    def _check_separation(self, tracks, begin_s, end_s, exempt):
        limit_m = hard_separation_m(self._facts)
        least_m = limit_m - min(DISTANCE_TOLERANCE_M, limit_m / 2.0)
        ids = sorted(agent for agent, track in tracks.items() if len(track))
        for i, one in enumerate(ids):
            for other in ids[i + 1:]:
                approaches = [
                    closest(tracks[one], tracks[other], *span) for span in
                    _without(begin_s, end_s, exempt.get((one, other), ()))]
                near_m = min((approach[0] for approach in approaches
                              if approach), default=np.inf)
                if not near_m >= least_m:
                    self._found('separation', 1,
                                '%s and %s are %.0f m apart, minimum %.0f m' %
                                (one, other, near_m, limit_m))

    def check_visits(self, visits, tracks, past=None):
        """`visits`: (agent id, window) -> (lon, lat, event IRIs, then the
        (lon, lat) of each stop on the way). `past`: those without tracks,
        whose events count."""
        for (agent_id, window), (lon, lat, _, *via) in sorted(visits.items()):
            end_s = self._facts.windows[window].end_s
            track = tracks[agent_id]
            there = track.at(min(end_s, track.time_s[-1]))
            off_m = float(distance_m(lon, lat, *there))
            self._found('visits', int(not off_m <= VISIT_TOLERANCE_M),
                        '%s is %.0f m off its waypoint of window %d' %
                        (agent_id, off_m, window))
            self._check_stops(agent_id, window, track, via)
        self._check_capacity({**(past or {}), **visits})

    def _check_stops(self, agent_id, window, track, via):
        """Does the track pass the stops in order?"""
        when = self._facts.windows[window]
        part = track.between(when.begin_s, when.end_s)
        begin_s = when.begin_s
        for number, (lon, lat) in enumerate(via):
            times = np.union1d(part.time_s, np.arange(
                begin_s, part.time_s[-1], STOP_STEP_S)) if len(part) else []
            times = np.asarray(times)[np.asarray(times) >= begin_s]
            near = times[distance_m(lon, lat, *part.at(times)) <=
                         VISIT_TOLERANCE_M] if len(times) else times
            self._found('visits', int(not len(near)),
                        '%s does not pass stop %d of window %d' %
                        (agent_id, number, window))
            begin_s = near[0] if len(near) else begin_s

    def _check_capacity(self, visits):
        guests = {}
        for (agent_id, window), (lon, lat, claimed, *via) in sorted(
                visits.items()):
            for iri in claimed:
                event = self._facts.events.get(iri)
                if event is None:
                    continue  # Removed from the facts after the visit.
                guests.setdefault(iri, set()).add(agent_id)
                off_m = min(float(distance_m(x, y, event.lon_deg,
                                             event.lat_deg))
                            for x, y in [*via, (lon, lat)])
                real = (window in event.windows and
                        off_m <= event.radius_m + DISTANCE_TOLERANCE_M)
                self._found('capacity', int(not real),
                            '%s does not visit %s in window %d' %
                            (agent_id, iri, window))
        for iri, agents in sorted(guests.items()):
            over = len(agents) - self._facts.events[iri].capacity
            self._found('capacity', max(0, over), '%s has %d visits too many'
                        % (iri, over))
