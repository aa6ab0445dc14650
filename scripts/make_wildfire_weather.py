#!/usr/bin/env python3
"""Makes the wind and the ground's temperature of the mission "wildfire": a
grass fire in a valley of 40 km, seen every 20 minutes for five hours.

    make_wildfire_weather.py --out wildfire_weather.nc [--seed 2026]

The wind is a breeze that veers and freshens, swirls over hills (from a stream
function: free of divergence), and what the fire draws in. The fire's edge
spreads from a point by the ellipse of a wind-driven fire, in every direction
at the rate of that direction's wind, ragged by the ground; behind it the ground
cools. A made fire: no measurement and no forecast in it.

The same seed gives the same values.
"""

import argparse
import datetime
import pathlib
import time

import netCDF4
import numpy as np

FIRST = datetime.datetime(2026, 8, 20, 16, 40)
EPOCH = datetime.datetime(2026, 1, 1)
STEPS = 15
STEP_S = 1200.0
LON = np.linspace(-120.70, -120.24, 93)   # 40 km each way,
LAT = np.linspace(38.40, 38.76, 73)       # cells of some 500 m.
IGNITION = (-120.60, 38.56)
BURNT_FOR_S = 3.0 * 3600.0   # Before the first step.
SPREAD_MPS = 0.60            # Of the head of the fire, in the mean wind.
FLAMES_K = 480.0             # The edge above the ground around it.
COOLS_IN_S = 2400.0
SCALE = 0.01
FILL = np.int16(-32767)
QUANTITIES = (  # name and CF standard name, long name, unit, offset
    ("eastward_wind", "Eastward wind, 120 m above the ground", "m s-1", 0.0),
    ("northward_wind", "Northward wind, 120 m above the ground", "m s-1", 0.0),
    ("surface_temperature", "Temperature of the ground's surface", "K", 550.0))


def metres():
    """East and north of the ignition, by row and column [m]."""
    metre = np.radians(1.0) * 6371e3
    east = (LON - IGNITION[0]) * metre * np.cos(np.radians(LAT.mean()))
    north = (LAT - IGNITION[1]) * metre
    return np.meshgrid(east, north)


def breeze(time_s):
    """East and north [m/s]: from west-south-west to north-west in five hours,
    from 5 to 7 m/s; constant before the beginning."""
    share = np.clip(time_s / (STEP_S * (STEPS - 1)), 0.0, 1.0)
    towards = np.radians(20.0 - 60.0 * share)  # Counter-clockwise from east.
    speed_mps = 5.0 + 2.0 * share
    return speed_mps * np.cos(towards), speed_mps * np.sin(towards)


class Swirls:
    """Eddies over the hills: fixed in place, their strength slowly changing."""

    def __init__(self, rng, east, north, rms_mps):
        self._modes = []
        for _ in range(24):
            length_m = rng.uniform(9e3, 22e3)
            heading = rng.uniform(0.0, 2.0 * np.pi)
            k, m = (2.0 * np.pi / length_m * np.array(
                [np.cos(heading), np.sin(heading)]))
            phase = rng.uniform(0.0, 2.0 * np.pi)
            drift = rng.uniform(-1.0, 1.0) * 2.0 * np.pi / 5.0 / 3600.0
            self._modes.append((k, m, phase, drift, length_m))
        self._east, self._north = east, north
        self._gain = rms_mps / np.sqrt(np.mean(np.square(self._raw(0.0))) * 2)

    def _raw(self, time_s):
        """psi = sum of sines; u = -dpsi/dy, v = dpsi/dx."""
        u, v = np.zeros_like(self._east), np.zeros_like(self._east)
        for k, m, phase, drift, length_m in self._modes:
            slope = length_m * np.cos(k * self._east + m * self._north + phase +
                                      drift * time_s)
            u -= m * slope
            v += k * slope
        return np.stack((u, v))

    def at(self, time_s):
        return self._gain * self._raw(time_s)


class Fire:
    """A perimeter, as its distance from the ignition in every direction."""

    def __init__(self, rng, east, north):
        self._angles = np.linspace(-np.pi, np.pi, 721)
        ragged = np.zeros_like(self._angles)
        for number in range(2, 14):
            ragged += (rng.uniform(-1.0, 1.0) / number *
                       np.cos(number * self._angles +
                              rng.uniform(0.0, 2.0 * np.pi)))
        self._ground = 1.0 + 0.35 * ragged / np.abs(ragged).max()
        self._distance_m = np.hypot(east, north)
        self._angle = np.arctan2(north, east)
        self._times_s = np.arange(-BURNT_FOR_S, STEP_S * STEPS, 60.0)
        rates = [self._rates_mps(time_s) for time_s in self._times_s]
        self._radius_m = np.cumsum(rates, axis=0) * 60.0

    def _rates_mps(self, time_s):
        """Rate of spread: an ellipse with the ignition in its rear focus."""
        u, v = breeze(time_s)
        excentricity = 0.7
        away = self._angles - np.arctan2(v, u)
        return (SPREAD_MPS * np.hypot(u, v) / 6.0 * self._ground *
                (1.0 - excentricity) / (1.0 - excentricity * np.cos(away)))

    def radius_m(self, time_s):
        """Of the perimeter, in the direction of every cell."""
        row = int(np.searchsorted(self._times_s, time_s))
        return np.interp(self._angle, self._angles, self._radius_m[row])

    def age_s(self, time_s):
        """Since the edge came by; negative where it has not yet."""
        age = np.full_like(self._distance_m, -1.0)
        for row in range(len(self._times_s)):
            if self._times_s[row] > time_s:
                break
            radius = np.interp(self._angle, self._angles, self._radius_m[row])
            new = (age < 0.0) & (radius >= self._distance_m)
            age[new] = time_s - self._times_s[row]
        return age

    def heat_k(self, time_s):
        """Temperature rise of the ground: burning behind the edge, dried ahead
        of it."""
        age = self.age_s(time_s)
        ahead_m = self._distance_m - self.radius_m(time_s)
        return FLAMES_K * np.where(age >= 0.0, np.exp(-age / COOLS_IN_S),
                                   0.25 * np.exp(-np.abs(ahead_m) / 600.0))

    def draught(self, time_s, east, north):
        """Wind drawn towards the fire, strongest about its edge [m/s]."""
        ahead_m = self._distance_m - self.radius_m(time_s)
        strength = 1.4 * np.exp(-(ahead_m / 2500.0) ** 2)
        far = np.maximum(self._distance_m, 1.0)
        return -strength * east / far, -strength * north / far


def ground_k(rng, east, north):
    """Of unburnt ground: forests and meadows in the sun."""
    field = np.zeros_like(east)
    for _ in range(30):
        length_m = rng.uniform(2e3, 8e3)
        heading = rng.uniform(0.0, 2.0 * np.pi)
        field += np.cos(2.0 * np.pi / length_m *
                        (east * np.cos(heading) + north * np.sin(heading)) +
                        rng.uniform(0.0, 2.0 * np.pi))
    return 305.0 + 3.0 * field / field.std()


def make_steps(rng):
    """East and north wind [m/s] and temperature [K], step by step."""
    east, north = metres()
    swirls = Swirls(rng, east, north, rms_mps=1.2)
    fire = Fire(rng, east, north)
    ground = ground_k(rng, east, north)
    for step in range(STEPS):
        time_s = STEP_S * step
        u, v = swirls.at(time_s)
        breeze_u, breeze_v = breeze(time_s)
        draught_u, draught_v = fire.draught(time_s, east, north)
        yield (u + breeze_u + draught_u, v + breeze_v + draught_v,
               ground + fire.heat_k(time_s))


def packed(values, offset):
    return np.rint((values - offset) / SCALE).astype(np.int16)


def _add_axis(file, name, values, **attributes):
    file.createDimension(name, len(values))
    axis = file.createVariable(name, "f8", (name,))
    axis.setncatts(attributes)
    axis[:] = values


def create(path, seed):
    file = netCDF4.Dataset(path, "w", format="NETCDF4")
    file.setncatts({
        "Conventions": "CF-1.8",
        "title": "Synthetic wildfire: wind and surface temperature",
        "source": "scripts/make_wildfire_weather.py: a made fire, no "
                  "measurement and no forecast in it; not for navigation",
        "history": f"seed {seed}"})
    minutes = (FIRST - EPOCH).total_seconds() / 60.0 + STEP_S / 60.0 * np.arange(
        STEPS)
    _add_axis(file, "time", minutes, standard_name="time", axis="T",
              calendar="standard", units="minutes since 2026-01-01 00:00:00")
    _add_axis(file, "lat", LAT, standard_name="latitude", axis="Y",
              units="degrees_north")
    _add_axis(file, "lon", LON, standard_name="longitude", axis="X",
              units="degrees_east")
    for name, long_name, units, offset in QUANTITIES:
        variable = file.createVariable(
            name, "i2", ("time", "lat", "lon"), zlib=True, complevel=4,
            shuffle=True, fill_value=FILL)
        variable.setncatts({
            "standard_name": name, "long_name": long_name, "units": units,
            "scale_factor": SCALE, "add_offset": offset})
        variable.set_auto_maskandscale(False)
    return file


def make(path, seed):
    """Writes the file completely or not at all."""
    started = time.monotonic()
    part = pathlib.Path(f"{path}.part")
    with create(part, seed) as file:
        steps = make_steps(np.random.default_rng(seed))
        for step, fields in enumerate(steps):
            for (name, _, _, offset), values in zip(QUANTITIES, fields):
                file[name][step] = packed(values, offset)
    part.replace(path)
    print(f"wildfire: {STEPS} steps, {LAT.size} x {LON.size} cells, seed "
          f"{seed}, {time.monotonic() - started:.1f} s -> {path}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--out", required=True, help="NetCDF file to write")
    parser.add_argument("--seed", type=int, default=2026)
    arguments = parser.parse_args()
    if arguments.seed < 0:
        parser.error("--seed is at least 0")
    make(arguments.out, arguments.seed)


if __name__ == "__main__":
    main()
