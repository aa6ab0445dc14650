#!/usr/bin/env python3
"""Makes the ocean of the mission "gulf": a synthetic Gulf of Mexico, in the
shape and packing of HYCOM's files (GOMu0.04: 1/25 degree, short, 0.001).

    make_gulf_ocean.py --out gulf_ocean.nc [--seed 2026] [--days 10]

Surface currents come from a stream function (gulf_flow.py) and carry the
temperature: a June background (warm Loop Current, cool shelves, the plume of
the Mississippi) is advected semi-Lagrangian in 3-hour steps and relaxed gently,
so that fronts move from day to day with the water. Days are at 12:00 UTC.
"""

import argparse
import datetime
import pathlib
import time

import netCDF4
import numpy as np
from scipy import ndimage

from gulf_coast import COASTS
from gulf_flow import TRANSPORT_M2PS, Flow
from gulf_raster import RADIUS_M

LON = -98.0 + 0.04 * np.arange(541)
LAT = 18.0 + 0.04 * np.arange(385)
EPOCH = datetime.datetime(2000, 1, 1)
FIRST = datetime.datetime(2026, 5, 31, 12)
FILL = -30000
SCALE = 0.001
STEP_H = 3
SPIN_UP_DAYS = 5
RELAXATION_DAYS = 25.0


def _bump(lon_c, lat_c, east_km, north_km):
    x, y = np.meshgrid(LON, LAT)
    metre = np.radians(1.0) * RADIUS_M
    east = (x - lon_c) * metre * np.cos(np.radians(lat_c)) / (1e3 * east_km)
    north = (y - lat_c) * metre / (1e3 * north_km)
    return np.exp(-0.5 * (east**2 + north**2))


def background_degc(flow, psi):
    """Early June: warm south and warm inside the loop and the rings."""
    lat = LAT[:, None]
    temperature = (29.0 - 0.17 * (lat - 20.0)
                   - 0.25 * np.maximum(lat - 29.5, 0.0)
                   + 1.1 * np.clip(psi / TRANSPORT_M2PS, -0.5, 1.1)
                   - 1.0 * (1.0 - flow.shelf)**2)
    temperature -= 2.2 * _bump(-88.0, 21.9, 110, 35)  # Yucatan upwelling.
    temperature -= 1.7 * _bump(-89.7, 28.8, 130, 40)  # The Mississippi.
    return temperature


def texture(rng):
    """Smooth noise of unit variance, some 60 km across: seeds filaments."""
    noise = ndimage.gaussian_filter(rng.standard_normal((LAT.size, LON.size)),
                                    sigma=9.0)
    return noise / noise.std()


class Advection:
    """Semi-Lagrangian: each cell takes the value at its departure point (midpoint
    rule), cubic in space, limited to the previous bounds."""

    def __init__(self, water):
        self._nearest_wet = tuple(ndimage.distance_transform_edt(
            ~water, return_distances=False, return_indices=True))
        self._row, self._column = np.meshgrid(
            np.arange(LAT.size, dtype=float), np.arange(LON.size, dtype=float),
            indexing="ij")
        degree = np.radians(LAT[1] - LAT[0]) * RADIUS_M
        self._rows_per_m = 1.0 / degree
        self._columns_per_m = 1.0 / (degree * np.cos(np.radians(LAT[:, None])))

    def _at(self, field, row, column, order):
        return ndimage.map_coordinates(field, [row, column], order=order,
                                       mode="nearest")

    def step(self, field, u, v, seconds):
        rows = v * self._rows_per_m * seconds
        columns = u * self._columns_per_m * seconds
        half = (self._row - 0.5 * rows, self._column - 0.5 * columns)
        row = self._row - self._at(rows, *half, order=1)
        column = self._column - self._at(columns, *half, order=1)
        wet = field[self._nearest_wet]
        return np.clip(self._at(wet, row, column, order=3), wet.min(),
                       wet.max())


def make_days(flow, rng, days):
    """Yields (u, v, temperature) for each day at noon."""
    advection = Advection(flow.water)
    day = -SPIN_UP_DAYS
    psi = flow.psi(day)
    background = background_degc(flow, psi)
    temperature = background + 0.35 * texture(rng)
    while True:
        if day >= 0:
            yield (*flow.velocity(psi), temperature)
        if day == days - 1:
            return
        following = flow.psi(day + 1)
        steps = 24 // STEP_H
        for index in range(steps):
            share = (index + 0.5) / steps
            u, v = flow.velocity((1 - share) * psi + share * following)
            temperature = advection.step(temperature, u, v, STEP_H * 3600.0)
            pull = STEP_H / (24.0 * RELAXATION_DAYS)
            temperature += pull * (background - temperature)
        day, psi = day + 1, following


def packed(values, offset, water):
    return np.where(water, np.rint((values - offset) / SCALE),
                    FILL).astype(np.int16)


QUANTITIES = (  # name, CF standard name, long name, unit, offset
    ("water_u", "eastward_sea_water_velocity", "Eastward Water Velocity",
     "m/s", 0.0),
    ("water_v", "northward_sea_water_velocity", "Northward Water Velocity",
     "m/s", 0.0),
    ("water_temp", "sea_water_temperature", "Water Temperature", "degC", 20.0))


def _add_axis(file, name, values, **attributes):
    file.createDimension(name, len(values))
    axis = file.createVariable(name, "f8", (name,))
    axis.setncatts(attributes)
    axis[:] = values


def _add_axes(file, days):
    hours = (FIRST - EPOCH).total_seconds() / 3600.0 + 24.0 * np.arange(days)
    _add_axis(file, "time", hours, standard_name="time", axis="T",
              long_name="Valid Time", calendar="gregorian",
              units="hours since 2000-01-01 00:00:00")
    _add_axis(file, "depth", [0.0], standard_name="depth", axis="Z",
              long_name="Depth", units="m", positive="down")
    _add_axis(file, "lat", LAT, standard_name="latitude", axis="Y",
              long_name="Latitude", units="degrees_north")
    _add_axis(file, "lon", LON, standard_name="longitude", axis="X",
              long_name="Longitude", units="degrees_east")


def create(path, seed, days):
    file = netCDF4.Dataset(path, "w", format="NETCDF4")
    file.setncatts({
        "Conventions": "CF-1.8",
        "title": "Synthetic Gulf of Mexico, surface, in HYCOM's packing",
        "source": "scripts/make_gulf_ocean.py: a made ocean, no measurement "
                  "and no forecast in it; not for navigation",
        "history": f"seed {seed}, {days} days",
        "coast": f"straight lines between "
                 f"{sum(len(c.places) for c in COASTS)} known places"})
    _add_axes(file, days)
    for name, standard_name, long_name, units, offset in QUANTITIES:
        variable = file.createVariable(
            name, "i2", ("time", "depth", "lat", "lon"), zlib=True,
            complevel=2, shuffle=True, fill_value=FILL,
            chunksizes=(1, 1, LAT.size, LON.size))
        variable.setncatts({
            "standard_name": standard_name, "long_name": long_name,
            "units": units, "missing_value": np.int16(FILL),
            "scale_factor": np.float32(SCALE),
            "add_offset": np.float32(offset)})
        variable.set_auto_maskandscale(False)
    return file


def make(path, seed, days):
    """Writes the file completely or not at all."""
    started = time.monotonic()
    rng = np.random.default_rng(seed)
    flow = Flow(LON, LAT, rng)
    part = pathlib.Path(f"{path}.part")
    with create(part, seed, days) as file:
        for day, fields in enumerate(make_days(flow, rng, days)):
            for (name, *_, offset), values in zip(QUANTITIES, fields):
                file[name][day, 0] = packed(values, offset, flow.water)
    part.replace(path)
    print(f"gulf ocean: {days} days, {LAT.size} x {LON.size} cells, "
          f"{100 * (1 - flow.water.mean()):.0f} % land, seed {seed}, "
          f"{time.monotonic() - started:.1f} s -> {path}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--out", required=True, help="NetCDF file to write")
    parser.add_argument("--seed", type=int, default=2026)
    parser.add_argument("--days", type=int, default=10)
    arguments = parser.parse_args()
    if arguments.days < 1 or arguments.seed < 0:
        parser.error("--days is at least 1, --seed at least 0")
    make(arguments.out, arguments.seed, arguments.days)


if __name__ == "__main__":
    main()
