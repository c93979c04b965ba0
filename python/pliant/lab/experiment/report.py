# SPDX-License-Identifier: MIT
"""The report of an experiment: figures, claims, sweep and open questions on one HTML page."""

from __future__ import annotations

import time
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from pliant.base import console
from pliant.base.new_file import write_text
from pliant.lab.experiment import document, drawings, heat_maps, sections
from pliant.lab.experiment import table as tables
from pliant.lab.experiment.claims import evidence_by_yardstick
from pliant.lab.experiment.document import Answer
from pliant.lab.experiment.questions import bfs_cycle, census, n_cycles, root_adaptation
from pliant.lab.experiment.settled import Settled, settings_text, settle
from pliant.lab.experiment.statistics import REPLICATES, Evidence
from pliant.lab.experiment.sweep import Point, read_sweep, run_sweep
from pliant.lab.experiment.verdict import OPEN
from pliant.lab.results import Cell, print_table

CLAIMS: dict[str, Cell] = {
    "id": lambda one: one.claim.id,
    "verdict": "word",
    "settings": settings_text,
    "depends on": "on_what",
}
QUESTIONS: tuple[Any, ...] = (bfs_cycle, root_adaptation, n_cycles, census)


@dataclass
class Report:
    """What was written and found."""

    path: Path
    settled: list[Settled]
    failed_questions: list[str]
    seconds: float

    def as_json(self) -> dict[str, Any]:
        """The claims for programs."""
        claims = sections.as_json(self.settled)
        return {"report": str(self.path), "seconds": self.seconds, "claims": claims}

    def print_claims(self) -> None:
        """A line a claim; what a sweep was too small to confirm, in this report or earlier."""
        print("claims of the thesis")
        print_table(self.settled, CLAIMS)
        left_open = [one.claim.id for one in self.settled if one.word == OPEN]
        if left_open:
            console.warn(
                f"cannot judge {', '.join(left_open)}: the sweep has too few graphs and forces"
                "; remove sweep.csv and make the report without --quick"
            )
        print(f"\n{console.printable_name(self.path)}  ({self.seconds:.0f} s)")


def make_report(
    folder: Path,
    *,
    sweep: bool = True,
    questions: bool = True,
    quick: bool = False,
    workers: int = 1,
    replicates: int = REPLICATES,
    quiet: bool = True,
) -> Report:
    """Writes ``report.html`` and its figures into the folder of an experiment.

    `quick`: small sizes, to look at, not to cite. Raises FileError if there is no table in it.
    """
    begin = time.monotonic()
    table = tables.read(folder)
    all_evidence = evidence_by_yardstick(Evidence(table, replicates=replicates))
    points = _points(folder, table, workers, quick, quiet) if sweep else []
    settled = settle(all_evidence, points)
    pictures = folder / "figures"
    with console.progress("drawing figures", quiet):
        bars, histograms = drawings.draw_all(all_evidence, pictures)
        maps = heat_maps.draw_maps(points, table.settings, pictures) if points else {}
    asked = _ask_all(folder, table.settings.seed, quick, quiet) if questions else []
    limits = sections.cannot_judge(settled, points, quick)
    content = [
        ("Claims", limits + sections.summary(settled, bool(points))),
        ("Reading the numbers", sections.method(table, points, replicates)),
        ("Figures of chapter 5", document.figures(bars, wide=True)),
        ("Each claim", sections.each_claim(settled, maps)),
        ("Contradictions", sections.contradictions()),
        ("Histograms of appendix C", document.figures(histograms, wide=True)),
        *((answer.title, document.answer(answer)) for _, answer in asked),
        ("Settings", sections.settings(table)),
    ]
    path = folder / "report.html"
    text = document.page("The thesis, settled", sections.subtitle(table), content)
    write_text(path, text, overwrite=True)
    failed = [name for name, answer in asked if answer.verdict.startswith("not answered")]
    return Report(path, settled, failed, time.monotonic() - begin)


def _points(
    folder: Path, table: tables.Table, workers: int, quick: bool, quiet: bool
) -> list[Point]:
    """Of an earlier sweep in this folder, or of one made now."""
    found = read_sweep(folder)
    if found:
        return found
    with console.progress("sweep, settings", quiet) as show:
        return run_sweep(table.settings, folder, workers, quick, show)


def _ask_all(folder: Path, seed: int, quick: bool, quiet: bool) -> list[tuple[str, Answer]]:
    """(name, answer) of each; one that cannot be answered says why, and the others go on."""
    answers = []
    with console.progress("open questions", quiet) as show:
        for done, question in enumerate(QUESTIONS):
            show(done, len(QUESTIONS))
            name = question.__name__.rpartition(".")[2]
            answers.append((name, _ask(question, folder / "questions" / name, seed, quick)))
    return answers


def _ask(question: Any, out: Path, seed: int, quick: bool) -> Answer:
    out.mkdir(parents=True, exist_ok=True)
    try:
        found: Answer = question.answer(out, seed, quick)
        return found
    except Exception as error:  # a page that fails must not cost the others
        console.warn(f"{question.__name__}: {type(error).__name__}: {error}")
        return Answer(question.TITLE, f"not answered: {type(error).__name__}: {error}")
