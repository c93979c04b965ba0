# SPDX-License-Identifier: MIT
"""A study as one JSON object."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from pliant.analyse.bar_verdict import verdict
from pliant.analyse.study import known
from pliant.analyse.verdicts import shape_rows, verdicts, whole

if TYPE_CHECKING:
    from pliant.analyse.study import Study


def summary(study: Study, outputs: Mapping[str, Any]) -> dict[str, Any]:
    """The study as JSON-ready values."""
    judged = verdict(study)
    values = {
        "input": study.options.path,
        "atoms": len(study.universe.atoms),
        "atoms_analysed": len(study.atoms),
        "superposed_on": study.fitted_name,
        "frames": len(study.frames),
        "first_frame": int(study.frames[0]),
        "last_frame": int(study.frames[-1]),
        "verdict": judged.kind,
        "verdict_text": judged.sentence,
    }
    for part in (
        _verdict_values,
        _flexibility_values,
        _shape_values,
        _residual_values,
        _motion_values,
        _torsion_values,
        _pca_values,
    ):
        values |= part(study)
    return values | {"skipped": study.skipped, "notes": study.notes, "outputs": outputs}


def _residual_values(study: Study) -> dict[str, Any]:
    if study.residuals is None:
        return {}
    found = study.residuals.results
    values = {
        "bars": len(study.residuals.bars),
        "tolerance": study.residuals.tolerance,
        "tolerance_length": study.residuals.tolerance_length,
        "precision": study.residuals.precision,
        "rounded_to": study.residuals.rounded_to,
        "max_residual": float(found.max_relative.max()),
        "frames_beyond_tolerance": int(np.count_nonzero(~found.within)),
    }
    if study.converged is not None:
        values["frames_not_converged"] = int(np.count_nonzero(~study.converged))
        values["converged_but_beyond"] = int(np.count_nonzero(known(study.broken_promises)))
    return values


def _motion_values(study: Study) -> dict[str, Any]:
    values: dict[str, Any] = {}
    sweeps = study.observable("sweeps")
    if sweeps is not None:
        values |= {"sweeps_mean": float(np.mean(sweeps)), "sweeps_max": int(np.max(sweeps))}
    if study.rmsd is not None:
        values |= {"rmsd_last": float(study.rmsd[-1]), "rmsd_max": float(study.rmsd.max())}
    if study.rmsf is not None:
        values["rmsf_mean"] = float(study.rmsf.results.rmsf.mean())
    if study.radius is not None:
        values |= {
            "radius_of_gyration_mean": float(study.radius.mean()),
            "radius_of_gyration_sd": float(study.radius.std()),
        }
    return values


def _torsion_values(study: Study) -> dict[str, Any]:
    if study.torsions is None:
        return {}
    return {"rotatable_bonds": len(study.torsions.torsions)}


def _pca_values(study: Study) -> dict[str, Any]:
    if study.pca is None:
        return {}
    found = study.pca.results
    values = {"pca_explained": found.explained[:10].tolist()}
    if len(found.cosine_content):
        values["pca_cosine_content"] = found.cosine_content.tolist()
    return values


def _flexibility_values(study: Study) -> dict[str, Any]:
    found = study.flexibility
    if found is None:
        return {}
    values = {
        "flexibility_mean": float(found.rmsf.mean()),
        "flexibility_error_mean": float(found.error.mean()),
        "flexibility_blocks": found.blocks,
        "halves_correlation": found.correlation,
        "halves_difference": found.difference,
        "converged": found.converged,
    }
    if study.domains is not None:
        values["domains"] = study.domains.count
        values["domains_explained"] = study.domains.explained
    return values


def _shape_values(study: Study) -> dict[str, Any]:
    rows = {row.name: {"found": row.found, "passed": bool(row.passed)} for row in shape_rows(study)}
    values: dict[str, Any] = {"stereochemistry": rows} if rows else {}
    asked = zip(study.options.distances, study.distances, strict=False)
    distances = [
        {"from": ends[0], "to": ends[1], "mean": float(found.mean()), "sd": float(found.std())}
        for ends, found in asked
    ]
    return values | ({"distances": distances} if distances else {})


def _verdict_values(study: Study) -> dict[str, Any]:
    made = {name: {"kind": v.kind, "text": v.sentence} for name, v in verdicts(study).items()}
    return {"frames_are": study.kind, "judgement": whole(study).kind, "verdicts": made}
