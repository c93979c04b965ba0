# SPDX-License-Identifier: MIT
"""The report page: one HTML file with everything in it, which asks no network for anything."""

from __future__ import annotations

import base64
from collections.abc import Mapping, Sequence
from html import escape
from importlib import metadata
from pathlib import Path
from typing import TYPE_CHECKING, Any

from pliant._core import techniques
from pliant.base.new_file import write_text
from pliant.base.verdict import Verdict, verdict_of_all
from pliant.measure.stages.parts import Residuals
from pliant.report.figures.style import WIDE
from pliant.report.page.additions import NOTHING, Additions
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
from pliant.report.page.methods import METHODS
from pliant.report.page.page_tables import facts, tables, title
from pliant.report.page.scene import scene
from pliant.report.page.section_titles import SECTIONS, WIDE_SECTIONS
from pliant.report.verdicts import verdicts
from pliant.trajectory.kind import ENSEMBLE

if TYPE_CHECKING:
    from pliant.measure.stages.analysis import Analysis
    from pliant.report.figures.figure_table import FigureKind


MARKS = {"good": "✓", "mixed": "!", "bad": "✕", "open": "–"}


def write_page(
    analysis: Analysis,
    figures: Sequence[tuple[FigureKind, Path]],
    files: Sequence[Path],
    path: Path,
    dpi: int,
    more: Additions = NOTHING,
) -> None:
    """Writes the page. figures: [(FigureKind, PNG path)]; files: outputs to link to."""
    text = page(analysis, figures, files, dpi, more)
    write_text(path, text, overwrite=True)


def page(
    analysis: Analysis,
    figures: Sequence[tuple[FigureKind, Path]],
    files: Sequence[Path],
    dpi: int,
    more: Additions = NOTHING,
) -> str:
    """The page as text."""
    shown = scene(analysis)
    return template("page.html").substitute(
        generator=escape(f"pliant {version()}"),
        title=escape(title(analysis)),
        subtitle=escape(_subtitle(analysis)),
        style=text_of("page.css"),
        eyebrow=more.made_by,
        lead=_lead([*verdicts(analysis).values(), *more.verdicts.values()], more),
        viewer=text_of("viewer.html"),
        facts="\n".join(fact(*row) for row in facts(analysis)),
        notes=_notes(analysis, shown),
        sections=_sections(analysis, figures, dpi, more),
        details=_details(analysis, files),
        footer=escape(f"pliant {version()} · MDAnalysis {metadata.version('MDAnalysis')}"),
        scripts=scripts(shown),
    )


def _subtitle(analysis: Analysis) -> str:
    parts = [f"{len(analysis.universe.atoms):,} atoms"]
    if Residuals in analysis:
        parts.append(f"{len(analysis[Residuals].measured.bars):,} bars")
    parts.append(f"{len(analysis.frames):,} frames")
    if analysis.steps is not None and analysis.kind != ENSEMBLE:
        parts.append(f"steps {analysis.steps[0]:,} to {analysis.steps[-1]:,}")
    run = analysis.record.parameters if analysis.record else {}
    if "run/technique" in run:
        parts.append(_technique(run))
    parts.append(Path(analysis.options.path).name)
    return " · ".join(parts)


def _technique(run: Mapping[str, Any]) -> str:
    """What a run was resolved with, from its parameters."""
    used = run.get("run/technique_used", run["run/technique"])
    weighted = any(row.name == used and row.has_weighting for row in techniques())
    return f"{used}, weighting {run.get('run/weighting', '?')}" if weighted else used


def _lead(made: Sequence[Verdict], more: Additions) -> str:
    """The verdict over all, the answers of a study, and one line a question."""
    judged = verdict_of_all(made)
    return (
        f'<section class="verdict card {judged.kind}">\n'
        f'<div class="mark" aria-hidden="true">{MARKS[judged.kind]}</div>\n'
        f"<p><strong>{escape(judged.sentence)}</strong><span>{escape(judged.details)}</span></p>\n"
        f'</section>\n{more.head()}<section class="verdicts card">\n{_verdicts(made)}\n</section>'
    )


def _verdicts(made: Sequence[Verdict]) -> str:
    """One line a question; none is green while another has failed."""
    failed = any(one.kind == "bad" for one in made)
    return "\n".join(_verdict(one, failed) for one in made)


def _verdict(one: Verdict, failed: bool) -> str:
    colour = "open" if failed and one.kind == "good" else one.kind
    return (
        f'<div class="one {colour}"><div class="mark" aria-hidden="true">{MARKS[one.kind]}</div>'
        f"<p><b>{escape(one.sentence)}</b> <span>{escape(one.details)}</span></p></div>"
    )


def _sections(
    analysis: Analysis, figures: Sequence[tuple[FigureKind, Path]], dpi: int, more: Additions
) -> str:
    """Each section that has anything: its heading, figures and tables."""
    parts = []
    numbers = [*tables(analysis), *more.tables]
    for section in SECTIONS:
        drawn = [
            _figure(analysis, kind, png, dpi) for kind, png in figures if kind.section == section
        ]
        listed = [
            table(one.headers, one.rows, one.caption) for one in numbers if one.section == section
        ]
        if drawn or listed:
            content = "\n".join(drawn + listed)
            wide = " wide" if section in WIDE_SECTIONS else ""
            parts.append(f'<h2>{section}</h2>\n<section class="figures{wide}">{content}</section>')
    return "\n".join(parts)


def _figure(analysis: Analysis, kind: FigureKind, png: Path, dpi: int) -> str:
    caption = kind.caption(analysis)
    content = Path(png).read_bytes()
    width, height = (int.from_bytes(content[k : k + 4], "big") for k in (16, 20))  # of the PNG
    tall = ' class="card tall"' if height > 0.9 * width else ' class="card"'
    style = f"max-width:{min(100, 100 * width / dpi / WIDE[0]):.0f}%"
    data = base64.b64encode(content).decode("ascii")
    return (
        f'<figure{tall}><img alt="{escape(caption)}" style="{style}" '
        f'src="data:image/png;base64,{data}">'
        f"<figcaption>{escape(caption)}</figcaption></figure>"
    )


def _notes(analysis: Analysis, shown: Mapping[str, Any] | None) -> str:
    notes = analysis.notes
    notes += [f"No {name}: {why}." for name, why in analysis.skipped.items()]
    if shown and shown["notes"]:
        notes.append(f"To keep the page small, the 3-D view shows {' and '.join(shown['notes'])}.")
    if not notes:
        return ""
    items = "".join(f"<li>{escape(sentence(note))}</li>" for note in notes)
    return f'<h2>Please note</h2><section class="notes card"><ul>{items}</ul></section>'


def _details(analysis: Analysis, files: Sequence[Path]) -> str:
    parts = [
        disclosure(
            "Methods", "".join(f"<p><b>{escape(a)}.</b> {escape(b)}</p>" for a, b in METHODS)
        )
    ]
    if analysis.record and analysis.record.parameters:
        rows = [
            (name, f"{value:g}" if isinstance(value, float) else str(value))
            for name, value in sorted(analysis.record.parameters.items())
        ]
        parts.append(disclosure("Options of the run", table(("option", "value"), rows)))
    links = "".join(f'<li><a href="{escape(f.name)}">{escape(f.name)}</a></li>' for f in files)
    parts.append(disclosure("Files beside this page", f"<ul>{links}</ul>"))
    return "\n".join(parts)
