# SPDX-License-Identifier: MIT
"""Writes all results of an analysis into a folder."""

from __future__ import annotations

from collections.abc import Mapping
from importlib import metadata
from pathlib import Path
from typing import Any

from pliant._core import techniques
from pliant.base.new_file import check_folder, write_text
from pliant.measure.stages.analysis import Analysis
from pliant.report.build import Report
from pliant.report.figures.draw_in_parallel import Drawing
from pliant.report.page.additions import NOTHING, Additions
from pliant.report.page.html import table
from pliant.report.page.page import Page, lead, links, methods, sections_of
from pliant.report.page.scene import scene
from pliant.report.save import Saved, drawing_of, save_beside
from pliant.report.sections.exports import ensemble_files
from pliant.report.sections.headings import HEADINGS, WIDE
from pliant.report.sections.table import SECTIONS
from pliant.trajectory.kind import ENSEMBLE

MOST_FACTS = 7  #: beside the molecule


def report_of(analysis: Analysis, more: Additions = NOTHING) -> Report[Analysis]:
    """The sections of an analysis, and those that are added."""
    files = ensemble_files([path.stem for path in more.models])
    return Report(analysis, [*SECTIONS, files, *more.sections])


def write_report(
    analysis: Analysis, folder: Path, dpi: int = 150, more: Additions = NOTHING
) -> dict[str, Any]:
    """Writes figures, tables, files for other programs and report.html; returns the paths of all.

    Files of an earlier report are replaced. `more` is what the report has besides the analysis.
    """
    check_folder(folder)
    with drawing_of(report_of(analysis), folder, dpi) as drawing:
        return finish_report(analysis, folder, drawing, more)


def finish_report(
    analysis: Analysis, folder: Path, drawing: Drawing[Analysis], more: Additions
) -> dict[str, Any]:
    """The same where the figures of the analysis are being drawn."""
    report, shown = report_of(analysis, more), scene(analysis, overlay=more.overlay)
    saved = save_beside(report, folder, drawing)
    page = folder / "report.html"
    write_text(page, _page(report, saved, more, shown, drawing.dpi).text(), overwrite=True)
    return {"report": str(page), **saved.as_json()}


def _page(
    report: Report[Analysis],
    saved: Saved[Analysis],
    more: Additions,
    shown: Mapping[str, Any],
    dpi: int,
) -> Page:
    analysis = report.found
    pictures = {picture.name: path for picture, path in saved.pictures}
    files = [*more.files, *saved.files, *saved.tables, *pictures.values()]
    return Page(
        title=_title(analysis),
        subtitle=_subtitle(analysis),
        made_by=more.made_by,
        lead=lead([*report.verdicts.values()], more.answers, pictures),
        facts=report.facts(HEADINGS)[:MOST_FACTS],
        sections=sections_of(report, pictures, HEADINGS, WIDE, dpi),
        scene=shown,
        notes=[*analysis.notes, *(f"No {what}: {why}." for what, why in analysis.skipped.items())],
        details={
            "Methods": methods(report.methods),
            **_options(analysis),
            "Files beside this page": links(files),
        },
        made_with=[f"MDAnalysis {metadata.version('MDAnalysis')}"],
    )


def _title(analysis: Analysis) -> str:
    """Name of the molecule's file, or of the trajectory."""
    return Path(str(analysis.source.parameters.get("input/file", analysis.options.path))).name


def _subtitle(analysis: Analysis) -> list[str]:
    parts = [f"{len(analysis.universe.atoms):,} atoms"]
    parts.append(f"{len(analysis.frames):,} frames")
    if analysis.steps is not None and analysis.kind != ENSEMBLE:
        parts.append(f"steps {analysis.steps[0]:,} to {analysis.steps[-1]:,}")
    run = analysis.source.parameters
    if "run/technique" in run:
        parts.append(_technique(run))
    return [*parts, Path(analysis.options.path).name]


def _technique(run: Mapping[str, Any]) -> str:
    """What a run was resolved with, from its parameters."""
    used = run.get("run/technique_used", run["run/technique"])
    weighted = any(row.name == used and row.has_weighting for row in techniques())
    return f"{used}, weighting {run.get('run/weighting', '?')}" if weighted else used


def _options(analysis: Analysis) -> dict[str, str]:
    run = analysis.source.parameters
    rows = [
        (name, f"{value:g}" if isinstance(value, float) else str(value))
        for name, value in sorted(run.items())
    ]
    return {"Options of the run": table(("option", "value"), rows)} if rows else {}
