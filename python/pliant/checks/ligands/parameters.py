# SPDX-License-Identifier: MIT
"""Parameters of molecules, made once and kept: in $XDG_CACHE_HOME/pliant/ligands.

A molecule is known by its SMILES with all hydrogens, which has elements, bonds with orders, charges
and stereo, but no coordinates: charges are of one standard 3-D structure, which RDKit makes of that
SMILES. So they are the same whatever frame they are asked for.
"""

from __future__ import annotations

import contextlib
import hashlib
import json
import os
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from pliant._core import FileError, InputError
from pliant.adapters.smiles import embed
from pliant.base.extras import late
from pliant.base.new_file import write_text
from pliant.checks.ligands import ambertools

if TYPE_CHECKING:
    from rdkit.Chem import Mol

Chem = late("rdkit.Chem")

#: prefix of names of files: what changes files of earlier versions changes it
FORMAT = "gaff2-1"


@dataclass(frozen=True)
class Parameters:
    """GAFF2 parameters of a molecule."""

    prmtop: str  #: AMBER's topology of it alone
    order: npt.NDArray[np.int64]  #: (L,) atom of the molecule that each of the prmtop is
    was_kept: bool  #: found, not made


def parameters_of(
    molecule: Mol, charges: str, place: str, say: Callable[[str], None]
) -> Parameters:
    """Of a molecule with all hydrogens. Raises InputError, which begins with `place`."""
    text, order = canonical(molecule)
    try:
        gaff = ambertools.version(ambertools.programs()["tleap"])
        file = folder() / f"{FORMAT}-{key(text, charges, gaff)}.prmtop"
        if (known := _kept(file, len(order))) is not None:
            return Parameters(known, order, True)
        heavy = sum(one.GetAtomicNum() > 1 for one in molecule.GetAtoms())
        say(f"{place}: {heavy} atoms without hydrogens get GAFF2 and {charges} charges, once")
        prmtop = ambertools.parametrise(
            _standard(text, place), charges, lambda passed: say(f"{place}: {passed}")
        )
    except InputError as error:
        raise InputError(f"{place}: {str(error).removeprefix(f'{place}: ')}") from None
    if atoms_of(prmtop) != len(order):
        raise InputError(f"{place}: tleap: expected {len(order)} atoms, found {atoms_of(prmtop)}")
    with contextlib.suppress(FileError, OSError):  # they are then made again
        file.parent.mkdir(parents=True, exist_ok=True)
        write_text(file, prmtop, overwrite=True)
    return Parameters(prmtop, order, False)


def canonical(molecule: Mol) -> tuple[str, npt.NDArray[np.int64]]:
    """Its SMILES with all hydrogens, and (L,) the atom that each of those of the SMILES is."""
    bare = Chem.Mol(molecule)
    for atom in bare.GetAtoms():
        atom.SetAtomMapNum(0)
        atom.SetIsotope(0)
    text = Chem.MolToSmiles(bare, allHsExplicit=True)
    order = [*bare.GetPropsAsDict(True, True)["_smilesAtomOutputOrder"]]
    return str(text), np.array(order, np.int64)


def key(text: str, charges: str, gaff: str) -> str:
    """Of a molecule's parameters: 32 letters."""
    return hashlib.sha256(json.dumps([text, charges, gaff]).encode()).hexdigest()[:32]


def folder() -> Path:
    """Where they are kept."""
    given = os.environ.get("XDG_CACHE_HOME", "")
    base = Path(given) if os.path.isabs(given) else Path.home() / ".cache"
    return base / "pliant" / "ligands"


def atoms_of(prmtop: str) -> int:
    """The first number of its POINTERS; -1 of what has none."""
    _, _, after = prmtop.partition("%FLAG POINTERS")
    words = after.split()
    return int(words[1]) if len(words) > 1 and words[1].isdigit() else -1


def _kept(file: Path, atoms: int) -> str | None:
    """None where there is none, or not a whole one."""
    try:
        text = file.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError):
        return None
    return text if atoms_of(text) == atoms else None


def _standard(text: str, place: str) -> Mol:
    """The molecule of a SMILES with all hydrogens, in 3-D, atoms in its order."""
    how = Chem.SmilesParserParams()
    how.removeHs = False
    made: Mol = Chem.MolFromSmiles(text, how)
    embed(made, place)
    return made
