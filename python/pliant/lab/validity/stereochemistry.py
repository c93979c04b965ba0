# SPDX-License-Identifier: MIT
"""What must not change in a frame, measured anew by NumPy and SciPy: nothing of the C++ library's.

Bars, least distances (the table of the page on models), chirality, omega, and the shares of
residues outside the Ramachandran contour that holds 99 % of well-ordered residues, and of side
chains outside that of chi1 and chi2 (Janin plot) that holds 98 % (S. C. Lovell et al., Proteins 50
(2003) 437, as MDAnalysis has them).
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from MDAnalysis.analysis.data.filenames import Janin_ref, Rama_ref
from scipy.ndimage import map_coordinates
from scipy.spatial import cKDTree

from pliant._core import MolecularModel, Structure
from pliant.lab.validity.clashes import HeavyClashes
from pliant.measure.backbone import neighbours_of, peptide_links, phi_psi_atoms
from pliant.measure.geometry import torsions_of
from pliant.measure.overlaps import within_three_bonds

KINDS = ("C", "N", "NH", "O", "OH", "S", "H", "HC", "M")
LEAST = np.array(
    [
        [3.2, 2.9, 2.9, 2.84, 2.84, 3.2, 2.3, 2.4, 2.2],
        [2.9, 2.72, 2.6, 2.69, 2.6, 3.1, 2.3, 2.3, 1.7],
        [2.9, 2.6, 2.6, 2.6, 2.6, 3.1, 2.3, 2.3, 1.7],
        [2.84, 2.69, 2.6, 2.66, 2.6, 3.0, 1.7, 2.2, 1.7],
        [2.84, 2.6, 2.6, 2.6, 2.6, 3.0, 1.7, 2.2, 1.7],
        [3.2, 3.1, 3.1, 3.0, 3.0, 3.22, 2.4, 2.5, 2.0],
        [2.3, 2.3, 2.3, 1.7, 1.7, 2.4, 1.8, 1.9, 1.9],
        [2.4, 2.3, 2.3, 2.2, 2.2, 2.5, 1.9, 2.0, 1.9],
        [2.2, 1.7, 1.7, 1.7, 1.7, 2.0, 1.9, 1.9, 2.4],
    ]
)
LIKE = {
    6: "C", 7: "N", 8: "O", 9: "O", 15: "S", 16: "S", 17: "S", 34: "S", 35: "S", 53: "S", 1: "H",
}  # fmt: skip  # some pairs a line
WITH_HYDROGEN = {7: "NH", 8: "OH"}
ALLOWED_OVERLAP = 0.1  #: Angstrom
ALLOWED_TURN = 5.0  #: degrees of omega
LEAST_VOLUME = 0.5  #: of three bonds, Angstrom^3: what is flatter is no chiral centre
OUTLIER_LEVEL = 1.0  #: of MDAnalysis' density: outside are 1 % of residues
GRID = 4.0  #: degrees of that density, from -180
CHI_GRID = 6.0  #: of that of chi1 and chi2, from 0
GAMMA, DELTA = ("CG", "CG1"), ("CD", "CD1", "OD1", "ND1", "SD")


@dataclass
class Stereochemistry:
    """What was found in a number of frames."""

    frames: int = 0
    worst_bar: float = 0.0  #: largest |length / rest - 1|
    overlaps: int = 0  #: pairs nearer than allowed by more than 0.1 Angstrom, over all frames
    worst_overlap: float = 0.0  #: Angstrom
    flipped: int = 0  #: chiral centres on the other side, over all frames
    turned: int = 0  #: omega more than 5 degrees from the start's, over all frames
    worst_turn: float = 0.0  #: degrees
    outliers: float = 0.0  #: share of residues, mean over frames
    outliers_of_start: float = 0.0
    residues: int = 0  #: that the share is of
    clashes: float = 0.0  #: of 1000 heavy atoms (``HeavyClashes``), mean over frames
    clashes_of_start: float = 0.0
    outliers_of_frames: list[float] = field(default_factory=list)
    rotamers: float = 0.0  #: share of side chains with unusual chi1 and chi2, mean over frames
    rotamers_of_start: float = 0.0


class Checker:
    """What a model holds, and the looks at frames of it."""

    def __init__(self, model: MolecularModel) -> None:
        structure = model.structure
        self._start = np.asarray(model.positions, dtype=float)
        self._bars = np.asarray(model.framework.bars, dtype=np.int64)
        self._rest = np.asarray(model.framework.rest_lengths)
        self._near = _Nearness(structure, self._start)
        self._clashes = HeavyClashes(structure)
        neighbours = neighbours_of(structure)
        self._centres = _centres(structure, neighbours, self._start)
        self._sides = _volumes(self._start, self._centres)
        links = peptide_links(structure, neighbours)
        self._omega = _omegas(links)
        self._phi_psi = phi_psi_atoms(structure, links)
        self._chi = _chis(structure)

    def look(self, frames: np.ndarray) -> Stereochemistry:
        """Frames (F, N, 3) Angstrom of the atoms of the model."""
        found = Stereochemistry(len(frames), residues=len(self._phi_psi))
        found.outliers_of_start = self._outliers(self._start)
        found.clashes_of_start = self._clashes.score(self._start)
        for frame in frames:
            self._look_at(np.asarray(frame, dtype=float), found)
        found.outliers = float(np.mean(found.outliers_of_frames)) if len(frames) else 0.0
        found.clashes /= max(len(frames), 1)
        found.rotamers_of_start = self._unusual_chis(self._start)
        found.rotamers /= max(len(frames), 1)
        return found

    def _look_at(self, frame: np.ndarray, found: Stereochemistry) -> None:
        length = np.linalg.norm(frame[self._bars[:, 0]] - frame[self._bars[:, 1]], axis=1)
        found.worst_bar = max(found.worst_bar, float(np.abs(length / self._rest - 1.0).max()))
        deep = self._near.overlaps(frame)
        found.overlaps += int((deep > ALLOWED_OVERLAP).sum())
        found.worst_overlap = max(found.worst_overlap, float(deep.max(initial=0.0)))
        found.clashes += self._clashes.score(frame)
        found.flipped += int((_volumes(frame, self._centres) * self._sides < 0).sum())
        turn = _apart(torsions_of(frame, self._omega), torsions_of(self._start, self._omega))
        found.turned += int((turn > ALLOWED_TURN).sum())
        found.worst_turn = max(found.worst_turn, float(turn.max(initial=0.0)))
        found.outliers_of_frames.append(self._outliers(frame))
        found.rotamers += self._unusual_chis(frame)

    def _outliers(self, positions: np.ndarray) -> float:
        if len(self._phi_psi) == 0:
            return 0.0
        phi, psi = (torsions_of(positions, self._phi_psi[:, k : k + 4]) for k in (0, 1))
        return _outside(Rama_ref, (psi + 180.0) / GRID, (phi + 180.0) / GRID)

    def _unusual_chis(self, positions: np.ndarray) -> float:
        if len(self._chi) == 0:
            return 0.0
        chi1, chi2 = (torsions_of(positions, self._chi[:, k : k + 4]) for k in (0, 1))
        return _outside(Janin_ref, chi2 / CHI_GRID, chi1 / CHI_GRID)


class _Nearness:
    """Pairs four or more bonds apart that are nearer than the table or the start allows."""

    def __init__(self, structure: Structure, start: np.ndarray) -> None:
        self._kind = _kinds(structure)
        self._count = len(structure)
        bonds = np.asarray(structure.bonds, dtype=np.int64).reshape(-1, 2)
        self._bonded = within_three_bonds(bonds, self._count)
        pairs = self._close(start)
        self._own = dict(zip(self._codes(pairs).tolist(), _lengths(start, pairs), strict=True))

    def overlaps(self, positions: np.ndarray) -> np.ndarray:
        """By how much, Angstrom, of all pairs that are too near."""
        pairs = self._close(positions)
        table = LEAST[self._kind[pairs[:, 0]], self._kind[pairs[:, 1]]]
        own = np.array([self._own.get(code, np.inf) for code in self._codes(pairs).tolist()])
        deep: np.ndarray = np.minimum(table, own) - _lengths(positions, pairs)
        return deep

    def _close(self, positions: np.ndarray) -> np.ndarray:
        tree = cKDTree(positions)
        pairs = tree.query_pairs(float(LEAST.max()), output_type="ndarray").astype(np.int64)
        pairs = np.sort(pairs.reshape(-1, 2), axis=1)
        least = LEAST[self._kind[pairs[:, 0]], self._kind[pairs[:, 1]]]
        pairs = pairs[_lengths(positions, pairs) < least]
        far: np.ndarray = pairs[~np.isin(self._codes(pairs), self._bonded)]
        return far

    def _codes(self, pairs: np.ndarray) -> np.ndarray:
        codes: np.ndarray = pairs[:, 0] * self._count + pairs[:, 1]
        return codes


def _lengths(positions: np.ndarray, pairs: np.ndarray) -> np.ndarray:
    lengths: np.ndarray = np.linalg.norm(positions[pairs[:, 0]] - positions[pairs[:, 1]], axis=1)
    return lengths


def _kinds(structure: Structure) -> np.ndarray:
    elements = np.asarray(structure.elements)
    kind = [LIKE.get(int(element), "M") for element in elements]
    for a, b in np.asarray(structure.bonds, dtype=np.int64).reshape(-1, 2):
        for hydrogen, parent in ((a, b), (b, a)):
            if elements[hydrogen] == 1 and elements[parent] == 6:
                kind[hydrogen] = "HC"
            elif elements[hydrogen] == 1:
                kind[parent] = WITH_HYDROGEN.get(int(elements[parent]), kind[parent])
    return np.array([KINDS.index(name) for name in kind])


def _centres(structure: Structure, neighbours: list[list[int]], start: np.ndarray) -> np.ndarray:
    """Rows of a carbon and three heavy neighbours that are not in a plane with it."""
    elements = structure.elements
    rows = []
    for atom in np.flatnonzero(elements == 6).tolist():
        heavy = sorted(other for other in neighbours[atom] if elements[other] > 1)
        if len(heavy) >= 3:
            rows.append([atom, *heavy[:3]])
    table = np.array(rows, dtype=np.int64).reshape(-1, 4)
    kept: np.ndarray = table[np.abs(_volumes(start, table)) > LEAST_VOLUME]
    return kept


def _volumes(positions: np.ndarray, centres: np.ndarray) -> np.ndarray:
    a, b, c = (positions[centres[:, k]] - positions[centres[:, 0]] for k in (1, 2, 3))
    volumes: np.ndarray = np.einsum("ni,ni->n", a, np.cross(b, c))
    return volumes


def _omegas(links: list[tuple[int, ...]]) -> np.ndarray:
    return np.array(links, dtype=np.int64).reshape(-1, 4)


def _chis(structure: Structure) -> np.ndarray:
    """Rows N, CA, CB, gamma, delta of side chains that have chi2, but not of proline."""
    found: dict[int, dict[str, int]] = {}
    # Once: each time that a structure is asked for a column, it makes all of it.
    columns = (structure.names, structure.residue_of, structure.residue_names)
    for atom, (name, residue, kind) in enumerate(zip(*columns, strict=True)):
        if str(kind) != "PRO":
            found.setdefault(int(residue), {})[str(name)] = atom
    rows = []
    for atoms in found.values():
        ends = [next((n for n in names if n in atoms), "") for names in (GAMMA, DELTA)]
        row = [atoms.get(name) for name in ("N", "CA", "CB", *ends)]
        if None not in row:
            rows.append(row)
    return np.array(rows, dtype=np.int64).reshape(-1, 5)


def _outside(reference: str, *places: np.ndarray) -> float:
    """Share of places on the grid of a density, which is periodic, outside its lowest contour."""
    density = map_coordinates(np.load(reference), places, order=1, mode="grid-wrap")
    return float((density < OUTLIER_LEVEL).mean())


def _apart(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    turn: np.ndarray = np.abs((a - b + 180.0) % 360.0 - 180.0)
    return turn
