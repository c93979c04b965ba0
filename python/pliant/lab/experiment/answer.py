# SPDX-License-Identifier: MIT
"""What a page of the report holds: a verdict, words, tables and figures."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path


@dataclass
class Table:
    """Rows under a caption; each row has as many cells as the header."""

    caption: str
    header: list[str]
    rows: list[list[str | int | float]] = field(default_factory=list)


@dataclass
class Figure:
    """A picture file (PNG or SVG) and the sentence or two that say what it shows."""

    path: Path
    caption: str


@dataclass
class Answer:
    """One question answered with data.

    The modules of ``pliant.lab.experiment.questions`` each have ``TITLE: str``, ``ORDER: int``
    (where the page stands in the report) and ``answer(out: Path, seed: int, quick: bool) ->
    Answer``; `out` is an empty or earlier filled folder that is theirs alone, `quick` asks for
    small sizes.
    """

    title: str
    verdict: str  #: one or two sentences
    paragraphs: list[str] = field(default_factory=list)
    tables: list[Table] = field(default_factory=list)
    figures: list[Figure] = field(default_factory=list)
