# SPDX-License-Identifier: MIT
"""Which residue of theirs is which of ours: chain by chain, by number where that fits, else by
sequence."""

from __future__ import annotations

import itertools
from dataclasses import dataclass

import numpy as np

from pliant._core import InputError
from pliant._sequence import aligned
from pliant.compare.traces import Trace

#: by number where so many of the residues of the shorter chain are found and called the same
LEAST_BY_NUMBER = 0.9
#: chains are the same molecule where so many residues of the shorter one are the same
LEAST_ALIKE = 0.3
LEAST_SHARED = 0.5  #: of our residues, below which files are refused
MOST_NAMED = 6  #: residues that differ, in a line


@dataclass(frozen=True)
class Match:
    """Residues of ours and theirs that stand for each other."""

    ours: np.ndarray  #: (K,) rising
    theirs: np.ndarray  #: (K,)
    notes: tuple[str, ...]  #: how, what differs, what is left out


def match(ours: Trace, theirs: Trace, source: str) -> Match:
    """Matches chains greedily, those that share most first, then residues within them.

    Raises InputError where less than half of our residues are found.
    """
    pairs = _paired_chains(ours, theirs)
    table = np.concatenate([found for _, _, found in pairs] or [np.empty((0, 2), dtype=np.int64)])
    if len(table) < max(3, LEAST_SHARED * len(ours)):
        raise InputError(
            f"{source}: only {len(table)} of {len(ours)} residues of ours are in it, matched by "
            "sequence: is it the same molecule? --select chooses parts of both"
        )
    table = table[np.argsort(table[:, 0])]
    found = Match(table[:, 0], table[:, 1], ())
    return Match(found.ours, found.theirs, tuple(_notes(ours, theirs, pairs, found, source)))


def _paired_chains(ours: Trace, theirs: Trace) -> list[tuple[str, str, np.ndarray]]:
    """Our chain, their chain and pairs (k, 2) of residues of each two that go together."""
    candidates = []
    groups = itertools.product(enumerate(_chains(ours)), enumerate(_chains(theirs)))
    for (i, mine), (j, other) in groups:
        if ours.kinds[mine[0]] != theirs.kinds[other[0]]:
            continue
        pairs, same = _paired_residues(ours, mine, theirs, other)
        if same >= max(1, LEAST_ALIKE * min(len(mine), len(other))):
            other_name = ours.chains[mine[0]] != theirs.chains[other[0]]
            candidates.append((-same, other_name, i, j, pairs))
    found, taken = [], set()
    for _, _, i, j, pairs in sorted(candidates, key=lambda one: one[:4]):
        if ("ours", i) not in taken and ("theirs", j) not in taken:
            taken |= {("ours", i), ("theirs", j)}
            found.append((str(ours.chains[pairs[0, 0]]), str(theirs.chains[pairs[0, 1]]), pairs))
    return found


def _chains(trace: Trace) -> list[np.ndarray]:
    """Residues of each chain and kind."""
    keys = list(zip(trace.chains, trace.kinds, strict=True))
    groups: dict[tuple[str, str], list[int]] = {}
    for residue, key in enumerate(keys):
        groups.setdefault(key, []).append(residue)
    return [np.array(group) for group in groups.values()]


def _paired_residues(
    ours: Trace, mine: np.ndarray, theirs: Trace, other: np.ndarray
) -> tuple[np.ndarray, int]:
    """Pairs (k, 2) of residues of two chains, and how many of them are the same."""
    pairs = _by_number(ours, mine, theirs, other)
    same = _same(ours, theirs, pairs)
    shorter = min(len(mine), len(other))
    if same >= LEAST_BY_NUMBER * max(shorter, len(pairs)):
        return pairs, same
    letters = ("".join(t.letters[k] for k in part) for t, part in ((ours, mine), (theirs, other)))
    places = aligned(*letters)
    pairs = np.stack([mine[places[:, 0]], other[places[:, 1]]], axis=1)
    return pairs, _same(ours, theirs, pairs)


def _by_number(ours: Trace, mine: np.ndarray, theirs: Trace, other: np.ndarray) -> np.ndarray:
    places = {(int(theirs.numbers[k]), str(theirs.codes[k])): k for k in other}
    keys = ((k, (int(ours.numbers[k]), str(ours.codes[k]))) for k in mine)
    found = [(k, places[key]) for k, key in keys if key in places]
    return np.array(found, dtype=np.int64).reshape(-1, 2)


def _same(ours: Trace, theirs: Trace, pairs: np.ndarray) -> int:
    return sum(ours.letters[a] == theirs.letters[b] for a, b in pairs)


def _notes(
    ours: Trace,
    theirs: Trace,
    pairs: list[tuple[str, str, np.ndarray]],
    found: Match,
    source: str,
) -> list[str]:
    chains = [f"{mine or '-'} with {other or '-'}" for mine, other, _ in pairs if mine != other]
    notes = [f"{source}: {len(found.ours)} of our {len(ours)} residues are in it"]
    if chains:
        notes[0] += f" (chains {', '.join(chains)})"
    differ = [
        f"{ours.label(a)} is {theirs.names[b]}{theirs.numbers[b]}"
        for a, b in zip(found.ours, found.theirs, strict=True)
        if ours.letters[a] != theirs.letters[b]
    ]
    if differ:
        more = f" and {len(differ) - MOST_NAMED} more" if len(differ) > MOST_NAMED else ""
        shown = ", ".join(differ[:MOST_NAMED]) + more
        one = "1 residue differs" if len(differ) == 1 else f"{len(differ)} residues differ"
        notes.append(f"{source}: {one}, compared all the same: {shown}")
    for whose, trace, used in (("ours", ours, found.ours), ("theirs", theirs, found.theirs)):
        rest = np.setdiff1d(np.arange(len(trace)), used)
        if len(rest):
            notes.append(f"{source}: left out, of {whose} alone: {trace.ranges(rest)}")
    return notes
