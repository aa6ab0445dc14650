"""Compares the published work fields with the files that the facts name, read
with netCDF4 instead of the project's own reader.
"""

import netCDF4
import numpy as np

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
        file.set_auto_maskandscale(False)
        for name, values in zip('uv', field.components()):
            variable = file.variables[
                row[name].rsplit('#', 1)[1].split('@')[0]]
            problem = _component(file, variable, field, values)
            if problem:
                return 'window %s, %s: %s' % (row['window'], variable.name,
                                              problem)
    return None


def _component(file, variable, field, values):
    lat, lat_order = read_axis(file, variable, ('degrees_north', 'degree_north'))
    lon, lon_order = read_axis(file, variable, ('degrees_east', 'degree_east'))
    for ours, theirs in ((field.lat_deg, lat), (field.lon_deg, lon)):
        if len(ours) != len(theirs):
            return 'the grid size differs'
        if np.abs(ours - theirs).max() > CELL_TOLERANCE * np.diff(theirs).min():
            return 'the grid coordinates differ'
    times = _times(file, variable)
    for time_s, ours in zip(field.time_s, values):
        index = int(np.abs(times - time_s).argmin())
        if abs(times[index] - time_s) > TIME_TOLERANCE_S:
            return 'no such time in the file: %.0f' % time_s
        theirs = read_slice(variable, index)[np.ix_(lat_order, lon_order)]
        if not np.all(np.abs(np.nan_to_num(theirs) - ours) <=
                      VALUE_TOLERANCE_MPS):
            return 'values differ at time step %d' % index
        if not field.land[np.isnan(theirs)].all():
            return 'values where the file has no data'
    return None


def read_axis(file, variable, units):
    """Ascending coordinates in [-180, 180) and the sort order."""
    for name in variable.dimensions:
        axis = file.variables.get(name)
        if axis is not None and getattr(axis, 'units', '') in units:
            values = np.asarray(axis[:], float)
            if units[0] == 'degrees_east':
                values = (values + 180.0) % 360.0 - 180.0
            order = np.argsort(values)
            return values[order], order
    raise ValueError('%s: no axis in %s' % (variable.name, units[0]))


def _times(file, variable):
    axis = next(file.variables[name] for name in variable.dimensions
                if ' since ' in getattr(file.variables.get(name), 'units', ''))
    unit, origin = axis.units.split(' since ')
    seconds = {'h': 3600.0, 'd': 86400.0, 'm': 60.0, 's': 1.0}[unit.strip()[0]]
    epoch = netCDF4.num2date(0.0, 'seconds since ' + origin)
    start_s = netCDF4.date2num(epoch, 'seconds since 1970-01-01 00:00:00')
    return start_s + seconds * np.asarray(axis[:], float)


def read_slice(variable, time_index):
    """lat x lon at one time and the first depth; NaN = no data."""
    index = []
    for name in variable.dimensions:
        units = getattr(variable.group().variables.get(name), 'units', '')
        if ' since ' in units:
            index.append(time_index)
        else:
            index.append(slice(None) if 'degree' in units else 0)
    raw = np.asarray(variable[tuple(index)])
    missing = np.zeros(raw.shape, bool)
    for attribute in ('_FillValue', 'missing_value'):
        if hasattr(variable, attribute):
            missing |= raw == getattr(variable, attribute)
    values = (raw * float(getattr(variable, 'scale_factor', 1.0)) +
              float(getattr(variable, 'add_offset', 0.0)))
    return np.where(missing, np.nan, values)


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
