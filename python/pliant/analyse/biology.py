# SPDX-License-Identifier: MIT
"""The stages that answer a biologist: what is flexible, what moves together, is it a molecule."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pliant._core import OptionError, node_b_factors
from pliant.analyse.found import Contacts, Units
from pliant.analyse.kind import frame_blocks, kind_of
from pliant.analyse.names import phi_psi_pairs
from pliant.analyse.reference import reference_of
from pliant.analyse.units import units_of
from pliant.analysis.domains import correlations, find_domains
from pliant.analysis.flexibility import flexibility
from pliant.analysis.overlaps import ResidueContacts
from pliant.analysis.rotatable import is_hydrogen
from pliant.analysis.stereochemistry import Stereochemistry
from pliant.analysis.superposition import superpose_frames, superpose_onto

if TYPE_CHECKING:
    from pliant.analyse.study import Study
    from pliant.analysis.frame_store import FrameStore

#: frames whose chemistry and contacts are looked at, spread over all
LOOKED_AT = 100
#: frames that are superposed at a time, and bytes of their positions
AT_ONCE = 32
AT_ONCE_BYTES = 1 << 22
#: chains shorter than this have no domains
LEAST_CHAIN = 20


def basics(study: Study) -> None:
    """What kind of frames these are, their reference and units."""
    study.kind = kind_of(study)
    study.reference = reference_of(study)
    study.units = units_of(study)


def rmsd_to_reference(study: Study) -> None:
    """RMSD of independent frames from the reference: of the fitted atoms, and of all others too."""
    assert study.reference is not None
    fitted = np.isin(study.atoms.ix, study.fitted.ix)
    target = study.reference.positions[study.atoms.ix]
    values = np.empty((2, len(study.frames)))
    size = min(AT_ONCE, max(1, AT_ONCE_BYTES // (24 * len(study.atoms))))
    for first in range(0, len(study.frames), size):
        part = range(first, min(first + size, len(study.frames)))
        frames = np.array([study.positions(k)[study.atoms.ix] for k in part])
        squares = np.sum((superpose_onto(frames, fitted, target[fitted]) - target) ** 2, axis=2)
        values[:, part] = np.sqrt([squares[:, fitted].mean(axis=1), squares.mean(axis=1)])
    study.rmsd = values[0]
    study.rmsd_all = None if fitted.all() else values[1]


def flexibility_stage(study: Study) -> None:
    """RMSF of the units with its error; correlations and domains of their sites."""
    if len(study.frames) < 4:
        raise ValueError("it needs at least 4 frames")
    units = study.units
    assert units is not None
    chosen = np.unique(np.concatenate([units.atoms, study.fitted.ix]))
    fitted = np.searchsorted(chosen, study.fitted.ix)
    moved = study.stored_positions(chosen)
    superpose_frames(moved, fitted)
    moved = moved.of_atoms(np.searchsorted(chosen, units.atoms))
    study.flexibility = flexibility(moved, units.unit, frame_blocks(study))
    study.b_estimate = b_estimate(study)
    if len(units.labels) < 4 or study.flexibility.still:
        return
    every = np.arange(len(units.labels))[:: study.site_stride]
    study.correlations = correlations(_sites(units, moved, every))
    chain = np.flatnonzero(units.of_chain)[:: study.site_stride]
    if len(chain) >= LEAST_CHAIN:
        study.domains = find_domains(_sites(units, moved, chain), units.chains[chain])


def _sites(units: Units, moved: FrameStore, chosen: np.ndarray) -> np.ndarray:
    """(F, k, 3) centres of some units."""
    return np.concatenate([units.sites(block)[:, chosen] for block in moved.blocks()])


def b_estimate(study: Study) -> np.ndarray | None:
    """(n,) B factors of a crystal of the reference, over their mean; NaN for units of no chain."""
    units, reference = study.units, study.reference
    assert units is not None and reference is not None
    chain = np.flatnonzero(units.of_chain)
    if len(chain) < LEAST_CHAIN:
        return None
    atoms = units.atoms[np.unique(units.unit, return_index=True)[1][chain]]
    values = np.full(len(units.labels), np.nan)
    names = units.chains[chain]
    numbers = np.cumsum(np.append(False, names[1:] != names[:-1]))
    values[chain] = node_b_factors(reference.positions[atoms], numbers)
    return values


def stereochemistry_stage(study: Study) -> None:
    """Angles, hands, planes, backbone and overlaps of frames spread over all."""
    atoms = study.universe.atoms
    if not hasattr(atoms, "elements") or not np.any(atoms.elements != ""):
        raise ValueError("the file does not say which elements the atoms are")
    if not hasattr(study.universe, "bonds") or len(study.universe.bonds) == 0:
        raise ValueError("the file has no bonds")
    assert study.reference is not None
    torsions = study.torsions.torsions if study.torsions else []
    phi, psi = phi_psi_pairs(torsions)
    names = study.universe.residues.resnames if phi else []
    with_side_chain = [k for k, p in enumerate(phi) if names[torsions[p].residue] != "GLY"]
    measured = Stereochemistry(
        np.asarray(atoms.elements),
        np.asarray(study.universe.bonds.indices),
        study.reference.positions,
        [t.atoms for t in torsions if t.kind == "omega"],
        [torsions[phi[k]].atoms for k in with_side_chain],
        [torsions[psi[k]].atoms for k in with_side_chain],
    )
    study.shape = measured
    study.shape_results = measured.run(study.positions(k) for k in spread(study))


def contacts_stage(study: Study) -> None:
    """Residue contacts of frames spread over all, and of the reference."""
    units = study.units
    assert units is not None and study.reference is not None
    if units.what != "residue" or len(units.labels) < LEAST_CHAIN:
        return
    heavy = study.atoms[~is_hydrogen(study.atoms)]
    heavy = heavy[np.isin(heavy.resindices, units.owners)]
    finder = ResidueContacts(np.searchsorted(units.owners, heavy.resindices), units.chains)
    at_start = finder.of(study.reference.positions[heavy.ix])
    looked_at = spread(study)
    keys = counts = np.zeros(0, dtype=np.int64)
    for k in looked_at:
        found = finder.of(study.positions(k)[heavy.ix])
        both = np.union1d(keys, found)
        more = np.isin(both, found).astype(np.int64)
        more[np.searchsorted(both, keys)] += counts
        keys, counts = both, more
    every = np.union1d(keys, at_start)
    share = np.zeros(len(every))
    share[np.searchsorted(every, keys)] = counts / len(looked_at)
    pairs = np.stack(np.divmod(every, len(units.labels)), axis=1)
    study.contacts = Contacts(pairs, share, np.isin(every, at_start), len(looked_at))


def distances_stage(study: Study) -> None:
    """Distances of the centres of the selections that were asked for."""
    for first, second in study.options.distances:
        ends = []
        for selection in (first, second):
            try:
                atoms = study.universe.select_atoms(selection)
            except Exception as error:  # MDAnalysis raises many kinds for a wrong selection
                reason = " ".join(str(error).split())
                raise OptionError(f"--distance '{selection}': {reason}") from error
            if len(atoms) == 0:
                raise OptionError(f"--distance '{selection}': selects no atoms")
            parts = [
                block.astype(np.float64).mean(axis=1) for block in study.some_positions(atoms.ix)
            ]
            ends.append(np.concatenate(parts))
        study.distances.append(np.linalg.norm(ends[1] - ends[0], axis=1))


def spread(study: Study) -> np.ndarray:
    """Places of at most LOOKED_AT frames, spread over those analysed."""
    count = min(LOOKED_AT, len(study.frames))
    return np.unique(np.linspace(0, len(study.frames) - 1, count).round().astype(int))
