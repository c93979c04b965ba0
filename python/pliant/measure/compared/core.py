# SPDX-License-Identifier: MIT
"""The residues by which two ensembles are superposed: all but ends of chains that wave freely."""

from __future__ import annotations

import numpy as np

from pliant.measure import agreement as alike

#: residues at an end of a chain wave freely where they move more than so many medians
FREE = 2.5
MOST_OF_AN_END = 15  #: residues; longer ends are domains and stay
LEAST_LEFT = 0.5  #: of all residues
ROUNDS = 10


def core_of(ours: np.ndarray, theirs: np.ndarray, chains: np.ndarray) -> np.ndarray:
    """(K,) bool: residues that are no free ends, in ours or theirs.

    ours: (F, K, 3), theirs: (G, K, 3), chains: (K,). A free end would turn the whole molecule in a
    superposition, and decide r alone: in every ensemble it moves most. Repeated until it rests.
    """
    core = np.ones(len(chains), dtype=bool)
    for _ in range(ROUNDS):
        free = np.zeros_like(core)
        for frames in (ours, theirs):
            if len(frames) > 1:
                free |= _free_ends(frames, core, chains)
        if (~free).sum() < max(3, LEAST_LEFT * len(core)) or np.array_equal(~free, core):
            break
        core = ~free
    return core


def _free_ends(frames: np.ndarray, core: np.ndarray, chains: np.ndarray) -> np.ndarray:
    rmsf = alike.fluctuations(alike.superposed_on_mean(frames, np.flatnonzero(core)))
    is_free = rmsf > FREE * np.median(rmsf[core])
    free = np.zeros_like(core)
    for chain in np.unique(chains):
        places = np.flatnonzero(chains == chain)
        for end in (places, places[::-1]):
            run = _leading(is_free[end])
            if run <= MOST_OF_AN_END:
                free[end[:run]] = True
    return free


def _leading(flags: np.ndarray) -> int:
    """How many of the first are set."""
    return int(np.argmin(flags)) if not flags.all() else len(flags)
