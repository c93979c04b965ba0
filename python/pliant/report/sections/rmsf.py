# SPDX-License-Identifier: MIT
"""RMSF of each atom and each residue, for tables."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from MDAnalysis import AtomGroup
from MDAnalysis.core.groups import ResidueGroup

from pliant.measure.rmsf import Rmsf
from pliant.measure.stages.analysis import Analysis
from pliant.measure.stages.names import chains_of
from pliant.measure.stages.parts import Measurement
from pliant.report.section import Columns
from pliant.report.sections.measured import Measured, has


@dataclass(frozen=True)
class AtomFluctuations(Measurement):
    """RMSF of each atom and residue."""

    measured: Rmsf


def _measure(analysis: Analysis) -> Iterator[AtomFluctuations]:
    if len(analysis.frames) < 2:
        raise ValueError("a single frame does not fluctuate")
    measured, near = Rmsf(analysis.atoms, superpose_on=analysis.fitted), analysis.around_start
    notes = []
    if not analysis.run(measured, around_start=True).average_converged:
        notes.append("the average structure of the RMSF did not come to rest")
    if near is not None:
        count = np.count_nonzero(near)
        notes.append(
            f"fluctuations, correlations and domains are those of the {count} frames "
            f"along modes; the other {len(near) - count} reach further"
        )
    yield AtomFluctuations(measured, notes=tuple(notes))


def _per_atom(analysis: Analysis) -> Columns:
    """Its place in the molecule and how much it moves."""
    atoms, found = analysis.atoms, analysis[AtomFluctuations].found
    columns: Columns = {"atom": atoms.ix}
    for name, attribute in {"name": "names", "element": "elements"}.items():
        if hasattr(atoms, attribute):
            columns[name] = getattr(atoms, attribute)
    columns |= _residues_of(atoms) | {"rmsf_angstrom": found.rmsf}
    axes = zip("xyz", found.average.T, strict=True)
    return columns | {f"average_{axis}_angstrom": values for axis, values in axes}


def _residues_of(group: AtomGroup | ResidueGroup) -> Columns:
    """Name, number and chain of the residue of each atom, or of each residue."""
    attributes = {"residue_name": "resnames", "residue_number": "resids"}
    columns = {name: getattr(group, a) for name, a in attributes.items() if hasattr(group, a)}
    return columns | ({"chain": chains_of(group)} if hasattr(group, "segids") else {})


def _per_residue(analysis: Analysis) -> Columns:
    found = analysis[AtomFluctuations].found
    residues = analysis.universe.residues[found.residues]
    columns: Columns = {"residue": found.residues} | _residues_of(residues)
    return columns | {"rmsf_angstrom": found.residue_rmsf}


RMSF = Measured(
    stage="RMSF",
    measure=_measure,
    applies=has(AtomFluctuations),
    values=lambda analysis: {"rmsf_mean": float(analysis[AtomFluctuations].found.rmsf.mean())},
    columns={"atoms": _per_atom, "residues": _per_residue},
    methods={
        "RMSF": (
            "Root mean square distance from the average place, after superposition on the average "
            "structure, which is found by iteration. For a residue: root of the mean of its atoms' "
            "squares."
        )
    },
)
