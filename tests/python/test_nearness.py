# SPDX-License-Identifier: MIT
"""What is resolved stays near, and planar groups keep their torsions, on real files."""

from pathlib import Path

import numpy as np
import pytest
from nearness import MOLECULES, Case, cases_of, largest_growth, large_files, without_hydrogens

import pliant

FILES = sorted(MOLECULES.iterdir())
MOST_GROWTH = 20.0
DIRECT = ["auto", "blocks", "newton", "shake", "units", "units_nearest"]
#: The page on methods says how far these go.
EXCEPTIONS: dict[tuple[str, str], float] = {}


def large_cases() -> list[Case]:
    pytest.importorskip("MDAnalysisTests", reason="its data hold AdK and 4E43")
    return [case for file in large_files() for case in cases_of(file)]


@pytest.mark.parametrize("file", FILES, ids=lambda file: file.name)
@pytest.mark.parametrize("technique", DIRECT)
def test_molecules_stay_near(file: Path, technique: str) -> None:
    for case in cases_of(file):
        found = largest_growth(case, technique)
        assert found <= EXCEPTIONS.get((technique, case.name), MOST_GROWTH), (case.name, found)


@pytest.mark.filterwarnings("ignore::pliant.PliantWarning")
@pytest.mark.parametrize("technique", ["auto", "units", "units_nearest"])
def test_proteins_stay_near_with_and_without_hydrogens(technique: str) -> None:
    for case in large_cases():
        assert largest_growth(case, technique) <= MOST_GROWTH, case.name


@pytest.mark.long
@pytest.mark.filterwarnings("ignore::pliant.PliantWarning")
@pytest.mark.parametrize("bars", ["bonds", "angles"])
@pytest.mark.parametrize("row", pliant.techniques(), ids=lambda row: row.name)
def test_every_technique_stays_near_on_every_file(row: pliant.TechniqueEntry, bars: str) -> None:
    pytest.importorskip("MDAnalysisTests", reason="its data hold AdK and 4E43")
    for file in [*FILES, *large_files()]:
        for case in cases_of(file, bars):
            if row.forests_only and not case.framework.graph_facts().is_forest:
                continue
            found = largest_growth(case, row.name, range(1), max_sweeps=200)
            allowed = EXCEPTIONS.get((row.name, case.name), MOST_GROWTH)
            assert found <= allowed, (case.name, found)


def torsions(points: np.ndarray) -> np.ndarray:
    """Of (M, 4, 3) points, in degrees."""
    along = np.diff(points, axis=1)
    left = np.cross(along[:, 0], along[:, 1])
    right = np.cross(along[:, 1], along[:, 2])
    axis = along[:, 1] / np.linalg.norm(along[:, 1], axis=1)[:, None]
    sine = np.einsum("ij,ij->i", np.cross(left, right), axis)
    return np.degrees(np.arctan2(sine, np.einsum("ij,ij->i", left, right)))


def planar_quadruples(structure: pliant.Structure) -> np.ndarray:
    """(M, 4) heavy atoms about peptide bonds, and of guanidinium and of aromatic rings."""
    names = [name.strip() for name in structure.names]
    around: dict[int, list[int]] = {}
    for a, b in np.asarray(structure.bonds).tolist():
        around.setdefault(a, []).append(b)
        around.setdefault(b, []).append(a)
    wanted = {("CA", "C", "N", "CA"), ("CD", "NE", "CZ", "NH1"), ("CB", "CG", "CD1", "CE1")}
    return np.array(
        [
            (a, b, c, d)
            for b in around
            for c in around[b]
            for a in around[b]
            for d in around[c]
            if (names[a], names[b], names[c], names[d]) in wanted and len({a, b, c, d}) == 4
        ]
    )


def change(before: np.ndarray, after: np.ndarray) -> float:
    """The largest change of an angle, in degrees."""
    return float(np.abs((after - before + 180) % 360 - 180).max())


def pushed_often(case: Case, technique: str, steps: int) -> np.ndarray:
    """Where the joints are after pushes of one and of all, in turn."""
    random = np.random.default_rng(5)
    resolver = pliant.Resolver(case.framework, technique=technique)
    here = case.positions.copy()
    for step in range(steps):
        before = here.copy()
        if step % 2:
            here[random.integers(len(here))] += random.normal(size=3) * 0.03
        else:
            here += random.normal(size=here.shape) * 0.03
        assert resolver.resolve(here, reference=before).converged
    return here


@pytest.mark.filterwarnings("ignore::pliant.PliantWarning")
@pytest.mark.parametrize("hydrogens", [True, False])
@pytest.mark.parametrize("technique", ["auto", "units_nearest", "newton"])
def test_planar_groups_keep_their_torsions(technique: str, hydrogens: bool) -> None:
    pytest.importorskip("MDAnalysisTests", reason="its data hold AdK")
    file = next(large_files())
    structure = pliant.read(str(file))
    structure.perceive_bonds()
    quadruples = planar_quadruples(structure)
    assert len(quadruples) > 213
    case = Case(file.name, structure.framework(bars="angles"), structure.positions.copy())
    if not hydrogens:
        case = without_hydrogens(file.name, case.framework, structure)
        quadruples = (np.cumsum(structure.elements != 1) - 1)[quadruples]
    before = torsions(case.positions[quadruples])
    steps = 6 if technique == "newton" else 50
    after = torsions(pushed_often(case, technique, steps)[quadruples])
    if technique == "newton":  # lengths alone do not tell a group from its mirror image
        before, after = np.abs(before), np.abs(after)
    assert change(before, after) <= 1.0


def test_a_cis_peptide_bond_stays_cis() -> None:
    structure = pliant.read(str(MOLECULES / "alanine_dipeptide.pdb"))
    structure.perceive_bonds()
    names = [name.strip() for name in structure.names]
    bonds = [(int(a), int(b)) for a, b in np.asarray(structure.bonds)]
    c, n = next((a, b) for a, b in bonds if {names[a], names[b]} == {"C", "N"})
    ends = [x for pair in bonds for x in pair if c in pair and x not in (c, n)]
    beyond = sorted({y for a, b in bonds for x, y in ((a, b), (b, a)) if x == n and y != c})
    assert ends and beyond
    behind, todo = {n}, [n]
    while todo:
        here = todo.pop()
        for a, b in bonds:
            for x, y in ((a, b), (b, a)):
                if x == here and y != c and y not in behind:
                    behind.add(y)
                    todo.append(y)
    turned = structure.positions.copy()
    axis = turned[n] - turned[c]
    axis /= np.linalg.norm(axis)
    for atom in behind:  # half a turn about the peptide bond
        offset = turned[atom] - turned[c]
        turned[atom] = turned[c] + 2 * axis * (axis @ offset) - offset
    structure.positions[:] = turned
    quadruple = np.array([[ends[0], c, n, beyond[-1]]])
    before = torsions(turned[quadruple])
    case = Case("cis", structure.framework(bars="angles"), turned)
    for technique in ("auto", "units_nearest"):
        assert change(before, torsions(pushed_often(case, technique, 30)[quadruple])) <= 1.0
