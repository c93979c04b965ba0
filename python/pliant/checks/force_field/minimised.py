# SPDX-License-Identifier: MIT
"""What minimising did to structures, and to the start structure alike."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

NO = float("nan")
SHORT, LONG = 100, 500  #: steps of the minimiser


@dataclass(frozen=True)
class LigandFound:
    """A ligand after 100 steps. Energies in kJ/mol, in implicit water; length in Angstrom."""

    energy: float  #: of it alone, at its positions
    contacts: float  #: of all less those of it and of the rest, parted
    strain: float  #: what minimising it alone takes from its energy
    moved: float  #: RMSD of its atoms without hydrogens; alpha carbons are superposed


@dataclass
class Minimised:
    """One structure: a frame of the file, one of MD, or the start.

    Energies in kJ/mol, lengths in Angstrom; not-a-number where it was not measured.
    """

    name: str  #: "start", "frame 10", "MD 0.5 ps"
    frame: int | None = None  #: of the file
    worst_force: float = NO  #: on an atom before, kJ/(mol nm)
    before: float = NO  #: energy
    after_short: float = NO  #: energy after 100 steps
    after_long: float = NO  #: energy after 500 steps
    moved: float = NO  #: RMSD of alpha carbons after 100 steps, superposed
    inverted: list[str] = field(default_factory=list)  #: residues with the other hand after
    ligands: dict[str, LigandFound] = field(default_factory=dict)  #: by label, "A:XK2263"
    outcome: str = ""  #: why it was not minimised; "" if it was

    def as_json(self) -> dict[str, Any]:
        """All of it as one JSON object."""
        return {**vars(self), "ligands": {key: vars(one) for key, one in self.ligands.items()}}

    @property
    def is_finite(self) -> bool:
        """Minimised, and every number that came out is one."""
        return math.isfinite(self.after_short) and math.isfinite(self.moved)


@dataclass
class ForceFieldReport:
    """What OpenMM's minimiser did to frames, to frames of MD, and to the start structure.

    The force field is amber14 with implicit water (OBC2), cut off at 16 Angstrom. Energies above
    the start's are of a residue, with both structures minimised for as many steps.
    """

    start: Minimised
    frames: list[Minimised]  #: of the file
    dynamics: list[Minimised]  #: of a short MD from the start
    residues: int  #: that the force field knows
    atoms: int  #: with the hydrogens that were placed
    placed_hydrogens: int  #: of these, not in the file
    md_picoseconds: float  #: length of the MD
    long_starts: int = 1  #: frames that were to be minimised for 500 steps
    #: molecules or residues without a template, which were left out: how many of each name
    left_out: dict[str, int] = field(default_factory=dict)
    why_left_out: dict[str, str] = field(default_factory=dict)  #: by label, "A:XK2263"
    ligands: list[str] = field(default_factory=list)  #: with parameters of their own, by label
    platform: str = ""  #: of OpenMM
    seconds: float = 0.0  #: that all of it took
    notes: list[str] = field(default_factory=list)
    why_not: str = ""  #: why nothing was minimised; "" if it was

    @property
    def without(self) -> str:
        """ "1 XK2, 2 CSO": what was left out; "" if nothing was."""
        return listed(self.left_out)

    @property
    def subject(self) -> str:
        """ " of the protein with A:XK2263 (without 2 CSO)"; "" of all of a protein."""
        without = f" (without {self.without})" if self.left_out else ""
        if self.ligands:
            return f" of the protein with {', '.join(self.ligands)}{without}"
        return f" of the protein alone{without}" if without else ""

    @property
    def usable(self) -> list[Minimised]:
        """Frames of the file that were minimised."""
        return [frame for frame in self.frames if not frame.outcome]

    def above_start(self, structures: Sequence[Minimised], steps: int = SHORT) -> np.ndarray:
        """Energy a residue above the start's after `steps` (100 or 500), of those that have it.

        kJ/mol. Infinite where a minimised structure has no finite energy.
        """
        start = self.start.after_short if steps == SHORT else self.start.after_long
        energies = [
            s.after_short if steps == SHORT else s.after_long
            for s in structures
            if not s.outcome and (steps == SHORT or not math.isnan(s.after_long))
        ]
        above = (np.array(energies, float) - start) / max(self.residues, 1)
        kept: np.ndarray = np.where(np.isfinite(above), above, np.inf)
        return kept if math.isfinite(start) else kept[:0]

    def moved(self, structures: Sequence[Minimised]) -> np.ndarray:
        """RMSD (Angstrom) that 100 steps move alpha carbons by, of those minimised."""
        moves = np.array([s.moved for s in structures if not s.outcome], float)
        kept: np.ndarray = np.where(np.isfinite(moves), moves, np.inf)
        return kept

    def as_json(self) -> dict[str, Any]:
        """All of it as one JSON object; `above_start` is energy a residue after 100 and 500."""
        fields = dict(vars(self))
        for name in ("frames", "dynamics"):
            fields[name] = [self._one(s) for s in fields[name]]
        return fields | {"start": self.start.as_json()}

    def _one(self, structure: Minimised) -> dict[str, Any]:
        above = {
            str(steps): float(found[0]) if len(found) else None
            for steps in (SHORT, LONG)
            for found in [self.above_start([structure], steps)]
        }
        return {**structure.as_json(), "above_start": above}


def listed(left_out: Mapping[str, int]) -> str:
    """ "2 CSO, 1 XK2", of the names of what was left out."""
    return ", ".join(f"{count} {name}" for name, count in sorted(left_out.items()))


def handedness(positions: np.ndarray, corners: np.ndarray) -> np.ndarray:
    """(C,) sign of the hand of each alpha carbon; corners (C, 4) are N, C, CB and CA."""
    n, c, beta, alpha = (positions[corners[:, k]] for k in range(4))
    volume = np.einsum("ij,ij->i", np.cross(n - alpha, c - alpha), beta - alpha)
    signs: np.ndarray = np.sign(volume)
    return signs
