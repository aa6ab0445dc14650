#!/usr/bin/python3
"""numpy in tensor_bench: bench_tensor_numpy.py FOLDER ROWS COLS COUNT

Eq. 1 with whole arrays, as one writes it down, COUNT times; fails if U is not
the one the C++ side left in FOLDER (to 1e-6).
"""

import sys

import numpy as np

EQUATORIAL_M, FLATTENING = 6378137.0, 1 / 298.257223563


def degrees_per_km(lat_deg):
    """Of longitude and latitude, by WGS84's radii of curvature."""
    squared = FLATTENING * (2 - FLATTENING)
    phi = np.radians(lat_deg)
    w = np.sqrt(1 - squared * np.sin(phi) ** 2)
    east = np.degrees(1e3 * w / (EQUATORIAL_M * np.cos(phi)))
    return east, np.degrees(1e3 * w ** 3 / (EQUATORIAL_M * (1 - squared)))


def main():
    folder = sys.argv[1]
    rows, cols, count = (int(text) for text in sys.argv[2:])

    def read(name, kind):
        return np.fromfile(f"{folder}/{name}", kind).reshape(rows, cols)

    value, prior = read("value", np.float32), read("prior", np.float32)
    soft, is_open = read("soft", np.uint8), read("hard", np.uint8) == 0
    factor = np.where(soft, np.float32(0.4), np.float32(1))
    lat_deg = 18.1 + 21.6 / cols * np.arange(rows)
    step = 21.6 / cols
    east = (degrees_per_km(lat_deg)[0] / (2 * step)).astype(np.float32)
    km = step / degrees_per_km(0.5 * (lat_deg[1:] + lat_deg[:-1]))[1]
    north = np.zeros(rows, np.float32)
    north[1:-1] = 1 / (km[1:] + km[:-1])
    for _ in range(count):
        gx, gy = np.zeros_like(value), np.zeros_like(value)
        gx[:, 1:-1] = (value[:, 2:] - value[:, :-2]) * east[:, None]
        gy[1:-1] = (value[2:] - value[:-2]) * north[1:-1, None]
        front = np.hypot(gx, gy)
        blend = (value / value[is_open].max()
                 + np.float32(0.5) * (front / front[is_open].max())
                 + np.float32(0.7) * prior)
        masked = np.maximum(blend, 0) * factor
        fused = np.where(is_open, np.float32(0.8) * (
            masked / masked[is_open].max()), np.float32(0))
    sys.exit(not np.abs(fused - read("fused", np.float32)).max() <= 1e-6)


if __name__ == "__main__":
    main()
