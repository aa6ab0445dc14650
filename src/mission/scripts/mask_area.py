"""A mask in a file as an area: the union of its cells that are neither 0 nor
without data, read with netCDF4 instead of the project's own reader.

A path must keep out of these cells, however fine they are beside those of the
mission's grid.
"""

import netCDF4
import numpy as np
from shapely.geometry import box
from shapely.ops import unary_union

from gridded_file import GriddedVariable

# Of a cell: the coordinates of files are rounded, and a path may follow the
# edge of a mission's cell that is also the edge of a masked one.
EDGE_TOLERANCE = 0.01


def mask_area(path, reference):
    """`reference` is ex:gridRef: "file#variable@step", the step may be missing.
    """
    name, _, step = reference.rsplit('#', 1)[1].partition('@')
    with netCDF4.Dataset(path) as file:
        variable = GriddedVariable(file, name)
        values = variable.values(int(step or 0))
    lat_order, lon_order = (np.argsort(axis) for axis in (variable.lat_deg,
                                                          variable.lon_deg))
    lat, lon = variable.lat_deg[lat_order], variable.lon_deg[lon_order]
    inside = np.nan_to_num(values)[np.ix_(lat_order, lon_order)] != 0.0
    return cells_area(inside, edges(lon), edges(lat))


def edges(centres):
    """Edges of cells: half way between centres."""
    middle = (centres[1:] + centres[:-1]) / 2.0
    return np.concatenate(([2.0 * centres[0] - middle[0]], middle,
                           [2.0 * centres[-1] - middle[-1]]))


def cells_area(inside, lon_edges, lat_edges):
    """Union of the cells that are set, without a rim of EDGE_TOLERANCE."""
    boxes = []
    for row, cells in enumerate(inside):
        turns = np.flatnonzero(np.diff(np.concatenate(
            ([False], cells, [False])).astype(int)))
        for first, end in zip(turns[::2], turns[1::2]):
            boxes.append(box(lon_edges[first], lat_edges[row], lon_edges[end],
                             lat_edges[row + 1]))
    cell = min(np.diff(lon_edges).min(), np.diff(lat_edges).min())
    return unary_union(boxes).buffer(-EDGE_TOLERANCE * cell, join_style=2)
