# SPDX-License-Identifier: MIT
"""Molecules with a known conformer, and the other one from which their conformers are made."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from rdkit import Chem
from rdkit.Chem import Mol, rdDistGeom, rdForceFieldHelpers

from pliant._core import InputError
from pliant.jobs.conformers.records import format_of, read_records

START_SEED = 7
_ENDINGS = (".sdf", ".mol", ".sdf.gz", ".mol.gz")
_MOST_TRIES = 50
_MOST_ITERATIONS = 2000


class NoStartError(Exception):
    """RDKit finds no conformer of a molecule."""


@dataclass
class Known:
    """A molecule with its known conformer, and another one of the same molecule."""

    name: str
    molecule: Mol  #: all hydrogens, one conformer
    start: Mol  #: the same atoms, as `start_of` places them


@dataclass
class KnownSet:
    """What is measured, and what could not be read, by name and number."""

    molecules: list[Known] = field(default_factory=list)
    skipped: list[str] = field(default_factory=list)


def start_of(molecule: Mol) -> Mol:
    """The molecule embedded anew by ETKDGv3 from its graph and stereo, relaxed by MMFF94.

    Raises NoStartError where RDKit finds no conformer.
    """
    made = Chem.Mol(molecule)
    made.RemoveAllConformers()
    # Cages such as C60 need the plain one, without ETKDG's planes.
    both: tuple[Any, ...] = (rdDistGeom.ETKDGv3(), rdDistGeom.EmbedParameters())
    for parameters in both:
        parameters.randomSeed = START_SEED
        parameters.maxIterations = _MOST_TRIES
        if rdDistGeom.EmbedMolecule(made, parameters) == 0:
            break
    else:
        raise NoStartError("RDKit finds no conformer")
    if rdForceFieldHelpers.MMFFHasAllMoleculeParams(made):
        rdForceFieldHelpers.MMFFOptimizeMolecule(made, maxIters=_MOST_ITERATIONS)
    return made


def read_known(path: Path, ring: int = 0) -> KnownSet:
    """The records of an SDF or MOL file, or of all in a folder; those with a ring of `ring` on.

    Raises InputError where there is no such file, or nothing in it can be used.
    """
    files = (
        sorted(p for p in path.iterdir() if p.name.endswith(_ENDINGS)) if path.is_dir() else [path]
    )
    if not files or not all(file.is_file() for file in files):
        raise InputError(f"{path}: no SDF or MOL file")
    found = KnownSet()
    for file in files:
        for place, molecule in _records(file):
            add(found, place, molecule, ring)
    if not found.molecules:
        first = f": {found.skipped[0]}" if found.skipped else ""
        raise InputError(f"{path}: no molecule with a known conformer{first}")
    return found


def add(found: KnownSet, place: str, molecule: Mol | None, ring: int = 0) -> None:
    """Adds a molecule, or says why not; one without a ring of `ring` members is left out."""
    if molecule is not None and largest_ring(molecule) < ring:
        return
    fault = _fault(molecule)
    if molecule is None or fault:
        found.skipped.append(f"{place}: {fault}")
        return
    name = molecule.GetProp("_Name").strip() if molecule.HasProp("_Name") else ""
    taken = {one.name for one in found.molecules}
    name = name if name and name not in taken else f"{name or 'molecule'} ({place})"
    Chem.AssignStereochemistryFrom3D(molecule)
    try:
        found.molecules.append(Known(name, molecule, start_of(molecule)))
    except NoStartError as error:
        found.skipped.append(f"{place}: {name}: {error}")


def largest_ring(molecule: Mol) -> int:
    """Members of the largest ring of the smallest set; 0 without rings."""
    return max(map(len, molecule.GetRingInfo().AtomRings()), default=0)


def _fault(molecule: Mol | None) -> str:
    """Why a molecule cannot be used, or nothing."""
    if molecule is None:
        return "RDKit cannot read it"
    if not molecule.GetNumConformers() or not molecule.GetConformer().Is3D():
        return "it has no positions in space"
    if any(atom.GetTotalNumHs() for atom in molecule.GetAtoms()):
        return "hydrogens are missing"
    if len(Chem.GetMolFrags(molecule)) > 1:
        return "it is of several parts"
    return ""


def _records(path: Path) -> Iterator[tuple[str, Mol | None]]:
    """All records with their places, "FILE, record N"."""
    for record in read_records(path):
        place = "" if format_of(path) == ".mol" else f", record {record.number}"
        text = record.text.encode(errors="replace").decode()
        yield f"{path.name}{place}", Chem.MolFromMolBlock(text, removeHs=False)
