# SPDX-License-Identifier: MIT
"""Prints the table of side-chain torsions that src/pliant/sample/pocket/rotamer_table.cpp holds, by
a count over the proteins of known structure in MDAnalysisTests.

Usage: .venv/bin/python data/count_rotamers.py
"""

from __future__ import annotations

import math
from collections import Counter, defaultdict
from collections.abc import Iterator
from pathlib import Path

import gemmi
import MDAnalysisTests

FILES = (
    "19hc.pdb.gz 1a28.pdb.gz 1hvr.pdb 1osm.pdb.gz 4E43.pdb 4x8u.pdbx 5a7u.pdb 6msm.pdb.bz2 "
    "adk_closed.pdb adk_open.pdb cobrotoxin.pdb merge/2zmm/protein.pdb mmcif/1BD2.cif.gz "
    "mmcif/3KPR.cif.gz mmcif/3PWP.cif.gz mmcif/5PTI.cif.gz mmcif/7ETN.cif.gz"
).split()
LARGEST_B = 60.0  #: of atoms that are counted, Angstrom^2
LEAST = 0.02  #: share of the rarest state that is kept

#: atoms after N CA CB along each side chain
CHAINS = {
    "ARG": "CG CD NE CZ", "ASN": "CG OD1", "ASP": "CG OD1", "CYS": "SG", "GLN": "CG CD OE1",
    "GLU": "CG CD OE1", "HIS": "CG ND1", "ILE": "CG1 CD1", "LEU": "CG CD1", "LYS": "CG CD CE NZ",
    "MET": "CG SD CE", "PHE": "CG CD1", "SER": "OG", "THR": "OG1", "TRP": "CG CD1", "TYR": "CG CD1",
    "VAL": "CG1",
}  # fmt: skip
#: residues whose last torsion is about the bond to a planar group
PLANAR = {"ASN", "ASP", "GLN", "GLU", "HIS", "PHE", "TRP", "TYR"}
#: those whose planar group looks the same after half a turn
HALF_TURNS = {"ASP", "GLU", "PHE", "TYR"}


def torsions_of(residue: gemmi.Residue) -> list[float] | None:
    """In degrees; none if atoms lack or are not well known."""
    atoms = []
    for name in ["N", "CA", "CB", *CHAINS[residue.name].split()]:
        if name not in residue or residue[name][0].b_iso > LARGEST_B:
            return None
        atoms.append(residue[name][0].pos)
    fours = zip(atoms, atoms[1:], atoms[2:], atoms[3:], strict=False)
    return [math.degrees(gemmi.calculate_dihedral(*four)) for four in fours]


def state_of(residue: str, torsion: float, is_last: bool) -> int:
    """60, 180 or 300 between tetrahedral atoms, else the nearest multiple of 30 degrees."""
    if not (is_last and residue in PLANAR):
        return 60 + 120 * int(torsion % 360 // 120)
    return 30 * round(torsion / 30) % (180 if residue in HALF_TURNS else 360)


def residues() -> Iterator[gemmi.Residue]:
    """Of the first models; further conformers of an atom are left out."""
    for file in FILES:
        path = Path(MDAnalysisTests.__file__).parent / "data" / file
        if path.suffix == ".bz2":
            import bz2

            with bz2.open(path, "rt") as opened:
                structure = gemmi.read_pdb_string(opened.read())
        elif path.suffix == ".pdbx":
            structure = gemmi.read_structure(str(path), format=gemmi.CoorFormat.Mmcif)
        else:
            structure = gemmi.read_structure(str(path))
        yield from (residue for chain in structure[0] for residue in chain)


def main() -> None:
    """Prints one row a state: residue, first torsion, states of it and the next, share."""
    counts: dict[tuple[str, int], Counter[tuple[int, ...]]] = defaultdict(Counter)
    for residue in residues():
        torsions = torsions_of(residue) if residue.name in CHAINS else None
        if torsions is None:
            continue
        last = len(torsions) - 1
        states = [state_of(residue.name, x, k == last) for k, x in enumerate(torsions)]
        counts[residue.name, 0][tuple(states[:2])] += 1
        for k in range(2, len(states)):
            counts[residue.name, k][(states[k],)] += 1
    for (name, first), found in sorted(counts.items()):
        print(f"    // {name} {found.total()}")
        for states, count in sorted(found.items()):
            if count >= LEAST * found.total():
                both = ", ".join(map(str, states))
                print(f'    {{"{name}", {first}, {{{both}}}, {100 * count / found.total():.0f}}},')


if __name__ == "__main__":
    main()
