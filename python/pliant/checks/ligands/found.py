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
OXYGEN = 8
Atoms = npt.NDArray[np.int64]


@dataclass(frozen=True)
class Ligand:
    """A molecule of a structure with its parameters."""

    label: str  #: "A:XK2263"
    atoms: Atoms  #: (G,) of the structure
    chemistry: Chemistry
    parameters: Parameters

    @property
    def names(self) -> list[str]:
        """Of all its atoms; "H" of hydrogens that were added."""
        known = [one.GetPDBResidueInfo() for one in self.chemistry.molecule.GetAtoms()]
        return [one.GetName().strip() if one else "H" for one in known]

    @property
    def said(self) -> str:
        """What it was taken for."""
        chemistry = self.chemistry
        return (
            f"{self.label}: GAFF2, charge {chemistry.charge:+d}, {chemistry.smiles}: "
            f"{chemistry.source}"
        )


@dataclass
class Others:
    """What a structure has beside residues of proteins."""

    ligands: list[Ligand] = field(default_factory=list)
    ions: Atoms = field(default_factory=lambda: np.empty(0, np.int64))
    refused: dict[str, str] = field(default_factory=dict)  #: why, by label


def others_of(
    structure: Structure, known: npt.NDArray[np.bool_], options: ForceFieldOptions,
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
    inside = np.isin(structure.bonds, atoms)
    if len(across := structure.bonds[inside.sum(axis=1) == 1]):
        end = next(int(k) for k in across[0] if k not in atoms)
        raise InputError(f"is bonded to {structure.label(end)}, which GAFF2 alone cannot describe")
    part = part_of(structure, atoms, structure.bonds[inside.all(axis=1)])
    chemistry = chemistry_of(part, label, options.ligands)
    parameters = parameters_of(chemistry.molecule, options.charges, label, say)
    return Ligand(label, atoms, chemistry, parameters)


def part_of(structure: Structure, atoms: Atoms, bonds: npt.NDArray[np.uint32]) -> Structure:
    """Atoms of a structure, with these of its bonds."""
    new = np.full(len(structure), -1)
    new[atoms] = np.arange(len(atoms))
    orders = {tuple(two): one for two, one in zip(structure.bonds.tolist(), structure.bond_orders.tolist(), strict=True)}
    return Structure(
        structure.positions[atoms],
        elements=structure.elements[atoms],
        names=structure.names[atoms].tolist(),
        residue_names=structure.residue_names[atoms].tolist(),
        residue_ids=structure.residue_ids[atoms],
        bonds=new[bonds],
        bond_orders=[orders[tuple(two)] for two in bonds.tolist()],
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
