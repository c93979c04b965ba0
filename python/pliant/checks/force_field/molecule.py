# SPDX-License-Identifier: MIT
"""The part of a recorded molecule that the force field knows, with all its hydrogens."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np

from pliant._core import Structure
from pliant.base.force_field_options import ForceFieldOptions
from pliant.checks.force_field.hydrogens import RESIDUES, Missing, find_missing, hydrogen_counts
from pliant.checks.ligands.found import Ligand, Others, others_of, residue_labels

WITHOUT_LIGANDS = ForceFieldOptions("none")


@dataclass
class Molecule:
    """Atoms as OpenMM gets them: those kept and hydrogens that were missing, residue by residue.

    A ligand is one residue. Residues come in the sequence of the file.
    """

    kept: np.ndarray  #: (K,) atoms of the file that are of proteins, and ions
    missing: list[Missing]  #: hydrogens to place, in numbers of the file
    order: np.ndarray  #: (P,) of kept atoms followed by placed hydrogens, residue by residue
    elements: np.ndarray  #: (M,) atomic numbers
    names: np.ndarray  #: (M,) of atoms, "H" of placed hydrogens
    residue_of: np.ndarray  #: (M,)
    labels: list[str]  #: (R,) "A:LYS45"
    bonds: np.ndarray  #: (B, 2)
    firsts: list[int]  #: (R,) an atom of the file in each residue
    of_file: np.ndarray  #: (N,) the completed atom that each of the file is, -1 of those left out
    sequence: np.ndarray  #: (M,) of atoms of proteins, then of each ligand: as they come
    ligands: list[Ligand] = field(default_factory=list)
    left_out: dict[str, int] = field(default_factory=dict)  #: residues without a template, by name
    why: dict[str, str] = field(default_factory=dict)  #: these were left out, by label
    notes: list[str] = field(default_factory=list)

    @property
    def placed(self) -> int:
        """Hydrogens that the file has not."""
        given = len(self.kept) + sum(len(one.atoms) for one in self.ligands)
        return len(self.elements) - given

    @property
    def whole_ligands(self) -> list[Ligand]:
        """Those that are molecules, not residues of a chain."""
        return [one for one in self.ligands if not len(one.caps)]

    @property
    def alpha_carbons(self) -> np.ndarray:
        """(A,) of the completed atoms."""
        return np.flatnonzero((self.names == "CA") & (self.elements == 6))

    def complete(self, positions: np.ndarray) -> np.ndarray:
        """(M, 3) of a frame (N, 3) of the file, Angstrom."""
        placed = [group.place(positions).reshape(-1, 3) for group in self.missing]
        protein = np.concatenate([positions[self.kept], *placed])[self.order]
        ligands = [one.complete(positions) for one in self.ligands]
        completed: np.ndarray = np.concatenate([protein, *ligands])[self.sequence]
        return completed

    def atoms_of(self, ligand: Ligand) -> np.ndarray:
        """(L,) of the completed atoms."""
        return np.flatnonzero(self.residue_of == self.labels.index(ligand.label))

    def where(self, ligand: Ligand) -> np.ndarray:
        """(C,) the completed atom of each of its chemistry, -1 of hydrogens of caps."""
        where = np.full(ligand.chemistry.molecule.GetNumAtoms(), -1)
        given = np.concatenate([ligand.atoms, ligand.caps])
        where[: len(given)] = self.of_file[given]
        where[ligand.own] = self.atoms_of(ligand)
        return where

    def add(self, ligand: Ligand) -> None:
        """Appends the atoms of a ligand as a residue."""
        first, molecule = len(self.elements), ligand.chemistry.molecule
        new = np.full(molecule.GetNumAtoms(), -1)
        new[ligand.own] = first + np.arange(len(ligand.own))
        elements = [molecule.GetAtomWithIdx(int(k)).GetAtomicNum() for k in ligand.own]
        self.elements = np.concatenate([self.elements, elements])
        self.names = np.concatenate([self.names, ligand.names])
        self.residue_of = np.append(self.residue_of, [len(self.labels)] * len(elements))
        self.labels.append(ligand.label)
        self.firsts.append(int(ligand.atoms[0]))
        self.of_file[ligand.atoms] = first + np.arange(len(ligand.atoms))
        given = np.concatenate([ligand.atoms, ligand.caps])
        new[len(ligand.atoms) : len(given)] = self.of_file[ligand.caps]
        ends = [(new[b.GetBeginAtomIdx()], new[b.GetEndAtomIdx()]) for b in molecule.GetBonds()]
        bonds = [two for two in ends if min(two) >= 0 and max(two) >= first]
        self.bonds = np.concatenate([self.bonds, np.array(bonds, int).reshape(-1, 2)])
        self.ligands.append(ligand)

    def arrange(self) -> None:
        """Puts residues that were appended where the file has them."""
        rank = np.argsort(np.argsort(self.firsts, kind="stable"))
        self.sequence = np.argsort(rank[self.residue_of], kind="stable")
        place = np.argsort(self.sequence)
        self.elements, self.names = self.elements[self.sequence], self.names[self.sequence]
        self.residue_of = rank[self.residue_of][self.sequence]
        self.labels = [self.labels[k] for k in np.argsort(rank)]
        self.firsts = sorted(self.firsts)
        self.bonds = place[self.bonds]
        self.of_file = np.where(self.of_file < 0, -1, place[self.of_file])

    def corners(self) -> tuple[np.ndarray, list[str]]:
        """(C, 4) atoms N, C, CB and CA of residues that have a hand, and their labels."""
        found, labels = [], []
        for residue, label in enumerate(self.labels):
            atoms = np.flatnonzero(self.residue_of == residue)
            by_name = dict(zip(self.names[atoms], atoms, strict=True))
            if {"N", "C", "CB", "CA"} <= by_name.keys():
                found.append([by_name[name] for name in ("N", "C", "CB", "CA")])
                labels.append(label)
        corners = [np.array(found, int).reshape(-1, 4)]
        for ligand in self.whole_ligands:
            own = ligand.chemistry.corners()
            corners.append(self.atoms_of(ligand)[own])
            labels += [ligand.label] * len(own)
        return np.concatenate(corners), labels


def why_not(structure: Structure) -> str:
    """Why no force field of proteins applies at all; "" where it does."""
    known = [name for name in structure.residue_names if name in RESIDUES]
    return "" if known else "there is no amino acid in it"


def molecule_of(
    structure: Structure,
    options: ForceFieldOptions = WITHOUT_LIGANDS,
    say: Callable[[str], None] = lambda _: None,
) -> Molecule:
    """Finds the missing hydrogens, and parameters of what amber14 has no template for.

    What there are none for is left out.
    """
    residue_of = np.asarray(structure.residue_of).astype(int)
    residue_names = [str(name) for name in structure.residue_names]  # of atoms
    is_known = np.array([name in RESIDUES for name in residue_names], bool)
    others = others_of(structure, is_known, options, say)
    is_known[others.ions] = True
    kept = np.flatnonzero(is_known)
    elements = np.asarray(structure.elements).astype(int)
    bonds = np.asarray(structure.bonds).astype(int).reshape(-1, 2)
    bonds = bonds[np.isin(bonds, kept).all(axis=1) & ~np.isin(bonds, others.ions).any(axis=1)]
    names = np.array([str(name) for name in structure.names])
    wanted = _wanted(kept, names, residue_names)
    missing = find_missing(wanted, elements, _neighbours(bonds, len(elements)))
    molecule = _ordered(structure, kept, missing, bonds, residue_of)
    for ligand in others.ligands:
        molecule.add(ligand)
        is_known[ligand.atoms] = True
    molecule.arrange()
    molecule.notes += _notes_on_ends(molecule)
    molecule.left_out = _left_out(structure, is_known)
    molecule.why = others.refused
    molecule.notes += _notes_on_others(structure, others)
    return molecule


def _notes_on_others(structure: Structure, others: Others) -> list[str]:
    notes = [one.said for one in others.ligands]
    if len(others.ions):
        named = ", ".join(residue_labels(structure, others.ions))
        notes.append(f"ions, which only charge and size hold in their place: {named}")
    return notes


def _wanted(kept: np.ndarray, names: np.ndarray, residue_names: list[str]) -> np.ndarray:
    """(N,) hydrogens that each carbon must have, -1 of other atoms."""
    wanted = np.full(len(names), -1)
    counts = {name: hydrogen_counts(name) for name in set(residue_names) if name in RESIDUES}
    for atom in kept:
        wanted[atom] = counts.get(residue_names[atom], {}).get(names[atom], -1)
    return wanted


def _neighbours(bonds: np.ndarray, count: int) -> list[list[int]]:
    found: list[list[int]] = [[] for _ in range(count)]
    for a, b in bonds.tolist():
        found[a].append(b)
        found[b].append(a)
    return [sorted(around) for around in found]


def _ordered(
    structure: Structure,
    kept: np.ndarray,
    missing: list[Missing],
    bonds: np.ndarray,
    residue_of: np.ndarray,
) -> Molecule:
    """Atoms of a residue come together: hydrogens that were placed follow its others."""
    carriers = [np.repeat(group.carbons, group.hydrogens) for group in missing]
    carrier = np.concatenate([np.empty(0, int), *carriers])
    owner = np.concatenate([residue_of[kept], residue_of[carrier]])
    order = np.argsort(owner, kind="stable")
    place = np.argsort(order)  # of the unordered atom among the ordered
    new = np.full(len(residue_of), -1)
    new[kept] = place[: len(kept)]
    residue_index = np.unique(owner[order], return_inverse=True)[1]
    firsts = kept[np.unique(residue_of[kept], return_index=True)[1]]
    return Molecule(
        kept=kept,
        missing=missing,
        order=order,
        elements=np.concatenate([structure.elements[kept], np.ones(len(carrier), int)])[order],
        names=np.concatenate([structure.names[kept], np.full(len(carrier), "H")])[order],
        residue_of=residue_index,
        labels=residue_labels(structure, firsts),
        firsts=firsts.tolist(),
        of_file=new,
        sequence=np.arange(len(owner)),
        bonds=np.concatenate(
            [new[bonds], np.column_stack([new[carrier], place[len(kept) :]])]
        ).reshape(-1, 2),
    )


def _left_out(structure: Structure, is_known: np.ndarray) -> dict[str, int]:
    unknown = np.flatnonzero(~is_known)
    firsts = unknown[np.unique(np.asarray(structure.residue_of)[unknown], return_index=True)[1]]
    return dict(Counter(map(str, structure.residue_names[firsts])))


def _notes_on_ends(molecule: Molecule) -> list[str]:
    """Notes on residues at the end of a chain or at a gap that lack the atoms of an end."""
    neighbours = _neighbours(molecule.bonds, len(molecule.elements))
    open_ends = []
    for name, wanted in (("N", 1), ("C", 8)):
        for atom in np.flatnonzero(molecule.names == name):
            around = neighbours[atom]
            inside = all(molecule.residue_of[k] == molecule.residue_of[atom] for k in around)
            if inside and sum(molecule.elements[k] == wanted for k in around) < 2:
                open_ends.append(molecule.labels[molecule.residue_of[atom]])
    if not open_ends:
        return []
    named = ", ".join(open_ends[:3]) + (", ..." if len(open_ends) > 3 else "")
    return [
        f"{len(open_ends)} ends of chains lack the atoms of an end ({named}): the force field "
        "takes them as if the chain went on"
    ]
