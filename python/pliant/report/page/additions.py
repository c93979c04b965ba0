# SPDX-License-Identifier: MIT
"""What a report may have besides an analysis: answers at its head, more sections and files."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING

from pliant.report.page.overlay import Overlay
from pliant.report.section import Section

if TYPE_CHECKING:
    from pliant.measure.stages.analysis import Analysis


@dataclass(frozen=True)
class Answer:
    """To one question of a study; `colour` or `figure` say which small picture the page has."""

    text: str  #: a plain sentence
    more: str = ""  #: residues and numbers behind it
    colour: str = ""  #: key of a colouring of the 3-D view
    figure: str = ""  #: name of a figure of the report

    def __str__(self) -> str:
        return f"{self.text} {self.more}".strip()


@dataclass(frozen=True)
class Additions:
    """Of the command that has an analysis made into a report."""

    made_by: str = "pliant analyse"
    answers: Mapping[str, Answer] = field(default_factory=dict)  #: at the head: what -> the answer
    sections: Sequence[Section[Analysis]] = ()  #: on more than an analysis asks
    files: Sequence[Path] = ()
    overlay: Overlay | None = None  #: in the 3-D view
    models: Sequence[Path] = ()  #: those of the files that show.pml and show.cxc load: PDB


NOTHING = Additions()
