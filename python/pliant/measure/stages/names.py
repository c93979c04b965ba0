# SPDX-License-Identifier: MIT
"""What atoms, bars and residues are called in figures and tables."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

import numpy as np

from pliant.trajectory.chains import chain_of

if TYPE_CHECKING:
    from MDAnalysis import AtomGroup
    from MDAnalysis.core.groups import ResidueGroup

    from pliant.measure.rotatable import Torsion


def atom_labels(atoms: AtomGroup) -> list[str]:
    """Names of atoms: "C4" in a single residue, "A:LYS12:CA" among several."""
    names = [str(name) for name in getattr(atoms, "names", atoms.ix)]
    if len(atoms.universe.residues) == 1:
        return names
    places = residue_labels(atoms.universe.residues)
    return [f"{places[r]}:{n}" for r, n in zip(atoms.resindices, names, strict=True)]


def residue_labels(residues: ResidueGroup) -> list[str]:
    """Names of residues: "A:LYS12", or "LYS12" where there is one chain."""
    chains = chains_of(residues)
    several = len(set(chains)) > 1
    names = getattr(residues, "resnames", [""] * len(residues))
    return [
        (f"{chain}:" if several and chain else "") + f"{name}{number}{code}"
        for chain, name, number, code in zip(
            chains, names, numbers_of(residues), codes_of(residues), strict=True
        )
    ]


def chains_of(residues: AtomGroup | ResidueGroup) -> np.ndarray:
    """Chain of each residue as an array of text; "" where there is none."""
    return np.array([chain_of(s) for s in getattr(residues, "segids", [""] * len(residues))])


def numbers_of(group: AtomGroup | ResidueGroup) -> np.ndarray:
    """Residue numbers of residues or atoms; counted from 1 where there are none."""
    return np.asarray(getattr(group, "resids", group.resindices + 1), dtype=np.int64)


def codes_of(group: AtomGroup | ResidueGroup) -> list[str]:
    """Insertion codes of residues or atoms; "" where there are none."""
    return [str(code).strip() for code in getattr(group, "icodes", [""] * len(group))]


def bar_labels(atoms: AtomGroup, bars: Iterable[np.ndarray]) -> list[str]:
    """Names of bars: the names of both atoms."""
    names = atom_labels(atoms)
    return [f"{names[a]} – {names[b]}" for a, b in bars]


def greek(label: str) -> str:
    """The label of a torsion with Greek letters: "LYS12 chi1" becomes "LYS12 χ1"."""
    for name, letter in {" phi": " φ", " psi": " ψ", " omega": " ω", " chi": " χ"}.items():
        label = label.replace(name, letter)
    return label


def phi_psi_pairs(torsions: Sequence[Torsion]) -> tuple[list[int], list[int]]:
    """Numbers of the phi and of the psi torsions of the residues that have both."""
    phi = {t.residue: k for k, t in enumerate(torsions) if t.kind == "phi"}
    psi = {t.residue: k for k, t in enumerate(torsions) if t.kind == "psi"}
    both = sorted(phi.keys() & psi.keys())
    return [phi[r] for r in both], [psi[r] for r in both]


def has_backbone(torsions: Sequence[Torsion]) -> bool:
    """Whether at least two residues have both phi and psi."""
    return len(phi_psi_pairs(torsions)[0]) > 1
