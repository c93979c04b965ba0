# SPDX-License-Identifier: MIT
"""How near a technique leaves what it resolves: farthest move over size of the push.

``python tests/support/python/nearness.py [TECHNIQUE...]`` prints the rows of the table that the
test of nearness has: the largest K of all pushes of one joint and of all, for bonds and for angles,
over all molecules with and without hydrogens.
"""

from __future__ import annotations

import importlib
import importlib.util
import math
import sys
import warnings
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from real_files import MOLECULES, biopython_file

import pliant

SIZES = (0.001, 0.01, 0.1)
HYDROGEN = 1
#: With angles sweeps do not get whole; by then they have gone as far as they go.
MOST_SWEEPS = 100


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


def growth(resolver: pliant.Resolver, case: Case, size: float, seed: int) -> np.ndarray:
    """(2,) for one joint pushed, for all: the farthest move of any joint from where the push left
    it, over the size of the push."""
    farthest = []
    for root, pushed in pushes(case, size, seed):
        resolved = pushed.copy()
        resolver.resolve(resolved, root=root, reference=case.positions)
        farthest.append(np.linalg.norm(resolved - pushed, axis=1).max())
    return np.array(farthest) / size


def growths(
    case: Case, technique: str, seeds: range = range(3), max_sweeps: int = 10000
) -> np.ndarray:
    """(2,) as `growth`, the largest over all sizes and seeds."""
    resolver = pliant.Resolver(case.framework, technique=technique, max_sweeps=max_sweeps)
    found = [growth(resolver, case, size, seed) for size in SIZES for seed in seeds]
    return np.max(found, axis=0)


def largest_growth(
    case: Case, technique: str, seeds: range = range(3), max_sweeps: int = 10000
) -> float:
    """Over all sizes and seeds, of one joint and of all."""
    return float(growths(case, technique, seeds, max_sweeps).max())


def large_files() -> list[Path]:
    """Adenylate kinase with hydrogens, 4E43 and 1A8O without: those that are installed."""
    found = []
    if importlib.util.find_spec("MDAnalysisTests") is not None:
        datafiles = importlib.import_module("MDAnalysisTests.datafiles")
        found = [Path(datafiles.PDB_small), Path(datafiles.PDB_full)]
    last = biopython_file("1A8O.pdb")
    return [*found, *([last] if last else [])]


@dataclass
class Row:
    """The largest K of a technique, and on which molecule it is."""

    technique: str
    bonds: np.ndarray  # (2,) one joint, all joints
    angles: np.ndarray
    largest_on: str

    def __str__(self) -> str:
        cells = " | ".join(f"{up(k):.1f}" for k in (*self.bonds, *self.angles))
        return f"| `{self.technique}` | {cells} | {self.largest_on} |"


def up(k: float) -> float:
    """Rounded up to a tenth."""
    return math.ceil(round(k, 3) * 10) / 10


def measure_row(row: pliant.TechniqueEntry, cases: dict[str, list[Case]]) -> Row:
    """Over all cases."""
    largest = {kind: np.zeros(2) for kind in cases}
    most, where = 0.0, ""
    for kind, some in cases.items():
        for case in some:
            if row.forests_only and not case.framework.graph_facts().is_forest:
                continue
            found = growths(case, row.name, max_sweeps=MOST_SWEEPS)
            largest[kind] = np.maximum(largest[kind], found)
            if found.max() > most:
                most, where = float(found.max()), f"{case.name}, {kind}"
    return Row(row.name, largest["bonds"], largest["angles"], where)


def all_cases() -> dict[str, list[Case]]:
    """Of all files, by the kind of bars."""
    files = [*sorted(MOLECULES.iterdir()), *large_files()]
    return {
        kind: [case for file in files for case in cases_of(file, kind)]
        for kind in ("bonds", "angles")
    }


def main() -> None:
    """Prints the rows of the table."""
    warnings.simplefilter("ignore", pliant.PliantWarning)
    asked = sys.argv[1:]
    cases = all_cases()
    for row in pliant.techniques():
        if not asked or row.name in asked:
            print(measure_row(row, cases), flush=True)


if __name__ == "__main__":
    main()
