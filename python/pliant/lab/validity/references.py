# SPDX-License-Identifier: MIT
"""What ensembles are compared with: NMR models, MD trajectories, other structures, B factors."""

from __future__ import annotations

import os
import warnings
from dataclasses import dataclass

import MDAnalysis
import numpy as np

import pliant
from pliant.lab.structures import LETTERS, Trace, amino_part, read_quietly, trace_of
from pliant.measure.joined_chains import joined_along


@dataclass(frozen=True)
class ReferenceEnsemble:
    """Alpha carbons of R residues in F frames."""

    sequence: str
    frames: np.ndarray  #: (F, R, 3) Angstrom


def models_of(path: str | os.PathLike[str]) -> ReferenceEnsemble:
    """All models of a file."""
    first = read_quietly(path)
    trace = trace_of(first)
    models = [first, *(read_quietly(path, k) for k in range(2, first.model_count + 1))]
    return ReferenceEnsemble(trace.sequence, np.array([trace_of(one).positions for one in models]))


def trajectory_of(
    topology: str | os.PathLike[str], path: str | os.PathLike[str]
) -> ReferenceEnsemble:
    """A trajectory that MDAnalysis reads; alpha carbons across a cell's border are joined."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of missing masses and the like
        universe = MDAnalysis.Universe(os.fspath(topology), os.fspath(path))
        alpha = universe.select_atoms("name CA and protein")
        frames = [joined_along(alpha.positions, step.dimensions) for step in universe.trajectory]
    letters = (LETTERS.get(str(name), "X") for name in alpha.resnames)
    return ReferenceEnsemble("".join(letters), np.array(frames))


@dataclass(frozen=True)
class BFactors:
    """Alpha carbons of a file, and the longest chain's B factors."""

    structure: pliant.Structure  #: amino acids of all chains
    trace: Trace  #: of it
    chain: np.ndarray  #: (K,) residues of the longest chain, into the trace
    values: np.ndarray  #: (K,) Angstrom^2
    estimate: np.ndarray  #: (K,) ``estimate_b_factors``


def b_factors_of(path: str | os.PathLike[str]) -> BFactors:
    """Of a PDB or mmCIF file. Raises InputError as amino_part does."""
    whole = read_quietly(path)
    structure = amino_part(whole)
    trace = trace_of(structure)
    names = [str(chain) for chain in structure.chains[trace.atoms]]
    longest = max(sorted(set(names)), key=names.count)
    estimate, atoms = pliant.estimate_b_factors(whole)
    place = {key: k for k, key in enumerate(_keys(whole, atoms))}
    keys = _keys(structure, trace.atoms)
    kept = [k for k, name in enumerate(names) if name == longest and keys[k] in place]
    own = np.array([place[keys[k]] for k in kept])
    values = np.asarray(whole.b_factors, dtype=np.float64)[atoms[own]]
    return BFactors(structure, trace, np.array(kept), values, estimate[own])


def _keys(structure: pliant.Structure, atoms: np.ndarray) -> list[tuple[str, int, str]]:
    """Chain, number and insertion code of each atom's residue."""
    columns = (structure.chains, structure.residue_ids, structure.insertion_codes)
    return [(str(a), int(b), str(c)) for a, b, c in zip(*(x[atoms] for x in columns), strict=True)]
