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
from pliant.report.page.bundle import viewer_script

#: cells of a table with more letters than this are text, which is wrapped
SHORT = 14


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


class Marked(str):
    """A cell of a table that is in red."""


def _row(tag: str, texts: Iterable[str]) -> str:
    row = [*texts]
    marked = ' class="off"' if any(isinstance(text, Marked) for text in row) else ""
    first, *others = map(escape, row)
    numbers = "".join(
        f'<{tag} class="{"n" if tag == "td" and len(text) <= SHORT else "t"}">{text}</{tag}>'
        for text in others
    )
    return f"<tr{marked}><{tag}>{first}</{tag}>{numbers}</tr>"


def sentence(text: str) -> str:
    """`text` with a capital and a full stop."""
    return text[:1].upper() + text[1:].rstrip(".") + "."


def disclosure(summary: str, content: str) -> str:
    """A card that opens when it is clicked."""
    return (
        f'<details class="card"><summary>{escape(summary)}</summary><div>{content}</div></details>'
    )


def scripts(shown: Mapping[str, Any]) -> str:
    """The scene and what draws it, as elements of the page."""
    data = json.dumps(plain(shown), separators=(",", ":"), allow_nan=False).replace("<", "\\u003c")
    return (
        f'<script type="application/json" id="scene">{data}</script>\n'
        f"<script>{_inline(viewer_script())}</script>"
    )


def _inline(code: str) -> str:
    """JavaScript that may stand inside a script element."""
    return re.sub(r"</(script)", r"<\\/\1", code, flags=re.IGNORECASE).replace("<!--", "<\\!--")
