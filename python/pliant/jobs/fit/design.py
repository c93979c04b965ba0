# SPDX-License-Identifier: MIT
"""Which distances to measure: those that differ most among the shapes in reach, each by what the
ones before do not tell (QR with column pivoting)."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any, Literal

import numpy as np

from pliant._core import InputError, OptionError, PathOptions
from pliant.base.checked import SEED, checked, whole
from pliant.base.display import Displayed, Facts
from pliant.jobs.fit.molecule import FRAMES, Molecule

__all__ = ["Design", "design"]

#: what methods can see: Angstrom between alpha carbons
RANGES = {
    "any": (0.0, math.inf),
    "fret": (20.0, 80.0),
    "deer": (15.0, 60.0),
    "crosslink": (0.0, 30.0),
}
NOT_LABELLED = ("GLY", "PRO")
LINKED = ("LYS",)
CROWD = 10.0  #: Angstrom: a residue is exposed if no more are so near than around half of them
CANDIDATES = 4000  #: pairs
APART = 8  #: more residues between two sites than these
GAINED = 0.001  #: share of the variance; what adds less is not worth a measurement


@dataclass(frozen=True)
class Pair:
    """Two sites whose distance is worth measuring."""

    pair: tuple[int, int]  #: nodes
    mean: float  #: Angstrom, over the frames
    spread: float
    explained: float  #: share of the variance of all distances, with those before it


def best_pairs(
    frames: np.ndarray,
    sites: Sequence[int],
    count: int,
    within: tuple[float, float],
    seed: int = 0,
    gained: float = GAINED,
) -> list[Pair]:
    """`count` pairs of `sites` at most, best first, of nodes of frames (F, M, 3).

    `within`: Angstrom, in which the mean distance must lie.
    """
    pairs = _candidates(np.asarray(sites), seed)
    distances = np.linalg.norm(frames[:, pairs[:, 0]] - frames[:, pairs[:, 1]], axis=2)
    mean = distances.mean(axis=0)
    inside = (mean >= within[0]) & (mean <= within[1])
    pairs, mean, left = pairs[inside], mean[inside], (distances - mean)[:, inside]
    whole = float((left**2).sum())
    spread = np.sqrt((left**2).mean(axis=0))
    found: list[Pair] = []
    before = 0.0
    while len(found) < count and whole > 0:
        squares = (left**2).sum(axis=0)
        best = int(np.argmax(squares))
        direction = left[:, best] / np.sqrt(squares[best])
        left = left - np.outer(direction, direction @ left)
        explained = 1.0 - float((left**2).sum()) / whole
        if explained - before < gained:
            break
        one, other = (int(k) for k in pairs[best])
        found.append(Pair((one, other), float(mean[best]), float(spread[best]), explained))
        before = explained
    return found


def _candidates(sites: np.ndarray, seed: int) -> np.ndarray:
    """(n, 2) pairs of sites far enough apart along the sequence, CANDIDATES at most."""
    i, j = np.triu_indices(len(sites), 1)
    far = sites[j] - sites[i] > APART
    pairs = np.stack([sites[i][far], sites[j][far]], axis=1)
    if len(pairs) <= CANDIDATES:
        return pairs
    chosen = np.random.default_rng(seed).choice(len(pairs), CANDIDATES, replace=False)
    return np.asarray(pairs[np.sort(chosen)])


@dataclass
class Design(Displayed):
    """Pairs of residues whose distances tell most of what is not known of the shape."""

    pairs: list[dict[str, Any]]  #: site1, site2, mean, spread (Angstrom), explained (share)
    asked: int
    candidates: int = field(default=0)  #: residues

    def facts(self) -> Facts:
        """The pairs, and what all of them explain."""
        return [
            *(
                (
                    f"{one['site1']} - {one['site2']}",
                    f"{one['mean']:.1f} +- {one['spread']:.1f} A, explained so far "
                    f"{one['explained']:.0%}",
                )
                for one in self.pairs
            ),
            ("in all", f"{len(self.pairs)} of {self.asked} asked for, among {self.candidates} "
                       f"residues{self._why_fewer()}"),
        ]  # fmt: skip

    def _why_fewer(self) -> str:
        return "; more would add nothing" if len(self.pairs) < self.asked else ""

    def as_json(self) -> dict[str, Any]:
        """The table."""
        return {"pairs": self.pairs, "asked": self.asked, "candidates": self.candidates}


def labelled(molecule: Molecule, method: str, exclude: Sequence[str]) -> list[int]:
    """The nodes that can carry a label of a method: exposed, no GLY or PRO; LYS of cross-links."""
    nodes = np.asarray(molecule.model.positions)[molecule.atoms]
    crowd = np.array([(np.linalg.norm(nodes - one, axis=1) < CROWD).sum() for one in nodes])
    names = [str(name) for name in molecule.model.structure.residue_names[molecule.atoms]]
    left_out = {molecule.sites.find(text) for text in exclude}
    usual = method != "crosslink"
    return [
        k
        for k, name in enumerate(names)
        if (name not in NOT_LABELLED if usual else name in LINKED)
        and crowd[k] <= np.median(crowd)
        and k not in left_out
    ]


@checked(distances=whole(1), frames=whole(50), seed=SEED)
def design(
    start: Any,
    distances: int = 10,
    *,
    method: Literal["any", "fret", "deer", "crosslink"] = "any",
    exclude: Sequence[str] = (),
    frames: int = FRAMES,
    seed: int = 0,
    **options: Any,
) -> Design:
    """Says which distances to measure: those that tell most about the shapes in reach.

    Parameters
    ----------
    start : Structure, path, Universe, AtomGroup, ...
        A protein or nucleic acid, as ``sample`` takes it.
    distances : int
        How many at most: it stops where nothing is gained.
    method : str
        Which distances it can see: fret (20 to 80 Angstrom), deer (15 to 60), crosslink (two LYS up
        to 30 apart) or any.
    exclude : sequence of str
        Residues that cannot be labelled, such as "A:45".
    frames, seed : int
        Of the ensemble.
    **options
        What ``path`` takes of the molecule and its model: `select`, `contacts`, ...

    Raises
    ------
    OptionError
        An option out of range.
    InputError
        A file that cannot be read, or no pair of residues that the method can see.
    """
    if method not in RANGES:
        raise OptionError(f"method = {method!r}: must be one of {', '.join(RANGES)}")
    molecule = Molecule(start, seed, PathOptions(**options))
    sites = labelled(molecule, method, exclude)
    molecule.sampled(frames)
    found = best_pairs(molecule.ensemble.frames, sites, distances, RANGES[method], seed)
    if not found:
        raise InputError(
            f"{molecule.start.source}: no two residues can be labelled so that {method} sees their "
            "distance change"
        )
    labels = molecule.sites.labels
    rows = [
        {
            "site1": labels[one.pair[0]],
            "site2": labels[one.pair[1]],
            "mean": one.mean,
            "spread": one.spread,
            "explained": one.explained,
        }
        for one in found
    ]
    return Design(rows, distances, len(sites))
