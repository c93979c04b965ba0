# SPDX-License-Identifier: MIT
"""Whether frames keep the shape that chemistry fixes: angles, hands, planes, backbone, overlaps."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field

import numpy as np

from pliant.measure.geometry import angles_of, corners_of, out_of_plane, torsions_of, volumes
from pliant.measure.overlaps import Overlaps
from pliant.measure.ramachandran import FAVOURED, OUTLIER, judged

#: a peptide bond is twisted where omega is further than this from 0 and 180 degrees
TWISTED = 30.0

_QUANTITIES = tuple(
    "angle angle_rms flips plane omega twisted outliers favoured overlap overlaps".split()
)


@dataclass
class StereochemistryResults:
    """Per frame looked at (f,), and of the reference."""

    angle: np.ndarray  #: largest change of a bond angle from the reference, degrees
    angle_rms: np.ndarray  #: root mean square change of bond angles, degrees
    flips: np.ndarray  #: centres of the other hand than in the reference
    plane: np.ndarray  #: furthest that a planar centre is from its neighbours' plane, Angstrom
    omega: np.ndarray  #: furthest that omega is from 0 or 180, degrees
    twisted: np.ndarray  #: peptide bonds beyond TWISTED
    outliers: np.ndarray  #: share of residues outside the allowed regions of phi and psi
    favoured: np.ndarray  #: share of residues inside the favoured ones
    overlap: np.ndarray  #: deepest overlap of heavy atoms that do not overlap in the reference
    overlaps: np.ndarray  #: number of such pairs
    reference: dict[str, float] = field(default_factory=dict)  #: the same of the reference


class Stereochemistry:
    """Measures frames of a molecule against a reference structure.

    elements: (N,) symbols; bonds: (B, 2); reference: (N, 3) Angstrom; omega: (W, 4) atoms of the
    torsions of peptide bonds; phi, psi: (R, 4) of residues with a side chain that is not proline's.
    """

    def __init__(
        self,
        elements: np.ndarray,
        bonds: np.ndarray,
        reference: np.ndarray,
        omega: Sequence[Sequence[int]] = (),
        phi: Sequence[Sequence[int]] = (),
        psi: Sequence[Sequence[int]] = (),
    ) -> None:
        self.corners = corners_of(bonds, elements, reference)
        self._overlaps = Overlaps(elements, bonds)
        self.omega, self.phi, self.psi = (
            np.array(rows, dtype=np.int64).reshape(-1, 4) for rows in (omega, phi, psi)
        )
        self._angles = angles_of(reference, self.corners.angles)
        self._hands = np.sign(volumes(reference, self.corners.handed))
        self._own, self._own_depth = self._overlaps.of(reference)
        self._reference = reference

    def run(self, frames: Iterable[np.ndarray]) -> StereochemistryResults:
        """Measures frames (f, N, 3), Angstrom."""
        rows = [self._measure(frame) for frame in frames]
        columns = {name: np.array([row[name] for row in rows]) for name in _QUANTITIES}
        own = self._measure(self._reference)
        own |= {
            "overlap": float(self._own_depth.max(initial=0.0)),
            "overlaps": float(len(self._own)),
        }
        return StereochemistryResults(**columns, reference=own)

    def _measure(self, positions: np.ndarray) -> dict[str, float]:
        change = np.abs(angles_of(positions, self.corners.angles) - self._angles)
        plane = np.abs(out_of_plane(positions, self.corners.planar))
        hands = np.sign(volumes(positions, self.corners.handed))
        return {
            "angle": float(change.max(initial=0.0)),
            "angle_rms": float(np.sqrt(np.mean(change**2))) if len(change) else 0.0,
            "flips": float(np.count_nonzero(hands != self._hands)),
            "plane": float(plane.max(initial=0.0)),
            **self._backbone(positions),
            **self._new_overlaps(positions),
        }

    def _backbone(self, positions: np.ndarray) -> dict[str, float]:
        omega = np.abs(torsions_of(positions, self.omega))
        off = np.minimum(omega, 180.0 - omega)
        found = judged(torsions_of(positions, self.phi), torsions_of(positions, self.psi))
        count = max(len(found), 1)
        return {
            "omega": float(off.max(initial=0.0)),
            "twisted": float(np.count_nonzero(off > TWISTED)),
            "outliers": np.count_nonzero(found == OUTLIER) / count,
            "favoured": np.count_nonzero(found == FAVOURED) / count,
        }

    def _new_overlaps(self, positions: np.ndarray) -> dict[str, float]:
        keys, depth = self._overlaps.of(positions)
        new = depth[~np.isin(keys, self._own)]
        return {"overlap": float(new.max(initial=0.0)), "overlaps": float(len(new))}
