# SPDX-License-Identifier: MIT
"""How well techniques hold planar groups and chirality under bars across angles.

``python tests/support/python/planarity.py [TECHNIQUE...]`` prints the rows of the table that the
test of planar groups has: the largest change of a signed angle, in degrees, after 100 steps of a
default run.
"""

from __future__ import annotations

import math
import sys
import warnings
from collections.abc import Iterator

import numpy as np
from nearness import MOST_SWEEPS, Case, cases_of, large_files

import pliant

STEPS = 100
#: The others sweep, and do not get angles whole.
DIRECT = ("auto", "froda", "newton", "shake", "units")
#: Torsions, each atom bonded to the next; in one residue or from one to the next.
TORSIONS = {
    "omega": [("CA", "C", "N", "CA")],
    "guanidinium": [("CD", "NE", "CZ", "NH1"), ("CD", "NE", "CZ", "NH2")],
    "aromatic": [
        ("CB", "CG", "CD1", "CE1"),
        ("CG", "CD1", "CE1", "CZ"),
        ("CD1", "CE1", "CZ", "CE2"),
        ("CB", "CG", "ND1", "CE1"),
        ("CB", "CG", "CD1", "NE1"),
    ],
}
#: Improper torsions: the centre and three neighbours of it.
CENTRES = {
    "amide": [("C", "CA", "N", "O"), ("CG", "CB", "ND2", "OD1"), ("CD", "CG", "NE2", "OE1")],
    "guanidinium": [("CZ", "NE", "NH1", "NH2")],
    "chirality": [("CA", "N", "C", "CB"), ("CB", "CA", "OG1", "CG2"), ("CB", "CA", "CG1", "CG2")],
}
KINDS = ("omega", "amide", "guanidinium", "aromatic", "chirality")


def torsions(points: np.ndarray) -> np.ndarray:
    """Of (M, 4, 3) points, in degrees."""
    along = np.diff(points, axis=1)
    left = np.cross(along[:, 0], along[:, 1])
    right = np.cross(along[:, 1], along[:, 2])
    axis = along[:, 1] / np.linalg.norm(along[:, 1], axis=1)[:, None]
    sine = np.einsum("ij,ij->i", np.cross(left, right), axis)
    return np.degrees(np.arctan2(sine, np.einsum("ij,ij->i", left, right)))


def change(before: np.ndarray, after: np.ndarray) -> float:
    """The largest change of an angle, in degrees; 0 of none."""
    if before.size == 0:
        return 0.0
    return float(np.abs((after - before + 180) % 360 - 180).max())


class Groups:
    """The angles of a structure that stay as they are."""

    def __init__(self, structure: pliant.Structure) -> None:
        self._names = [name.strip() for name in structure.names]
        self._around: dict[int, list[int]] = {}
        for a, b in np.asarray(structure.bonds).tolist():
            self._around.setdefault(a, []).append(b)
            self._around.setdefault(b, []).append(a)
        self.quadruples = {kind: self._find(kind) for kind in KINDS}

    def _find(self, kind: str) -> np.ndarray:
        found = [quadruple for names in TORSIONS.get(kind, []) for quadruple in self._paths(names)]
        found += [quadruple for names in CENTRES.get(kind, []) for quadruple in self._stars(names)]
        return np.array(found, dtype=int).reshape(-1, 4)

    def _beside(self, atom: int, name: str) -> list[int]:
        return [at for at in self._around[atom] if self._names[at] == name]

    def _paths(self, names: tuple[str, ...]) -> Iterator[tuple[int, ...]]:
        for b in self._around:
            if self._names[b] != names[1]:
                continue
            for c in self._beside(b, names[2]):
                for a in self._beside(b, names[0]):
                    for d in self._beside(c, names[3]):
                        if len({a, b, c, d}) == 4:
                            yield a, b, c, d

    def _stars(self, names: tuple[str, ...]) -> Iterator[tuple[int, ...]]:
        for centre in self._around:
            if self._names[centre] != names[0]:
                continue
            around = [self._beside(centre, name) for name in names[1:]]
            if all(around):
                yield (centre, *(found[0] for found in around))

    def renumbered(self, numbers: np.ndarray) -> dict[str, np.ndarray]:
        """The quadruples in other numbers of atoms."""
        return {kind: numbers[found] for kind, found in self.quadruples.items()}


def walked(case: Case, technique: str, steps: int = STEPS) -> np.ndarray:
    """Where the joints are after a default run."""
    sweeps = 10000 if technique in DIRECT else MOST_SWEEPS
    motion = pliant.Motion(case.framework, case.positions, technique=technique, max_sweeps=sweeps)
    motion.start()
    for _ in range(steps):
        motion.step()
    return np.array(motion.state.positions)


def changes(
    case: Case, quadruples: dict[str, np.ndarray], technique: str, steps: int = STEPS
) -> dict[str, float]:
    """The largest change of each kind of angle."""
    after = walked(case, technique, steps)
    return {
        kind: change(torsions(case.positions[found]), torsions(after[found]))
        for kind, found in quadruples.items()
    }


def protein_cases() -> Iterator[tuple[Case, dict[str, np.ndarray]]]:
    """AdK with and without hydrogens, 4E43, 1A8O: those that are installed."""
    for file in large_files():
        structure = pliant.read(str(file))
        structure.perceive_bonds()
        groups = Groups(structure)
        heavy = np.cumsum(np.asarray(structure.elements) != 1) - 1
        for case in cases_of(file):
            all_atoms = np.arange(len(structure.positions))
            is_heavy = len(case.positions) < len(all_atoms)
            yield case, groups.renumbered(heavy if is_heavy else all_atoms)


def page_row(name: str) -> str:
    """The largest change of each kind on all proteins, rounded up to hundredths."""
    found = [changes(case, quadruples, name) for case, quadruples in protein_cases()]
    cells = (f"{up(max(one[kind] for one in found)):.2f}" for kind in KINDS)
    return f"| `{name}` | {' | '.join(cells)} |"


def up(degrees: float) -> float:
    """Rounded up to hundredths."""
    return math.ceil(degrees * 100) / 100


def main() -> None:
    """Prints the rows of the table."""
    warnings.simplefilter("ignore", pliant.PliantWarning)
    for name in sys.argv[1:] or [row.name for row in pliant.techniques() if not row.forests_only]:
        print(page_row(name), flush=True)


if __name__ == "__main__":
    main()
