# SPDX-License-Identifier: MIT
"""The report page: one HTML file with everything in it, which asks no network for anything."""

from __future__ import annotations

import base64
import json
import re
from collections.abc import Iterable, Mapping, Sequence
from html import escape
from importlib import metadata, resources
from pathlib import Path
from string import Template
from typing import TYPE_CHECKING, Any

from pliant._core import techniques
from pliant.analyse.figures.style import WIDE
from pliant.analyse.found import ENSEMBLE
from pliant.analyse.methods import METHODS
from pliant.analyse.page_tables import PageTable, facts, tables, title
from pliant.analyse.scene import scene
from pliant.analyse.sections import SECTIONS
from pliant.analyse.verdicts import verdicts, whole
from pliant.console import plain

if TYPE_CHECKING:
    from pliant.analyse.bar_verdict import Verdict
    from pliant.analyse.figures import FigureKind
    from pliant.analyse.study import Study


MARKS = {"good": "✓", "mixed": "!", "bad": "✕", "open": "–"}

#: cells of a table with more letters than this are text, which is wrapped
SHORT = 14

MISSING_VIEWER = (
    "The 3-D view is not in this page, because 3Dmol.js is not in the installed package "
    "(pliant/static/3Dmol-min.js). It is fetched from npm when pliant is built. "
    "The rest of the page is whole."
)


def write_page(
    study: Study,
    figures: Sequence[tuple[FigureKind, Path]],
    files: Sequence[Path],
    path: Path,
    dpi: int,
) -> None:
    """Writes the page. figures: [(FigureKind, PNG path)]; files: outputs to link to."""
    text = page(study, figures, files, dpi)
    Path(path).write_text(text, encoding="utf-8")


def page(
    study: Study, figures: Sequence[tuple[FigureKind, Path]], files: Sequence[Path], dpi: int
) -> str:
    """The page as text."""
    judged = whole(study)
    javascript = viewer_script()
    shown = scene(study) if javascript else None
    return _template("page.html").substitute(
        generator=escape(f"pliant {_version()}"),
        title=escape(title(study)),
        subtitle=escape(_subtitle(study)),
        style=_text("page.css"),
        verdict_kind=judged.kind,
        verdict_mark=MARKS[judged.kind],
        verdict=escape(judged.sentence),
        verdict_details=escape(judged.details),
        viewer=_text("viewer.html")
        if shown
        else f'<div class="viewer card notes">{escape(MISSING_VIEWER)}</div>',
        facts="\n".join(_fact(*row) for row in facts(study)),
        notes=_notes(study, shown),
        verdicts=_verdicts(study),
        sections=_sections(study, figures, dpi),
        details=_details(study, files),
        footer=escape(f"pliant {_version()} · MDAnalysis {metadata.version('MDAnalysis')}"),
        scripts=_scripts(javascript, shown) if shown else "",
    )


def viewer_script() -> str:
    """The text of 3Dmol.js, or "" when the package was built without it."""
    file = resources.files("pliant") / "static" / "3Dmol-min.js"
    return file.read_text(encoding="utf-8") if file.is_file() else ""


def _text(name: str) -> str:
    return (resources.files("pliant.analyse") / name).read_text(encoding="utf-8")


def _template(name: str) -> Template:
    return Template(_text(name))


def _version() -> str:
    try:
        return metadata.version("pliant")
    except metadata.PackageNotFoundError:
        return ""


def _subtitle(study: Study) -> str:
    parts = [f"{len(study.universe.atoms):,} atoms"]
    if study.residuals is not None:
        parts.append(f"{len(study.residuals.bars):,} bars")
    parts.append(f"{len(study.frames):,} frames")
    if study.steps is not None and study.kind != ENSEMBLE:
        parts.append(f"steps {study.steps[0]:,} to {study.steps[-1]:,}")
    run = study.record.parameters if study.record else {}
    if "run/technique" in run:
        parts.append(_technique(run))
    parts.append(Path(study.options.path).name)
    return " · ".join(parts)


def _technique(run: Mapping[str, Any]) -> str:
    """What a run was resolved with, from its parameters."""
    used = run.get("run/technique_used", run["run/technique"])
    weighted = any(row.name == used and row.has_weighting for row in techniques())
    return f"{used}, weighting {run.get('run/weighting', '?')}" if weighted else used


def _fact(number: str, unit: str, meaning: str) -> str:
    unit = f"<small>{escape(unit)}</small>" if unit else ""
    return (
        f'<div class="fact card"><b>{escape(number)}{unit}</b><span>{escape(meaning)}</span></div>'
    )


def _verdicts(study: Study) -> str:
    """One line a question; none is green while another has failed."""
    made = verdicts(study).values()
    failed = any(one.kind == "bad" for one in made)
    return "\n".join(_verdict(one, failed) for one in made)


def _verdict(one: Verdict, failed: bool) -> str:
    colour = "open" if failed and one.kind == "good" else one.kind
    return (
        f'<div class="one {colour}"><div class="mark" aria-hidden="true">{MARKS[one.kind]}</div>'
        f"<p><b>{escape(one.sentence)}</b> <span>{escape(one.details)}</span></p></div>"
    )


def _sections(study: Study, figures: Sequence[tuple[FigureKind, Path]], dpi: int) -> str:
    """Each section that has anything: its heading, figures and tables."""
    parts = []
    numbers = tables(study)
    for section in SECTIONS:
        drawn = [_figure(study, kind, png, dpi) for kind, png in figures if kind.section == section]
        told = [_table(table) for table in numbers if table.section == section]
        if drawn or told:
            content = "\n".join(drawn + told)
            parts.append(f'<h2>{section}</h2>\n<section class="figures">{content}</section>')
    return "\n".join(parts)


def _figure(study: Study, kind: FigureKind, png: Path, dpi: int) -> str:
    caption = kind.caption(study)
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


def _table(table: PageTable) -> str:
    title = f"<caption>{escape(table.caption)}</caption>" if table.caption else ""
    body = _row("th", table.headers) + "".join(_row("td", row) for row in table.rows)
    return f'<div class="table card"><table>{title}{body}</table></div>'


def _row(tag: str, texts: Iterable[str]) -> str:
    first, *others = (escape(text) for text in texts)
    numbers = "".join(
        f'<{tag} class="{"n" if tag == "td" and len(text) <= SHORT else "t"}">{text}</{tag}>'
        for text in others
    )
    return f"<tr><{tag}>{first}</{tag}>{numbers}</tr>"


def _notes(study: Study, shown: Mapping[str, Any] | None) -> str:
    notes = [*study.notes]
    notes += [f"No {name}: {why}." for name, why in study.skipped.items()]
    if shown and shown["notes"]:
        notes.append(f"To stay small, the 3-D view shows {' and '.join(shown['notes'])}.")
    if not notes:
        return ""
    items = "".join(f"<li>{escape(_sentence(note))}</li>" for note in notes)
    return f'<h2>Please note</h2><section class="notes card"><ul>{items}</ul></section>'


def _sentence(text: str) -> str:
    return text[:1].upper() + text[1:].rstrip(".") + "."


def _details(study: Study, files: Sequence[Path]) -> str:
    parts = [
        _disclosure(
            "Methods", "".join(f"<p><b>{escape(a)}.</b> {escape(b)}</p>" for a, b in METHODS)
        )
    ]
    if study.record and study.record.parameters:
        rows = [
            (name, f"{value:g}" if isinstance(value, float) else str(value))
            for name, value in sorted(study.record.parameters.items())
        ]
        options = PageTable("", "", ("option", "value"), rows)
        parts.append(_disclosure("Options of the run", _table(options)))
    links = "".join(f'<li><a href="{escape(f.name)}">{escape(f.name)}</a></li>' for f in files)
    parts.append(_disclosure("Files beside this page", f"<ul>{links}</ul>"))
    licence = resources.files("pliant") / "static" / "3Dmol-LICENSE.txt"
    if licence.is_file():
        text = escape(licence.read_text(encoding="utf-8"))
        parts.append(
            _disclosure("Licence of 3Dmol.js, which draws the 3-D view", f"<pre>{text}</pre>")
        )
    return "\n".join(parts)


def _disclosure(summary: str, content: str) -> str:
    return (
        f'<details class="card"><summary>{escape(summary)}</summary><div>{content}</div></details>'
    )


def _scripts(javascript: str, shown: Mapping[str, Any]) -> str:
    data = json.dumps(plain(shown), separators=(",", ":"), allow_nan=False).replace("<", "\\u003c")
    parts = [f'<script type="application/json" id="scene">{data}</script>']
    for code in (javascript, _text("timeline.js"), _text("viewer.js")):
        parts.append(f"<script>{_inline(code)}</script>")
    return "\n".join(parts)


def _inline(code: str) -> str:
    """JavaScript that may stand inside a script element."""
    return re.sub(r"</(script)", r"<\\/\1", code, flags=re.IGNORECASE).replace("<!--", "<\\!--")
