# SPDX-License-Identifier: MIT
"""Curves of frames: what is computed once, and what follows for any expansion and any layer of
water."""

from __future__ import annotations

import copy
import math
from dataclasses import dataclass

import numpy as np

from pliant._core import Structure, form_factors, partial_profiles, scattering_groups
from pliant.jobs.fit.saxs.curve import Curve

FINENESS = 0.5  #: the step in q times the largest diameter
WINDOW = 6  #: points that a polynomial goes through

#: expansion of the displaced solvent, and density of the layer of water: coarse, then finer
EXPANSIONS = np.linspace(0.95, 1.05, 11)
LAYERS = np.linspace(-2, 4, 61)
FINER = np.linspace(-1, 1, 11)


@dataclass(frozen=True)
class Water:
    """How the solvent is taken into account."""

    expansion: float = 1.0  #: c1: of the radii of atoms, as the solvent sees them
    layer: float = 0.0  #: c2: 1 puts one water's scattering at each atom that is all exposed


def interpolation(grid: np.ndarray, q: np.ndarray) -> np.ndarray:
    """(K, n): values on an even grid (K) to values at q (n), by polynomials through the six points
    around."""
    step = grid[1] - grid[0]
    first = np.clip((q / step).astype(int) - WINDOW // 2 + 1, 0, len(grid) - WINDOW)
    places = q / step - first
    found = np.zeros((len(grid), len(q)))
    for k in range(WINDOW):
        weight = np.ones(len(q))
        for other in range(WINDOW):
            if other != k:
                weight *= (places - other) / (k - other)
        found[first + k, np.arange(len(q))] = weight
    return found


def diameters(positions: np.ndarray) -> np.ndarray:
    """(F) the longest distance in each frame (F, N, 3), to 2 %: along directions of a cube."""
    axes = np.stack(np.meshgrid(*[np.arange(-2, 3)] * 3), axis=-1).reshape(-1, 3)
    axes = axes[len(axes) // 2 + 1 :]
    directions = axes / np.linalg.norm(axes, axis=1, keepdims=True)
    return np.array([np.ptp(frame @ directions.T, axis=0).max() for frame in positions])


class Profiles:
    """Curves of frames of a molecule at the points of a measured one."""

    def __init__(self, structure: Structure, frames: np.ndarray, curve: Curve) -> None:
        atoms, elements, hydrogens = scattering_groups(structure)
        groups = np.ascontiguousarray(frames[:, atoms], dtype=np.float64)
        self.diameters = diameters(groups)
        self.curve = curve
        count = math.ceil(curve.q[-1] * self.diameters.max() / FINENESS) + WINDOW
        self.grid = np.linspace(0, curve.q[-1], count)
        self.on_grid = partial_profiles(elements, hydrogens, groups, self.grid)
        self.partials = self.on_grid @ interpolation(self.grid, curve.q)
        volume = form_factors(elements, hydrogens, [0.0])[2].mean()
        self._area = volume ** (2 / 3) / (4 * math.pi)

    def __len__(self) -> int:
        return len(self.partials)

    def expanded(self, expansion: float, q: np.ndarray) -> np.ndarray:
        """What all displaced solvent is multiplied by, if radii are so many times as long."""
        return np.asarray(expansion**3 * np.exp(-self._area * (expansion**2 - 1) * q**2))

    def powers(
        self, partials: np.ndarray, expansion: float, q: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Intensities are the first + layer x the second + layer^2 x the third."""
        vv, vd, dd, vw, dw, ww = np.moveaxis(partials, -2, 0)
        by = self.expanded(expansion, q)
        return vv - 2 * by * vd + by**2 * dd, 2 * (vw - by * dw), ww

    def intensities(self, partials: np.ndarray, water: Water) -> np.ndarray:
        """(..., n) at the points of the curve, of partial profiles (..., 6, n)."""
        one, two, three = self.powers(partials, water.expansion, self.curve.q)
        return np.asarray(one + water.layer * two + water.layer**2 * three)

    def radii_of_gyration(self, water: Water) -> np.ndarray:
        """(F) Angstrom: how curves begin, with the layer of water."""
        one, two, three = self.powers(self.on_grid, water.expansion, self.grid)
        begun = (one + water.layer * two + water.layer**2 * three)[:, :2]
        return np.asarray(np.sqrt(3 * np.log(begun[:, 0] / begun[:, 1])) / self.grid[1])


@dataclass(frozen=True)
class WaterFit:
    """The water with which each of some profiles explains the curve best."""

    waters: list[Water]
    misfits: np.ndarray  #: sums of squares, in errors


class Weighed:
    """A curve as what is minimised sees it: in errors, without the background that is let free."""

    def __init__(self, profiles: Profiles, background: bool, some: np.ndarray | None = None):
        curve = profiles.curve
        self.profiles = profiles
        self.background = background
        self._weight = 1 / curve.sigma if some is None else np.where(some, 1 / curve.sigma, 0.0)
        unit = self._weight / np.linalg.norm(self._weight)
        self._constant = unit if background else None
        self.goal = self.of(curve.intensity)
        self.square = float(self.goal @ self.goal)

    def with_goal(self, goal: np.ndarray) -> Weighed:
        """The same for another curve, in errors."""
        other = copy.copy(self)
        other.goal, other.square = goal, float(goal @ goal)
        return other

    def of(self, intensities: np.ndarray) -> np.ndarray:
        """Intensities (..., n) over errors; 0 where they are not looked at."""
        found = intensities * self._weight
        if self._constant is not None:
            found = found - np.multiply.outer(found @ self._constant, self._constant)
        return np.asarray(found)

    def fitted(self, intensities: np.ndarray) -> np.ndarray:
        """Intensities (n), as they are scaled, with the background."""
        if not self.background:
            return intensities
        left = self.profiles.curve.intensity - intensities
        return np.asarray(intensities + np.average(left, weights=self._weight**2))

    def water_of(self, partials: np.ndarray) -> WaterFit:
        """Of each profile (F, 6, n), alone."""
        coarse = self._best_of(partials, EXPANSIONS, np.tile(LAYERS, (len(partials), 1)))
        fine = self._finer(partials, coarse)
        return WaterFit([Water(*map(float, row)) for row in fine[:, :2]], fine[:, 2])

    def _finer(self, partials: np.ndarray, coarse: np.ndarray) -> np.ndarray:
        """Each about its own best of before."""
        layers = coarse[:, 1:2] + FINER * (LAYERS[1] - LAYERS[0])
        found: np.ndarray = coarse.copy()
        for expansion in np.unique(coarse[:, 0]):
            rows = np.flatnonzero(coarse[:, 0] == expansion)
            steps = expansion + FINER * (EXPANSIONS[1] - EXPANSIONS[0])
            steps = np.clip(steps, EXPANSIONS[0], EXPANSIONS[-1])
            some = np.clip(layers[rows], LAYERS[0], LAYERS[-1])
            found[rows] = self._best_of(partials[rows], steps, some)
        return found

    def _best_of(
        self, partials: np.ndarray, expansions: np.ndarray, layers: np.ndarray
    ) -> np.ndarray:
        """(F, 3) expansion, layer and misfit, of the expansions and of layers (F, L) of each."""
        found = np.full((len(partials), 3), np.inf)
        for expansion in expansions:
            misfits = self._misfits(partials, float(expansion), layers)
            best = misfits.argmin(axis=1)
            rows = np.arange(len(partials))
            tried = np.stack(
                [np.full(len(rows), expansion), layers[rows, best], misfits[rows, best]], axis=1
            )
            better = tried[:, 2] < found[:, 2]
            found[better] = tried[better]
        return found

    def _misfits(self, partials: np.ndarray, expansion: float, layers: np.ndarray) -> np.ndarray:
        """(F, L) with the best scale of each."""
        q = self.profiles.curve.q
        a, b, c = (self.of(x) for x in self.profiles.powers(partials, expansion, q))
        goal = self.goal
        along = (a @ goal)[:, None] + layers * (b @ goal)[:, None] + layers**2 * (c @ goal)[:, None]
        products = [(a * a), 2 * (a * b), b * b + 2 * (a * c), 2 * (b * c), c * c]
        square: np.ndarray = np.zeros(layers.shape)
        for k, product in enumerate(products):
            square += product.sum(axis=1)[:, None] * layers**k
        return np.asarray(self.square - np.maximum(along, 0) ** 2 / square)
