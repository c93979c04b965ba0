# SPDX-License-Identifier: MIT
"""Side chains built by rule, against the crystal structure from which they were taken."""

from contextlib import nullcontext
from pathlib import Path

import expected_warnings
import numpy as np
import pytest

import pliant

pytest.importorskip("MDAnalysisTests")
import MDAnalysisTests

OPEN = Path(MDAnalysisTests.__file__).parent / "data" / "adk_open.pdb"  # all hydrogens
BACKBONE = ("N", "CA", "C", "O")
ROUNDED = {"OT1", "OT2", "CD"}  # ends of the chain; CHARMM's name for CD1 of ILE


def atoms_of(structure):
    """{residue: {name: atom}} of the heavy atoms."""
    table = {}
    for atom, name in enumerate(structure.names):
        if structure.elements[atom] > 1:
            table.setdefault(int(structure.residue_ids[atom]), {})[str(name)] = atom
    return table


def without(tmp_path, is_out):
    """AdK without the atoms for which is_out(residue number, residue name, atom name)."""
    path = tmp_path / "part.pdb"
    rows = [line for line in OPEN.read_text().splitlines(keepends=True) if line.startswith("ATOM")]
    kept = [r for r in rows if not is_out(int(r[22:26]), r[17:20], r[12:16].strip())]
    path.write_text("".join(kept))
    return expected_warnings.read_without_elements(path)


def filled(structure, is_tight=True):
    overlaps = pytest.warns(pliant.PliantWarning, match="these overlap other atoms")
    with (
        overlaps if is_tight else nullcontext(),
        pytest.warns(pliant.PliantWarning, match="built by rule, which is a guess"),
    ):
        return pliant.prepare(structure, fill_side_chains=True, add_hydrogens=False)


@pytest.fixture(scope="module", params=["none", "CB"])
def rebuilt(request, tmp_path_factory):
    """The crystal's structure, and one of its backbone (and CB) with side chains built."""
    kept = (*BACKBONE, "CB") if request.param == "CB" else BACKBONE
    part = without(tmp_path_factory.mktemp("part"), lambda _, __, name: name not in kept)
    return expected_warnings.read_without_elements(OPEN), filled(part).structure


def test_no_atom_is_missing_and_none_moved(rebuilt):
    crystal, built = rebuilt
    theirs, ours = atoms_of(crystal), atoms_of(built)
    for residue, atoms in theirs.items():
        names = {"CD1" if name == "CD" and "CG1" in atoms else name for name in atoms}
        assert set(ours[residue]) | {"OT1", "OT2"} >= names
        for name in BACKBONE:
            if name in atoms:
                assert np.array_equal(
                    crystal.positions[atoms[name]], built.positions[ours[residue][name]]
                )


def test_bonds_are_those_of_the_crystal(rebuilt):
    crystal, built = rebuilt

    def named(structure):
        number = {a: (r, n) for r, atoms in atoms_of(structure).items() for n, a in atoms.items()}
        pairs = ((number.get(int(a)), number.get(int(b))) for a, b in structure.bonds[:, :2])
        joined = {frozenset(p) for p in pairs if None not in p}
        return {p for p in joined if not any(name in ROUNDED | {"CD1"} for _, name in p)}

    assert named(built) == named(crystal)


def means(crystal, built, measure, groups):
    """Mean of a measure over all residues of a kind, of the crystal and of what was built."""
    theirs, ours = atoms_of(crystal), atoms_of(built)
    found = {}
    for residue, atoms in ours.items():
        kind = str(built.residue_names[atoms["CA"]])
        for names in groups(atoms):
            if all(name in theirs[residue] for name in names):
                pair = [
                    measure(s.positions[[table[residue][name] for name in names]])
                    for s, table in ((crystal, theirs), (built, ours))
                ]
                found.setdefault((kind, names), []).append(pair)
    return {key: np.mean(pairs, axis=0) for key, pairs in found.items()}


def bonded(structure):
    joined = {}
    for a, b in structure.bonds[:, :2]:
        joined.setdefault(int(a), set()).add(int(b))
        joined.setdefault(int(b), set()).add(int(a))
    return joined


def angle(points):
    one, other = points[0] - points[1], points[2] - points[1]
    return np.degrees(np.arccos(one @ other / np.linalg.norm(one) / np.linalg.norm(other)))


def handedness(points):
    return np.linalg.det(points[1:] - points[0])


def test_angles_are_those_of_the_crystal(rebuilt):
    """The means of a kind of residue: single angles of a crystal spread by two degrees."""
    crystal, built = rebuilt
    joined = bonded(built)

    def groups(atoms):
        names = {atom: name for name, atom in atoms.items()}
        for name, atom in atoms.items():
            ends = sorted(names[k] for k in joined[atom] if k in names)
            for k, one in enumerate(ends):
                for other in ends[k + 1 :]:
                    yield one, name, other

    compared = means(crystal, built, angle, groups)
    assert len(compared) > 150
    worst = max(compared, key=lambda key: abs(np.subtract(*compared[key])))
    assert abs(np.subtract(*compared[worst])) < 4.5, (worst, compared[worst])


def test_chirality_is_that_of_the_crystal(rebuilt):
    crystal, built = rebuilt
    centres = {"THR": ("CB", "CA", "OG1", "CG2"), "ILE": ("CB", "CA", "CG1", "CG2")}
    named = {"VAL": ("CB", "CA", "CG1", "CG2"), "LEU": ("CG", "CB", "CD1", "CD2")}
    for kind, names in (centres | named).items():
        theirs, ours = atoms_of(crystal), atoms_of(built)
        for residue, atoms in ours.items():
            if built.residue_names[atoms["CA"]] != kind:
                continue
            one = handedness(crystal.positions[[theirs[residue][name] for name in names]])
            other = handedness(built.positions[[atoms[name] for name in names]])
            assert one * other > 0, (kind, residue)


def test_most_first_torsions_are_those_of_the_crystal(rebuilt):
    """By chance a third would be; nothing of the crystal but its backbone was known."""
    from MDAnalysis.lib.distances import calc_dihedrals

    crystal, built = rebuilt
    theirs, ours = atoms_of(crystal), atoms_of(built)
    near = []
    for residue, atoms in ours.items():
        last = next((n for n in ("CG", "CG1", "OG", "OG1", "SG") if n in atoms), None)
        if last is None:
            continue
        names = ("N", "CA", "CB", last)
        chi = [
            calc_dihedrals(*s.positions[[table[residue][n] for n in names]].astype(np.float32))
            for s, table in ((crystal, theirs), (built, ours))
        ]
        near.append(abs((chi[0] - chi[1] + np.pi) % (2 * np.pi) - np.pi) < np.radians(40))
    assert np.mean(near) > 0.65


def test_an_atom_is_placed_by_the_one_beside_it(tmp_path):
    """THR's OG1 by its CG2, and what lies beyond PHE's CG by the torsion that is there."""
    crystal = expected_warnings.read_without_elements(OPEN)
    part = without(
        tmp_path,
        lambda residue, kind, name: (
            (kind == "THR" and name in ("OG1", "HG1"))
            or (residue == 86 and name in ("CE1", "CE2", "CZ", "HE1", "HE2", "HZ"))
        ),
    )
    built = filled(part, is_tight=False).structure
    theirs, ours = atoms_of(crystal), atoms_of(built)
    off = [
        np.linalg.norm(built.positions[atoms[name]] - crystal.positions[theirs[residue][name]])
        for residue, atoms in ours.items()
        for name in ("OG1", "CE1", "CZ")
        if name in atoms and (name == "OG1" or residue == 86)
    ]
    assert len(off) > 8
    assert max(off) < 0.3  # 4 degrees, 1.4 Angstrom away; more where three angles add up


def test_what_cannot_be_built_is_left_and_reported(tmp_path):
    """No CA; an atom missing amid others."""
    part = without(
        tmp_path,
        lambda residue, _, name: (
            (residue == 13 and name in ("CA", "CB", "CG")) or (residue == 36 and name == "CD")
        ),
    )
    with (
        pytest.warns(pliant.PliantWarning, match=r"lack atoms: LYS13 \(CB CG\), ARG36 \(CD\)"),
        pytest.warns(pliant.PliantWarning, match="cannot be built"),
    ):
        prepared = pliant.prepare(part, fill_side_chains=True)
    assert [line for line in prepared.missing if "LYS13" in line and "ARG36" in line]


def test_ensembles_of_what_was_built(tmp_path):
    part = without(tmp_path, lambda _, __, name: name not in BACKBONE)
    with pytest.warns(pliant.PliantWarning):
        model = pliant.build_model(part, fill_side_chains=True)
    ensemble = pliant.sample(model, 3)
    assert len(ensemble.positions) == 3
    assert ensemble.max_residual < 1e-10
