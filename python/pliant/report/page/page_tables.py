# SPDX-License-Identifier: MIT
"""The numbers of the page: its facts and its tables."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from pliant.measure.collective import collectivity, moving_stretches, participation
from pliant.measure.pockets.pocket_volumes import PocketVolumes
from pliant.measure.shapes.other_shapes import OtherShapes
from pliant.measure.stages.amplitude import asked_amplitude
from pliant.measure.stages.names import bar_labels, greek
from pliant.measure.stages.parts import (
    Components,
    ContactFrequencies,
    Distances,
    Gyration,
    ReferenceStructure,
    Residuals,
    RigidDomains,
    Rmsd,
    Shapes,
    Torsions,
    UnitFlexibility,
    Units,
    UnitsInComponents,
)
from pliant.report.bar_verdict import scientific, tolerance_text
from pliant.report.domains.domain_texts import domain_rows
from pliant.report.figures.torsion_figures import most_mobile
from pliant.report.page.section_titles import (
    CHEMISTRY,
    COLLECTIVE,
    EXACT,
    FLEXIBLE,
    OTHER,
    POCKETS,
    SHAPES,
    TOGETHER,
)
from pliant.report.pockets.pocket_texts import CAPTION, HEADERS, pocket_table_rows
from pliant.report.shapes.shape_texts import NO_POPULATION, page_rows, pocket_rows
from pliant.report.verdicts import shape_rows
from pliant.trajectory.kind import ENSEMBLE, TRANSITION

if TYPE_CHECKING:
    from pliant.measure.stages.analysis import Analysis


#: share of the frames from which a contact counts as kept, and below which as lost
KEPT = 0.9
ERRORS = "± 2 standard errors of sampling"
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


def facts(analysis: Analysis) -> list[tuple[str, str, str]]:
    """Up to seven (number, unit, meaning) for the side of the page, biology first."""
    rows = [*_flexible_facts(analysis), *_chemical_facts(analysis)]
    if size := analysis.get(Gyration):
        text = f"radius of gyration, ± {size.radius.std():.2g} Å"
        rows.append((f"{size.radius.mean():.2f}", "Å", text))
    if torsions := analysis.get(Torsions):
        rows.append((str(len(torsions.measured.torsions)), "", "rotatable bonds"))
    if residuals := analysis.get(Residuals):
        worst = residuals.found.max_relative.max()
        text = f"largest relative residual; tolerance {tolerance_text(residuals.measured)}"
        rows.append((scientific(worst), "", text))
    return rows[:7]


def _flexible_facts(analysis: Analysis) -> list[tuple[str, str, str]]:
    rows = []
    if UnitFlexibility in analysis and analysis.kind != TRANSITION:
        found, units = analysis[UnitFlexibility].found, analysis[Units]
        text = f"mean fluctuation of a{'n atom' if units.what == 'atom' else ' residue'} (RMSF)"
        if asked_amplitude(analysis.record.parameters if analysis.record else {}) is not None:
            text += "; its size is an input, ± the error of sampling"
        rows.append((f"{found.rmsf.mean():.2f} ± {2 * found.error.mean():.1g}", "Å", text))
    if domains := analysis.get(RigidDomains):
        count, share = domains.found.count, 100 * domains.found.explained
        text = f"domains, which explain {share:.0f} % of the motion by moving rigidly"
        none = "domains that repeat", "piece: no domains were found"
        rows.append((str(count), "", text if count > 1 else none[count]))
    if Components in analysis:
        share = 100 * analysis[Components].found.explained[0]
        rows.append((f"{share:.0f}", "%", "of the motion along one direction (PC1)"))
    if Rmsd in analysis:
        rmsd = analysis[Rmsd].fitted
        if analysis.kind == ENSEMBLE:
            text = f"mean RMSD from {analysis[ReferenceStructure].name}, {analysis.fitted_name}"
            rows.append((f"{rmsd.mean():.2f}", "Å", text))
        else:
            text = f"RMSD of the last frame from the first, {analysis.fitted_name}"
            rows.append((f"{rmsd[-1]:.2f}", "Å", text))
    return rows


def _chemical_facts(analysis: Analysis) -> list[tuple[str, str, str]]:
    rows = []
    if found := analysis.get(ContactFrequencies):
        kept = int(np.count_nonzero(found.at_start & (found.share >= KEPT)))
        text = f"of {np.count_nonzero(found.at_start)} contacts of residues kept in 90 % of frames"
        rows.append((str(kept), "", text))
    return rows


def tables(analysis: Analysis) -> list[PageTable]:
    """Tables for the page, in no order of sections."""
    makers = {
        UnitFlexibility: _flexible_table,
        RigidDomains: _domain_table,
        Components: _component_table,
        Shapes: _shape_table,
        ContactFrequencies: _contact_table,
        Distances: _distance_table,
        Torsions: _torsion_table,
        Residuals: _bar_table,
    }
    made = [make(analysis) for part, make in makers.items() if part in analysis]
    if UnitFlexibility in analysis and analysis.kind != TRANSITION:
        made.append(_ligand_table(analysis))
    if OtherShapes in analysis:
        made += _other_tables(analysis)
    if PocketVolumes in analysis:
        made.append(PageTable(POCKETS, CAPTION, HEADERS, pocket_table_rows(analysis)))
    return [table for table in made if table.rows]


def _other_tables(analysis: Analysis) -> list[PageTable]:
    """The other shapes, and their pockets."""
    rows = page_rows(analysis)
    if not analysis[OtherShapes].looked_for:
        return [PageTable(OTHER, "", ("frames", "other shapes"), rows)]
    columns = ("how many", "frame shown", "RMSD (Å)", "spread (Å)", "what rotated", "contacts gone")
    shapes = PageTable(OTHER, NO_POPULATION, ("frames are", *columns), rows)
    headers = ("", "room (Å³)", "at the start", "around it", "lined by")
    caption = "Pockets with more room than at the start"
    return [shapes, PageTable(OTHER, caption, headers, pocket_rows(analysis))]


def _flexible_table(analysis: Analysis) -> PageTable:
    found, units = analysis[UnitFlexibility].found, analysis[Units]
    rows = _most_flexible(analysis, units.ranked)
    if analysis.kind == TRANSITION:
        caption = f"{units.what.capitalize()}s that move most on the way"
        return PageTable(FLEXIBLE, caption, (units.what, "RMSF (Å)"), [row[:2] for row in rows])
    caption = f"Most flexible {units.what}s" + ("" if found.converged else " (not converged)")
    return PageTable(FLEXIBLE, caption, (units.what, "RMSF (Å)", ERRORS), rows)


def _ligand_table(analysis: Analysis) -> PageTable:
    rows = _most_flexible(analysis, ~analysis[Units].ranked)
    return PageTable(FLEXIBLE, "Ligands", ("ligand", "RMSF (Å)", ERRORS), rows)


def _most_flexible(analysis: Analysis, chosen: np.ndarray) -> list[tuple[str, ...]]:
    found, units = analysis[UnitFlexibility].found, analysis[Units]
    order = np.argsort(-found.rmsf, kind="stable")
    numbers = order[chosen[order]][:8]
    texts = [(f"{found.rmsf[k]:.3f}", f"± {2 * found.error[k]:.2g}") for k in numbers]
    return [(units.labels[k], *text) for k, text in zip(numbers, texts, strict=True)]


def _domain_table(analysis: Analysis) -> PageTable:
    headers = ("domain", "residues", "found in")
    return PageTable(TOGETHER, "Domains that move as rigid bodies", headers, domain_rows(analysis))


def _component_table(analysis: Analysis) -> PageTable:
    found = analysis[Components].found
    share = participation(found.components[:5])
    spread = collectivity(found.components[:5])
    rows = []
    for k, part in enumerate(found.explained[:5]):
        cosine = f"{found.cosine_content[k]:.2f}" if k < len(found.cosine_content) else "–"
        moves = _moves(analysis, share[k])
        rows.append((f"PC{k + 1}", f"{100 * part:.1f} %", cosine, f"{spread[k]:.2f}", moves))
    headers = ("", "share", "cosine content", "collectivity", "moves most")
    return PageTable(COLLECTIVE, "Principal components", headers, rows)


def _moves(analysis: Analysis, share: np.ndarray) -> str:
    """Which stretches a component moves most, in words."""
    if UnitsInComponents not in analysis:
        return "–"
    units, moved = analysis[Units], analysis[UnitsInComponents].units
    labels = [units.labels[k] for k in moved]
    if units.what == "atom":
        return ", ".join(labels[k] for k in np.argsort(-share, kind="stable")[:3])
    return ", ".join(
        labels[a] if a == b else f"{labels[a]} to {labels[b]}"
        for a, b, _ in moving_stretches(share, units.chains[moved])
    )


def _shape_table(analysis: Analysis) -> PageTable:
    rows = [
        (("✓ " if row.passed else "✕ ") + row.name, row.found, row.start, row.limit)
        for row in shape_rows(analysis)
    ]
    headers = ("question", "frames", analysis[ReferenceStructure].name, "allowed")
    return PageTable(CHEMISTRY, "Stereochemistry", headers, rows)


def _contact_classes(found: ContactFrequencies) -> dict[str, np.ndarray]:
    """Masks of the contacts that are kept, come and go, lost, and gained."""
    start, share = found.at_start, found.share
    return {
        "kept": start & (share >= KEPT),
        "come and go": start & (share < KEPT) & (share > LOST),
        "lost": start & (share <= LOST),
        "gained": ~start & (share >= GAINED),
    }


def _contact_table(analysis: Analysis) -> PageTable:
    found, labels = analysis[ContactFrequencies], analysis[Units].labels
    classes = _contact_classes(found)
    meaning = {
        "kept": "of the start, in 90 % of frames and more",
        "come and go": "of the start, between",
        "lost": "of the start, in 10 % and less",
        "gained": "not of the start, in 50 % and more",
    }
    rows = [(name, meaning[name], str(np.count_nonzero(classes[name]))) for name in classes]
    least = np.flatnonzero(found.at_start)
    for k in least[np.argsort(found.share[least], kind="stable")][:5]:
        a, b = found.pairs[k]
        rows.append((f"{labels[a]} – {labels[b]}", "among the least kept", f"{found.share[k]:.0%}"))
    caption = f"Contacts of residues, in {found.frames} frames"
    return PageTable(CHEMISTRY, caption, ("contacts", "", "number, share"), rows)


def _distance_table(analysis: Analysis) -> PageTable:
    found = analysis[Distances]
    rows = [
        (
            f"{ends[0]} to {ends[1]}",
            f"{values.mean():.2f}",
            f"{values.std():.2f}",
            f"{values.min():.2f} to {values.max():.2f}",
        )
        for ends, values in zip(found.ends, found.values, strict=True)
    ]
    headers = ("distance", "mean (Å)", "standard deviation", "range")
    return PageTable(SHAPES, "Distances asked for", headers, rows)


def _bar_table(analysis: Analysis) -> PageTable:
    residuals = analysis[Residuals].measured
    values = residuals.results.bar_max_relative
    chosen = np.argsort(-values, kind="stable")[:8]
    names = bar_labels(analysis.universe.atoms, residuals.bars[chosen])
    lengths = residuals.rest_lengths[chosen]
    rows = [
        (n, f"{length:.4f}", scientific(values[k]))
        for n, length, k in zip(names, lengths, chosen, strict=True)
    ]
    return PageTable(
        EXACT, "Bars that were furthest off", ("bar", "rest length (Å)", "largest residual"), rows
    )


def _torsion_table(analysis: Analysis) -> PageTable:
    torsions = analysis[Torsions].measured
    found = torsions.results
    rows = [
        (greek(torsions.torsions[k].label), f"{found.mean[k]:.0f}°", f"{found.spread[k]:.0f}°")
        for k in sorted(most_mobile(torsions, 8), key=lambda k: -found.spread[k])
    ]
    headers = ("torsion", "circular mean", "spread")
    return PageTable(SHAPES, "Most mobile torsions", headers, rows)


def title(analysis: Analysis) -> str:
    """Name of the molecule's file, or of the trajectory."""
    if analysis.record and analysis.record.parameters.get("input/file"):
        return Path(str(analysis.record.parameters["input/file"])).name
    return Path(analysis.options.path).name
