# SPDX-License-Identifier: MIT
"""The numbers of the page: its facts and its tables."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from pliant.analyse.bar_verdict import scientific, tolerance_text
from pliant.analyse.figures.torsion_figures import most_mobile
from pliant.analyse.found import ENSEMBLE, TRANSITION
from pliant.analyse.names import bar_labels, greek
from pliant.analyse.page.sections import CHEMISTRY, COLLECTIVE, EXACT, FLEXIBLE, SHAPES, TOGETHER
from pliant.analyse.study import known
from pliant.analyse.verdicts import shape_rows
from pliant.analysis.collective import collectivity, moving_stretches, participation

if TYPE_CHECKING:
    from pliant.analyse.study import Study


#: share of the frames from which a contact counts as kept, and below which as lost
KEPT = 0.9
LOST = 0.1
#: share of the frames from which a contact that the start lacks counts as gained
GAINED = 0.5


@dataclass(frozen=True)
class PageTable:
    """A table of the page, in text."""

    section: str
    caption: str
    headers: Sequence[str]
    rows: Sequence[Sequence[str]]


def facts(study: Study) -> list[tuple[str, str, str]]:
    """Up to seven (number, unit, meaning) for the side of the page, biology first."""
    rows = [*_flexible_facts(study), *_chemical_facts(study)]
    if study.radius is not None:
        rows.append(
            (f"{study.radius.mean():.2f}", "Å", f"radius of gyration, ± {study.radius.std():.2g} Å")
        )
    if study.torsions is not None:
        rows.append((str(len(study.torsions.torsions)), "", "rotatable bonds"))
    if study.residuals is not None:
        worst = study.residuals.results.max_relative.max()
        rows.append(
            (scientific(worst), "", f"largest relative residual; tolerance {tolerance_text(study)}")
        )
    return rows[:7]


def _flexible_facts(study: Study) -> list[tuple[str, str, str]]:
    rows = []
    if study.flexibility is not None and study.kind != TRANSITION:
        found, units = study.flexibility, known(study.units)
        text = f"mean fluctuation of a{'n atom' if units.what == 'atom' else ' residue'} (RMSF)"
        rows.append((f"{found.rmsf.mean():.2f} ± {2 * found.error.mean():.1g}", "Å", text))
    if study.domains is not None:
        count, share = study.domains.count, 100 * study.domains.explained
        text = f"domains, which explain {share:.0f} % of the motion by moving rigidly"
        rows.append((str(count), "", text if count > 1 else "piece: no domains were found"))
    if study.pca is not None:
        share = 100 * study.pca.results.explained[0]
        rows.append((f"{share:.0f}", "%", "of the motion along one direction (PC1)"))
    if study.rmsd is not None:
        if study.kind == ENSEMBLE:
            text = f"mean RMSD from {known(study.reference).name}, {study.fitted_name}"
            rows.append((f"{study.rmsd.mean():.2f}", "Å", text))
        else:
            text = f"RMSD of the last frame from the first, {study.fitted_name}"
            rows.append((f"{study.rmsd[-1]:.2f}", "Å", text))
    return rows


def _chemical_facts(study: Study) -> list[tuple[str, str, str]]:
    rows = []
    if study.contacts is not None:
        found = study.contacts
        kept = int(np.count_nonzero(found.at_start & (found.share >= KEPT)))
        text = f"of {np.count_nonzero(found.at_start)} contacts of residues kept in 90 % of frames"
        rows.append((str(kept), "", text))
    return rows


def tables(study: Study) -> list[PageTable]:
    """Tables for the page, in no order of sections."""
    made = []
    if study.flexibility is not None:
        made.append(_flexible_table(study))
    if study.domains is not None and study.domains.count > 1:
        made.append(_domain_table(study))
    if study.pca is not None:
        made.append(_component_table(study))
    if shape_rows(study):
        made.append(_shape_table(study))
    if study.contacts is not None:
        made.append(_contact_table(study))
    if study.distances:
        made.append(_distance_table(study))
    if study.torsions is not None:
        made.append(_torsion_table(study))
    if study.residuals is not None:
        made.append(_bar_table(study))
    return made


def _flexible_table(study: Study) -> PageTable:
    found, units = known(study.flexibility), known(study.units)
    rows = [
        (units.labels[k], f"{found.rmsf[k]:.3f}", f"± {2 * found.error[k]:.2g}")
        for k in np.argsort(-found.rmsf, kind="stable")[:8]
    ]
    if study.kind == TRANSITION:
        caption = f"{units.what.capitalize()}s that move most on the way"
        return PageTable(FLEXIBLE, caption, (units.what, "RMSF (Å)"), [row[:2] for row in rows])
    caption = f"Most flexible {units.what}s"
    if not found.converged:
        caption += " (not converged)"
    return PageTable(FLEXIBLE, caption, (units.what, "RMSF (Å)", "two errors"), rows)


def _domain_table(study: Study) -> PageTable:
    found, units = known(study.domains), known(study.units)
    chain = np.flatnonzero(units.of_chain)[:: study.site_stride]
    labels = [units.labels[k] for k in chain]
    rows = []
    for k in range(found.count):
        sites = np.flatnonzero(study.unit_domains == k)
        ends = (np.diff(sites) > 1) | (units.chains[sites[1:]] != units.chains[sites[:-1]])
        parts = np.split(sites, np.flatnonzero(ends) + 1)
        text = ", ".join(f"{units.labels[p[0]]} to {units.labels[p[-1]]}" for p in parts)
        rows.append((f"{k + 1}", text))
    hinges = ", ".join(f"{labels[a]}|{labels[b]}" for a, b in found.hinges)
    rows.append(("hinges", hinges or "none within a chain"))
    return PageTable(TOGETHER, "Domains that move as rigid bodies", ("domain", "residues"), rows)


def _component_table(study: Study) -> PageTable:
    found = known(study.pca).results
    share = participation(found.components[:5])
    spread = collectivity(found.components[:5])
    rows = []
    for k, part in enumerate(found.explained[:5]):
        cosine = f"{found.cosine_content[k]:.2f}" if k < len(found.cosine_content) else "–"
        moves = _moves(study, share[k])
        rows.append((f"PC{k + 1}", f"{100 * part:.1f} %", cosine, f"{spread[k]:.2f}", moves))
    headers = ("", "share", "cosine content", "collectivity", "moves most")
    return PageTable(COLLECTIVE, "Principal components", headers, rows)


def _moves(study: Study, share: np.ndarray) -> str:
    """Which stretches a component moves most, in words."""
    units, moved = known(study.units), study.component_units
    if moved is None:
        return "–"
    labels = [units.labels[k] for k in moved]
    if units.what == "atom":
        return ", ".join(labels[k] for k in np.argsort(-share, kind="stable")[:3])
    return ", ".join(
        labels[a] if a == b else f"{labels[a]} to {labels[b]}"
        for a, b, _ in moving_stretches(share, units.chains[moved])
    )


def _shape_table(study: Study) -> PageTable:
    rows = [
        (("✓ " if row.passed else "✕ ") + row.name, row.found, row.start, row.limit)
        for row in shape_rows(study)
    ]
    headers = ("question", "frames", known(study.reference).name, "allowed")
    return PageTable(CHEMISTRY, "Stereochemistry", headers, rows)


def contact_classes(study: Study) -> dict[str, np.ndarray]:
    """Masks of the contacts that are kept, come and go, lost, and gained."""
    found = known(study.contacts)
    start, share = found.at_start, found.share
    return {
        "kept": start & (share >= KEPT),
        "come and go": start & (share < KEPT) & (share > LOST),
        "lost": start & (share <= LOST),
        "gained": ~start & (share >= GAINED),
    }


def _contact_table(study: Study) -> PageTable:
    found, labels = known(study.contacts), known(study.units).labels
    classes = contact_classes(study)
    meaning = {
        "kept": "of the start, in 90 % of frames and more", "come and go": "of the start, between",
        "lost": "of the start, in 10 % and less", "gained": "not of the start, in 50 % and more",
    }  # fmt: skip
    rows = [(name, meaning[name], str(np.count_nonzero(classes[name]))) for name in classes]
    least = np.flatnonzero(found.at_start)
    for k in least[np.argsort(found.share[least], kind="stable")][:5]:
        a, b = found.pairs[k]
        rows.append((f"{labels[a]} – {labels[b]}", "among the least kept", f"{found.share[k]:.0%}"))
    caption = f"Contacts of residues, in {found.frames} frames"
    return PageTable(CHEMISTRY, caption, ("contacts", "", "number, share"), rows)


def _distance_table(study: Study) -> PageTable:
    rows = [
        (f"{ends[0]} to {ends[1]}", f"{values.mean():.2f}", f"{values.std():.2f}",
         f"{values.min():.2f} to {values.max():.2f}")
        for ends, values in zip(study.options.distances, study.distances, strict=True)
    ]  # fmt: skip
    headers = ("distance", "mean (Å)", "standard deviation", "range")
    return PageTable(SHAPES, "Distances asked for", headers, rows)


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
    return PageTable(
        EXACT, "Bars that were furthest off", ("bar", "rest length (Å)", "largest residual"), rows
    )


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
    headers = ("torsion", "circular mean", "spread")
    return PageTable(SHAPES, "Most mobile torsions", headers, rows)


def title(study: Study) -> str:
    """Name of the molecule's file, or of the trajectory."""
    if study.record and study.record.parameters.get("input/file"):
        return Path(str(study.record.parameters["input/file"])).name
    return Path(study.options.path).name
