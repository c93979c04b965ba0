# SPDX-License-Identifier: MIT
"""An analysis as one JSON object."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from pliant.base.verdict import Verdict, verdict_of_all
from pliant.measure.pockets.pocket_volumes import PocketVolumes
from pliant.measure.shapes.other_shapes import OtherShapes
from pliant.measure.stages.parts import (
    AtomFluctuations,
    Components,
    Distances,
    Gyration,
    Residuals,
    RigidDomains,
    Rmsd,
    Shapes,
    Sweeps,
    Torsions,
    UnitFlexibility,
)
from pliant.report.domains.domain_texts import domain_json
from pliant.report.pockets.pocket_texts import pockets_json
from pliant.report.shapes.shape_texts import shapes_json
from pliant.report.verdicts import shape_rows

if TYPE_CHECKING:
    from collections.abc import Callable

    from pliant.measure.stages.analysis import Analysis
    from pliant.measure.stages.parts import Part

Values = dict[str, Any]  #: JSON-ready


def summary(analysis: Analysis, outputs: Mapping[str, Any], made: Mapping[str, Verdict]) -> Values:
    """The analysis as JSON-ready values, what to believe of it (by `made`) first."""
    judged = verdict_of_all(made.values())
    values: Values = {
        "verdict": judged.kind,
        "verdict_text": judged.sentence,
        "input": analysis.options.path,
        "atoms": len(analysis.universe.atoms),
        "atoms_analysed": len(analysis.atoms),
        "superposed_on": analysis.fitted_name,
        "frames": len(analysis.frames),
        "first_frame": int(analysis.frames[0]),
        "last_frame": int(analysis.frames[-1]),
        "frames_are": analysis.kind,
        "judgement": judged.kind,
        "judgement_text": judged.sentence,
        "verdicts": {name: {"kind": v.kind, "text": v.sentence} for name, v in made.items()},
    }
    for part, values_of in VALUES.items():
        if part in analysis:
            values |= values_of(analysis)
    skipped, notes = dict(analysis.skipped), analysis.notes
    return values | {"skipped": skipped, "notes": notes, "outputs": outputs}


def _flexibility(analysis: Analysis) -> Values:
    found = analysis[UnitFlexibility].found
    return {
        "flexibility_mean": float(found.rmsf.mean()),
        "flexibility_error_mean": float(found.error.mean()),
        "flexibility_blocks": found.blocks,
        "halves_correlation": found.correlation,
        "halves_difference": found.difference,
        "converged": found.converged,
    }


def _shapes(analysis: Analysis) -> Values:
    rows = shape_rows(analysis)
    found = {row.name: {"found": row.found, "passed": bool(row.passed)} for row in rows}
    return {"stereochemistry": found}


def _distances(analysis: Analysis) -> Values:
    part = analysis[Distances]
    pairs = zip(part.ends, part.values, strict=True)
    found = [
        {"from": first, "to": second, "mean": float(values.mean()), "sd": float(values.std())}
        | {"smallest": float(values.min()), "largest": float(values.max())}
        for (first, second), values in pairs
    ]
    return {"distances": found}


def _residuals(analysis: Analysis) -> Values:
    part = analysis[Residuals]
    measured, found = part.measured, part.found
    values = {
        "bars": len(measured.bars),
        "tolerance": measured.tolerance,
        "tolerance_length": measured.tolerance_length,
        "precision": measured.precision,
        "rounded_to": measured.rounded_to,
        "max_residual": float(found.max_relative.max()),
        "frames_beyond_tolerance": int(np.count_nonzero(~found.within)),
    }
    if analysis.converged is not None and part.broken_promises is not None:
        values["frames_not_converged"] = int(np.count_nonzero(~analysis.converged))
        values["converged_but_beyond"] = int(np.count_nonzero(part.broken_promises))
    return values


def _sweeps(analysis: Analysis) -> Values:
    counts = analysis[Sweeps].counts
    return {"sweeps_mean": float(np.mean(counts)), "sweeps_max": int(np.max(counts))}


def _rmsd(analysis: Analysis) -> Values:
    values = analysis[Rmsd].fitted
    return {"rmsd_last": float(values[-1]), "rmsd_max": float(values.max())}


def _gyration(analysis: Analysis) -> Values:
    radius = analysis[Gyration].radius
    return {
        "radius_of_gyration_mean": float(radius.mean()),
        "radius_of_gyration_sd": float(radius.std()),
    }


def _components(analysis: Analysis) -> Values:
    found = analysis[Components].found
    values = {"pca_explained": found.explained[:10].tolist()}
    if len(found.cosine_content):
        values["pca_cosine_content"] = found.cosine_content.tolist()
    return values


#: in the order of the object; a part that is missing gives nothing
VALUES: dict[type[Part], Callable[[Analysis], Values]] = {
    UnitFlexibility: _flexibility,
    RigidDomains: domain_json,
    Shapes: _shapes,
    Distances: _distances,
    Residuals: _residuals,
    Sweeps: _sweeps,
    Rmsd: _rmsd,
    AtomFluctuations: lambda analysis: {
        "rmsf_mean": float(analysis[AtomFluctuations].found.rmsf.mean())
    },
    Gyration: _gyration,
    Torsions: lambda analysis: {"rotatable_bonds": len(analysis[Torsions].measured.torsions)},
    Components: _components,
    OtherShapes: shapes_json,
    PocketVolumes: pockets_json,
}
