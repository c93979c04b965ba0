# SPDX-License-Identifier: MIT
"""Under bars across angles planar groups keep their torsions, and centres their chirality."""

import numpy as np
import pytest
from nearness import MOLECULES, Case
from planarity import DIRECT, KINDS, change, changes, protein_cases, torsions

import pliant

#: At most so many degrees (KINDS); of techniques that only sweep, of all of them together.
LIMITS = {
    "auto units froda": (0.01, 0.01, 0.01, 0.01, 0.01),
    "newton shake": (0.17, 0.43, 0.01, 0.01, 0.01),
    "random bfs_cycle dfs_cycle bfs_reverse dfs_reverse bfs_adapt bfs_random input anderson": (
        (1.86, 3.19, 4.49, 7.05, 0.10)
    ),
    "blocks": (14.42, 4.75, 8.74, 15.31, 0.01),
}
MOST_CHANGE = 1.0  # degrees
NAMES = [row.name for row in pliant.techniques() if not row.forests_only]
SWEEPS = [name for name in NAMES if name not in (*DIRECT, "blocks")]
pytestmark = pytest.mark.filterwarnings("ignore::pliant.PliantWarning")


def limits() -> dict[str, dict[str, float]]:
    """The largest change of each kind, in degrees."""
    return {
        name: dict(zip(KINDS, row, strict=True))
        for names, row in LIMITS.items()
        for name in names.split()
    }


def check(name: str, most_joints: float = np.inf) -> None:
    """The changes on all proteins that are installed and not larger."""
    cases = [both for both in protein_cases() if len(both[0].positions) <= most_joints]
    if not cases:
        pytest.skip("MDAnalysisTests and Biopython's tests are not installed")
    for case, quadruples in cases:
        found = changes(case, quadruples, name)
        for kind in KINDS:
            assert found[kind] <= limits()[name][kind], (case.name, kind, found[kind])


def test_every_technique_has_limits_and_those_that_get_whole_stay_within_a_degree() -> None:
    assert set(limits()) == set(NAMES)
    for name in DIRECT:
        assert max(limits()[name].values()) <= MOST_CHANGE, name


def test_all_kinds_of_group_are_there() -> None:
    found = [quadruples for _, quadruples in protein_cases()]
    if len(found) < 4:
        pytest.skip("MDAnalysisTests or Biopython's tests are not installed")
    for quadruples in found:
        assert all(len(quadruples[kind]) > 0 for kind in KINDS)


@pytest.mark.parametrize("name", ["auto", "units"])
def test_units_hold_planar_groups_with_and_without_hydrogens(name: str) -> None:
    check(name)


@pytest.mark.parametrize("name", ["newton", "shake", "bfs_cycle"])
def test_what_knows_bars_alone_holds_planar_groups(name: str) -> None:
    check(name, 1000)


@pytest.mark.long
@pytest.mark.parametrize("name", NAMES)
def test_every_technique_stays_within_its_limits(name: str) -> None:
    check(name)


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


@pytest.mark.parametrize("name", DIRECT)
def test_planar_groups_hold_under_pushes_of_all_joints(name: str) -> None:
    cases = [both for both in protein_cases() if len(both[0].positions) < 1000]
    if not cases:
        pytest.skip("Biopython's tests are not installed")
    for case, quadruples in cases:
        after = pushed_often(case, name, 10)
        for kind, found in quadruples.items():
            turned = change(torsions(case.positions[found]), torsions(after[found]))
            assert turned <= MOST_CHANGE, (kind, turned)


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
    for technique in DIRECT:
        assert change(before, torsions(pushed_often(case, technique, 30)[quadruple])) <= 1.0
