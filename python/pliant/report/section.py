# SPDX-License-Identifier: MIT
"""A row of a report: a question, and how its answer is shown on a terminal, in files, in a page."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any, Generic, TypeVar

import numpy as np

from pliant.base.console import Table

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from pliant.base.verdict import Verdict

#: what a report is of: the analysis of a file or an ensemble, a comparison, a check
Found = TypeVar("Found")

Values = dict[str, Any]  #: JSON-ready
Columns = dict[str, Any]  #: arrays or lists of equal length, by their headers
#: which columns a table has: name -> its header, and the text of a cell
Shown = Mapping[str, tuple[str, Callable[[Any], str]]]
Line = str | tuple[str, str] | Table  #: on the terminal; a pair is a text under a label


def _nothing(found: object) -> Any:
    return {}


def _always(found: object) -> bool:
    return True


@dataclass(frozen=True)
class Fact:
    """One number, with what it means."""

    number: str
    unit: str
    meaning: str


@dataclass(frozen=True)
class Picture(Generic[Found]):
    """A figure, which a file of that name holds as PNG."""

    name: str
    draw: Callable[[Found], Figure]
    caption: str | Callable[[Found], str] = ""  #: what it shows
    suits: Callable[[Found], bool] = _always  #: whether it can be drawn

    def caption_of(self, found: Found) -> str:
        """What it shows of what was found."""
        return self.caption if isinstance(self.caption, str) else self.caption(found)


@dataclass(frozen=True)
class Section(Generic[Found]):
    """One question. Each way to show the answer is a function of what was found; what is not given
    is not shown."""

    name: str = ""  #: of its verdict
    heading: str = ""  #: of the page, which other sections may share
    applies: Callable[[Found], bool] = _always  #: without it only the verdict is asked for
    verdict: Callable[[Found], Verdict | None] = lambda found: None
    values: Callable[[Found], Values] = _nothing  #: of --json
    lines: Callable[[Found], Iterable[Line]] = _nothing
    facts: Callable[[Found], Iterable[Fact]] = _nothing  #: beside the molecule in the page
    tables: Callable[[Found], Iterable[Table]] = _nothing  #: of the page
    pictures: Sequence[Picture[Found]] = ()
    blocks: Callable[[Found], Iterable[str]] = _nothing  #: of the page, HTML: what else it has
    columns: Mapping[str, Callable[[Found], Columns]] = field(default_factory=dict)  #: CSV files
    files: Callable[[Found, Path], Iterable[Path]] = lambda found, folder: ()  #: writes others
    methods: Mapping[str, str] = field(default_factory=dict)  #: how it was measured


def table_of(title: str, columns: Columns, shown: Shown, rows: np.ndarray) -> Table:
    """Some rows of columns as a table."""
    cells = [[text(columns[name][k]) for name, (_, text) in shown.items()] for k in rows]
    return Table(title, [header for header, _ in shown.values()], cells)
