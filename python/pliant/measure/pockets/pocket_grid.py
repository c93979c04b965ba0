# SPDX-License-Identifier: MIT
"""Pockets of a structure on a grid: room for a small probe, out of reach of a large one."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.ndimage import distance_transform_edt, label
from scipy.spatial import ConvexHull, cKDTree

#: radius of water, of the large probe, and how deep below the latter a pocket begins, Angstrom
SMALL_PROBE = 1.4
LARGE_PROBE = 4.0
LEAST_DEPTH = 2.4
SPACING = 1.0  #: of the grid, Angstrom
#: connected room smaller than this is no pocket, Angstrom^3
LEAST_VOLUME = 30.0
#: atoms whose surface may be the one nearest to a point: their radii differ by 0.3 Angstrom at most
NEAREST = 4
#: a place is enclosed where at least this share of all directions meets an atom within this
#: distance, Angstrom: midway between two walls that are further apart than it, none is
ENCLOSED, REACH = 0.5, 8.0
DIRECTIONS = 30

#: Angstrom (A. Bondi, J. Phys. Chem. 68 (1964) 441); others: that of carbon
RADII = {"C": 1.70, "N": 1.55, "O": 1.52, "S": 1.80, "P": 1.80}


@dataclass(frozen=True)
class Pockets:
    """The room of all pockets, point by point of a grid."""

    volume: float  #: that each point stands for, Angstrom^3
    pocket: np.ndarray  #: (v,) the pocket of each point, from 0 by size
    atom: np.ndarray  #: (v,) the atom nearest to each point


def find_pockets(positions: np.ndarray, radii: np.ndarray, spacing: float = SPACING) -> Pockets:
    """Pockets between atoms (n, 3) of radii (n,), Angstrom.

    A point is in a pocket where a sphere of SMALL_PROBE that touches no atom covers it, and where
    no sphere of LARGE_PROBE that comes from outside covers it or comes nearer than LEAST_DEPTH
    (N. Voss, M. Gerstein, Nucleic Acids Res. 38 (2010) W555; T. Oliveira et al., BMC
    Bioinformatics 15 (2014) 197). A wide cleft that is open to water is no pocket.
    """
    step = float(spacing)
    margin = LARGE_PROBE + float(radii.max()) + step
    origin = positions.min(axis=0) - margin
    shape = np.ceil((positions.max(axis=0) + margin - origin) / step).astype(int) + 1
    places = (positions - origin) / step
    free = _free_radius(places, radii / step, (LARGE_PROBE + step) / step, shape) * step
    regions = label(free >= LARGE_PROBE)[0]
    deep = ~_covered(regions == regions[0, 0, 0], free + LEAST_DEPTH, step)
    room = deep & _covered(free >= SMALL_PROBE, free, step)
    found, _ = label(room)
    sizes = np.bincount(found.ravel())
    sizes[0] = 0
    large = np.flatnonzero(sizes * step**3 >= LEAST_VOLUME)
    names = np.full(len(sizes), -1)
    names[large[np.argsort(-sizes[large], kind="stable")]] = np.arange(len(large))
    points = np.argwhere(room)
    pocket = names[found[room]]
    kept = pocket >= 0
    atom = cKDTree(places).query(points[kept])[1]
    return Pockets(step**3, pocket[kept], np.asarray(atom, dtype=np.int64))


def _free_radius(
    places: np.ndarray, radii: np.ndarray, most: float, shape: np.ndarray
) -> np.ndarray:
    """Radius of the sphere about each point of the grid that touches no atom; `most` at most.

    Lengths are in steps of the grid.
    """
    free = np.full(shape, most, dtype=np.float32)
    for place, radius in zip(places, radii.tolist(), strict=True):
        first = np.maximum(np.ceil(place - radius - most), 0).astype(int)
        last = np.floor(place + radius + most).astype(int) + 1
        x, y, z = (
            (np.arange(a, b) - c).astype(np.float32)
            for a, b, c in zip(first, last, place, strict=True)
        )
        apart = (x * x)[:, None, None] + ((y * y)[:, None] + z * z)
        np.sqrt(apart, out=apart)
        apart -= radius
        own = free[tuple(map(slice, first, last))]
        np.minimum(own, apart, out=own)
    return free


def _covered(centres: np.ndarray, radius: np.ndarray, step: float) -> np.ndarray:
    """Mask of the points within the sphere about the centre (of a mask) that is nearest to them.

    A sphere that is larger than the probe is full of places for the probe: taking all of it, and
    not the probe alone, is what makes a coarse grid good enough.
    """
    apart, nearest = distance_transform_edt(~centres, return_indices=True)
    return np.asarray(apart * step <= radius[tuple(nearest)])


@dataclass(frozen=True)
class Room:
    """Room within a convex hull, and how much of it is a pocket, Angstrom^3."""

    all: float
    enclosed: float  #: where atoms are around: see ENCLOSED

    @property
    def share(self) -> float:
        """Of the room that is enclosed; 1 where there is none."""
        return self.enclosed / self.all if self.all else 1.0


def room_among(
    positions: np.ndarray,
    radii: np.ndarray,
    lining: np.ndarray,
    spacing: float = SPACING,
    offset: float = 0.0,
) -> Room:
    """Room for SMALL_PROBE within the convex hull of lining atoms (indices).

    positions (n, 3), radii (n,): all atoms, Angstrom. The grid lies `offset` steps further along
    x, y and z. Unlike that of `find_pockets` this room does not end where a large probe comes in:
    it grows as a pocket opens, up to planes across its mouth. (Room in a region that is given:
    J. Durrant et al., J. Chem. Theory Comput. 10 (2014) 5047.) Where the lining parts, the hull
    spans the gap, which is not enclosed. (Rays that meet the protein: T. Halgren, J. Chem. Inf.
    Model. 49 (2009) 377.)
    """
    hull = ConvexHull(positions[lining])
    planes = hull.equations.astype(np.float32)
    low, high = hull.min_bound - SMALL_PROBE, hull.max_bound + SMALL_PROBE
    axes = (
        np.arange(a + (offset - 1) * spacing, b, spacing) for a, b in zip(low, high, strict=True)
    )
    points = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, 3)
    outside = (points.astype(np.float32) @ planes[:, :3].T + planes[:, 3]).max(axis=1)
    near = outside <= SMALL_PROBE  # there the centre of a probe may be that reaches inside
    points, inside = points[near], outside[near] <= 0
    apart, atom = cKDTree(positions).query(points, k=min(NEAREST, len(positions)))
    free = (apart - radii[atom]).reshape(len(points), -1).min(axis=1)
    centres = free >= SMALL_PROBE
    if not centres.any():
        return Room(0.0, 0.0)
    # As in _covered: the whole sphere about the nearest centre, which makes a coarse grid do.
    apart, nearest = cKDTree(points[centres]).query(points[inside])
    room = points[inside][apart <= free[centres][nearest]]
    if len(room) == 0:
        return Room(0.0, 0.0)
    enclosed = int(np.count_nonzero(_met(room, positions, radii) >= ENCLOSED))
    return Room(len(room) * spacing**3, enclosed * spacing**3)


def _met(points: np.ndarray, positions: np.ndarray, radii: np.ndarray) -> np.ndarray:
    """Share of the directions in which there is an atom within REACH of each point."""
    margin = REACH + float(radii.max()) + SPACING
    low = points.min(axis=0) - margin
    cells = np.ceil((points.max(axis=0) + margin - low) / SPACING).astype(int) + 1
    near = np.all((positions > low) & (positions < low + SPACING * cells), axis=1)
    filled = _filled((positions[near] - low) / SPACING, radii[near] / SPACING, cells)
    met = np.zeros((len(points), DIRECTIONS), dtype=bool)
    places, directions = ((points - low) / SPACING)[:, None], _directions()
    for length in np.arange(1.0, REACH / SPACING + 0.5):
        at = np.rint(places + length * directions).astype(int)
        met |= filled[at[..., 0], at[..., 1], at[..., 2]]
    return np.asarray(met.mean(axis=1))


def _filled(places: np.ndarray, radii: np.ndarray, cells: np.ndarray) -> np.ndarray:
    """Mask of the cells of a grid whose middles are in an atom; lengths are in its steps."""
    most = int(np.ceil(radii.max()))
    cube = np.indices((2 * most + 1,) * 3).reshape(3, -1).T - most
    at = np.rint(places).astype(int)[:, None] + cube
    inside = np.sum((at - places[:, None]) ** 2, axis=2) <= (radii**2)[:, None]
    inside &= np.all((at >= 0) & (at < cells), axis=2)
    filled = np.zeros(cells, dtype=bool)
    filled[tuple(at[inside].T)] = True
    return filled


def _directions() -> np.ndarray:
    """(DIRECTIONS, 3) unit vectors, evenly over the sphere (a spiral by the golden angle)."""
    turn = np.arange(DIRECTIONS) + 0.5
    z = 1 - 2 * turn / DIRECTIONS
    angle, r = np.pi * (1 + np.sqrt(5)) * turn, np.sqrt(1 - z**2)
    return np.stack([r * np.cos(angle), r * np.sin(angle), z], axis=1)
