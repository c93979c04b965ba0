# SPDX-License-Identifier: MIT
"""Writes tables, figures and other files of a report into a folder."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Generic

from pliant.base.csv_cells import write_csv
from pliant.report.build import Report
from pliant.report.figures.draw_in_parallel import Drawing
from pliant.report.section import Found, Picture


@dataclass(frozen=True)
class Saved(Generic[Found]):
    """The files of a report."""

    tables: list[Path]  #: CSV
    files: list[Path]  #: for other programs
    pictures: list[tuple[Picture[Found], Path]]  #: PNG

    def as_json(self, files: str = "exports") -> dict[str, list[str]]:
        """Their paths; `files` is what those for other programs are called."""
        kinds = {"tables": self.tables, files: self.files}
        kinds["figures"] = [path for _, path in self.pictures]
        return {kind: [str(path) for path in paths] for kind, paths in kinds.items()}

    def lines(self) -> Iterator[tuple[str, str]]:
        """Their paths, for the terminal."""
        for paths in self.as_json().values():
            yield from (("written", path) for path in paths)


def save(report: Report[Found], folder: Path, dpi: int) -> Saved[Found]:
    """Writes CSV files, figures and files for other programs, replacing earlier ones."""
    with drawing_of(report, folder, dpi) as drawing:
        return save_beside(report, folder, drawing)


def drawing_of(report: Report[Found], folder: Path, dpi: int) -> Drawing[Found]:
    """The figures, which a process of their own begins to draw."""
    folder.mkdir(parents=True, exist_ok=True)
    return Drawing(report.found, report.pictures, folder, dpi)


def save_beside(report: Report[Found], folder: Path, drawing: Drawing[Found]) -> Saved[Found]:
    """What `save` writes, where the figures are being drawn."""
    tables = _save_tables(report, folder)
    files = [path for row in report.sections for path in row.files(report.found, folder)]
    return Saved(tables, files, drawing.finish())


def _save_tables(report: Report[Found], folder: Path) -> list[Path]:
    written = []
    every = ((name, make) for row in report.sections for name, make in row.columns.items())
    for name, make in every:
        if columns := make(report.found):
            written.append(folder / f"{name}.csv")
            write_csv(written[-1], columns)
    return written
