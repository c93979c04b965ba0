# SPDX-License-Identifier: MIT
"""What the pages share: the template, the 3-D view, cards and tables."""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Mapping, Sequence
from html import escape
from importlib import metadata, resources
from string import Template
from typing import Any

from pliant.base.console import plain

#: cells of a table with more letters than this are text, which is wrapped
SHORT = 14

MISSING_VIEWER = (
    "The 3-D view is not in this page, because 3Dmol.js is not in the installed package "
    "(pliant/static/3Dmol-min.js). It is fetched from npm when pliant is built. "
    "The rest of the page is whole."
)


def viewer_script() -> str:
    """The text of 3Dmol.js, or "" when the package was built without it."""
    file = resources.files("pliant") / "static" / "3Dmol-min.js"
    return file.read_text(encoding="utf-8") if file.is_file() else ""


def text_of(name: str) -> str:
    """A file of this package."""
    return (resources.files("pliant.report.page") / name).read_text(encoding="utf-8")


def template(name: str) -> Template:
    """A file of this package as a template."""
    return Template(text_of(name))


def version() -> str:
    """The version of the installed package; "" where it is not installed."""
    try:
        return metadata.version("pliant")
    except metadata.PackageNotFoundError:
        return ""


def viewer(is_there: bool) -> str:
    """The frame of the 3-D view, or why it is missing."""
    missing = f'<div class="viewer card notes">{escape(MISSING_VIEWER)}</div>'
    return text_of("viewer.html") if is_there else missing


def fact(number: str, unit: str, meaning: str) -> str:
    """A card with one number."""
    unit = f"<small>{escape(unit)}</small>" if unit else ""
    return (
        f'<div class="fact card"><b>{escape(number)}{unit}</b><span>{escape(meaning)}</span></div>'
    )


def table(headers: Sequence[str], rows: Iterable[Sequence[str]], caption: str = "") -> str:
    """A card with a table; the first column is on the left."""
    title = f"<caption>{escape(caption)}</caption>" if caption else ""
    body = _row("th", headers) + "".join(_row("td", row) for row in rows)
    return f'<div class="table card"><table>{title}{body}</table></div>'


def _row(tag: str, texts: Iterable[str]) -> str:
    first, *others = (escape(text) for text in texts)
    numbers = "".join(
        f'<{tag} class="{"n" if tag == "td" and len(text) <= SHORT else "t"}">{text}</{tag}>'
        for text in others
    )
    return f"<tr><{tag}>{first}</{tag}>{numbers}</tr>"


def sentence(text: str) -> str:
    """`text` with a capital and a full stop."""
    return text[:1].upper() + text[1:].rstrip(".") + "."


def disclosure(summary: str, content: str) -> str:
    """A card that opens when it is clicked."""
    return (
        f'<details class="card"><summary>{escape(summary)}</summary><div>{content}</div></details>'
    )


def licence_of_viewer() -> str:
    """The licence of 3Dmol.js; "" where it is not in the package."""
    licence = resources.files("pliant") / "static" / "3Dmol-LICENSE.txt"
    if not licence.is_file():
        return ""
    text = escape(licence.read_text(encoding="utf-8"))
    return disclosure("Licence of 3Dmol.js, which draws the 3-D view", f"<pre>{text}</pre>")


def scripts(javascript: str, shown: Mapping[str, Any]) -> str:
    """3Dmol.js, the scene and what draws it, as elements of the page."""
    data = json.dumps(plain(shown), separators=(",", ":"), allow_nan=False).replace("<", "\\u003c")
    parts = [f'<script type="application/json" id="scene">{data}</script>']
    for code in (javascript, text_of("timeline.js"), text_of("viewer.js")):
        parts.append(f"<script>{_inline(code)}</script>")
    return "\n".join(parts)


def _inline(code: str) -> str:
    """JavaScript that may stand inside a script element."""
    return re.sub(r"</(script)", r"<\\/\1", code, flags=re.IGNORECASE).replace("<!--", "<\\!--")
