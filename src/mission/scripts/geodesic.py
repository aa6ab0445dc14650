"""Length of geodesics on WGS84, by Vincenty's inverse formula.

T. Vincenty, "Direct and inverse solutions of geodesics on the ellipsoid with
application of nested equations", Survey Review 23 (176), 1975, pp. 88-93.
Accurate to less than a millimetre except for nearly antipodal points, which no
mission here compares.
"""

import numpy as np

A_M = 6378137.0            # WGS84 semi-major axis.
F = 1.0 / 298.257223563    # Flattening.
B_M = A_M * (1.0 - F)
MAX_ITERATIONS = 50


def distance_m(lon1_deg, lat1_deg, lon2_deg, lat2_deg):
    """Elementwise distance of two sets of positions [m]."""
    lon1, lat1, lon2, lat2 = np.broadcast_arrays(
        *(np.radians(np.asarray(v, float))
          for v in (lon1_deg, lat1_deg, lon2_deg, lat2_deg)))
    reduced1 = np.arctan((1.0 - F) * np.tan(lat1))
    reduced2 = np.arctan((1.0 - F) * np.tan(lat2))
    trig = (np.sin(reduced1), np.cos(reduced1),
            np.sin(reduced2), np.cos(reduced2))
    sine, cosine, cos2_alpha, cos_2m = _converge(lon2 - lon1, trig)
    return _length(sine, cosine, cos2_alpha, cos_2m)


def _arc(lam, trig):
    """Angular distance (sine, cosine) and azimuth terms for `lam`."""
    sin1, cos1, sin2, cos2 = trig
    sine = np.hypot(cos2 * np.sin(lam),
                    cos1 * sin2 - sin1 * cos2 * np.cos(lam))
    cosine = sin1 * sin2 + cos1 * cos2 * np.cos(lam)
    safe = np.where(sine > 0.0, sine, 1.0)
    sin_alpha = np.where(sine > 0.0, cos1 * cos2 * np.sin(lam) / safe, 0.0)
    cos2_alpha = 1.0 - sin_alpha ** 2
    safe = np.where(cos2_alpha > 0.0, cos2_alpha, 1.0)
    cos_2m = np.where(cos2_alpha > 0.0, cosine - 2.0 * sin1 * sin2 / safe, 0.0)
    return sine, cosine, sin_alpha, cos2_alpha, cos_2m


def _converge(delta_lon, trig):
    lam = delta_lon
    for _ in range(MAX_ITERATIONS):
        sine, cosine, sin_alpha, cos2_alpha, cos_2m = _arc(lam, trig)
        c = F / 16.0 * cos2_alpha * (4.0 + F * (4.0 - 3.0 * cos2_alpha))
        sigma = np.arctan2(sine, cosine)
        new = delta_lon + (1.0 - c) * F * sin_alpha * (sigma + c * sine * (
            cos_2m + c * cosine * (2.0 * cos_2m ** 2 - 1.0)))
        done = np.all(np.abs(new - lam) < 1e-13)
        lam = new
        if done:
            break
    return sine, cosine, cos2_alpha, cos_2m


def _length(sine, cosine, cos2_alpha, cos_2m):
    u2 = cos2_alpha * (A_M ** 2 - B_M ** 2) / B_M ** 2
    a = 1.0 + u2 / 16384.0 * (
        4096.0 + u2 * (-768.0 + u2 * (320.0 - 175.0 * u2)))
    b = u2 / 1024.0 * (256.0 + u2 * (-128.0 + u2 * (74.0 - 47.0 * u2)))
    delta = b * sine * (cos_2m + b / 4.0 * (
        cosine * (2.0 * cos_2m ** 2 - 1.0) - b / 6.0 * cos_2m *
        (4.0 * sine ** 2 - 3.0) * (4.0 * cos_2m ** 2 - 3.0)))
    return B_M * a * (np.arctan2(sine, cosine) - delta)
