"""Variables of gridded files by the CF conventions (1.8), read with netCDF4 for
checks of what the project's own reader makes of the same files.
"""

import re

import netCDF4
import numpy as np

POSSIBLE_MPS = {'wind': 120.0, 'water': 10.0}  # Faster is no data.
LENGTHS_M = {'m': 1.0, 'meter': 1.0, 'metre': 1.0, 'cm': 0.01,
             'centimeter': 0.01, 'centimetre': 0.01, 'mm': 0.001, 'km': 1000.0,
             'kilometer': 1000.0, 'kilometre': 1000.0}
TIMES_S = {'s': 1.0, 'sec': 1.0, 'second': 1.0, 'min': 60.0, 'minute': 60.0,
           'h': 3600.0, 'hr': 3600.0, 'hour': 3600.0, 'd': 86400.0,
           'day': 86400.0}
KNOT_MPS = 1852.0 / 3600.0
HUGE = 1e10
NAMES = {'lat': 'lat', 'latitude': 'lat', 'nav_lat': 'lat', 'lon': 'lon',
         'longitude': 'lon', 'nav_lon': 'lon', 'time': 'time', 't': 'time',
         'mt': 'time', 'ocean_time': 'time', 'depth': 'level', 'lev': 'level',
         'level': 'level', 'deptht': 'level', 'z': 'level', 'layer': 'level'}
EAST = re.compile(r'^degrees?_?(east|E)$')
NORTH = re.compile(r'^degrees?_?(north|N)$')


class GriddedVariable:
    """One variable of an open netCDF4.Dataset with automatic masks off.

    Raises ValueError for what it does not understand.
    """

    def __init__(self, file, path):
        file.set_auto_maskandscale(False)
        self._variable = file[path]
        self._axes = {role: self._axis(role) for role in ('lat', 'lon')}
        self.lat_deg = self._along('lat')
        self.lon_deg = (self._along('lon') + 180.0) % 360.0 - 180.0

    def times_s(self):
        """When the values hold [Unix s], in the order of the file."""
        time = self._axis('time') or self._single_time()
        if time is None:
            raise ValueError('%s: no time' % self._variable.name)
        times_s = _seconds(time, time)
        bounds = self._find(_text(time, 'bounds'))
        if bounds is None or re.search(
                r'\b(time|%s): (\w+: )*point' % time.name,
                _text(self._variable, 'cell_methods')):
            return times_s
        return _seconds(bounds, time).reshape(-1, 2).mean(axis=1)

    def values(self, time_index):
        """lat x lon at one time, at the surface; NaN = no data."""
        index = []
        for name in self._variable.dimensions:
            if name in (self._dimension('lat'), self._dimension('lon')):
                index.append(slice(None))
            elif name == self._dimension('time'):
                index.append(time_index)
            else:
                index.append(self._surface(name))
        values = unpacked(self._variable, self._variable[tuple(index)])
        order = self._variable.dimensions
        if order.index(self._dimension('lat')) > order.index(
                self._dimension('lon')):
            values = values.T
        return values

    def speeds_mps(self, time_index):
        """The values as a component of a velocity."""
        speeds = speed_unit_mps(_text(self._variable, 'units')) * self.values(
            time_index)
        medium = 'wind' if 'wind' in _words(self._variable) else 'water'
        with np.errstate(invalid='ignore'):
            return np.where(np.abs(speeds) <= POSSIBLE_MPS[medium], speeds,
                            np.nan)

    def _visible(self):
        """Variables of its group and those around it, the nearest first."""
        group = self._variable.group()
        while group is not None:
            yield from group.variables.values()
            group = group.parent

    def _find(self, name):
        return next((other for other in self._visible()
                     if name and other.name == name), None)

    def _axis(self, role):
        """The coordinate with this role along a dimension, the clearest."""
        found = [other for other in self._visible()
                 if role_of(other)[0] == role and other.dimensions and
                 set(other.dimensions) <= set(self._variable.dimensions) and
                 len(other.dimensions) <= 2]
        if not found and role in ('lat', 'lon'):
            raise ValueError('%s: no %s' % (self._variable.name, role))
        return max(found, key=lambda other: role_of(other)[1], default=None)

    def _dimension(self, role):
        """The dimension along which an axis varies."""
        axis = self._axes.get(role) or self._axis(role)
        if axis is None:
            return None
        if len(axis.dimensions) == 1:
            return axis.dimensions[0]
        plane = unpacked(axis, axis[:])
        along_rows = np.ptp(plane, axis=1).max() < np.ptp(plane, axis=0).max()
        return axis.dimensions[0 if along_rows else 1]

    def _along(self, role):
        axis = self._axes[role]
        values = unpacked(axis, axis[:])
        if values.ndim == 1:
            return values
        along_rows = self._dimension(role) == axis.dimensions[0]
        return values[:, 0] if along_rows else values[0]

    def _single_time(self):
        listed = _text(self._variable, 'coordinates').split()
        found = [other for other in self._visible()
                 if other.size == 1 and role_of(other)[0] == 'time']
        return max(found, default=None, key=lambda other: (
            other.name in listed, role_of(other)[1], other.name == 'time'))

    def _surface(self, dimension):
        """The index of the level nearest to the surface."""
        axis = next((other for other in self._visible()
                     if other.dimensions == (dimension,)), None)
        if axis is None or axis.size == 1:
            return 0
        levels = unpacked(axis, axis[:])
        is_air = 'wind' in _words(self._variable)
        return int(surface_key(axis, levels, is_air).argmin())


def surface_key(axis, levels, is_air):
    """The less, the nearer is a level to the surface."""
    words = _words(axis)
    positive = _text(axis, 'positive').lower()
    if re.search(r'sea_?\s?floor|above (the )?bed|bottom', words):
        return -levels
    if 'sigma' in words or 'ocean_s_' in words or 'ocean_double' in words:
        ocean = 'ocean' in words or not is_air and 'atmosphere' not in words
        return np.abs(levels) if ocean else -levels
    if re.search('depth|height|altitude', words) or axis.name in ('depth',
                                                                  'deptht'):
        return np.abs(levels)
    units = _text(axis, 'units').lower()
    if 'pressure' in words or re.search('bar|pa$|pascal', units):
        in_sea = 'sea' in words or 'dbar' in units or 'decibar' in units
        return levels if in_sea else -levels
    if positive not in ('up', 'down'):
        raise ValueError('%s: which level is the surface?' % axis.name)
    upper = positive == 'up'
    if is_air:
        return levels if upper else -levels
    return -levels if upper else np.abs(levels)


def role_of(variable):
    """('lat', 'lon', 'time', 'other time', 'level' or '', how clearly)."""
    standard = _text(variable, 'standard_name')
    units = _text(variable, 'units')
    if standard in ('latitude', 'longitude', 'time'):
        return {'latitude': 'lat', 'longitude': 'lon'}.get(standard,
                                                           standard), 3
    if standard.startswith('forecast_'):
        return 'other time', 3
    if re.search('^grid_|^projection_', standard):
        return '', 0
    for role, pattern in (('lat', NORTH), ('lon', EAST)):
        if pattern.match(units):
            return role, 2
    if re.search(r' since \d', units):
        other = standard or re.search(
            'ref|analysis|run|lead|issue|cycle|init|tau|creation',
            variable.name.lower() + ' ' + _text(variable, 'long_name').lower())
        return ('other time' if other else 'time'), 2
    if not standard and variable.name.lower() in NAMES and (
            not units or 'deg' in units):
        return NAMES[variable.name.lower()], 1
    return '', 0


def unpacked(variable, raw):
    """Values in the variable's unit; NaN = no data."""
    raw = np.asarray(raw)
    signed = _text(variable, '_Unsigned').lower()
    if signed == 'true' and raw.dtype.kind == 'i':
        raw = raw.view(raw.dtype.str.replace('i', 'u'))
    elif signed == 'false' and raw.dtype.kind == 'u':
        raw = raw.view(raw.dtype.str.replace('u', 'i'))
    values = raw.astype(float)
    missing = ~np.isfinite(values)
    for fill in _fills(variable, raw.dtype):
        tolerance = 1e-5 if abs(fill) >= HUGE else 6e-8
        if raw.dtype.kind != 'f':
            tolerance = 0.0
        missing |= np.abs(values - fill) <= tolerance * abs(fill)
    values = (values * float(getattr(variable, 'scale_factor', 1.0)) +
              float(getattr(variable, 'add_offset', 0.0)))
    return np.where(missing, np.nan, values)


def _fills(variable, kind):
    fills = [] if kind.itemsize == 1 else [
        netCDF4.default_fillvals[kind.str[1:]]]
    for name in ('_FillValue', 'missing_value'):
        given = getattr(variable, name, [])
        for fill in given.split() if isinstance(given, str) else np.ravel(given):
            fill = float(str(fill).rstrip('fs')) if isinstance(
                fill, str) else fill
            # With the sign that the values have.
            fills.append(float(np.array(fill).astype(kind))
                         if kind.kind in 'iu' else float(fill))
    return fills


def speed_unit_mps(unit):
    """How many m/s one of it is; an absent unit is m/s."""
    text = unit.strip().lower()
    if not text:
        return 1.0
    if re.match(r'^(knots?|kts?)$', text):
        return KNOT_MPS
    words = re.match(r'^([a-z]+?)s?\s*(?:/|per|[\s.*]*)\s*([a-z]+?)s?'
                     r'(?:(?:\*\*|\^)?-1)?$', text)
    if words is None or words[1] not in LENGTHS_M or words[2] not in TIMES_S:
        raise ValueError('unit "%s" is not understood' % unit)
    return LENGTHS_M[words[1]] / TIMES_S[words[2]]


def _seconds(values, time):
    """Unix seconds of raw values, in the unit of `time`."""
    calendar = getattr(time, 'calendar', 'standard')
    dates = netCDF4.num2date(unpacked(values, values[...]), time.units, calendar,
                             only_use_cftime_datetimes=True)
    return np.atleast_1d(netCDF4.date2num(
        dates, 'seconds since 1970-01-01 00:00:00', calendar)).astype(float)


def _text(variable, attribute):
    value = getattr(variable, attribute, '')
    return value if isinstance(value, str) else ''


def _words(variable):
    return (_text(variable, 'standard_name') + ' ' +
            _text(variable, 'long_name')).lower()
