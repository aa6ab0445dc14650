#!/usr/bin/env python3
"""The synthetic Gulf: packed like HYCOM files, free of divergence, with the known
currents."""

import pathlib
import tempfile
import unittest

import netCDF4
import numpy as np
from scipy.interpolate import RegularGridInterpolator

import make_gulf_ocean
from gulf_coast import COASTS
from gulf_flow import TRANSPORT_M2PS, Flow
from gulf_raster import RADIUS_M, WATER, inside

LAND_PLACES = {
    "Havana": (-82.36, 23.08), "Miami": (-80.30, 25.80),
    "Key West": (-81.80, 24.56), "Tampa": (-82.30, 27.95),
    "Orlando": (-81.38, 28.54), "New Orleans": (-90.07, 29.95),
    "Mississippi delta": (-89.20, 29.10), "Houston": (-95.37, 29.76),
    "Brownsville": (-97.50, 25.93), "Merida": (-89.62, 20.97),
    "Veracruz": (-96.25, 19.17), "Tampico": (-97.90, 22.26),
    "Nueva Gerona": (-82.80, 21.85), "Andros": (-77.95, 24.60),
    "Freeport": (-78.65, 26.57), "Savannah": (-81.10, 32.08)}
WATER_PLACES = {
    "mid Gulf": (-90.0, 25.0), "Yucatan Channel": (-85.9, 21.8),
    "Straits of Florida": (-81.5, 23.8), "off Miami": (-79.7, 25.8),
    "Campeche Bank": (-90.0, 22.0), "Bay of Campeche": (-94.0, 19.5),
    "Apalachee Bay": (-84.1, 29.7), "off South Pass": (-89.1, 28.7),
    "off Galveston": (-94.5, 29.0), "off Havana": (-82.36, 23.4),
    "Gulf of Batabano": (-82.8, 22.3), "Tongue of the Ocean": (-77.45, 24.4),
    "Flower Garden Banks": (-93.6, 27.9), "Caribbean": (-80.0, 19.0)}


def unpacked(file, name):
    variable = file[name]
    variable.set_auto_maskandscale(False)
    raw = variable[:, 0]
    values = raw * float(variable.scale_factor) + float(variable.add_offset)
    return np.where(raw == variable._FillValue, np.nan, values)


def divergence_1ps(u, v, lon, lat):
    """Central differences on the sphere; NaN where a neighbour is land."""
    cos_lat = np.cos(np.radians(lat))[:, None]
    step = 2 * np.radians(lat[1] - lat[0])
    flux = v * cos_lat
    east = (u[..., 1:-1, 2:] - u[..., 1:-1, :-2]) / step
    north = (flux[..., 2:, 1:-1] - flux[..., :-2, 1:-1]) / step
    return (east + north) / (RADIUS_M * cos_lat[1:-1])


class TheMadeGulf(unittest.TestCase):

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        path = pathlib.Path(cls.folder.name) / "gulf.nc"
        make_gulf_ocean.make(path, seed=2026, days=10)
        cls.file = netCDF4.Dataset(path)
        cls.lon, cls.lat = cls.file["lon"][:].data, cls.file["lat"][:].data
        cls.u = unpacked(cls.file, "water_u")
        cls.v = unpacked(cls.file, "water_v")
        cls.temperature = unpacked(cls.file, "water_temp")
        cls.speed = np.hypot(cls.u, cls.v)
        cls.water = ~np.isnan(cls.u[0])
        cls.flow = Flow(cls.lon, cls.lat, np.random.default_rng(2026))

    @classmethod
    def tearDownClass(cls):
        cls.file.close()
        cls.folder.cleanup()

    def cell(self, place):
        lon, lat = place
        return (np.abs(self.lat - lat).argmin(),
                np.abs(self.lon - lon).argmin())

    def test_stands_on_the_grid_of_hycom(self):
        self.assertEqual(self.u.shape, (10, 385, 541))
        np.testing.assert_allclose(self.lon[[0, -1]], [-98.0, -76.4])
        np.testing.assert_allclose(self.lat[[0, -1]], [18.0, 33.36])

    def test_has_one_field_a_day_at_noon(self):
        time = self.file["time"]
        dates = netCDF4.num2date(time[:], time.units, time.calendar)
        self.assertEqual([d.strftime("%m-%d %H:%M") for d in dates[[0, -1]]],
                         ["05-31 12:00", "06-09 12:00"])
        np.testing.assert_array_equal(np.diff(time[:]), 24.0)

    def test_is_packed_as_hycom_packs(self):
        for name, offset in (("water_u", 0), ("water_temp", 20)):
            variable = self.file[name]
            self.assertEqual(variable.dtype, np.int16)
            self.assertEqual(variable.dimensions,
                             ("time", "depth", "lat", "lon"))
            self.assertEqual(variable._FillValue, -30000)
            self.assertEqual(variable.missing_value, -30000)
            self.assertEqual(variable.scale_factor, np.float32(0.001))
            self.assertEqual(variable.add_offset, offset)

    def test_packing_loses_no_more_than_half_a_step(self):
        values = np.random.default_rng(1).uniform(-12, 52, (50, 60))
        raw = make_gulf_ocean.packed(values, 20.0, np.ones_like(values, bool))
        np.testing.assert_allclose(raw * 0.001 + 20.0, values, atol=0.000501)

    def test_masks_every_field_by_the_same_land(self):
        for field in (self.u, self.v, self.temperature):
            for day in field:
                np.testing.assert_array_equal(~np.isnan(day), self.water)

    def test_says_that_it_is_made(self):
        self.assertIn("Synthetic", self.file.title)
        self.assertIn("not for navigation", self.file.source)

    def divergence_beyond_rounding(self, u, v):
        """Largest divergence, relative to the bound of the packing error."""
        inner = (slice(None), slice(1, -1), slice(1, -1))
        found = divergence_1ps(u[inner], v[inner], self.lon[1:-1],
                               self.lat[1:-1])
        cell_m = RADIUS_M * np.radians(0.04)
        rounding = 0.0005 * 2.02 / (
            cell_m * np.cos(np.radians(self.lat[2:-2])))[:, None]
        return np.nanmax(np.abs(found) / rounding)

    def test_water_neither_appears_nor_vanishes(self):
        self.assertLess(self.divergence_beyond_rounding(self.u, self.v), 1.0)

    def test_the_divergence_check_sees_a_wrong_field(self):
        self.assertGreater(
            self.divergence_beyond_rounding(1.05 * self.u, self.v), 5.0)

    def test_before_packing_the_divergence_is_rounding_of_doubles(self):
        u, v = self.flow.velocity(self.flow.psi(3))
        u, v = (np.where(self.water, w, np.nan) for w in (u, v))
        found = divergence_1ps(u, v, self.lon, self.lat)[1:-1, 1:-1]
        self.assertLess(np.nanmax(np.abs(found)), 1e-15 * 1e5)

    def test_no_water_flows_through_a_coast(self):
        psi = self.flow.psi(4)
        for index, coast in enumerate(COASTS):
            on_it = psi[self.flow.owner == index]
            wanted = TRANSPORT_M2PS * coast.right_of_current
            self.assertGreater(on_it.size, 0, coast.name)
            np.testing.assert_array_equal(on_it, wanted, err_msg=coast.name)

    def test_the_same_water_passes_both_straits(self):
        metre = RADIUS_M * np.radians(0.04)
        row, west = self.cell((-87.1, 21.88))
        east = self.cell((-84.8, 21.88))[1]
        yucatan = np.nansum(self.v[2, row, west:east + 1]) * metre * np.cos(
            np.radians(21.88))
        south, column = self.cell((-81.36, 23.0))
        north = self.cell((-81.36, 24.72))[0]
        florida = np.nansum(self.u[2, south:north + 1, column]) * metre
        for transport in (yucatan, florida):
            self.assertLess(abs(transport / TRANSPORT_M2PS - 1), 0.03)

    def test_the_loop_current_runs_at_1_5_to_2_mps_every_day(self):
        for day in self.speed:
            self.assertGreater(np.nanmax(day), 1.5)
            self.assertLess(np.nanmax(day), 2.0)

    def test_the_loop_current_goes_in_by_yucatan_and_out_by_florida(self):
        row, column = self.cell((-86.1, 21.6))
        self.assertGreater(
            self.v[0, row, column - 12:column + 12].max(), 1.2)
        row, column = self.cell((-81.7, 23.9))
        self.assertGreater(
            self.u[0, row - 12:row + 12, column].max(), 1.2)

    def test_shelves_are_slow_and_the_deep_gulf_moderate(self):
        shelf = self.water & (self.flow.shelf < 0.5)
        for day in self.speed:
            self.assertLess(np.quantile(day[shelf], 0.99), 0.2)
        gulf = self.water & (self.flow.shelf == 1.0)
        gulf &= inside([(-97.5, 18.5), (-97.5, 28.5), (-89, 28.5), (-89, 18.5)],
                       self.lon, self.lat)
        median = np.median(self.speed[:, gulf])
        self.assertGreater(median, 0.1)
        self.assertLess(median, 0.4)

    def test_temperature_is_that_of_early_summer(self):
        wet = self.temperature[:, self.water]
        self.assertGreater(wet.min(), 23.0)
        self.assertLess(wet.max(), 32.0)
        north = wet[:, (self.lat[:, None] + 0 * self.lon > 29)[self.water]]
        south = wet[:, (self.lat[:, None] + 0 * self.lon < 22)[self.water]]
        self.assertGreater(south.mean() - north.mean(), 1.5)

    def carried(self, day):
        """Temperature at the position a day earlier, traced back by RK4 in the
        fields of the file: an independent reference for advection."""
        axes = (np.array([0.0, 1.0]), self.lat, self.lon)
        interpolate = {
            name: RegularGridInterpolator(
                axes, np.nan_to_num(field[day:day + 2]), bounds_error=False,
                fill_value=np.nan)
            for name, field in (("u", self.u), ("v", self.v))}
        y, x = np.meshgrid(self.lat, self.lon, indexing="ij")
        degrees = 86400.0 / np.radians(RADIUS_M)

        def slope(share, y, x):
            at = np.stack([np.full_like(y, share), y, x], -1)
            return (-degrees * interpolate["v"](at),
                    -degrees * interpolate["u"](at) / np.cos(np.radians(y)))

        h = 1.0 / 16
        for index in range(16):
            t = 1.0 - index * h
            a = slope(t, y, x)
            b = slope(t - h / 2, y + h / 2 * a[0], x + h / 2 * a[1])
            c = slope(t - h / 2, y + h / 2 * b[0], x + h / 2 * b[1])
            d = slope(t - h, y + h * c[0], x + h * c[1])
            y = y + h / 6 * (a[0] + 2 * b[0] + 2 * c[0] + d[0])
            x = x + h / 6 * (a[1] + 2 * b[1] + 2 * c[1] + d[1])
        warm = RegularGridInterpolator(axes[1:], self.temperature[day],
                                       bounds_error=False, fill_value=np.nan)
        return warm(np.stack([y, x], -1))

    def test_fronts_move_with_the_water(self):
        change = self.temperature[5] - self.temperature[4]
        unexplained = self.temperature[5] - self.carried(4)
        known = ~np.isnan(unexplained) & self.water & (self.flow.shelf == 1)
        self.assertGreater(known.sum(), 60000)
        self.assertGreater(np.quantile(np.abs(change[known]), 0.99), 0.3)
        share = np.mean(unexplained[known]**2) / np.mean(change[known]**2)
        self.assertLess(share, 0.15)

    def test_known_places_stand_on_the_right_side_of_the_coast(self):
        for name, place in LAND_PLACES.items():
            self.assertFalse(self.water[self.cell(place)], name)
        for name, place in WATER_PLACES.items():
            self.assertTrue(self.water[self.cell(place)], name)

    def test_all_water_is_one_sea_and_a_third_is_land(self):
        self.assertGreater(1 - self.water.mean(), 0.28)
        self.assertLess(1 - self.water.mean(), 0.38)
        np.testing.assert_array_equal(self.flow.owner == WATER, self.water)

    def test_a_coast_is_a_hundred_or_so_places_named_once(self):
        names = [place.name for coast in COASTS for place in coast.places]
        self.assertGreater(len(names), 100)
        for coast in COASTS:
            own = [place.name for place in coast.places]
            self.assertEqual(len(own), len(set(own)), coast.name)

    def day_zero(self, seed):
        path = pathlib.Path(self.folder.name) / f"seed_{seed}.nc"
        make_gulf_ocean.make(path, seed=seed, days=1)
        with netCDF4.Dataset(path) as file:
            return [unpacked(file, name) for name, *_ in
                    make_gulf_ocean.QUANTITIES]

    def test_the_same_seed_makes_the_same_bytes_and_another_does_not(self):
        whole = (self.u, self.v, self.temperature)
        for day, field in zip(self.day_zero(2026), whole):
            self.assertEqual(day.tobytes(), field[:1].tobytes())
        other = self.day_zero(7)
        self.assertFalse(np.array_equal(other[0], self.u[:1], equal_nan=True))
        self.assertLess(np.nanmax(np.hypot(*other[:2])), 2.1)


if __name__ == "__main__":
    unittest.main()
