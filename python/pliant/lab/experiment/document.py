# SPDX-License-Identifier: MIT
"""The report as one HTML file with everything in it, which asks no network for anything."""

from __future__ import annotations

import base64
from collections.abc import Sequence
from dataclasses import dataclass, field
from html import escape
from importlib import resources
from pathlib import Path

import pliant

EXTRA_STYLE = """
h3 { font-size: 1.02rem; font-weight: 650; margin: 0 0 8px; }
.block { padding: 18px 22px; margin-bottom: 18px; overflow-x: auto; }
.block p + p, .block p + .figures, .block details { margin-top: 12px; }
.block figure { padding: 12px 0 0; }
.badge { display: inline-block; border-radius: 8px; padding: 1px 9px; color: #fff;
  font-size: 0.82rem; font-weight: 650; white-space: nowrap; background: var(--soft); }
.holds { background: var(--green); } .fails { background: var(--red); }
.depends { background: var(--amber); }
.scroll { overflow-x: auto; } .claims td { vertical-align: top; }
.claims th, .claims td { padding-right: 9px; font-size: 0.8rem; }
.claims td:nth-child(2) { min-width: 13em; } .claims td:nth-child(4) { min-width: 15em; }
.claims td:nth-child(5) { min-width: 17em; color: var(--soft); }
.wide { grid-template-columns: minmax(0, 1fr); }
nav { margin-top: 14px; display: flex; flex-wrap: wrap; gap: 6px 16px; font-size: 0.9rem; }
"""


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

    The modules of ``pliant.lab.experiment.questions`` each have ``TITLE: str`` and ``answer(out:
    Path, seed: int, quick: bool) -> Answer``; `out` is an empty or earlier filled folder that is
    theirs alone, `quick` asks for small sizes.
    """

    title: str
    verdict: str  #: one or two sentences
    paragraphs: list[str] = field(default_factory=list)
    tables: list[Table] = field(default_factory=list)
    figures: list[Figure] = field(default_factory=list)


def as_text(tables: list[Table]) -> list[Table]:
    """Every cell as words, so that columns of figures and of intervals stand alike."""
    for table in tables:
        table.rows = [[str(cell) for cell in row] for row in table.rows]
    return tables


def page(title: str, subtitle: str, sections: Sequence[tuple[str, str]]) -> str:
    """The page as text: sections of (heading, HTML), with links to them at the top."""
    css = (resources.files("pliant.report.page") / "page.css").read_text(encoding="utf-8")
    links = "".join(f'<a href="#s{k}">{escape(name)}</a>' for k, (name, _) in enumerate(sections))
    bodies = "\n".join(
        f'<h2 id="s{k}">{escape(name)}</h2>\n{body}' for k, (name, body) in enumerate(sections)
    )
    return f"""<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; img-src data:; \
style-src 'unsafe-inline'">
<title>{escape(title)}</title>
<link rel="icon" href="data:,">
<style>
{css}{EXTRA_STYLE}</style>
</head>
<body>
<main>
<header>
<p class="eyebrow">pliant lab experiment</p>
<h1>{escape(title)}</h1>
<p class="subtitle">{escape(subtitle)}</p>
<nav>{links}</nav>
</header>
{bodies}
<footer>pliant {escape(pliant.__version__)}</footer>
</main>
</body>
</html>
"""


def block(*parts: str) -> str:
    """A card with these pieces of HTML."""
    return '<div class="card block">' + "\n".join(part for part in parts if part) + "</div>"


def paragraph(text: str) -> str:
    """A paragraph of plain text."""
    return f"<p>{escape(text)}</p>"


def badge(word: str) -> str:
    """A verdict as a coloured word."""
    return f'<span class="badge {escape(word)}">{escape(word)}</span>'


def table(made: Table, kind: str = "") -> str:
    """A table; numbers are right-aligned. A cell that is a verdict becomes a badge."""
    head = "".join(f"<th>{escape(name)}</th>" for name in made.header)
    rows = "\n".join("<tr>" + "".join(map(_cell, row)) + "</tr>" for row in made.rows)
    caption = f"<caption>{escape(made.caption)}</caption>" if made.caption else ""
    return (
        f'<div class="scroll"><table class="{kind}">{caption}<thead><tr>{head}</tr></thead>\n'
        f"<tbody>{rows}</tbody></table></div>"
    )


def _cell(value: str | int | float) -> str:
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        text = str(value)
        shown = badge(text) if text in ("holds", "fails", "depends", "open", "untested") else None
        return f"<td>{shown or escape(text)}</td>"
    text = str(value) if isinstance(value, int) else f"{value:.4g}"
    return f'<td class="n">{escape(text)}</td>'


def figure(drawn: Figure) -> str:
    """A figure with its picture in the page."""
    kind = "svg+xml" if drawn.path.suffix == ".svg" else "png"
    data = base64.b64encode(Path(drawn.path).read_bytes()).decode("ascii")
    return (
        f'<figure class="card"><img alt="{escape(drawn.caption, quote=True)}" '
        f'src="data:image/{kind};base64,{data}">'
        f"<figcaption>{escape(drawn.caption)}</figcaption></figure>"
    )


def figures(drawn: Sequence[Figure], wide: bool = False) -> str:
    """Figures beside each other, or each over the whole width."""
    return (
        f'<div class="figures{" wide" if wide else ""}">'
        + "\n".join(figure(one) for one in drawn)
        + "</div>"
    )


def fold(summary: str, *parts: str) -> str:
    """Pieces of HTML that are shown on demand."""
    return f"<details><summary>{escape(summary)}</summary>{''.join(parts)}</details>"


def answer(made: Answer) -> str:
    """A question with its answer, as a section's HTML."""
    head = block(
        f"<p><strong>{escape(made.verdict)}</strong></p>",
        *(paragraph(text) for text in made.paragraphs),
    )
    tables = "".join(block(table(one)) for one in made.tables)
    return head + tables + (figures(made.figures, wide=True) if made.figures else "")
