# SPDX-License-Identifier: MIT
"""Scripts called as AmberTools' programs are, and the AMBER topology of a molecule, for tests."""

import stat

import numpy as np

LEAP = "(UNKNOWN ATOM TYPE) AMBER General Force Field for organic molecules (Version 9.9, test)"


def prmtop(symbols, charges, bonds, angles):
    """A topology of a molecule without torsions, whose terms are alike; charges in e."""
    count, pairs = len(symbols), [{*two} for two in bonds]
    near = [
        sorted(
            {*[a for a, _, b in angles if b == k], *[b for a, _, b in angles if a == k]}
            | {next(iter(two - {k})) for two in pairs if k in two}
        )
        for k in range(count)
    ]
    after = [[j + 1 for j in one if j > k] or [0] for k, one in enumerate(near)]
    is_light = ["H" in (symbols[a], symbols[b]) for a, b in bonds]
    assert all(is_light)
    pointers = [count, 1, len(bonds), 0, len(angles), 0, 0, 0, 0, 0, sum(map(len, after)), 1]
    pointers += [0, 0, 0, 1, 1, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, count, 0, 0]
    sections = _of_atoms(symbols, charges, after, pointers) | _of_terms(bonds, angles)
    text = "%VERSION  VERSION_STAMP = V0001.000\n"
    for name, (form, values) in sections.items():
        text += f"%FLAG {name}\n%FORMAT({form})\n" + _lines(form, values)
    return text


def _of_atoms(symbols, charges, after, pointers):
    count = len(symbols)
    numbers = {"H": (1, 1.008), "C": (6, 12.01)}
    return {
        "TITLE": ("20a4", ["LIG"]),
        "POINTERS": ("10I8", pointers),
        "ATOM_NAME": ("20a4", [f"{s}{k}" for k, s in enumerate(symbols)]),
        "CHARGE": ("5E16.8", 18.2223 * np.array(charges)),
        "ATOMIC_NUMBER": ("10I8", [numbers[s][0] for s in symbols]),
        "MASS": ("5E16.8", [numbers[s][1] for s in symbols]),
        "ATOM_TYPE_INDEX": ("10I8", [1] * count),
        "NUMBER_EXCLUDED_ATOMS": ("10I8", [len(one) for one in after]),
        "NONBONDED_PARM_INDEX": ("10I8", [1]),
        "RESIDUE_LABEL": ("20a4", ["LIG"]),
        "RESIDUE_POINTER": ("10I8", [1]),
        "EXCLUDED_ATOMS_LIST": ("10I8", [j for one in after for j in one]),
        "HBOND_ACOEF": ("5E16.8", []),
        "HBOND_BCOEF": ("5E16.8", []),
        "AMBER_ATOM_TYPE": ("20a4", ["c3" if s == "C" else "hc" for s in symbols]),
        "RADII": ("5E16.8", [1.5] * count),
        "SCREEN": ("5E16.8", [0.8] * count),
    }  # fmt: skip


def _of_terms(bonds, angles):
    return {
        "BOND_FORCE_CONSTANT": ("5E16.8", [340.0]),
        "BOND_EQUIL_VALUE": ("5E16.8", [1.09]),
        "ANGLE_FORCE_CONSTANT": ("5E16.8", [39.0]),
        "ANGLE_EQUIL_VALUE": ("5E16.8", [1.91]),
        **{name: ("5E16.8", []) for name in (
            "DIHEDRAL_FORCE_CONSTANT", "DIHEDRAL_PERIODICITY", "DIHEDRAL_PHASE",
            "SCEE_SCALE_FACTOR", "SCNB_SCALE_FACTOR", "SOLTY")},
        "LENNARD_JONES_ACOEF": ("5E16.8", [1e5]),
        "LENNARD_JONES_BCOEF": ("5E16.8", [1e2]),
        "BONDS_INC_HYDROGEN": ("10I8", [n for a, b in bonds for n in (3 * a, 3 * b, 1)]),
        "BONDS_WITHOUT_HYDROGEN": ("10I8", []),
        "ANGLES_INC_HYDROGEN": ("10I8", [n for t in angles for n in (*(3 * k for k in t), 1)]),
        "ANGLES_WITHOUT_HYDROGEN": ("10I8", []),
        "DIHEDRALS_INC_HYDROGEN": ("10I8", []),
        "DIHEDRALS_WITHOUT_HYDROGEN": ("10I8", []),
    }  # fmt: skip


def _lines(form, values):
    kinds = {"20a4": (20, "{:<4}"), "10I8": (10, "{:8d}"), "5E16.8": (5, "{:16.8E}")}
    width, one = kinds[form]
    cells = [one.format(value) for value in values]
    rows = ["".join(cells[k : k + width]) for k in range(0, len(cells), width)]
    return "\n".join(rows or [""]) + "\n"


def methane():
    """Its topology, atoms in the sequence of its SMILES with hydrogens: [H]C([H])([H])[H]."""
    hydrogens = (0, 2, 3, 4)
    angles = [(a, 1, b) for a in hydrogens for b in hydrogens if a < b]
    charges = [0.1, -0.4, 0.1, 0.1, 0.1]
    return prmtop("HCHHH", charges, [(1, k) for k in hydrogens], angles)


def install(folder, topology="", **scripts):
    """Four programs; `scripts` are of those that do otherwise, None of one that is not there."""
    folder.mkdir(exist_ok=True)
    (folder / "stored.prmtop").write_text(topology)
    usual = {
        "antechamber": "echo made > ligand.mol2",
        "parmchk2": "echo made > ligand.frcmod",
        "sqm": "true",
        "tleap": f'echo "{LEAP}"; grep -q ligand "$2" && cp {folder}/stored.prmtop ligand.prmtop\n'
        f"echo $2 >> {folder}/calls",
    }
    for name, script in (usual | scripts).items():
        if script is not None:
            file = folder / name
            file.write_text(f"#!/bin/sh\n{script}\n")
            file.chmod(file.stat().st_mode | stat.S_IXUSR)
    return folder
