# SPDX-License-Identifier: MIT
"""The surface of a density map about a structure, coarse enough for a page."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from pliant._core import DensityMap, Structure
from pliant.report.page.drawn import as_base64, drawn_positions

#: Angstrom^3 a dalton, of proteins (Y. Harpaz et al., Structure 2 (1994) 641): the surface encloses
#: the volume of the molecule
VOLUME = 1.21
MARGIN = 8.0  #: Angstrom about the molecule: what of the map is shown
STEPS = 4  #: points of the surface in the resolution, along an axis
MOST_POINTS = 1 << 18  #: of the part of the map
MOST_VERTICES = 10_000  #: 240 kB of text


@dataclass(frozen=True)
class MapSurface:
    """Triangles."""

    vertices: np.ndarray  #: (V, 3) Angstrom
    triangles: np.ndarray  #: (T, 3) of vertices
    coarse: DensityMap | None = None  #: what it is the surface of
    level: float = 0.0

    @classmethod
    def around(cls, density: DensityMap, resolution: float, molecule: Structure) -> MapSurface:
        """At the level about which the map encloses the volume of a molecule that is in it."""
        low, high = _part(density, np.asarray(molecule.positions))
        step = max(resolution / STEPS, float(np.cbrt(np.prod(high - low) / MOST_POINTS)))
        while True:
            coarse = _coarse(density, low, high, step)
            whole = float(np.prod(coarse.shape)) * step**3
            level = coarse.level_around(min(VOLUME * float(molecule.masses.sum()), whole))
            vertices, triangles = coarse.surface(level)
            if len(vertices) <= MOST_VERTICES:
                return cls(vertices, triangles, coarse, level)
            step *= max(1.1, float(np.sqrt(len(vertices) / MOST_VERTICES)))

    def drawn(self, about: np.ndarray) -> dict[str, Any]:
        """JSON-ready, about a point (3,)."""
        triangles = as_base64(self.triangles.astype("<u2"))
        return {**drawn_positions(self.vertices[None], about), "triangles": triangles}


def _part(density: DensityMap, positions: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Corners of the box about positions (n, 3) in which the map is."""
    last = np.subtract(density.shape, 1)
    ends = density.origin + np.array([*np.ndindex(2, 2, 2)]) * last @ density.steps
    low = np.maximum(positions.min(axis=0) - MARGIN, ends.min(axis=0))
    return low, np.minimum(positions.max(axis=0) + MARGIN, ends.max(axis=0))


def _coarse(density: DensityMap, low: np.ndarray, high: np.ndarray, step: float) -> DensityMap:
    """The map in a box at points so far apart, each the mean of eight where that is coarser."""
    each = 2 if step > 1.5 * density.spacing.max() else 1
    count = np.maximum(2, np.floor((high - low) / step).astype(int))
    along = [low[k] + step / each * (np.arange(each * count[k]) + 0.5) for k in range(3)]
    places = np.stack(np.meshgrid(*along, indexing="ij"), axis=-1).reshape(-1, 3)
    halves = [size for one in count.tolist() for size in (one, each)]
    values = density.at(places)[0].reshape(halves).mean(axis=(1, 3, 5))
    return DensityMap(values, [step] * 3, low + step / 2)
