"""The synthetic flow of the Gulf: one stream function psi(lon, lat, day), m^2/s.

    u = -(1/R) dpsi/dlat,   v = 1/(R cos lat) dpsi/dlon        (m/s)

with central differences of psi on the cell centres: then the same central
differences of u and v cos(lat) cancel term by term, and the divergence is zero
wherever a cell's four neighbours are water.

psi is made in two steps. A sketch: the Loop Current, a tanh jet along a drawn
axis (north through the Yucatan Channel, round the loop, out by the Straits of
Florida, up the Atlantic side), shed anticyclones, cyclones and small eddies
from the seed, all drifting west. Then the nearest field that leaves coast and
shelf alone: the minimiser of

    int |grad(psi - sketch)|^2 + s |grad psi|^2 + k (psi - sketch)^2

with psi constant on every coast (one constant left of the Loop Current, one
right of it, so nothing flows through a coast), s large on the shelves.
"""

import numpy as np
from scipy import sparse
from scipy.interpolate import CubicSpline
from scipy.sparse.linalg import splu
from scipy.spatial import cKDTree

from gulf_coast import COASTS
from gulf_raster import (RADIUS_M, WATER, grid_points_m, inside, land_owner,
                         on_sphere_m, shelf_share)

TRANSPORT_M2PS = 1.0e5   # Of the Loop Current: psi right of it minus left.
JET_WIDTH_M = 32e3       # Peak speed = transport / (2 width) = 1.6 m/s.
FAR_M = 8 * JET_WIDTH_M  # Further off its axis the jet is not felt.
SHELF_WEIGHT = 60.0      # s at the coast.
PULL_LENGTH_M = 100e3    # k = 1 / length^2 in deep water.

# The axis of the jet, (lon, lat) on day 0, and the degrees that ten days add to
# it: the loop reaches north-west, the way it does before it sheds an eddy.
AXIS = np.array([
    (-81.3, 16.6, 0.0, 0.0), (-83.2, 18.2, 0.0, 0.0),
    (-85.2, 19.7, 0.0, 0.0), (-86.1, 21.0, 0.0, 0.0),
    (-86.1, 22.1, 0.0, 0.0), (-86.7, 23.4, -0.1, 0.0),
    (-87.6, 24.7, -0.2, 0.05), (-88.0, 25.9, -0.25, 0.15),
    (-87.3, 26.9, -0.3, 0.3), (-86.2, 27.25, -0.15, 0.3),
    (-85.2, 26.75, 0.05, 0.25), (-84.8, 25.7, 0.1, 0.1),
    (-84.5, 24.7, 0.1, 0.0), (-83.4, 23.9, 0.0, 0.0),
    (-81.7, 23.85, 0.0, 0.0), (-80.6, 24.3, 0.0, 0.0),
    (-79.8, 25.1, 0.0, 0.0), (-79.65, 26.0, 0.0, 0.0),
    (-79.6, 27.2, 0.0, 0.0), (-79.8, 28.5, 0.0, 0.0),
    (-80.1, 29.8, 0.0, 0.0), (-79.9, 30.9, 0.0, 0.0),
    (-79.0, 31.8, 0.0, 0.0), (-77.4, 32.8, 0.0, 0.0),
    (-75.0, 34.4, 0.0, 0.0)])
RIGHT_OF_AXIS = [(-75.0, 16.6)]  # Closes the axis to the side right of it.

# (lon, lat, radius km, peak speed m/s: > 0 anticyclone, drift west km/day)
EDDIES = np.array([
    (-90.9, 25.7, 85, 0.85, 4.5),   # Just shed.
    (-94.1, 24.6, 80, 0.55, 3.5),   # Last year's.
    (-96.1, 22.6, 55, 0.35, 2.0),   # Against the Mexican slope.
    (-89.2, 23.9, 60, -0.40, 3.0),
    (-94.7, 20.3, 75, -0.38, 0.5),  # The Campeche cyclone.
    (-92.6, 27.3, 55, -0.35, 3.0),
    (-88.9, 28.0, 45, -0.35, 3.0),
    (-83.4, 24.8, 35, -0.30, -3.0),  # The Tortugas cyclone, goes east.
    (-96.3, 26.2, 45, -0.25, 1.5),
    (-82.0, 19.6, 70, 0.35, 3.0),   # Caribbean.
    (-78.5, 29.5, 70, 0.30, 2.0)])  # Sargasso side.
SMALL_EDDIES = 120


def _gaussian_eddies(table, day, lon, lat):
    """psi of Gaussian eddies: peak speed = psi_0 exp(-1/2) / radius."""
    psi = np.zeros((lat.size, lon.size))
    metre = np.radians(1.0) * RADIUS_M
    for lon_c, lat_c, radius_km, speed_mps, drift_km in table:
        radius_m = 1e3 * radius_km
        east_m = (lon - lon_c) * metre * np.cos(np.radians(lat_c))
        east = (east_m + 1e3 * drift_km * day) / radius_m
        north = (lat - lat_c) * metre / radius_m
        psi += (speed_mps * radius_m * np.exp(0.5) *
                np.outer(np.exp(-0.5 * north**2), np.exp(-0.5 * east**2)))
    return psi


def _small_eddies(rng, lon, lat):
    count = SMALL_EDDIES
    return np.column_stack([
        rng.uniform(lon[0], lon[-1], count),
        rng.uniform(lat[0], lat[-1], count),
        rng.uniform(25, 55, count),
        rng.uniform(0.08, 0.22, count) * rng.choice([-1, 1], count),
        rng.uniform(1, 4, count)])


class Flow:
    """psi of any day; constant parts are computed once."""

    def __init__(self, lon, lat, rng):
        self.lon, self.lat = lon, lat
        self.owner = land_owner(lon, lat)
        self.water = self.owner == WATER
        self.shelf = shelf_share(lon, lat)
        self._points = grid_points_m(lon, lat)
        self._wave_phase = rng.uniform(0, 2 * np.pi)
        self._eddies = EDDIES * rng.uniform(0.97, 1.03, (len(EDDIES), 1))
        self._eddies[:, :2] = EDDIES[:, :2] + rng.uniform(-0.1, 0.1,
                                                          (len(EDDIES), 2))
        self._small = _small_eddies(rng, lon, lat)
        self._factorise()

    def axis(self, day):
        """The jet's axis: a spline, with frontal waves that run along it."""
        knots = AXIS[:, :2] + AXIS[:, 2:] * day / 10.0
        step = np.hypot(*np.diff(knots, axis=0).T)
        along = np.concatenate([[0.0], np.cumsum(step)])
        s = np.arange(0.0, along[-1], 0.01)
        spline = CubicSpline(along, knots)
        tangent = spline(s, 1)
        normal = np.stack([-tangent[:, 1], tangent[:, 0]], -1)
        normal /= np.hypot(*normal.T)[:, None]
        in_loop = np.exp(-((s - along[8]) / 4.0)**4)  # Not in the straits.
        wave = 0.11 * in_loop * np.sin(
            2 * np.pi * (s / 2.4 - day / 12.0) + self._wave_phase)
        return spline(s) + wave[:, None] * normal

    def sketch(self, day):
        axis = self.axis(day)
        tree = cKDTree(on_sphere_m(axis[:, 0], axis[:, 1]))
        distance_m, _ = tree.query(self._points, distance_upper_bound=FAR_M)
        distance_m = np.minimum(distance_m, FAR_M).reshape(self.water.shape)
        right = inside(np.vstack([axis, RIGHT_OF_AXIS]), self.lon, self.lat)
        signed_m = np.where(right, distance_m, -distance_m)
        psi = 0.5 * TRANSPORT_M2PS * (1.0 + np.tanh(signed_m / JET_WIDTH_M))
        for table in (self._eddies, self._small):
            psi += _gaussian_eddies(table, day, self.lon, self.lat)
        return psi

    def psi(self, day):
        sketch = self.sketch(day).ravel()
        wanted = self._smooth @ sketch + self._pull * sketch
        wet, coast = self._wet, self._coast_psi
        psi = coast.copy()
        psi[wet] = self._solve(wanted[wet] - (self._matrix @ coast)[wet])
        return psi.reshape(self.water.shape)

    def _factorise(self):
        difference, weight = self._edges()
        shelf = SHELF_WEIGHT * (1.0 - self.shelf.ravel())**2
        at_edge = 0.5 * abs(difference) @ shelf
        area = self._cell_area_m2()
        self._pull = area * (self.shelf.ravel() / PULL_LENGTH_M)**2
        self._smooth = difference.T @ sparse.diags(weight) @ difference
        stiff = sparse.diags(weight * (1.0 + at_edge))
        self._matrix = (difference.T @ stiff @ difference
                        + sparse.diags(self._pull)).tocsr()
        right = np.array([coast.right_of_current for coast in COASTS])
        owner = self.owner.ravel()
        self._wet = owner == WATER
        self._coast_psi = np.where(self._wet, 0.0,
                                   TRANSPORT_M2PS * right[owner])
        inner = self._matrix[self._wet][:, self._wet].tocsc()
        self._solve = splu(inner, permc_spec="MMD_AT_PLUS_A",
                           diag_pivot_thresh=0.0,
                           options={"SymmetricMode": True}).solve

    def _cell_area_m2(self):
        dx, dy = self._spacing_m()
        return np.broadcast_to(dx[:, None] * dy, self.water.shape).ravel()

    def _spacing_m(self):
        dy = RADIUS_M * np.radians(self.lat[1] - self.lat[0])
        dlon = np.radians(self.lon[1] - self.lon[0])
        return RADIUS_M * np.cos(np.radians(self.lat)) * dlon, dy

    def _edges(self):
        """Difference operator over all edges of the grid, and their weights
        (length of the cell face over the distance between the centres)."""
        dx, dy = self._spacing_m()
        cell = np.arange(self.water.size).reshape(self.water.shape)
        pairs = [(cell[:, :-1], cell[:, 1:], dy / dx),
                 (cell[:-1], cell[1:], 0.5 * (dx[:-1] + dx[1:]) / dy)]
        tails = np.concatenate([tail.ravel() for tail, _, _ in pairs])
        heads = np.concatenate([head.ravel() for _, head, _ in pairs])
        weight = np.concatenate([np.repeat(w, tail.shape[1])
                                 for tail, _, w in pairs])
        row = np.arange(tails.size)
        value = np.ones(tails.size)
        shape = (tails.size, self.water.size)
        return (sparse.csr_matrix((value, (row, heads)), shape)
                - sparse.csr_matrix((value, (row, tails)), shape)), weight

    def velocity(self, psi):
        """(u, v) in m/s; 0 on land. One-sided at the border of the box."""
        dpsi_dlat, dpsi_dlon = np.gradient(psi, np.radians(self.lat),
                                           np.radians(self.lon))
        u = -dpsi_dlat / RADIUS_M
        v = dpsi_dlon / (RADIUS_M * np.cos(np.radians(self.lat))[:, None])
        return np.where(self.water, u, 0.0), np.where(self.water, v, 0.0)
