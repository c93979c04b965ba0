# SPDX-License-Identifier: MIT
"""Frames as the models of an mmCIF file: the table ``_atom_site`` of the PDBx/mmCIF dictionary."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from typing import TextIO

import numpy as np

from pliant import _core

COLUMNS = tuple(
    "group_PDB id type_symbol label_atom_id label_alt_id label_comp_id label_asym_id "
    "label_entity_id label_seq_id pdbx_PDB_ins_code Cartn_x Cartn_y Cartn_z occupancy "
    "B_iso_or_equiv auth_seq_id auth_comp_id auth_asym_id auth_atom_id pdbx_PDB_model_num".split()
)
#: what must stand in quotes: empty, blanks, a first sign that means something, words of the format
QUOTED = re.compile(
    r"$|.*[\s'\"]|[_#$;\[\]]|[.?]$|(data_|loop_|global_|save_|stop_)", re.IGNORECASE
)


def write_models(file: TextIO, structure: _core.Structure, frames: Iterable[np.ndarray]) -> int:
    """Writes frames, each (N, 3) in Angstrom, as models 1, 2, ...; how many.

    Places have 0.00001 Angstrom. Polymers (amino and nucleic residues) are numbered along each
    chain in ``label_seq_id``; numbers, insertion codes and chains of the structure are the
    ``auth_`` ones. Bonds are not written: programs know those of residues by their names.
    """
    file.write("data_pliant\n#\nloop_\n")
    file.writelines(f"_atom_site.{name}\n" for name in COLUMNS)
    around = list(_around_places(structure))
    models = 0
    for positions in frames:
        first, models = models * len(around) + 1, models + 1
        file.writelines(
            f"{group} {first + k} {before} {x:.5f} {y:.5f} {z:.5f} {after} {models}\n"
            for k, ((group, before, after), (x, y, z)) in enumerate(
                zip(around, positions.tolist(), strict=True)
            )
        )
    file.write("#\n")
    return models


def _value(text: str, empty: str) -> str:
    """A value of CIF 1.1 that is read as this text; `empty` where there is none."""
    text = " ".join(str(text).split())
    if not text:
        return empty
    if not QUOTED.match(text):
        return text
    return f"'{text}'" if '" ' in text else f'"{text}"'


def _values(texts: np.ndarray, empty: str) -> list[str]:
    """A value for each; what comes again is made once."""
    unique, which = np.unique(texts, return_inverse=True)
    values = [_value(text, empty) for text in unique.tolist()]
    return [values[k] for k in which.tolist()]


def _around_places(structure: _core.Structure) -> Iterator[tuple[str, str, str]]:
    """The group of each atom, the values between its number and its place, and those between its
    place and the number of the model."""
    sequence = _numbers_in_chains(structure)
    b_factors: np.ndarray = np.asarray(structure.b_factors)
    if len(b_factors) == 0:
        b_factors = np.zeros(len(structure))
    for symbol, name, residue_name, chain, residue, insertion, number, b_factor in zip(
        _values(structure.symbols, "X"),
        _values(structure.names, "X"),
        _values(structure.residue_names, "UNK"),
        _values(structure.chains, "A"),
        structure.residue_of.tolist(),
        _values(structure.insertion_codes, "?"),
        structure.residue_ids.tolist(),
        b_factors.tolist(),
        strict=True,
    ):
        place = sequence[residue]
        before = f"{symbol} {name} . {residue_name} {chain} ? {place} {insertion}"
        after = f"1.00 {b_factor:.2f} {number} {residue_name} {chain} {name}"
        yield "HETATM" if place == "." else "ATOM", before, after


def _numbers_in_chains(structure: _core.Structure) -> list[str]:
    """The number of each residue along its chain; "." where it is of no polymer."""
    residue_of, chains = structure.residue_of, structure.chains
    polymers = _core.select_atoms(structure, "protein or nucleic")
    is_polymer = np.zeros(structure.residue_count, dtype=bool)
    is_polymer[residue_of[polymers]] = True
    firsts = np.searchsorted(residue_of, np.arange(structure.residue_count))
    counts: dict[str, int] = {}
    numbers = []
    for is_of_chain, chain in zip(is_polymer.tolist(), chains[firsts].tolist(), strict=True):
        counts[chain] = counts.get(chain, 0) + is_of_chain
        numbers.append(str(counts[chain]) if is_of_chain else ".")
    return numbers
