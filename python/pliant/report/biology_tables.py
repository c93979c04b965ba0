# SPDX-License-Identifier: MIT
"""Columns of the tables of flexibility, correlations, contacts, distances and stereochemistry."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from pliant.measure.collective import participation
from pliant.measure.stages.names import atom_labels
from pliant.measure.stages.parts import (
    Components,
    ContactFrequencies,
    Correlations,
    Distances,
    RigidDomains,
    Shapes,
    UnitFlexibility,
    Units,
    UnitsInComponents,
)

if TYPE_CHECKING:
    from pliant.measure.stages.analysis import Analysis

#: components whose motion of each unit stands in flexibility.csv
MOTIONS = 3


def flexibility_columns(analysis: Analysis) -> dict[str, Any]:
    """One row per residue, or atom of a small molecule: RMSF with its error, domain, motions."""
    part, units = analysis[UnitFlexibility], analysis[Units]
    found = part.found
    columns: dict[str, Any] = {
        units.what: units.labels,
        "chain": units.chains,
        "number": units.numbers,
        "of_chain": units.of_chain.astype(int),
        "rmsf_angstrom": np.round(found.rmsf, 4),
        "error_angstrom": np.round(found.error, 4),
        "first_half_angstrom": np.round(found.halves[0], 4),
        "second_half_angstrom": np.round(found.halves[1], 4),
        "converged": [int(found.converged)] * len(units.labels),
    }
    if part.b_estimate is not None:
        columns["b_estimate_over_mean"] = [
            "" if b != b else round(b, 3) for b in part.b_estimate.tolist()
        ]
    if RigidDomains in analysis:
        columns["domain"] = analysis[RigidDomains].of_unit + 1  # 0: none
        columns["hinge_share"] = analysis[RigidDomains].hinge_share
    if UnitsInComponents in analysis:
        moved, results = analysis[UnitsInComponents].units, analysis[Components].found
        share = participation(results.components[:MOTIONS])
        for k, row in enumerate(share):
            values = np.full(len(units.labels), np.nan)
            values[moved] = np.sqrt(row * results.eigenvalues[k])
            columns[f"pc{k + 1}_angstrom"] = [
                "" if v != v else round(v, 4) for v in values.tolist()
            ]
    return columns


def correlation_columns(analysis: Analysis) -> dict[str, Any]:
    """The correlation matrix, rounded to 4 digits; one column a unit."""
    units = analysis[Units]
    labels = units.labels[:: units.site_stride]
    unique = len(set(labels)) == len(labels)
    names = labels if unique else [f"{label} ({k})" for k, label in enumerate(labels)]
    columns: dict[str, Any] = {"unit": names}
    return columns | dict(zip(names, np.round(analysis[Correlations].matrix, 4), strict=True))


def contact_columns(analysis: Analysis) -> dict[str, Any]:
    """One row per pair of residues that are in contact at the start or in any frame looked at."""
    found, labels = analysis[ContactFrequencies], analysis[Units].labels
    return {
        "first": [labels[k] for k in found.pairs[:, 0]],
        "second": [labels[k] for k in found.pairs[:, 1]],
        "share_of_frames": found.share,
        "at_start": found.at_start.astype(int),
    }


def held_contact_columns(analysis: Analysis) -> dict[str, Any]:
    """One row per contact of the model: in what share of the frames it is held, broken, off."""
    contacts = analysis.record.contacts if analysis.record else None
    if contacts is None or contacts.states is None or len(contacts.states) <= max(analysis.frames):
        return {}
    names = atom_labels(analysis.universe.atoms)
    shares = contacts.shares(analysis.frames)
    return {
        "first": [names[joint] for joint in contacts.joints[:, 0]],
        "second": [names[joint] for joint in contacts.joints[:, 1]],
        "kind": contacts.kinds,
        "energy_kcal_per_mol": ["" if e != e else e for e in contacts.energies.tolist()],
        "share_held": shares[:, 0],
        "share_broken": shares[:, 1],
        "share_off": shares[:, 2],
    }


def distance_columns(analysis: Analysis) -> dict[str, Any]:
    """One column per distance that was asked for."""
    found = analysis.get(Distances)
    pairs = zip(found.ends, found.values, strict=True) if found else ()
    return {f"distance {first} to {second} (angstrom)": values for (first, second), values in pairs}


def shape_columns(analysis: Analysis) -> dict[str, Any]:
    """One row per frame looked at."""
    part = analysis[Shapes]
    found = part.found
    return {
        "frame": part.frames,
        "largest_angle_change_degrees": found.angle,
        "rms_angle_change_degrees": found.angle_rms,
        "centres_turned_over": found.flips,
        "furthest_out_of_plane_angstrom": found.plane,
        "omega_furthest_off_degrees": found.omega,
        "omega_beyond_30_degrees": found.twisted,
        "ramachandran_outliers": found.outliers,
        "ramachandran_favoured": found.favoured,
        "new_overlaps": found.overlaps,
        "deepest_new_overlap_angstrom": found.overlap,
    }
