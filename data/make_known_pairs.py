# SPDX-License-Identifier: MIT
"""Prints the table of known pairs that python/pliant/measure/shapes/known_pairs.py holds, and how
well quartiles of pairs of like softness hold for a protein that is left out.

Usage: .venv/bin/python data/make_known_pairs.py FOLDER...
FOLDERs are those of `pliant lab bench coverage --data`: subfolders with two structures each.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
from pliant._core import softness
from pliant.lab.pairs.directions import directions_of
from pliant.lab.structures import read_quietly
from pliant.measure.shapes.known_pairs import quartiles_of_like
from pliant.trajectory.superposition import rmsd_to
from scipy.stats import spearmanr


def alpha_carbons(path: Path) -> dict[int, np.ndarray]:
    """Positions by residue number."""
    structure = read_quietly(path)
    chosen = np.flatnonzero(np.array(structure.names) == "CA")
    numbers = np.array(structure.residue_ids)[chosen]
    return dict(zip(numbers.tolist(), np.array(structure.positions)[chosen], strict=True))


def main() -> None:
    """Prints the rows, and the figures of leaving one protein out."""
    rows = []
    for folder in map(Path, sys.argv[1:]):
        for direction in directions_of(folder):
            start, goal = alpha_carbons(direction.start), alpha_carbons(direction.goal)
            shared = sorted(start.keys() & goal.keys())
            ours, theirs = (np.array([ends[k] for k in shared]) for ends in (start, goal))
            off = float(rmsd_to(ours[None], theirs[None])[0, 0])
            rows.append((direction.protein, softness(np.array(list(start.values()))), off))
    for protein, soft, off in sorted(rows, key=lambda row: row[1]):
        print(f"    ({soft:.4f}, {off:.2f}),  # {protein}")
    proteins = np.array([row[0] for row in rows])
    known = np.array([row[1:] for row in rows])
    inside, width = [], []
    for protein, (soft, off) in zip(proteins, known, strict=True):
        found = quartiles_of_like(soft, known[proteins != protein])
        if found is not None:
            inside.append(found[0] <= off <= found[2])
            width.append(found[2] - found[0])
    every = np.percentile(known[:, 1], [25, 75])
    line = np.polyfit(*np.log(known.T), 1)
    print(f"ln(distance) = {line[1]:.2f} + {line[0]:.2f} ln(softness)")
    print(
        f"Spearman {spearmanr(*known.T)[0]:.2f}; left out: {np.mean(inside):.0%} of {len(inside)}"
    )
    print(f"lie between the quartiles, {np.mean(width):.1f} Å apart; of all {np.ptp(every):.1f} Å")


if __name__ == "__main__":
    main()
