# SPDX-License-Identifier: MIT
"""The stages that answer a biologist: what is flexible, what moves together, is it a molecule."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

import numpy as np

from pliant._core import OptionError, node_b_factors
from pliant.measure.domains import LOOSE, correlations, find_domains
from pliant.measure.flexibility import flexibility, numbered_blocks, path_blocks
from pliant.measure.overlaps import ResidueContacts
from pliant.measure.rotatable import is_hydrogen
from pliant.measure.stages.names import phi_psi_pairs
from pliant.measure.stages.parts import (
    Components,
    ContactFrequencies,
    Correlations,
    Distances,
    ReferenceStructure,
    RigidDomains,
    Shapes,
    Torsions,
    UnitFlexibility,
    Units,
)
from pliant.measure.stereochemistry import Stereochemistry
from pliant.trajectory.kind import ENSEMBLE
from pliant.trajectory.superposition import superpose_frames

if TYPE_CHECKING:
    from pliant.measure.stages.analysis import Analysis
    from pliant.measure.stages.runner import Runner
    from pliant.trajectory.frame_store import FrameStore

#: frames whose chemistry and contacts are looked at, spread over all
LOOKED_AT = 100
#: chains shorter than this have no domains
LEAST_CHAIN = 20
#: domains are of at most so many units; more are thinned along their chains
MOST_DOMAIN_SITES = 500
#: numbers of frames of `pliant sample` are white within blocks of so many
WHITE = 100


def flexibility_of_units(
    analysis: Analysis, runner: Runner
) -> Iterator[UnitFlexibility | Correlations | RigidDomains]:
    """RMSF of the units with its error; correlations and domains of their sites.

    Of the frames around the start alone, where others reach further.
    """
    near = analysis.around_start
    if len(analysis.frames if near is None else analysis.frames[near]) < 4:
        raise ValueError("it needs at least 4 frames")
    units = analysis[Units]
    chosen = np.unique(np.concatenate([units.atoms, analysis.fitted.ix]))
    moved = analysis.stored_positions(chosen, near)
    superpose_frames(moved, np.searchsorted(chosen, analysis.fitted.ix))
    moved = moved.of_atoms(np.searchsorted(chosen, units.atoms))
    found = flexibility(moved, units.unit, _frame_blocks(analysis))
    yield UnitFlexibility(found, _b_estimate(analysis))
    if len(units.labels) < 4 or found.still:
        return
    every = np.arange(len(units.labels))[:: units.site_stride]
    yield Correlations(correlations(_sites(units, moved, every)))
    chain = np.flatnonzero(units.of_chain)
    if len(chain) >= LEAST_CHAIN:
        yield _domains(analysis, moved, chain)


def _domains(analysis: Analysis, moved: FrameStore, chain: np.ndarray) -> RigidDomains:
    """Of units of chains, thinned where there are many."""
    units = analysis[Units]
    stride = -(-len(chain) // MOST_DOMAIN_SITES)
    thinned = chain[::stride]
    blocks = None if analysis.kind == ENSEMBLE else _frame_blocks(analysis)
    found = find_domains(_sites(units, moved, thinned), units.chains[thinned], blocks)
    of_unit, hinge_share = np.full(len(units.labels), LOOSE), np.zeros(len(units.labels))
    of_unit[chain] = np.repeat(found.domain, stride)[: len(chain)]
    hinge_share[chain] = np.repeat(found.hinge_share, stride)[: len(chain)]
    return RigidDomains(found, thinned, of_unit, hinge_share)


def _frame_blocks(analysis: Analysis) -> list[np.ndarray]:
    """Blocks of frames that count as independent: the white ones of an ensemble, else stretches
    longer than the memory of the first three principal components."""
    if analysis.kind == ENSEMBLE:
        numbers = np.asarray(analysis.frames if analysis.steps is None else analysis.steps)
        near = analysis.around_start
        return numbered_blocks(numbers if near is None else numbers[near], WHITE)
    components = analysis.get(Components)
    if components is None or components.stride > 1:
        return path_blocks(np.arange(len(analysis.frames), dtype=float))
    return path_blocks(components.found.projections[:, :3])


def _sites(units: Units, moved: FrameStore, chosen: np.ndarray) -> np.ndarray:
    """(F, k, 3) centres of some units."""
    return np.concatenate([units.sites(block)[:, chosen] for block in moved.blocks()])


def _b_estimate(analysis: Analysis) -> np.ndarray | None:
    """(n,) B factors of a crystal of the reference, over their mean; NaN for units of no chain."""
    units = analysis[Units]
    chain = np.flatnonzero(units.of_chain)
    if len(chain) < LEAST_CHAIN:
        return None
    atoms = units.atoms[np.unique(units.unit, return_index=True)[1][chain]]
    values = np.full(len(units.labels), np.nan)
    names = units.chains[chain]
    numbers = np.cumsum(np.append(False, names[1:] != names[:-1]))
    values[chain] = node_b_factors(analysis[ReferenceStructure].positions[atoms], numbers)
    return values


def stereochemistry(analysis: Analysis, runner: Runner) -> Iterator[Shapes]:
    """Angles, hands, planes, backbone and overlaps of frames spread over all."""
    universe = analysis.universe
    elements = getattr(universe.atoms, "elements", None)
    if elements is None or not np.any(elements != ""):
        raise ValueError("the file does not say which elements the atoms are")
    if not hasattr(universe, "bonds") or len(universe.bonds) == 0:
        raise ValueError("the file has no bonds")
    known = analysis.get(Torsions)
    torsions = known.measured.torsions if known else []
    phi, psi = phi_psi_pairs(torsions)
    names = universe.residues.resnames if phi else []
    with_side_chain = [k for k, p in enumerate(phi) if names[torsions[p].residue] != "GLY"]
    measured = Stereochemistry(
        np.asarray(elements),
        np.asarray(universe.bonds.indices),
        analysis[ReferenceStructure].positions,
        [t.atoms for t in torsions if t.kind == "omega"],
        [torsions[phi[k]].atoms for k in with_side_chain],
        [torsions[psi[k]].atoms for k in with_side_chain],
    )
    looked_at = _spread(analysis)
    found = measured.run(analysis.positions(k) for k in looked_at)
    yield Shapes(measured, found, analysis.frames[looked_at])


def contacts(analysis: Analysis, runner: Runner) -> Iterator[ContactFrequencies]:
    """Residue contacts of frames spread over all, and of the reference."""
    units = analysis[Units]
    if units.what != "residue" or len(units.labels) < LEAST_CHAIN:
        return
    heavy = analysis.atoms[~is_hydrogen(analysis.atoms)]
    heavy = heavy[np.isin(heavy.resindices, units.owners)]
    finder = ResidueContacts(np.searchsorted(units.owners, heavy.resindices), units.chains)
    at_start = finder.of(analysis[ReferenceStructure].positions[heavy.ix])
    looked_at = _spread(analysis)
    keys = counts = np.zeros(0, dtype=np.int64)
    for k in looked_at:
        found = finder.of(analysis.positions(k)[heavy.ix])
        both = np.union1d(keys, found)
        more = np.isin(both, found).astype(np.int64)
        more[np.searchsorted(both, keys)] += counts
        keys, counts = both, more
    every = np.union1d(keys, at_start)
    share = np.zeros(len(every))
    share[np.searchsorted(every, keys)] = counts / len(looked_at)
    pairs = np.stack(np.divmod(every, len(units.labels)), axis=1)
    yield ContactFrequencies(pairs, share, np.isin(every, at_start), len(looked_at))


def distances(analysis: Analysis, runner: Runner) -> Iterator[Distances]:
    """Distances of the centres of the selections that were asked for."""
    asked = analysis.options.distances
    if asked:
        ends = [[_centres(analysis, selection) for selection in pair] for pair in asked]
        yield Distances(asked, tuple(np.linalg.norm(b - a, axis=1) for a, b in ends))


def _centres(analysis: Analysis, selection: str) -> np.ndarray:
    """(F, 3) centres of the atoms selected, Angstrom."""
    try:
        atoms = analysis.universe.select_atoms(selection)
    except Exception as error:  # MDAnalysis raises many kinds for a wrong selection
        reason = " ".join(str(error).split())
        raise OptionError(f"--distance '{selection}': {reason}") from error
    if len(atoms) == 0:
        raise OptionError(f"--distance '{selection}': selects no atoms")
    blocks = analysis.some_positions(atoms.ix)
    return np.concatenate([block.astype(np.float64).mean(axis=1) for block in blocks])


def _spread(analysis: Analysis) -> np.ndarray:
    """Places of at most LOOKED_AT frames, spread over those analysed."""
    count = min(LOOKED_AT, len(analysis.frames))
    return np.unique(np.linspace(0, len(analysis.frames) - 1, count).round().astype(int))
