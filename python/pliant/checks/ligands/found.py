# SPDX-License-Identifier: MIT
"""Which parts of a structure are ligands, ions, waters; those that can be had with parameters."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np
import numpy.typing as npt

from pliant._core import InputError, Structure
from pliant.base.extras import MissingPackageError
from pliant.base.force_field_options import ForceFieldOptions
from pliant.checks.ligands.chemistry import Chemistry, chemistry_of
from pliant.checks.ligands.parameters import Parameters, parameters_of

#: elements of ions that OpenMM's amber14 files have, by name of their template
IONS = {11: "NA", 12: "MG", 17: "CL", 19: "K", 20: "CA", 30: "ZN"}
#: of a residue in a chain: atoms that must be there, one of each
BACKBONE = ("N", "H", "CA", "C", "O")
#: atoms of the neighbours of a residue that stand for them, by the residue's atom at the bond
CAPS = {"N": ("C", "O", "CA"), "C": ("N", "H", "CA")}
OXYGEN = 8
Atoms = npt.NDArray[np.int64]


@dataclass(frozen=True)
class Ligand:
    """A molecule of a structure, or a modified residue of a chain, with its parameters.

    The chemistry of a residue has caps: C, O and CA of the residue before it, N, H and CA of that
    after it. Caps are no atoms of the ligand.
    """

    label: str  #: "A:XK2263"
    atoms: Atoms  #: (G,) of the structure
    caps: Atoms  #: (K,) of the structure; none of a molecule
    chemistry: Chemistry  #: of atoms, caps, and hydrogens that were added
    parameters: Parameters

    @property
    def own(self) -> Atoms:
        """(L,) atoms of the chemistry but caps and their hydrogens."""
        given, own = self.chemistry.given, len(self.atoms)
        added = [*self.chemistry.molecule.GetAtoms()][given:]
        carriers = [one.GetNeighbors()[0].GetIdx() for one in added]
        more = [given + k for k, carrier in enumerate(carriers) if carrier < own]
        return np.array([*range(own), *more], np.int64)

    @property
    def names(self) -> list[str]:
        """(L,) of its atoms; "H" of hydrogens that were added."""
        known = [one.GetPDBResidueInfo() for one in self.chemistry.molecule.GetAtoms()]
        return [known[k].GetName().strip() if known[k] else "H" for k in self.own]

    def complete(self, positions: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
        """(L, 3) of positions (N, 3) of the structure."""
        given = positions[np.concatenate([self.atoms, self.caps])]
        return self.chemistry.complete(given)[self.own]

    @property
    def said(self) -> str:
        """What it was taken for."""
        chemistry, capped = self.chemistry, " (capped)" if len(self.caps) else ""
        return (
            f"{self.label}: GAFF2, charge {chemistry.charge:+d}, {chemistry.smiles}{capped}: "
            f"{chemistry.source}"
        )


@dataclass
class Others:
    """What a structure has beside residues of proteins."""

    ligands: list[Ligand] = field(default_factory=list)
    ions: Atoms = field(default_factory=lambda: np.empty(0, np.int64))
    refused: dict[str, str] = field(default_factory=dict)  #: why, by label


def others_of(
    structure: Structure,
    known: npt.NDArray[np.bool_],
    options: ForceFieldOptions,
    say: Callable[[str], None],
) -> Others:
    """All atoms but those that are `known` (N,)."""
    found, ions, labels = Others(), [], Counter[str]()
    for atoms in parts(structure, ~known):
        (label,) = residue_labels(structure, atoms[:1])
        labels[label] += 1
        label += f"#{labels[label]}" * (labels[label] > 1)
        elements = structure.elements[atoms]
        if len(atoms) == 1 and int(elements[0]) in IONS:
            ions.append(int(atoms[0]))
        elif _is_water(elements):
            found.refused[label] = "implicit water stands for it"
        else:
            try:
                found.ligands.append(_ligand(structure, atoms, known, label, options, say))
            except (InputError, MissingPackageError) as error:
                found.refused[label] = str(error).removeprefix(f"{label}: ")
    found.ions = np.array(ions, np.int64)
    return found


def parts(structure: Structure, chosen: npt.NDArray[np.bool_]) -> list[Atoms]:
    """Atoms of molecules among those that are `chosen` (N,); residues stay whole."""
    residue_of = structure.residue_of.astype(np.int64)
    group = np.unique(residue_of, return_inverse=True)[1]
    for a, b in structure.bonds[chosen[structure.bonds].all(axis=1)].tolist():
        if group[a] != group[b]:
            group[group == group[b]] = group[a]
    return [np.flatnonzero(chosen & (group == one)) for one in dict.fromkeys(group[chosen])]


def _is_water(elements: npt.NDArray[np.uint8]) -> bool:
    return sorted(elements.tolist()) in ([OXYGEN], [1, OXYGEN], [1, 1, OXYGEN])


def _ligand(
    structure: Structure,
    atoms: Atoms,
    known: npt.NDArray[np.bool_],
    label: str,
    options: ForceFieldOptions,
    say: Callable[[str], None],
) -> Ligand:
    """Raises InputError or MissingPackageError."""
    if options.charges == "none":
        raise InputError("left out by --charges none")
    caps = _caps(structure, atoms, known)
    part = part_of(structure, np.concatenate([atoms, caps]))
    chemistry = chemistry_of(part, label, options.ligands, is_capped=len(caps) > 0)
    parameters = parameters_of(chemistry.molecule, options.charges, label, say)
    return Ligand(label, atoms, caps, chemistry, parameters)


def _caps(structure: Structure, atoms: Atoms, known: npt.NDArray[np.bool_]) -> Atoms:
    """Of a residue within a chain; none of a molecule.

    Raises InputError for what is bonded to a protein in another way.
    """
    names = structure.names
    inside = np.isin(structure.bonds, atoms)
    across = structure.bonds[inside.sum(axis=1) == 1].astype(np.int64)
    ends = {
        str(names[a if a in atoms else b]): int(b if a in atoms else a) for a, b in across.tolist()
    }
    if not ends:
        return np.empty(0, np.int64)
    own = names[atoms].tolist()
    is_residue = all(own.count(name) == 1 for name in BACKBONE)
    if not is_residue or {*ends} != {*CAPS} or len(across) != len(CAPS):
        end = next(iter(ends.values()))
        raise InputError(f"is bonded to {structure.label(end)}: neither a residue nor a molecule")
    caps = []
    for name, wanted in CAPS.items():
        if not known[ends[name]]:
            raise InputError(f"is bonded to {structure.label(ends[name])}, which is left out")
        beside = np.flatnonzero(structure.residue_of == structure.residue_of[ends[name]])
        caps += [int(k) for k in beside if names[k] in wanted]
    return np.array(caps, np.int64)


def part_of(structure: Structure, atoms: Atoms) -> Structure:
    """Atoms of a structure, in this sequence, with the bonds between them."""
    new = np.full(len(structure), -1)
    new[atoms] = np.arange(len(atoms))
    chosen = (new[structure.bonds] >= 0).all(axis=1)
    return Structure(
        structure.positions[atoms],
        elements=structure.elements[atoms],
        names=structure.names[atoms].tolist(),
        residue_names=structure.residue_names[atoms].tolist(),
        residue_ids=structure.residue_ids[atoms],
        bonds=new[structure.bonds[chosen]],
        bond_orders=structure.bond_orders[chosen],
        charges=structure.charges[atoms] if len(structure.charges) else None,
    )


def residue_labels(structure: Structure, atoms: Atoms) -> list[str]:
    """ "A:LYS45", of the residue of each atom."""
    columns = (
        structure.chains,
        structure.residue_names,
        structure.residue_ids,
        structure.insertion_codes,
    )
    return [
        f"{chain.strip()}:" * bool(chain.strip()) + f"{name}{f'{number}{code}'.strip()}"
        for chain, name, number, code in zip(*(one[atoms] for one in columns), strict=True)
    ]
