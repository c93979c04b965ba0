# SPDX-License-Identifier: MIT
"""A report page: one HTML file with everything in it, which asks no network for anything."""

from __future__ import annotations

import base64
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from html import escape
from pathlib import Path
from typing import Any

from pliant.base.verdict import Verdict, verdict_of_all
from pliant.report.build import Report
from pliant.report.page.additions import Answer
from pliant.report.page.html import (
    disclosure,
    fact,
    scripts,
    sentence,
    table,
    template,
    text_of,
    version,
)
from pliant.report.section import Fact, Found

WIDTH = 6.4  #: inches of a figure that fills its place
MARKS = {"good": "✓", "mixed": "!", "bad": "✕", "open": "–"}


@dataclass(frozen=True)
class Page:
    """What a page shows; `lead`, `sections` and the contents of `details` are HTML."""

    title: str
    subtitle: Sequence[str]
    made_by: str  #: the command
    lead: str
    facts: Sequence[Fact]
    sections: str
    scene: Mapping[str, Any]  #: of the 3-D view
    notes: Sequence[str] = ()
    details: Mapping[str, str] = field(default_factory=dict)  #: what opens when it is clicked
    made_with: Sequence[str] = ()  #: beside Pliant

    def text(self) -> str:
        """The page as HTML."""
        details = [disclosure(what, content) for what, content in self.details.items()]
        return template("page.html").substitute(
            generator=escape(f"pliant {version()}"),
            title=escape(self.title),
            subtitle=escape(" · ".join(self.subtitle)),
            style=text_of("page.css"),
            eyebrow=self.made_by,
            lead=self.lead,
            viewer=text_of("viewer.html"),
            facts="\n".join(fact(one.number, one.unit, one.meaning) for one in self.facts),
            notes=self._notes(),
            sections=self.sections,
            details="\n".join(details),
            footer=escape(" · ".join([f"pliant {version()}", *self.made_with])),
            scripts=scripts(self.scene),
        )

    def _notes(self) -> str:
        notes = [*self.notes]
        if self.scene["notes"]:
            shown = " and ".join(self.scene["notes"])
            notes.append(f"To keep the page small, the 3-D view shows {shown}.")
        if not notes:
            return ""
        items = "".join(f"<li>{escape(sentence(note))}</li>" for note in notes)
        return f'<h2>Please note</h2><section class="notes card"><ul>{items}</ul></section>'


def lead(
    made: Sequence[Verdict], answers: Mapping[str, Answer], pictures: Mapping[str, Path]
) -> str:
    """The verdict over all, the answers of a study, and one line a check; below answers, those are
    folded away that are no reason for doubt."""
    judged = verdict_of_all(made)
    failed = any(one.kind == "bad" for one in made)
    folded = [one for one in made if answers and one.kind in ("good", "open")]
    shown = [_verdict(one, failed) for one in made if one not in folded]
    mark = f'<div class="mark" aria-hidden="true">{MARKS[judged.kind]}</div>'
    parts = [headline(judged.sentence, judged.details, judged.kind, mark)]
    if answers:
        parts.append(_answers(answers, pictures))
    if shown:
        parts.append(f'<section class="verdicts card">{"".join(shown)}</section>')
    if folded:
        lines = "".join(_verdict(one, failed) for one in folded)
        parts.append(disclosure("What was checked", f'<div class="verdicts">{lines}</div>'))
    return "\n".join(parts)


def headline(text: str, more: str, kind: str = "", mark: str = "") -> str:
    """What follows from all, on a card of its own."""
    said = f"<p><strong>{escape(text)}</strong><span>{escape(more)}</span></p>"
    return f'<section class="verdict card {kind}">{mark}{said}</section>'


def _answers(answers: Mapping[str, Answer], pictures: Mapping[str, Path]) -> str:
    """A card with a row an answer."""
    rows = "\n".join(_answer(what, one, pictures) for what, one in answers.items())
    return f'<section class="answers card">\n{rows}\n</section>'


def _answer(what: str, one: Answer, pictures: Mapping[str, Path]) -> str:
    """A sentence, what is behind it, and its small picture."""
    shown, alt = "", escape(f"A small picture: {one.text}")
    if one.colour:  # a copy that the 3-D view draws
        size = "width=680 height=380"
        shown = f'<canvas data-colour="{one.colour}" {size} role="img" aria-label="{alt}"></canvas>'
    elif one.figure in pictures:
        shown = f'<img alt="{alt}" src="{_as_data(pictures[one.figure].read_bytes())}">'
    more = f"<small>{escape(one.more)}</small>" if one.more else ""
    return f"<div><h3>{escape(what)}</h3><p>{escape(one.text)}{more}</p>{shown}</div>"


def _verdict(one: Verdict, failed: bool) -> str:
    """One line a question; none is green while another has failed."""
    colour = "open" if failed and one.kind == "good" else one.kind
    return (
        f'<div class="one {colour}"><div class="mark" aria-hidden="true">{MARKS[one.kind]}</div>'
        f"<p><b>{escape(one.sentence)}</b> <span>{escape(one.details)}</span></p></div>\n"
    )


def refuse_other_headings(headings: Sequence[str], report: Report[Found]) -> None:
    """Raises ValueError for a section under a heading that a page does not have."""
    for row in report.sections:
        if row.heading and row.heading not in headings:
            raise ValueError(f"heading {row.heading!r}: expected one of {', '.join(headings)}")


def sections_of(
    report: Report[Found],
    pictures: Mapping[str, Path],
    headings: Sequence[str],
    wide: Sequence[str],
    dpi: int = 150,
) -> str:
    """Figures and tables under their headings; under `wide` ones each is as wide as the page."""
    parts = []
    refuse_other_headings(headings, report)
    for heading in headings:
        shown = [row for row in report.sections if row.heading == heading]
        figures = [
            _figure(picture.caption_of(report.found), pictures[picture.name], dpi)
            for row in shown
            for picture in row.pictures
            if picture.name in pictures
        ]
        tables = [
            table(one.columns, one.rows, one.title)
            for row in shown
            for one in row.tables(report.found)
            if one.rows
        ]
        blocks = [block for row in shown for block in row.blocks(report.found)]
        if content := "\n".join([*figures, *tables, *blocks]):
            is_wide = " wide" * (heading in wide)
            section = f'<section class="figures{is_wide}">{content}</section>'
            parts.append(f"<h2>{heading}</h2>\n{section}")
    return "\n".join(parts)


def _figure(caption: str, png: Path, dpi: int) -> str:
    content = png.read_bytes()
    width, height = (int.from_bytes(content[k : k + 4], "big") for k in (16, 20))  # of the PNG
    tall = ' class="card tall"' if height > 0.9 * width else ' class="card"'
    style = f"max-width:{min(100, 100 * width / dpi / WIDTH):.0f}%"
    return (
        f'<figure{tall}><img alt="{escape(caption)}" style="{style}" src="{_as_data(content)}">'
        f"<figcaption>{escape(caption)}</figcaption></figure>"
    )


def _as_data(png: bytes) -> str:
    return f"data:image/png;base64,{base64.b64encode(png).decode('ascii')}"


def methods(texts: Mapping[str, str]) -> str:
    """A paragraph each."""
    return "".join(f"<p><b>{escape(a)}.</b> {escape(b)}</p>" for a, b in texts.items())


def links(files: Sequence[Path]) -> str:
    """To files beside the page."""
    items = (f'<li><a href="{escape(one.name)}">{escape(one.name)}</a></li>' for one in files)
    return f"<ul>{''.join(items)}</ul>"
