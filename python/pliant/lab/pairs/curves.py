# SPDX-License-Identifier: MIT
"""SAXS curves as experiments have them."""

from __future__ import annotations

import numpy as np

from pliant._core import Structure
from pliant.jobs.fit.saxs.curve import Curve
from pliant.jobs.fit.saxs.profiles import Profiles, Water

Q = np.linspace(0.01, 0.35, 150)  #: 1/Angstrom
NOISE = 0.015  #: of the intensity, at small q; twice that at 0.15
WATER = Water(1.01, 1.2)


def curve_of(structure: Structure, seed: int = 0) -> Curve:
    """A curve of a structure with its layer of water, and noise."""
    ones = np.ones(len(Q))
    frames = np.asarray(structure.positions)[None]
    profiles = Profiles(structure, frames, Curve(Q, ones, ones))
    intensity = profiles.intensities(profiles.partials, WATER)[0]
    sigma = NOISE * intensity * (1 + (Q / 0.15) ** 2)
    drawn = np.random.default_rng(seed).standard_normal(len(Q))
    return Curve(Q, intensity + sigma * drawn, sigma)
