# SPDX-License-Identifier: MIT
"""Two structures of one molecule: which residues and atoms stand for each other, which contacts
both have."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from pliant._core import InputError, MolecularModel, Structure, build_model
from pliant.compare.matching import match
from pliant.compare.traces import trace_of_structure
from pliant.path.contacts import keys, names_of, with_ligands

Named = dict[tuple[int, str], int]  #: atoms by the number of the match of their residue, and name


@dataclass
class Side:
    """One of the two: a molecule, and which of its atoms are asked to go where the other's are."""

    model: MolecularModel  #: with the contacts that both structures have
    asked: np.ndarray  #: (K,) atoms
    leader: np.ndarray  #: (N,) of each atom the matched residue that it goes with

    @cached_property
    def positions(self) -> np.ndarray:
        """(N, 3) Angstrom, of the file."""
        return np.array(self.model.positions)


class Ends:
    """The two structures, matched.

    atoms: "CA" (P of nucleotides), or "heavy" for those of matched residues with the same name.
    Throws InputError where no residues match.
    """

    def __init__(self, start: Structure, end: Structure, atoms: str) -> None:
        self._given = start, end
        whole, self._goal = build_model(start), build_model(end)
        ours, theirs = whole.structure, self._goal.structure
        self._match(ours, theirs)
        self._names = (_named(ours, self._residues[0]), _named(theirs, self._residues[1]))
        self._share_contacts(whole)
        self._asked = self._traced if atoms == "CA" else self._heavy(ours)
        self.goal = np.array(self._goal.positions)[self._asked[1]]  #: (K, 3) where the end has them
        model = build_model(start, contacts=whole.contacts[self._is_shared[0]])
        self.start = self._side(0, model)

    @cached_property
    def end(self) -> Side:
        """The other molecule, to be moved as well."""
        shared = self._goal.contacts[self._is_shared[1]]
        return self._side(1, build_model(self._given[1], contacts=shared))

    @property
    def source_of_end(self) -> str:
        """Its file."""
        return self._goal.structure.source

    @property
    def matched(self) -> int:
        """How many residues."""
        return len(self._residues[0])

    def _side(self, which: int, model: MolecularModel) -> Side:
        traced = np.asarray(model.positions)[self._traced[which]]
        leader = _leaders(model, self._residues[which], traced)
        return Side(model, self._asked[which], leader)

    def _match(self, ours: Structure, theirs: Structure) -> None:
        """Residues (numbers of residue_of) of ours and theirs that stand for each other."""
        our_trace, their_trace = trace_of_structure(ours), trace_of_structure(theirs)
        if len(our_trace) == 0:
            raise InputError(f"{ours.source}: has no residues of proteins or nucleic acids")
        found = match(our_trace, their_trace, theirs.source)
        self.notes = list(found.notes)
        self._traced = our_trace.atoms[found.ours], their_trace.atoms[found.theirs]
        self._residues = ours.residue_of[self._traced[0]], theirs.residue_of[self._traced[1]]

    def _heavy(self, ours: Structure) -> tuple[np.ndarray, np.ndarray]:
        (here, there), elements = self._names, np.asarray(ours.elements)
        pairs = [(atom, there[k]) for k, atom in here.items() if k in there and elements[atom] > 1]
        one, other = np.array(pairs, dtype=np.int64).T
        return one, other

    def _share_contacts(self, whole: MolecularModel) -> None:
        """Which contacts of the start the end has as well; those that only one has.

        Ligands and metals are matched by chain, number and name. Contacts of what is not matched
        are let go, and counted for neither.
        """
        ours, theirs = whole.structure, self._goal.structure
        residues = with_ligands(ours, theirs, *self._residues)
        here, there = _named(ours, residues[0]), names_of(_named(theirs, residues[1]))
        at_start = keys(whole.contacts, names_of(here), ours)
        at_end = keys(self._goal.contacts, there, theirs)
        shared = (set(at_start) & set(at_end)) - {None}
        self._is_shared = tuple(
            np.array([k in shared for k in at], bool) for at in (at_start, at_end)
        )
        is_named = [np.array([k is not None for k in at], bool) for at in (at_start, at_end)]
        self.only_start = whole.contacts[is_named[0] & ~self._is_shared[0]]
        only_end = self._goal.contacts[is_named[1] & ~self._is_shared[1]]
        self.only_end = len(only_end)  #: contacts that only the end has
        self.to_make = _as_ours(only_end, there, here)  #: those that the start has atoms for


def _as_ours(contacts: np.ndarray, names: dict[int, tuple[int, str]], ours: Named) -> np.ndarray:
    """Contacts of theirs between atoms of ours, as far as we have those."""
    ends = [[ours.get(names[int(atom)], -1) for atom in contacts[end]] for end in ("a", "b")]
    kept = contacts.copy()
    kept["a"], kept["b"] = np.maximum(ends, 0)
    known: np.ndarray = kept[(np.array(ends) >= 0).all(axis=0)]
    return known


def _named(structure: Structure, residues: np.ndarray) -> Named:
    """Atoms of matched residues by the number of the match and their name."""
    number = {int(residue): k for k, residue in enumerate(residues)}
    atoms = zip(structure.residue_of.tolist(), structure.names, strict=True)
    return {
        (number[residue], str(name)): atom
        for atom, (residue, name) in enumerate(atoms)
        if residue in number
    }


def _leaders(model: MolecularModel, residues: np.ndarray, traced: np.ndarray) -> np.ndarray:
    """(N,) of each atom the matched residue that it goes with: its own, else the nearest."""
    number = {int(residue): k for k, residue in enumerate(residues)}
    residue_of, positions = model.structure.residue_of, np.asarray(model.positions)
    leader = np.array([number.get(residue, -1) for residue in residue_of.tolist()])
    for residue in np.unique(residue_of[leader < 0]):
        members = np.flatnonzero(residue_of == residue)
        middle = positions[members].mean(axis=0)
        leader[members] = np.argmin(np.linalg.norm(traced - middle, axis=1))
    return leader
