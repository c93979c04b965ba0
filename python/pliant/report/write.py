# SPDX-License-Identifier: MIT
"""Writes all results of an analysis into a folder."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

from pliant._core import InputError
from pliant.report.exports import save_exports
from pliant.report.figures.draw_in_parallel import Drawing
from pliant.report.page.additions import NOTHING, Additions
from pliant.report.page.page import write_page
from pliant.report.tables import save_tables

if TYPE_CHECKING:
    from pliant.measure.stages.analysis import Analysis


def check_folder(folder: Path) -> None:
    """Asked before the input is read; the folder is made when there is something to write."""
    if folder.exists() and not folder.is_dir():
        raise InputError(f"{folder}: is a file, expected a folder for the results")


def write_report(
    analysis: Analysis, folder: Path, dpi: int = 150, more: Additions = NOTHING
) -> dict[str, Any]:
    """Writes figures, tables, files for other programs and report.html; returns the paths of all.

    Files of an earlier report are replaced. `more` is what the page has besides the analysis.
    """
    check_folder(folder)
    folder.mkdir(parents=True, exist_ok=True)
    with Drawing(analysis, folder, dpi) as drawing:
        tables = save_tables(analysis, folder)
        exports = save_exports(analysis, folder, more.models)
        figures = drawing.finish()
    report = folder / "report.html"
    pictures = [path for _, path in figures]
    write_page(analysis, figures, [*more.files, *exports, *tables, *pictures], report, dpi, more)
    return {
        "report": str(report),
        "figures": [str(path) for path in pictures],
        "tables": [str(path) for path in tables],
        "exports": [str(path) for path in exports],
    }
