# SPDX-License-Identifier: MIT
"""What the page of a study has beside the analysis of its ensemble."""

from __future__ import annotations

from typing import TYPE_CHECKING

from pliant.report.page.additions import Additions
from pliant.report.page.page_tables import PageTable
from pliant.report.page.section_titles import ON_THE_WAY, STARTS
from pliant.report.study.answers import LABELS

if TYPE_CHECKING:
    from pliant.checks.check_report import CheckReport
    from pliant.jobs.path.found import MolecularPath
    from pliant.report.study.studied import Study

#: answers that the page gives elsewhere
NOT_AT_THE_HEAD = ("verdict", "page", "files")


def additions(study: Study) -> Additions:
    """The answers, the path, and the check of MD starts."""
    tables = []
    if study.path is not None:
        tables.append(_path_table(study.path, study.end))
    if study.check is not None:
        tables.append(_check_table(study.check))
    answers = {
        LABELS.get(k, k): text for k, text in study.answers.items() if k not in NOT_AT_THE_HEAD
    }
    files = [study.sampled.ensemble, *study.outputs.values()]
    models = [path for name, path in study.outputs.items() if name == "representatives"]
    verdicts = study.report.more_verdicts
    return Additions("pliant study", answers, verdicts, tables, files, models)


def _path_table(path: MolecularPath, end: str) -> PageTable:
    first, last = path.frames[0], path.frames[-1]
    tight = [
        (f"tightest, frame {one.step}", f"{one.atoms}: {one.overlap:.2f} Å too near")
        for one in path.tight_places()
    ]
    rows = [
        ("arrived", "yes" if path.arrived else "no"),
        ("distance at first", f"{first.to_end:.2f} Å, {path.atoms} of {path.matched} residues"),
        ("distance at last", f"{last.to_end:.2f} Å"),
        ("frames", f"{len(path.frames)}, each with exact bonds and angles"),
        ("contacts of both", f"{path.held}, held"),
        ("contacts of the start alone", f"{last.lost} of {path.only_start} lost"),
        ("contacts of the end alone", f"{last.made} of {path.only_end} made"),
        *tight,
    ]
    caption = (
        f"A path to {end}: it shows that a way exists, not how fast or how likely it is, or that "
        "the molecule takes it"
    )
    return PageTable(ON_THE_WAY, caption, ("", "path"), rows)


def _check_table(check: CheckReport) -> PageTable:
    rows = [
        (one.subject, one.result, one.measured or "–", one.allowed or "–") for one in check.findings
    ]
    caption = f"Checked with OpenMM: {check.covers.text}"
    return PageTable(STARTS, caption, ("what", "result", "measured", "allowed"), rows)
