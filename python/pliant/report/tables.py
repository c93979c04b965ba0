# SPDX-License-Identifier: MIT
"""The results as CSV files: one row per frame, atom, residue, bar, torsion or component.

Numbers are written with all their digits (but in flexibility.csv and pockets.csv);
atoms, residues, bars and frames count from 0.
"""

from __future__ import annotations

import csv
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from pliant.base.csv_cells import harmless
from pliant.base.new_file import new_text
from pliant.measure.pockets.pocket_volumes import PocketVolumes
from pliant.measure.shapes.other_shapes import OtherShapes
from pliant.measure.stages.names import atom_labels, bar_labels, chains_of
from pliant.measure.stages.parts import (
    MAX_ANGLES,
    AtomFluctuations,
    Components,
    ContactFrequencies,
    Correlations,
    Gyration,
    Part,
    Residuals,
    Rmsd,
    Shapes,
    Torsions,
    UnitFlexibility,
    Units,
)
from pliant.report.biology_tables import (
    contact_columns,
    correlation_columns,
    distance_columns,
    flexibility_columns,
    held_contact_columns,
    shape_columns,
)
from pliant.report.pockets.pocket_texts import volume_columns
from pliant.report.shapes.shape_texts import frame_shapes, pocket_columns, shapes_columns
from pliant.trajectory.drawn_by import DRAWN_BY

if TYPE_CHECKING:
    from MDAnalysis import AtomGroup
    from MDAnalysis.core.groups import ResidueGroup

    from pliant.measure.rotatable import Torsion
    from pliant.measure.stages.analysis import Analysis


#: Columns of equal length (arrays or lists) by their headers.
Columns = dict[str, Any]

#: components whose projections stand in frames.csv
PROJECTIONS = 10
#: cells of a table that are made into numbers and text at once
CELLS_AT_ONCE = 1 << 15


def save_tables(analysis: Analysis, folder: Path) -> list[Path]:
    """Writes the CSV files whose parts are there into a folder; returns their paths."""
    tables: dict[str, tuple[type[Part], Callable[[Analysis], Columns]]] = {
        "frames": (Units, frame_columns),
        "atoms": (AtomFluctuations, atom_columns),
        "residues": (AtomFluctuations, residue_columns),
        "bars": (Residuals, bar_columns),
        "torsions": (Torsions, torsion_columns),
        "torsion_histograms": (Torsions, histogram_columns),
        "torsion_angles": (Torsions, angle_columns),
        "pca": (Components, component_columns),
        "flexibility": (UnitFlexibility, flexibility_columns),
        "correlations": (Correlations, correlation_columns),
        "contacts": (ContactFrequencies, contact_columns),
        "held_contacts": (Units, held_contact_columns),
        "stereochemistry": (Shapes, shape_columns),
        "shapes": (OtherShapes, shapes_columns),
        "shape_pockets": (OtherShapes, pocket_columns),
        "pockets": (PocketVolumes, volume_columns),
    }
    written = []
    for name, (needs, columns_of) in tables.items():
        if needs in analysis and (columns := columns_of(analysis)):
            path = folder / f"{name}.csv"
            write_csv(path, columns)
            written.append(path)
    return written


def write_csv(path: Path, columns: Columns) -> None:
    """Writes columns {header: values of equal length} as CSV with a header line."""
    count = max(map(len, columns.values()))
    rows = max(1, CELLS_AT_ONCE // len(columns))
    with new_text(path, overwrite=True) as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(map(harmless, columns))
        for first in range(0, count, rows):
            values = [_cells(column[first : first + rows]) for column in columns.values()]
            writer.writerows(zip(*values, strict=True))


def _cells(column: Any) -> list[Any]:
    """The values of a column; text that a spreadsheet would run is made harmless."""
    if isinstance(column, np.ndarray) and column.dtype.kind in "fiub":
        return list(column.tolist())
    return [harmless(cell) for cell in (column.tolist() if hasattr(column, "tolist") else column)]


#: observables of a recording that go into the table of frames as they are
RECORDED = tuple(
    "sweeps projections root_joint redraws contacts_held contacts_broken contacts_off".split()
)


def frame_columns(analysis: Analysis) -> Columns:
    """One row per frame analysed."""
    columns: Columns = {"frame": analysis.frames}
    if analysis.steps is not None:
        columns["step"] = analysis.steps
    columns["time_ps"] = analysis.times
    if Residuals in analysis:
        columns |= _residual_columns(analysis)
    for name in RECORDED:
        if analysis.observable(name) is not None:
            columns[name] = analysis.observable(name)
    drawn_by = analysis.observable("sampler")
    if drawn_by is not None and drawn_by.any():
        columns["drawn_by"] = [DRAWN_BY[value] for value in drawn_by]
    columns |= frame_shapes(analysis)
    if distance := analysis.get(Rmsd):
        columns["rmsd_angstrom"] = distance.fitted
        if distance.analysed is not None:
            columns["rmsd_all_angstrom"] = distance.analysed
    if Gyration in analysis:
        columns["radius_of_gyration_angstrom"] = analysis[Gyration].radius
    return columns | distance_columns(analysis) | _projection_columns(analysis)


def _residual_columns(analysis: Analysis) -> Columns:
    residuals = analysis[Residuals]
    found = residuals.found
    ends = residuals.measured.bars[found.worst_bar]
    columns: Columns = {
        "max_relative_residual": found.max_relative,
        "rms_relative_residual": found.rms_relative,
        "max_residual_angstrom": found.max_length,
        "worst_bar": found.worst_bar,
        "worst_bar_i": ends[:, 0],
        "worst_bar_j": ends[:, 1],
        "within_tolerance": found.within.astype(int),
    }
    if analysis.converged is not None:
        columns["converged"] = analysis.converged.astype(int)
    return columns


def _projection_columns(analysis: Analysis) -> Columns:
    components = analysis.get(Components)
    if components is None or components.stride > 1:
        return {}
    projections = components.found.projections
    unit = "sqrt_u_angstrom" if analysis.options.mass_weighted else "angstrom"
    count = min(PROJECTIONS, projections.shape[1])
    return {f"pc{k + 1}_{unit}": projections[:, k] for k in range(count)}


def atom_columns(analysis: Analysis) -> Columns:
    """One row per atom analysed: its place in the molecule and how much it moves."""
    atoms, found = analysis.atoms, analysis[AtomFluctuations].found
    columns: Columns = {"atom": atoms.ix}
    for name, attribute in {"name": "names", "element": "elements"}.items():
        if hasattr(atoms, attribute):
            columns[name] = getattr(atoms, attribute)
    columns |= _residue_columns_of(atoms)
    columns["rmsf_angstrom"] = found.rmsf
    for k, axis in enumerate("xyz"):
        columns[f"average_{axis}_angstrom"] = found.average[:, k]
    return columns


def _residue_columns_of(group: AtomGroup | ResidueGroup) -> Columns:
    """Name, number and chain of the residue of each atom, or of each residue."""
    attributes = {"residue_name": "resnames", "residue_number": "resids"}
    columns = {name: getattr(group, a) for name, a in attributes.items() if hasattr(group, a)}
    return columns | ({"chain": chains_of(group)} if hasattr(group, "segids") else {})


def residue_columns(analysis: Analysis) -> Columns:
    """One row per residue."""
    found = analysis[AtomFluctuations].found
    residues = analysis.universe.residues[found.residues]
    columns: Columns = {"residue": found.residues} | _residue_columns_of(residues)
    return columns | {"rmsf_angstrom": found.residue_rmsf}


def bar_columns(analysis: Analysis) -> Columns:
    """One row per bar: its rest length and the largest residual it ever had."""
    residuals = analysis[Residuals]
    bars = residuals.measured.bars
    return {
        "bar": np.arange(len(bars)),
        "i": bars[:, 0],
        "j": bars[:, 1],
        "name": bar_labels(analysis.universe.atoms, bars),
        "rest_length_angstrom": residuals.measured.rest_lengths,
        "max_relative_residual": residuals.found.bar_max_relative,
    }


def torsion_columns(analysis: Analysis) -> Columns:
    """One row per rotatable bond."""
    torsions, found = analysis[Torsions].measured.torsions, analysis[Torsions].found
    atoms = np.array([t.atoms for t in torsions])
    names = atom_labels(analysis.universe.atoms)
    columns: Columns = {"torsion": [t.label for t in torsions], "kind": [t.kind for t in torsions]}
    for k, letter in enumerate("ijkl"):
        columns[letter] = atoms[:, k]
    columns["bond"] = [f"{names[t.atoms[1]]} – {names[t.atoms[2]]}" for t in torsions]
    columns["mean_degrees"] = found.mean
    columns["spread_degrees"] = found.spread
    return columns


def histogram_columns(analysis: Analysis) -> Columns:
    """One row per bin, one column per torsion: share of the frames per degree."""
    part = analysis[Torsions]
    edges = part.found.edges
    columns: Columns = {"from_degrees": edges[:-1], "to_degrees": edges[1:]}
    return columns | _one_column_each(part.measured.torsions, part.found.density)


def angle_columns(analysis: Analysis) -> Columns:
    """One row per frame, one column per torsion, degrees; none if that were too many numbers."""
    part = analysis[Torsions]
    if part.found.angles.size > MAX_ANGLES:
        return {}
    columns: Columns = {"frame": analysis.frames}
    return columns | _one_column_each(part.measured.torsions, part.found.angles.T)


def _one_column_each(torsions: Sequence[Torsion], rows: np.ndarray) -> Columns:
    """Columns by label; where a label occurs twice the atoms are added."""
    labels = [t.label for t in torsions]
    if len(set(labels)) < len(labels):
        labels = [f"{t.label} ({'-'.join(map(str, t.atoms))})" for t in torsions]
    return dict(zip(labels, rows, strict=True))


def component_columns(analysis: Analysis) -> Columns:
    """One row per principal component."""
    found = analysis[Components].found
    count = len(found.eigenvalues)
    cosine = np.full(count, np.nan)
    cosine[: len(found.cosine_content)] = found.cosine_content
    unit = "u_angstrom2" if analysis.options.mass_weighted else "angstrom2"
    return {
        "component": np.arange(1, count + 1),
        f"eigenvalue_{unit}": found.eigenvalues,
        "explained": found.explained,
        "cumulative": np.cumsum(found.explained),
        "cosine_content": ["" if np.isnan(c) else c for c in cosine.tolist()],
    }
