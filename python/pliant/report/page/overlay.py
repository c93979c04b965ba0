# SPDX-License-Identifier: MIT
"""Another structure of the molecule, which the 3-D view shows over the start."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from pliant.report.page.drawn import drawn_positions
from pliant.report.page.map_surface import MapSurface


@dataclass(frozen=True)
class Overlay:
    """All atoms of both, and lines between some."""

    label: str  #: of its button
    positions: np.ndarray  #: (2, N, 3) the structure and the start, Angstrom
    pairs: np.ndarray  #: (K, 2) atoms that lines join
    colours: Sequence[str]  #: (K) of the lines
    surface: MapSurface | None = None  #: of the map that both are in

    def drawn(self, atoms: np.ndarray) -> dict[str, Any]:
        """JSON-ready, of those atoms (n,) that are shown."""
        place = np.full(self.positions.shape[1], -1)
        place[atoms] = np.arange(len(atoms))
        lines = place[self.pairs]
        kept = np.flatnonzero((lines >= 0).all(axis=1))
        colours = [self.colours[k] for k in kept.tolist()]
        kinds = sorted(set(colours))
        shown = self.positions[:, atoms]
        return {
            "label": self.label,
            **drawn_positions(shown),
            "surface": self.surface and self.surface.drawn(shown[0].mean(axis=0)),
            "lines": lines[kept].ravel().tolist(),
            "kinds": [kinds.index(colour) for colour in colours],
            "colours": kinds,
        }
