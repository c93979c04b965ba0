# SPDX-License-Identifier: MIT
"""Maps as experiments make them worse."""

from __future__ import annotations

import numpy as np

from pliant._core import DensityMap

SIGNAL = 0.05  #: of the greatest value: points above it are of the molecule


def noisy(map: DensityMap, resolution: float, *, share: float, seed: int = 0) -> DensityMap:
    """With Gaussian noise as smooth as a map of that resolution, of so much of the r.m.s. density
    of the molecule."""
    white = np.random.default_rng(seed).normal(size=map.shape).astype(np.float32)
    noise = DensityMap(white, map.spacing, map.origin).blurred(resolution).values
    inside = map.values[map.values > SIGNAL * map.values.max()]
    size = share * float(np.sqrt((inside**2).mean())) / float(noise.std())
    return DensityMap(map.values + size * noise, map.spacing, map.origin)


def without_half(map: DensityMap) -> DensityMap:
    """Nothing beyond the plane through the middle of the longest axis."""
    axis = int(np.argmax(map.shape))
    values = np.moveaxis(map.values.copy(), axis, 0)
    values[len(values) // 2 :] = 0.0
    return DensityMap(np.moveaxis(values, 0, axis), map.spacing, map.origin)
