# SPDX-License-Identifier: MIT
"""The report of an experiment: figures, claims, sweep and open questions on one HTML page."""

from __future__ import annotations

import time
from dataclasses import dataclass
from pathlib import Path

from pliant.base.new_file import write_text
from pliant.lab.experiment import document, drawings, heat_maps, sections
from pliant.lab.experiment import table as tables
from pliant.lab.experiment.choices import Choices
from pliant.lab.experiment.claims import evidence_by_yardstick
from pliant.lab.experiment.inquiry import run_questions
from pliant.lab.experiment.settled import Settled, settle
from pliant.lab.experiment.statistics import Evidence
from pliant.lab.experiment.sweep import Point, read_sweep, run_sweep

REPORT = "report.html"
FIGURES = "figures"


@dataclass
class Report:
    """What was written and found."""

    path: Path
    settled: list[Settled]
    failed_questions: list[str]
    seconds: float


def make_report(folder: Path, choices: Choices | None = None) -> Report:
    """Writes ``report.html`` and its figures into the folder of an experiment.

    Raises FileError if there is no table in it.
    """
    choices = choices or Choices()
    begin = time.monotonic()
    table = tables.read(folder)
    all_evidence = evidence_by_yardstick(Evidence(table, replicates=choices.replicates))
    points = _points(folder, table, choices) if choices.sweep else []
    settled = settle(all_evidence, points)
    pictures = folder / FIGURES
    with choices.progress("drawing figures"):
        bars, histograms = drawings.draw_all(all_evidence, pictures)
        maps = heat_maps.draw_maps(points, table.settings, pictures) if points else {}
    asked = run_questions(folder, table.settings.seed, choices) if choices.questions else []
    limits = sections.cannot_judge(settled, points, choices.quick)
    content = [
        ("Claims", limits + sections.summary(settled, bool(points))),
        ("Reading the numbers", sections.method(table, points, choices.replicates)),
        ("Figures of chapter 5", document.figures(bars, wide=True)),
        ("Each claim", sections.each_claim(settled, maps)),
        ("Contradictions", sections.contradictions()),
        ("Histograms of appendix C", document.figures(histograms, wide=True)),
        *((answer.title, document.answer(answer)) for _, answer in asked),
        ("Settings", sections.settings(table)),
    ]
    path = folder / REPORT
    text = document.page("The thesis, settled", sections.subtitle(table), content)
    write_text(path, text, overwrite=True)
    failed = [name for name, answer in asked if answer.verdict.startswith("not answered")]
    return Report(path, settled, failed, time.monotonic() - begin)


def _points(folder: Path, table: tables.Table, choices: Choices) -> list[Point]:
    """Of an earlier sweep in this folder, or of one made now."""
    found = read_sweep(folder)
    if found:
        return found
    with choices.progress("sweep, settings") as show:
        return run_sweep(table.settings, folder, choices.workers, choices.quick, show)
