# SPDX-License-Identifier: MIT
"""What a page may have besides an analysis: answers at its head, more tables and files."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from html import escape
from pathlib import Path

from pliant.base.verdict import Verdict
from pliant.report.page.page_tables import PageTable


@dataclass(frozen=True)
class Additions:
    """Of the command that has an analysis made into a page."""

    made_by: str = "pliant analyse"
    answers: Mapping[str, str] = field(default_factory=dict)  #: at the head: what -> the answer
    verdicts: Mapping[str, Verdict] = field(default_factory=dict)  #: on more than an analysis asks
    tables: Sequence[PageTable] = ()
    files: Sequence[Path] = ()
    models: Sequence[Path] = ()  #: those of the files that show.pml and show.cxc load: PDB

    def head(self) -> str:
        """The answers as a card; "" without any."""
        if not self.answers:
            return ""
        rows = "".join(
            f"<tr><td>{escape(what)}</td><td>{escape(answer)}</td></tr>"
            for what, answer in self.answers.items()
        )
        return f'<section class="answers card"><table>{rows}</table></section>\n'


NOTHING = Additions()
