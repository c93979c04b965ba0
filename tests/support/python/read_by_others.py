# SPDX-License-Identifier: MIT
"""Atoms of a molecule file as Pliant, gemmi, MDAnalysis and RDKit read them, in one form."""

import warnings
from pathlib import Path
from typing import NamedTuple

import numpy as np

import pliant


class Atom(NamedTuple):
    """One atom; a field is None where the reader does not say."""

    position: tuple[float, float, float]  # Angstrom
    name: str
    element: int | None
    residue: str | None = None
    number: int | None = None
    insertion: str | None = None
    chain: str | None = None
    conformer: str = ""

    def key(self, single: bool) -> tuple:
        """By which the same atom is found in another list: its place, and its name."""
        return tuple(np.float32(self.position).tolist() if single else self.position), self.name


def ours(path: Path) -> list[Atom]:
    """As Pliant reads them."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", pliant.PliantWarning)
        read = pliant.read(path, perceive_bonds=False)
    columns = (
        map(tuple, read.positions.tolist()),
        read.names.tolist(),
        read.elements.tolist(),
        read.residue_names.tolist(),
        read.residue_ids.tolist(),
        read.insertion_codes.tolist(),
        read.chains.tolist(),
    )
    return [Atom(*row) for row in zip(*columns, strict=True)]


def gemmis(path: Path) -> list[Atom]:
    """As gemmi reads the first model."""
    import gemmi

    cif = ".cif" in path.name or ".pdbx" in path.name
    kind = gemmi.CoorFormat.Mmcif if cif else gemmi.CoorFormat.Pdb
    model = gemmi.read_structure(str(path), merge_chain_parts=False, format=kind)[0]
    return [
        Atom(
            tuple(atom.pos.tolist()),
            *(atom.name, atom.element.atomic_number, residue.name, residue.seqid.num),
            *(residue.seqid.icode.strip(), chain.name, atom.altloc.strip("\0")),
        )
        for chain in model
        for residue in chain
        for atom in residue
    ]


def mdanalysis(path: Path) -> list[Atom]:
    """As MDAnalysis reads the first frame: coordinates in single precision."""
    import MDAnalysis

    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        atoms = MDAnalysis.Universe(str(path), to_guess=()).atoms

    def column(name: str) -> list:
        return list(getattr(atoms, name)) if hasattr(atoms, name) else [None] * len(atoms)

    symbols = column("elements") if hasattr(atoms, "elements") else column("types")
    columns = (
        map(tuple, atoms.positions.tolist()),
        column("names"),
        map(number_of, symbols),
        column("resnames"),
        column("resids"),
        column("icodes"),
        column("chainIDs"),
        [text or "" for text in column("altLocs")],
    )
    return [Atom(*row) for row in zip(*columns, strict=True)]


def number_of(symbol: str | None) -> int | None:
    """Atomic number; None where the file has no element."""
    import gemmi

    number = gemmi.Element(symbol).atomic_number if symbol else 0
    return number or None


def rdkits(path: Path) -> list[Atom]:
    """As RDKit reads an SDF, MOL or XYZ file."""
    from rdkit import Chem

    if path.suffix == ".xyz":
        molecule = Chem.MolFromXYZFile(str(path))
    else:
        molecule = Chem.MolFromMolFile(str(path), removeHs=False, sanitize=False)
    places = molecule.GetConformer().GetPositions().tolist()
    return [
        Atom(tuple(place), atom.GetSymbol(), atom.GetAtomicNum())
        for place, atom in zip(places, molecule.GetAtoms(), strict=True)
    ]
