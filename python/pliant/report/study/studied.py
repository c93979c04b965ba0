# SPDX-License-Identifier: MIT
"""What a study found: the parts that its answers are made from, and the answers."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

from pliant.base.display import Displayed, Facts

#: what answers are called where people read them
LABELS = {"together": "moves as one"}

if TYPE_CHECKING:
    from pliant.jobs.path.found import MolecularPath
    from pliant.measure.shapes.representatives import Representatives
    from pliant.report.check.check_report import CheckReport
    from pliant.report.page.additions import Answer
    from pliant.report.study.data_fit import DataFit
    from pliant.report.suite import AnalysisReport


@dataclass(frozen=True)
class Sampled:
    """What `pliant sample` did."""

    facts: dict[str, Any]  #: its JSON
    ensemble: Path


@dataclass
class Study(Displayed):
    """An ensemble of a molecule, and what it answers."""

    file: str
    folder: Path
    sampled: Sampled  #: the ensemble
    report: AnalysisReport  #: its analysis
    representatives: Representatives | None = None  #: None where there are too few frames
    fit: DataFit | None = None  #: to measured data, if there are any
    path: MolecularPath | None = None  #: to the other structure, if there is one
    end: str = ""  #: the other structure
    check: CheckReport | None = None  #: what OpenMM made of a few frames
    why_no_check: str = ""  #: why OpenMM was not asked
    outputs: dict[str, Any] = field(default_factory=dict)  #: paths of the files
    answered: dict[str, Answer] = field(default_factory=dict)  #: question in a word -> its answer

    @property
    def answers(self) -> dict[str, str]:
        """Question in a word -> its answer in words."""
        return {what: str(answer) for what, answer in self.answered.items()}

    @property
    def page(self) -> Path:
        """The report page."""
        return self.folder / "report.html"

    def facts(self) -> Facts:
        """The answers."""
        return list(self.answers.items())

    def as_json(self) -> dict[str, Any]:
        """All of it as one JSON object."""
        judged = self.report.verdict
        return {
            "verdict": judged.kind,
            "verdict_text": judged.sentence,
            "file": self.file,
            "answers": self.answers,
            "left_out": self.sampled.facts["left_out"],
            "sample": self.sampled.facts,
            "analysis": self.report.as_json(),
            "representatives": self.representatives and self.representatives.as_json(),
            "fit": None if self.fit is None else self.fit.found.as_json(),
            "path": None if self.path is None else self.path.as_json(),
            "check": None if self.check is None else self.check.as_json(),
            "why_no_check": self.why_no_check,
            "outputs": {name: str(path) for name, path in self.outputs.items()},
        }
