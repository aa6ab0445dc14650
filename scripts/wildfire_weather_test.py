#!/usr/bin/env python3
"""The synthetic fire: CF names, winds that drones can fly in, an edge that spreads
with the wind, the same result for the same seed."""

import pathlib
import tempfile
import unittest

import netCDF4
import numpy as np

import make_wildfire_weather as weather

SLOWEST_MPS = 20 * 1852 / 3600  # Of the mission's drones.
BURNING_K = 450.0


class TheMadeFire(unittest.TestCase):

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.path = pathlib.Path(cls.folder.name) / "fire.nc"
        weather.make(cls.path, seed=2026)
        with netCDF4.Dataset(cls.path) as file:
            cls.attributes = {name: (file[name].standard_name,
                                     file[name].units)
                              for name, *_ in weather.QUANTITIES}
            cls.title = file.title + file.source
            cls.u, cls.v, cls.kelvin = (
                np.ma.filled(file[name][:], np.nan)
                for name, *_ in weather.QUANTITIES)
        cls.east, cls.north = weather.metres()

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_is_small_and_says_that_it_is_made(self):
        self.assertLess(self.path.stat().st_size, 1.5e6)
        self.assertIn("Synthetic", self.title)
        self.assertIn("not for navigation", self.title)

    def test_has_the_names_of_the_air_and_the_ground(self):
        self.assertEqual(self.attributes, {
            "eastward_wind": ("eastward_wind", "m s-1"),
            "northward_wind": ("northward_wind", "m s-1"),
            "surface_temperature": ("surface_temperature", "K")})

    def test_has_data_everywhere_in_forty_kilometres(self):
        for values in (self.u, self.v, self.kelvin):
            self.assertEqual((15, 73, 93), values.shape)
            self.assertFalse(np.isnan(values).any())
        for width in (np.ptp(self.east), np.ptp(self.north)):
            self.assertLess(abs(width - 40e3), 1e3)

    def test_the_wind_is_nearly_as_fast_as_the_slowest_drone(self):
        speed = np.hypot(self.u, self.v)
        self.assertGreater(speed.max(), 0.85 * SLOWEST_MPS)
        self.assertLess(speed.max(), SLOWEST_MPS)
        self.assertGreater(speed[-1].mean(), speed[0].mean() + 1.0)

    def test_the_wind_veers_to_the_north_west(self):
        first, last = (np.degrees(np.arctan2(v.mean(), u.mean()))
                       for u, v in ((self.u[0], self.v[0]),
                                    (self.u[-1], self.v[-1])))
        self.assertAlmostEqual(20.0, first, delta=8.0)
        self.assertAlmostEqual(-40.0, last, delta=8.0)

    def test_the_fire_spreads_and_mostly_downwind(self):
        burnt = [int((kelvin > BURNING_K).sum()) for kelvin in self.kelvin]
        self.assertGreater(burnt[-1], 2 * burnt[0])
        hot = self.kelvin[-1] > BURNING_K
        east, west = self.east[hot].max(), -self.east[hot].min()
        self.assertGreater(east, 3 * west)
        self.assertLess(east, self.east.max())  # It stays in the valley.

    def test_the_edge_is_the_steepest(self):
        rows, cols = np.gradient(self.kelvin[6])
        steep = np.hypot(rows, cols)
        near = self.kelvin[6] > 330.0
        self.assertGreater(steep[near].mean(), 5 * steep[~near].mean())

    def test_ground_that_burnt_cools(self):
        row, col = np.unravel_index(np.argmin(np.hypot(
            self.east - 800.0, self.north)), self.east.shape)
        self.assertLess(self.kelvin[-1, row, col], self.kelvin[0, row, col])

    def test_swirls_make_no_air(self):
        rng = np.random.default_rng(1)
        u, v = weather.Swirls(rng, self.east, self.north, 1.2).at(3600.0)
        flow = (np.gradient(u, axis=1)[1:-1, 1:-1] / np.diff(
            self.east[0]).mean() + np.gradient(v, axis=0)[1:-1, 1:-1] /
            np.diff(self.north[:, 0]).mean())
        turn = np.abs(np.gradient(v, axis=1) / np.diff(self.east[0]).mean())
        self.assertLess(np.abs(flow).max(), 0.02 * turn.max())

    def test_the_same_seed_makes_the_same_values_and_another_does_not(self):
        fields = [next(weather.make_steps(np.random.default_rng(seed)))
                  for seed in (2026, 2026, 7)]
        self.assertTrue(np.array_equal(fields[0][0], fields[1][0]))
        self.assertFalse(np.array_equal(fields[0][0], fields[2][0]))


if __name__ == "__main__":
    unittest.main()
