# SPDX-License-Identifier: MIT
"""The contacts that a model held, as an H5MD file of Pliant records them frame by frame."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from pliant._core import InputError

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


def contacts_of(reader: Any, path: str) -> RecordedContacts | None:
    """What a reader of H5MD tells; None where the file has no limits.

    Raises InputError where states are not those of these contacts.
    """
    limits, states = reader.limits(), reader.contact_states()
    if len(limits) == 0:
        return None
    limits = limits[_first_of_each(limits["group"])]
    if len(states) % len(limits):
        wanted = f"states of {len(limits)} contacts in each frame"
        raise InputError(f"{path}: /connectivity/contact_states: expected {wanted}")
    return RecordedContacts(
        joints=np.stack([limits["a"], limits["b"]], axis=1).astype(np.int64),
        kinds=limits["kind"].tolist(),
        energies=limits["energy"] / KJ_PER_KCAL,
        states=states.reshape(-1, len(limits)) if len(states) else None,
    )


def _first_of_each(groups: np.ndarray) -> np.ndarray:
    """Place of the first limit of each contact."""
    own = np.flatnonzero(groups == NO_GROUP)
    firsts = np.unique(groups, return_index=True)[1]
    return np.union1d(firsts[groups[firsts] != NO_GROUP], own)
