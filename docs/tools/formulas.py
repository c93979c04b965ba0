# SPDX-License-Identifier: MIT
"""Formulas: LaTeX as pymdownx.arithmatex marks it, to MathML."""

from __future__ import annotations

import html
import re

from latex2mathml.converter import convert

MARKED = re.compile(r'<(span|div) class="arithmatex">\\[(\[](.*?)\\[)\]]</\1>', re.DOTALL)


def with_mathml(page: str) -> str:
    """The page, with each marked formula as a <math> element."""

    def as_mathml(found: re.Match[str]) -> str:
        display = "block" if found[1] == "div" else "inline"
        return convert(html.unescape(found[2]).strip(), display=display)

    return MARKED.sub(as_mathml, page)
