# SPDX-License-Identifier: MIT
"""What ensembles are compared with: NMR models, MD trajectories, other structures, B factors."""

from __future__ import annotations

import gzip
import os
import warnings
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np

import pliant
from pliant.analysis.sequence import LETTERS
from pliant.analysis.traces import joined_along
from pliant.lab.validity.trace import Trace, amino_part, trace_of


@dataclass(frozen=True)
class Reference:
    """Alpha carbons of R residues in F frames."""

    sequence: str
    frames: np.ndarray  #: (F, R, 3) Angstrom


def read_quietly(path: str | os.PathLike[str], model: int = 1) -> pliant.Structure:
    """A model of a file, without warnings of its columns, alternates and links."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", pliant.PliantWarning)
        return pliant.read(path, model)


def models_of(path: str | os.PathLike[str]) -> Reference:
    """All models of a file."""
    first = read_quietly(path)
    trace = trace_of(first)
    models = [first, *(read_quietly(path, k) for k in range(2, first.model_count + 1))]
    return Reference(trace.sequence, np.array([trace_of(one).positions for one in models]))


def trajectory_of(topology: str | os.PathLike[str], path: str | os.PathLike[str]) -> Reference:
    """A trajectory that MDAnalysis reads; alpha carbons across a cell's border are joined."""
    import MDAnalysis

    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of missing masses and the like
        universe = MDAnalysis.Universe(os.fspath(topology), os.fspath(path))
        alpha = universe.select_atoms("name CA and protein")
        frames = [joined_along(alpha.positions, step.dimensions) for step in universe.trajectory]
    letters = (LETTERS.get(str(name), "X") for name in alpha.resnames)
    return Reference("".join(letters), np.array(frames))


@dataclass(frozen=True)
class BFactors:
    """Alpha carbons of a file, and the longest chain's B factors."""

    structure: pliant.Structure  #: amino acids of all chains
    trace: Trace  #: of it
    chain: np.ndarray  #: (K,) residues of the longest chain, into the trace
    values: np.ndarray  #: (K,) Angstrom^2


def b_factors_of(path: str | os.PathLike[str]) -> BFactors:
    """Of a PDB file. Raises InputError as amino_part does."""
    structure = amino_part(read_quietly(path))
    trace = trace_of(structure)
    lines = dict(_alpha_lines(Path(path)))
    keys = [
        (str(structure.chains[a]), int(structure.residue_ids[a]),
         str(structure.insertion_codes[a]))
        for a in trace.atoms
    ]  # fmt: skip
    chains = [chain for chain, _, _ in keys]
    longest = max(sorted(set(chains)), key=chains.count)
    kept = [k for k, key in enumerate(keys) if key[0] == longest and key in lines]
    return BFactors(structure, trace, np.array(kept), np.array([lines[keys[k]] for k in kept]))


def _alpha_lines(path: Path) -> Iterator[tuple[tuple[str, int, str], float]]:
    """Chain, number, insertion code and B factor of each CA of the first model."""
    data = path.read_bytes()
    text = (gzip.decompress(data) if path.suffix == ".gz" else data).decode("latin-1")
    for line in text.split("\nENDMDL")[0].splitlines():
        is_atom = line.startswith(("ATOM  ", "HETATM"))
        if is_atom and line[12:16] == " CA " and line[16] in " A1":
            yield (line[21].strip(), int(line[22:26]), line[26].strip()), float(line[60:66])
