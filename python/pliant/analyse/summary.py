# SPDX-License-Identifier: MIT
"""The few numbers and sentences that a study comes down to."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from pliant.analyse.figures.torsion_figures import most_mobile
from pliant.analyse.names import bar_labels, greek, residue_labels
from pliant.analyse.study import known

if TYPE_CHECKING:
    from pliant.analyse.study import Study


#: A table of the page: caption, headers, rows of text.
PageTable = tuple[str, Sequence[str], Sequence[Sequence[str]]]


@dataclass(frozen=True)
class Verdict:
    """Whether the run kept its promise, in a sentence."""

    kind: str  #: "good", "mixed", "bad" or "open" (there is nothing to judge)
    sentence: str
    details: str


def verdict(study: Study) -> Verdict:
    """Judges the bars of all frames analysed, from the coordinates."""
    if study.residuals is None:
        return Verdict(
            "open", "There are no bars in this file to judge.", study.skipped["bar residuals"]
        )
    within = study.residuals.results.within
    beyond = np.count_nonzero(~within)
    details = _worst(study)
    if beyond == 0:
        return Verdict("good", "Every bar of every frame is within tolerance.", details)
    broken = study.broken_promises
    count = f"{beyond} of {len(within)} frames"
    if broken is None:
        return Verdict("bad", f"{count} have a bar beyond tolerance.", details)
    if broken.any():
        called = f"{np.count_nonzero(broken)} of which the run calls converged"
        sentence = f"{count} have a bar beyond tolerance, {called}."
        return Verdict("bad", sentence, details)
    sentence = f"{count} have a bar beyond tolerance; the run says so of each."
    return Verdict("mixed", sentence, details)


def tolerance_text(study: Study) -> str:
    """The tolerance with its unit."""
    residuals = known(study.residuals)
    if residuals.tolerance_length > 0:
        return f"{residuals.tolerance_length:g} Å"
    return scientific(residuals.tolerance, 0)


def scientific(value: float, digits: int = 2) -> str:
    """A small number for readers: 9.97 × 10⁻⁷; for 10⁻⁶ sharp only the power."""
    mantissa, exponent = f"{value:.{digits}e}".split("e")
    power = "10" + str(int(exponent)).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))
    if value == 0:
        return "0"
    return power if mantissa == "1" else f"{mantissa} × {power}"


def _worst(study: Study) -> str:
    residuals = known(study.residuals)
    found = residuals.results
    k = int(np.argmax(found.max_relative))
    bar = residuals.bars[found.worst_bar[k]]
    (name,) = bar_labels(study.universe.atoms, [bar])
    where = f"frame {study.frames[k]}"
    if study.steps is not None:
        where += f" (step {study.steps[k]})"
    return (
        f"The worst is off by {scientific(found.max_relative[k])} of its length (tolerance "
        f"{tolerance_text(study)}): bar {name} in {where}. Computed anew from the "
        f"{'double' if residuals.precision == 'float64' else 'single'} precision "
        "coordinates in the file."
    )


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
    for part in (_residual_values, _motion_values, _torsion_values, _pca_values):
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


def facts(study: Study) -> list[tuple[str, str, str]]:
    """Up to seven (number, unit, meaning) for the side of the page."""
    rows = []
    if study.residuals is not None:
        worst = study.residuals.results.max_relative.max()
        rows.append(
            (scientific(worst), "", f"largest relative residual; tolerance {tolerance_text(study)}")
        )
    sweeps = study.observable("sweeps")
    if sweeps is not None:
        rows.append(
            (f"{np.mean(sweeps):.1f}", "", f"sweeps a step on average, {np.max(sweeps)} at most")
        )
    if study.rmsd is not None:
        text = f"RMSD of the last frame from the first, {study.fitted_name}"
        rows.append((f"{study.rmsd[-1]:.2f}", "Å", text))
    if study.rmsf is not None:
        rows.append(
            (f"{study.rmsf.results.rmsf.mean():.2f}", "Å", "mean fluctuation of an atom (RMSF)")
        )
    if study.radius is not None:
        rows.append(
            (f"{study.radius.mean():.2f}", "Å", f"radius of gyration, ± {study.radius.std():.2g} Å")
        )
    if study.torsions is not None:
        rows.append((str(len(study.torsions.torsions)), "", "rotatable bonds"))
    if study.pca is not None:
        rows.append(
            (
                f"{100 * study.pca.results.explained[0]:.0f}",
                "%",
                "of the motion along one direction (PC1)",
            )
        )
    return rows


def tables(study: Study) -> list[PageTable]:
    """Tables for the page: (caption, headers, rows of text)."""
    made = []
    if study.residuals is not None:
        made.append(_bar_table(study))
    if study.rmsf is not None and len(study.rmsf.results.residues) > 1:
        made.append(_residue_table(study))
    if study.torsions is not None:
        made.append(_torsion_table(study))
    if study.pca is not None:
        made.append(_component_table(study))
    return made


def _bar_table(study: Study) -> PageTable:
    residuals = known(study.residuals)
    values = residuals.results.bar_max_relative
    chosen = np.argsort(-values, kind="stable")[:8]
    names = bar_labels(study.universe.atoms, residuals.bars[chosen])
    lengths = residuals.rest_lengths[chosen]
    rows = [
        (n, f"{length:.4f}", scientific(values[k]))
        for n, length, k in zip(names, lengths, chosen, strict=True)
    ]
    return "Bars that were furthest off", ("bar", "rest length (Å)", "largest residual"), rows


def _residue_table(study: Study) -> PageTable:
    found = known(study.rmsf).results
    chosen = np.argsort(-found.residue_rmsf, kind="stable")[:8]
    names = residue_labels(study.universe.residues)
    rows = [(names[found.residues[k]], f"{found.residue_rmsf[k]:.3f}") for k in chosen]
    return "Most mobile residues", ("residue", "RMSF (Å)"), rows


def _torsion_table(study: Study) -> PageTable:
    torsions = known(study.torsions)
    found = torsions.results
    rows = [
        (
            greek(torsions.torsions[k].label),
            f"{found.mean[k]:.0f}°",
            f"{found.spread[k]:.0f}°",
        )
        for k in sorted(most_mobile(torsions, 8), key=lambda k: -found.spread[k])
    ]
    return "Most mobile torsions", ("torsion", "circular mean", "spread"), rows


def _component_table(study: Study) -> PageTable:
    found = known(study.pca).results
    rows = []
    for k, share in enumerate(found.explained[:5]):
        cosine = f"{found.cosine_content[k]:.2f}" if k < len(found.cosine_content) else "–"
        rows.append((f"PC{k + 1}", f"{found.eigenvalues[k]:.4g}", f"{100 * share:.1f} %", cosine))
    unit = "u Å²" if study.options.mass_weighted else "Å²"
    return "Principal components", ("", f"variance ({unit})", "share", "cosine content"), rows


def title(study: Study) -> str:
    """Name of the molecule's file, or of the trajectory."""
    if study.record and study.record.parameters.get("input/file"):
        return Path(str(study.record.parameters["input/file"])).name
    return Path(study.options.path).name
