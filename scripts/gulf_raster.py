"""Outlines to cells: land, the coast it belongs to, distance from the coast.

Grids are lon/lat by cell centre, WGS84 taken as a sphere of radius RADIUS_M
(the ocean is made, so 0.3 % of length does not matter; consistency does).
"""

import numpy as np
from scipy import ndimage
from scipy.spatial import cKDTree

from gulf_coast import COASTS

RADIUS_M = 6371000.0
WATER = -1


def inside(outline, lon, lat):
    """Even-odd rule, a row of cells at a time. outline: (n, 2) lon, lat."""
    ring = np.asarray(outline, dtype=float)
    a, b = ring, np.roll(ring, -1, axis=0)
    cells = np.zeros((lat.size, lon.size), dtype=bool)
    for row, y in enumerate(lat):
        cut = (a[:, 1] <= y) != (b[:, 1] <= y)
        share = (y - a[cut, 1]) / (b[cut, 1] - a[cut, 1])
        crossings = np.sort(a[cut, 0] + share * (b[cut, 0] - a[cut, 0]))
        cells[row] = np.searchsorted(crossings, lon) % 2 == 1
    return cells


def densified(points, step_deg, closed):
    """The columns of points (lon, lat, ...) interpolated along the line."""
    points = np.asarray(points, dtype=float)
    if closed:
        points = np.vstack([points, points[:1]])
    pieces = []
    for a, b in zip(points[:-1], points[1:]):
        count = max(1, int(np.ceil(np.hypot(*(b - a)[:2]) / step_deg)))
        share = np.arange(count)[:, None] / count
        pieces.append(a + share * (b - a))
    return np.vstack(pieces + [points[-1:]])


def on_sphere_m(lon_deg, lat_deg):
    """Points in space, so that straight distances need no projection."""
    lon, lat = np.radians(lon_deg), np.radians(lat_deg)
    return RADIUS_M * np.stack([np.cos(lat) * np.cos(lon),
                                np.cos(lat) * np.sin(lon), np.sin(lat)], -1)


def grid_points_m(lon, lat):
    return on_sphere_m(*np.meshgrid(lon, lat)).reshape(-1, 3)


def _coast_line(coast):
    rows = [(p.lon_deg, p.lat_deg, p.shelf_km) for p in coast.places]
    return densified(rows, 0.01, closed=coast.half_width_deg == 0)


def _cells_of(coast, lon, lat):
    line = _coast_line(coast)
    if coast.half_width_deg == 0:
        return inside(line[:, :2], lon, lat)
    tree = cKDTree(line[:, :2])
    cells = np.stack(np.meshgrid(lon, lat), -1)
    return tree.query(cells)[0] <= coast.half_width_deg


def land_owner(lon, lat):
    """For each cell the index of its coast in COASTS, or WATER."""
    owner = np.full((lat.size, lon.size), WATER, dtype=np.int16)
    for index, coast in enumerate(COASTS):
        owner[_cells_of(coast, lon, lat)] = index
    return _without_ponds(owner)


def _without_ponds(owner):
    """Water cut off from the sea becomes land of the nearest coast."""
    label, _ = ndimage.label(owner == WATER)
    sea = np.bincount(label[label > 0]).argmax()
    pond = (owner == WATER) & (label != sea)
    nearest = ndimage.distance_transform_edt(
        owner == WATER, return_distances=False, return_indices=True)
    return np.where(pond, owner[tuple(nearest)], owner)


def shelf_share(lon, lat):
    """Distance from the nearest coast over the width of its shelf, 0..1."""
    line = np.vstack([_coast_line(coast) for coast in COASTS])
    tree = cKDTree(on_sphere_m(line[:, 0], line[:, 1]))
    distance_m, index = tree.query(grid_points_m(lon, lat))
    share = distance_m / (1e3 * line[index, 2])
    return np.minimum(share, 1.0).reshape(lat.size, lon.size)
