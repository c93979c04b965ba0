# SPDX-License-Identifier: MIT
"""How near a technique leaves what it resolves: farthest move over size of the push.

``python tests/support/nearness.py [TECHNIQUE...]`` prints the table of the page on methods: for each
technique and structure, with and without hydrogens, the largest K of all pushes.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np

import pliant

MOLECULES = Path(__file__).parents[2] / "data" / "molecules"
SIZES = (0.001, 0.01, 0.1)
HYDROGEN = 1


@dataclass
class Case:
    """A molecule whose bars are whole at its positions."""

    name: str
    framework: pliant.Framework
    positions: np.ndarray


def without_hydrogens(name: str, framework: pliant.Framework, structure: pliant.Structure) -> Case:
    """The bars between heavy atoms: as if the file had no hydrogens."""
    heavy = np.asarray(structure.elements) != HYDROGEN
    number = np.cumsum(heavy) - 1
    bars = np.asarray(framework.bars)
    kept = heavy[bars].all(axis=1)
    positions = structure.positions[heavy]
    masses = 1.0 / framework.inverse_masses[heavy]
    return Case(
        name + " without H",
        pliant.Framework(number[bars[kept]], positions=positions, masses=masses),
        positions,
    )


def cases_of(file: Path, bars: str = "angles") -> Iterator[Case]:
    """The molecule of a file, and without its hydrogens if it has any."""
    structure = pliant.read(str(file))
    structure.perceive_bonds()
    framework = structure.framework(bars=bars)
    yield Case(file.name, framework, structure.positions.copy())
    if (np.asarray(structure.elements) == HYDROGEN).any():
        yield without_hydrogens(file.name, framework, structure)


def pushes(case: Case, size: float, seed: int) -> Iterator[tuple[int, np.ndarray]]:
    """(root, positions): of one joint, and of all joints by ``size`` each."""
    random = np.random.default_rng(seed)
    move = random.normal(size=case.positions.shape)
    move *= size / np.linalg.norm(move, axis=1)[:, None]
    root = int(random.integers(len(case.positions)))
    one = case.positions.copy()
    one[root] += move[root]
    yield root, one
    yield root, case.positions + move


def growth(resolver: pliant.Resolver, case: Case, size: float, seed: int) -> float:
    """The farthest move of any joint from where the push left it, over the size of the push."""
    farthest = 0.0
    for root, pushed in pushes(case, size, seed):
        resolved = pushed.copy()
        resolver.resolve(resolved, root=root, reference=case.positions)
        farthest = max(farthest, float(np.linalg.norm(resolved - pushed, axis=1).max()))
    return farthest / size


def largest_growth(
    case: Case, technique: str, seeds: range = range(3), max_sweeps: int = 10000
) -> float:
    """Over all sizes and seeds."""
    resolver = pliant.Resolver(case.framework, technique=technique, max_sweeps=max_sweeps)
    return max(growth(resolver, case, size, seed) for size in SIZES for seed in seeds)


def large_files() -> Iterator[Path]:
    """Adenylate kinase with hydrogens, and 4E43 without."""
    datafiles = __import__("MDAnalysisTests.datafiles", fromlist=["PDB_small"])
    yield Path(datafiles.PDB_small)
    yield Path(datafiles.PDB_full)


def main() -> None:
    """Prints the table."""
    names = sys.argv[1:] or ["units", "units_nearest"]
    files = [*sorted(MOLECULES.iterdir()), *large_files()]
    for case in (case for file in files for case in cases_of(file)):
        found = [largest_growth(case, name) for name in names]
        print(f"{case.name:40}", *(f"{name} {k:8.2f}" for name, k in zip(names, found, strict=True)))


if __name__ == "__main__":
    main()
