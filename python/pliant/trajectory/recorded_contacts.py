# SPDX-License-Identifier: MIT
"""The contacts that a model held, as an H5MD file of Pliant records them frame by frame."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import h5py
import numpy as np

from pliant.trajectory import hdf5 as _hdf5

HELD, BROKEN, OFF = 0, 1, 2
#: a limit of no group stands for a contact of its own
NO_GROUP = -1
KJ_PER_KCAL = 4.184  #: files have kJ/mol


@dataclass
class RecordedContacts:
    """Contacts of a model of a molecule, in the order of each one's first limit."""

    joints: np.ndarray  #: (C, 2) the two joints of its first limit, from 0
    kinds: list[str]  #: (C,) "hydrogen_bond", "hydrophobic" ...
    energies: np.ndarray  #: (C,) kcal/mol, NaN where there is none
    #: (F, C) 0 held, 1 broken by more than 0.1 Angstrom, 2 switched off; None: not recorded
    states: np.ndarray | None = None

    def shares(self, frames: np.ndarray) -> np.ndarray:
        """(C, 3) share of the frames numbered `frames` in which each is held, broken, off."""
        if self.states is None:
            raise ValueError("the file does not say which contact is held in which frame")
        rows = self.states[frames]
        return np.stack([(rows == state).mean(axis=0) for state in (HELD, BROKEN, OFF)], axis=1)


def contacts_of(file: h5py.File) -> RecordedContacts | None:
    """What an open file tells; None where it has no limits, or not in the shape it should have."""
    limits = _hdf5.item(file, "connectivity/limits")
    columns: list[Any] = [
        _hdf5.item(file, f"parameters/limit/{name}") for name in ("group", "kind", "energy")
    ]
    if not _hdf5.is_array(limits, "iu", (None, 2)):
        return None
    if not all(_hdf5.is_array(one, "iuf", limits.shape[:1]) for one in columns):
        return None
    names = h5py.check_enum_dtype(columns[1].dtype) or {}
    groups, kinds, energies = (_hdf5.read(one) for one in columns)
    first = _first_of_each(groups)
    name_of = {number: name for name, number in names.items()}
    found = RecordedContacts(
        joints=_hdf5.read(limits).astype(np.int64)[first],
        kinds=[name_of.get(int(kind), "") for kind in kinds[first]],
        energies=energies[first].astype(np.float64) / KJ_PER_KCAL,
    )
    states = _hdf5.item(file, "connectivity/contact_states/value")
    if _hdf5.is_array(states, "iu", (None, len(first))):
        found.states = _hdf5.read(states).astype(np.uint8)
    return found


def _first_of_each(groups: np.ndarray) -> np.ndarray:
    """Place of the first limit of each contact."""
    own = np.flatnonzero(groups == NO_GROUP)
    firsts = np.unique(groups, return_index=True)[1] if len(groups) else own
    return np.union1d(firsts[groups[firsts] != NO_GROUP], own)
