# SPDX-License-Identifier: MIT
"""What ``pliant lab bench step`` pushes: frameworks, molecules of any size, and those of files."""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

import pliant
from pliant.lab.bench.large_frameworks import Large, protein, zigzag
from pliant.lab.bench.large_molecules import copies, many_peptides, peptide
from pliant.measure import bars as _bars

BARS = ("bonds", "angles")
MODELS = ("molecule", "protein")  #: of pliant.models(), besides those of bars alone


FRAMEWORKS: dict[str, Callable[[int], Large]] = {"protein": protein, "zigzag": zigzag}
MOLECULES: dict[str, Callable[[int], pliant.Structure]] = {
    "peptide": peptide,
    "copies": many_peptides,
}


@dataclass
class Scene:
    """A framework in positions in which it is whole."""

    kind: str  #: of the tables above, or the name of a file
    model: str  #: bonds, angles, molecule or protein
    framework: pliant.Framework
    positions: np.ndarray  #: (N, 3) Angstrom


def make_scene(source: str | os.PathLike[str], size: int | None, model: str) -> Scene:
    """A kind in one size; or the molecule of a file, copied side by side up to a size if given.

    Raises OptionError for a kind that there is not, or that the model is none of; InputError and
    FileError as `read` and `build_model` do.
    """
    name = os.fspath(source)
    if name in FRAMEWORKS:
        return _of_arrays(name, FRAMEWORKS[name](size or 0), model)
    if name in MOLECULES:
        return _of_structure(name, MOLECULES[name](size or 0), model)
    structure = pliant.read(source)
    if size is not None:
        structure = copies(structure, size)
    return _of_structure(os.path.basename(name), structure, model)


def check_kind(kind: str, model: str) -> None:
    """Refuses what make_scene() would refuse, before any work is done."""
    known = [*FRAMEWORKS, *MOLECULES]
    if kind not in known:
        raise pliant.OptionError(f'no kind named "{kind}"; known: {", ".join(known)}')
    if kind in FRAMEWORKS and model not in BARS:
        atoms = ", ".join(MOLECULES)
        raise pliant.OptionError(f'"{kind}" has no atoms, of which a model is made; {atoms} have')


def _of_structure(kind: str, structure: pliant.Structure, model: str) -> Scene:
    if model in BARS:
        return Scene(kind, model, structure.framework(model), np.array(structure.positions))
    built = pliant.build_model(structure, model)  # type: ignore[arg-type]  # one of MODELS
    return Scene(kind, model, built.framework, np.array(built.positions))


def _of_arrays(kind: str, large: Large, model: str) -> Scene:
    x, count = large.positions, len(large.positions)
    if model == "bonds":
        framework = pliant.Framework(
            large.bars.astype(np.uint32), _bars.lengths(x, large.bars), count
        )
    else:
        framework = pliant.Framework(with_angles(large.bars, count).astype(np.uint32), positions=x)
    return Scene(kind, model, framework, x)


def with_angles(bars: np.ndarray, count: int) -> np.ndarray:
    """(B', 2): the bars, and one between each two joints that have a neighbour in common."""
    ends = np.concatenate([bars, bars[:, ::-1]])
    ends = ends[np.argsort(ends[:, 0], kind="stable")]
    most = int(np.bincount(ends[:, 0], minlength=1).max(initial=0))
    pairs = [np.sort(bars, axis=1)]
    for apart in range(1, most):
        is_one = ends[apart:, 0] == ends[:-apart, 0]
        pairs.append(np.sort(np.column_stack([ends[apart:, 1], ends[:-apart, 1]])[is_one], axis=1))
    found = np.concatenate(pairs)
    _, first = np.unique(found @ [count, 1], return_index=True)
    kept: np.ndarray = found[np.sort(first)]
    return kept
