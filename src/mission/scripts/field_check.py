"""Compares the published work fields with the files that the facts name, read
with netCDF4 instead of the project's own reader.
"""

import netCDF4
import numpy as np

from gridded_file import GriddedVariable

VALUE_TOLERANCE_MPS = 1e-3
TIME_TOLERANCE_S = 60.0
CELL_TOLERANCE = 0.02  # Of the spacing: file coordinates have rounding noise.

FIELDS = """
    SELECT ?window ?u ?v ?path WHERE {
      VALUES ?kind { ex:CurrentField ex:WorkField }
      ?f a ?kind ; ex:forWindow ?w ; ex:gridRefU ?u ;
         ex:gridRefV ?v ; prov:wasDerivedFrom ?file .
      ?file ex:path ?path . ?w ex:index ?window }"""


def difference(row, field):
    """The first difference between a plan_check.Field and its file, or None.

    `row` is a solution of FIELDS.
    """
    with netCDF4.Dataset(row['path']) as file:
        for name, values in zip('uv', field.components()):
            path = row[name].rsplit('#', 1)[1].rpartition('@')[0]
            problem = _component(GriddedVariable(file, path), field, values)
            if problem:
                return 'window %s, %s: %s' % (row['window'], path, problem)
    return None


def _component(variable, field, values):
    rows = matches(field.lat_deg, variable.lat_deg)
    cols = matches(field.lon_deg, variable.lon_deg)
    for found, theirs in ((rows, variable.lat_deg), (cols, variable.lon_deg)):
        # A column that is there again a turn later counts once.
        if len(np.unique(np.round(theirs, 5))) > np.count_nonzero(found >= 0):
            return 'the grid coordinates differ'
    times_s = variable.times_s()
    for time_s, ours in zip(field.time_s, values):
        # Of equal times the one written last.
        away_s = np.abs(times_s - time_s)[::-1]
        index = len(times_s) - 1 - int(away_s.argmin())
        if away_s.min() > TIME_TOLERANCE_S:
            return 'no such time in the file: %.0f' % time_s
        theirs = variable.speeds_mps(index)[np.ix_(rows, cols)]
        theirs[rows < 0] = np.nan
        theirs[:, cols < 0] = np.nan
        if not np.all(np.abs(np.nan_to_num(theirs) - ours) <=
                      VALUE_TOLERANCE_MPS):
            return 'values differ at time step %d' % index
        if not field.land[np.isnan(theirs)].all():
            return 'values where the file has no data'
    return None


def matches(ours_deg, theirs_deg):
    """For each of our coordinates the index in the file; -1 where the file has
    none, as in a hole between tiles."""
    spacing_deg = np.median(np.diff(np.sort(theirs_deg)))
    away_deg = np.abs((ours_deg[:, None] - theirs_deg[None, :] + 180.0) % 360.0
                      - 180.0)  # 180 E is 180 W.
    is_there = away_deg.min(axis=1) <= CELL_TOLERANCE * spacing_deg
    return np.where(is_there, away_deg.argmin(axis=1), -1)


class FieldCheck:
    """Compares each field once and caches the finding."""

    def __init__(self, select):
        self._select = select
        self._found = {}  # (path, window, hash) -> (is violation, line).

    def findings(self, fields, hashes):
        """[(counts as a violation?, line)] of the fields by window."""
        found = []
        for row in self._select(FIELDS):
            window = int(row['window'])
            if window not in fields:
                continue
            key = (row['path'], window, hashes[window])
            if key not in self._found:
                self._found[key] = _finding(row, fields[window])
            if self._found[key] is not None:
                found.append(self._found[key])
        return found


def _finding(row, field):
    try:
        line = difference(row, field)
        return None if line is None else (True, 'field: ' + line)
    except (OSError, KeyError, ValueError, StopIteration) as error:
        return False, 'field of window %s not compared: %r' % (row['window'],
                                                               error)
