"""The mission facts that the checker needs, read by SPARQL SELECT.

SI and degrees: seconds (unix), metres, metres per second, WGS84 lon/lat [deg].
"""

import collections
import dataclasses
import datetime
import re

from shapely import wkt

from mask_area import mask_area

MPS_PER_KNOT = 1852.0 / 3600.0


class WorldChanged(RuntimeError):
    """The facts changed while they were being read."""

    def __str__(self):
        return 'the world version changed while reading'


@dataclasses.dataclass
class Window:
    index: int
    begin_s: float
    end_s: float


@dataclasses.dataclass
class Agent:
    iri: str
    id: str
    cruise_mps: float
    max_mps: float
    boost_gain: float


@dataclasses.dataclass
class Constraint:
    """A no_go area or mask; `area` is None for the land of the work field."""
    iri: str
    area: object
    buffer_cells: float
    windows: set   # Indices; empty = all.
    agents: set    # IRIs; empty = all.

    def applies(self, agent_iri, window):
        return ((not self.windows or window in self.windows) and
                (not self.agents or agent_iri in self.agents))


@dataclasses.dataclass
class Event:
    iri: str
    lon_deg: float
    lat_deg: float
    capacity: int
    radius_m: float
    windows: set


@dataclasses.dataclass
class Facts:
    world_version: int
    windows: list      # By index.
    agents: dict       # By id.
    constraints: list  # Kind no_go only.
    events: dict       # By IRI.
    separation_m: float
    separation_is_hard: bool


def geometry(text):
    """Well-known text in CRS84, with or without GeoSPARQL's <crs> prefix or
    EWKT's SRID."""
    shape = wkt.loads(re.sub(r'^\s*(<[^>]*>|SRID\s*=\s*\d+\s*;)\s*', '', text,
                             flags=re.IGNORECASE))
    return shape if shape.is_valid else shape.buffer(0)


def unix_seconds(text):
    time = datetime.datetime.fromisoformat(text.replace('Z', '+00:00'))
    if time.tzinfo is None:
        time = time.replace(tzinfo=datetime.timezone.utc)
    return time.timestamp()


def duration_s(text):
    """Seconds of an xsd:duration of days, hours, minutes and seconds."""
    match = re.fullmatch(
        r'P(?:(\d+)D)?(?:T(?:(\d+)H)?(?:(\d+)M)?(?:([\d.]+)S)?)?', text)
    if not match:
        raise ValueError('duration %r: expected days to seconds only' % text)
    units = (86400.0, 3600.0, 60.0, 1.0)
    return sum(float(part or 0) * unit
               for part, unit in zip(match.groups(), units))


def is_true(text):
    return text in ('true', '1')


class FactsReader:
    """Reads Facts of one world version; raises WorldChanged if that changes."""

    def __init__(self, select):
        self._select = select
        self._version = None

    def read(self):
        self._version = None
        windows = self._windows()
        mission = self._mission()
        return Facts(
            windows=[window for _, window in sorted(windows.values(),
                                                    key=lambda w: w[0])],
            agents=self._agents(),
            constraints=self._constraints(windows),
            events=self._events(windows),
            separation_m=1000.0 * float(mission.get('km', 0.0)),
            separation_is_hard=is_true(mission.get('hard', 'true')),
            world_version=self._version)

    def _rows(self, query):
        rows = self._select(query)
        if self._version not in (None, rows.world_version):
            raise WorldChanged()
        self._version = rows.world_version
        return rows

    def _windows(self):
        rows = self._rows("""
            SELECT ?w ?i ?begin ?end ?hours WHERE {
              ?w a ex:TimeWindow ; ex:index ?i ; time:hasBeginning ?begin .
              OPTIONAL { ?w time:hasEnd ?end }
              OPTIONAL { ?w ex:durationHours ?hours } }""")
        begins = sorted(unix_seconds(row['begin']) for row in rows)
        windows = {}
        for row in rows:
            begin_s = unix_seconds(row['begin'])
            windows[row['w']] = (int(row['i']), Window(
                int(row['i']), begin_s, _end_s(row, begin_s, begins)))
        return windows

    def _mission(self):
        rows = self._rows("""
            SELECT ?km ?hard WHERE { ?m a ex:Mission .
              OPTIONAL { ?m ex:minimumSeparationKm ?km }
              OPTIONAL { ?m ex:separationIsHard ?hard } }""")
        return rows[0] if rows else {}

    def _agents(self):
        rows = self._rows("""
            SELECT ?a ?id ?cruise ?max ?boost WHERE {
              ?m a ex:Mission ; ex:hasAgent ?a .
              ?a ex:id ?id ; ex:hasCapabilities ?c .
              ?c ex:cruiseSpeedKts ?cruise ; ex:maxSpeedKts ?max .
              OPTIONAL { ?c ex:boostGain ?boost } }""")
        return {row['id']: Agent(row['a'], row['id'],
                                 MPS_PER_KNOT * float(row['cruise']),
                                 MPS_PER_KNOT * float(row['max']),
                                 float(row.get('boost', 1.0)))
                for row in rows}

    def _scopes(self, where, prop):
        """Every value of `prop`, by subject."""
        values = collections.defaultdict(set)
        for row in self._rows('SELECT ?s ?v WHERE { ?s %s ; %s ?v }' %
                              (where, prop)):
            values[row['s']].add(row['v'])
        return values

    def _constraints(self, windows):
        rows = self._rows("""
            SELECT ?c ?wkt ?ref ?buffer WHERE {
              ?c a ex:Constraint ; ex:kind "no_go" .
              OPTIONAL { ?c geo:asWKT ?wkt }
              OPTIONAL { ?c ex:gridRef ?ref }
              OPTIONAL { ?c ex:bufferCells ?buffer } }""")
        files = {row['c']: row['path'] for row in self._rows("""
            SELECT ?c ?path WHERE {
              ?file a ex:SourceFile ; ex:ingestedFrom ?c ; ex:path ?path }""")}
        in_windows = self._scopes('a ex:Constraint', 'ex:appliesIn')
        to_agents = self._scopes('a ex:Constraint', 'ex:appliesTo')
        return [Constraint(
            row['c'], _area(row, files),
            float(row.get('buffer', 0.0)),
            {windows[w][0] for w in in_windows[row['c']]},
            to_agents[row['c']]) for row in rows]

    def _events(self, windows):
        rows = self._rows("""
            SELECT ?e ?wkt ?capacity ?km ?expires WHERE {
              ?e a ex:Event ; geo:asWKT ?wkt .
              OPTIONAL { ?e ex:capacity ?capacity }
              OPTIONAL { ?e ex:radiusKm ?km }
              OPTIONAL { ?e ex:expiresAfter ?expires } }""")
        in_windows = self._scopes('a ex:Event', 'ex:forWindow')
        events = {}
        for row in rows:
            point = geometry(row['wkt'])
            named = [windows[w][1] for w in in_windows[row['e']]]
            every = [window for _, window in windows.values()]
            events[row['e']] = Event(
                row['e'], point.x, point.y, int(row.get('capacity', 1)),
                1000.0 * float(row.get('km', 0.0)),
                {w.index for w in _active(named, every, row.get('expires'))})
        return events


def _area(row, files):
    """None for land, which has neither an area nor a file."""
    if 'wkt' in row:
        return geometry(row['wkt'])
    if row['c'] in files:
        return mask_area(files[row['c']], row['ref'])
    return None


def _end_s(row, begin_s, begins):
    """End of a window: stated, by its length, or the begin of the next one."""
    if 'end' in row:
        return unix_seconds(row['end'])
    if 'hours' in row:
        return begin_s + 3600.0 * float(row['hours'])
    later = [other for other in begins if other > begin_s]
    return later[0] if later else begin_s


def _active(named, every, expires):
    """Windows in which an event is active: those named or, with an expiry, all
    from the first named one on that begin before the expiry."""
    if expires is None or not named:
        return named
    first_s = min(window.begin_s for window in named)
    limit_s = (first_s + duration_s(expires) if expires.startswith('P')
               else unix_seconds(expires))
    return [window for window in every
            if first_s <= window.begin_s < limit_s]
