# SPDX-License-Identifier: MIT
"""Reads one public file with Pliant, and checks what it has read without Pliant."""

import warnings
from pathlib import Path
from typing import NamedTuple

import numpy as np
import structure_checks as checks

import pliant

#: the largest file whose model is built, in atoms
LARGEST_MODEL = 30_000


class Finding(NamedTuple):
    """What is wrong with a file that was read: by which check, and whether a warning told it."""

    file: str
    check: str
    words: str
    told: bool


def read(path: Path) -> tuple["pliant.Structure | None", list[str]]:
    """The structure, or None if the file was refused, and the warnings."""
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        try:
            structure = pliant.read(path)
        except pliant.Error:
            return None, []
    return structure, [str(warning.message) for warning in caught]


def prepared(structure: "pliant.Structure") -> "pliant.Structure | None":
    """With all hydrogens, as for starting MD; None if it is no protein that can be prepared."""
    is_protein = np.isin(structure.residue_names, sorted(checks.HEAVY)).any()
    if not is_protein or structure.is_drawing or len(structure) > LARGEST_MODEL:
        return None
    try:
        return pliant.prepare(structure, all_hydrogens=True).structure
    except pliant.Error:
        return None


def findings(path: Path, structure: "pliant.Structure") -> list[tuple[str, str]]:
    """What is wrong, each with the check that says so. The bonds of SDF are the file's own."""
    found = []
    if structure.format != "sdf":
        found += [("valence", words) for words in checks.valence(structure)]
    if not structure.is_drawing:
        found += [("length of bonds", words) for words in checks.bond_lengths(structure)]
    if structure.format in ("pdb", "mmcif"):
        found += [("sequence", words) for words in checks.sequence(path, structure)]
    if structure.format == "pdb":
        found += [("residues", words) for words in checks.residues(path, structure)]
    model = prepared(structure)
    if model is not None:
        found += [("hydrogens", words) for words in checks.hydrogens(model)]
    return found


#: words of the warning that tells of what a check finds
TOLD = {
    "length of bonds": "longer than 1.3 times",
    "valence": "more bonds than such atoms have",
    "residues": "highest occupancy",
}


def look_at(path: Path) -> "list[Finding] | None":
    """What is wrong with what Pliant reads of a file; None if it refuses the file."""
    structure, told = read(path)
    if structure is None:
        return None
    return [
        Finding(str(path), check, words, any(TOLD.get(check, words) in line for line in told))
        for check, words in findings(path, structure)
    ]
