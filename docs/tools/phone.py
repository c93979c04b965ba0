# SPDX-License-Identifier: MIT
"""Fits a page to a narrow screen: pictures open in full, short code stays on a line."""

from __future__ import annotations

import re

PICTURE = re.compile(r"<img [^>]*?src=\"([^\"]+)\"[^>]*>")
LINKED = re.compile(r"(<a\b[^>]*>(?:(?!</a>).)*</a>)", re.DOTALL)
SHORT = 24  #: characters of code that a phone shows on one line
CODE = re.compile(rf"(<pre\b.*?</pre>)|<code>([^<]{{1,{SHORT}}})</code>", re.DOTALL)


def fitted(page: str) -> str:
    """The page, with its pictures linked to themselves and short code kept together."""
    parts = LINKED.split(page)  # what is no link, and links, by turns
    parts[::2] = [PICTURE.sub(_linked, part) for part in parts[::2]]
    return CODE.sub(_together, "".join(parts))


def _linked(found: re.Match[str]) -> str:
    return f'<a class="picture" href="{found[1]}">{found[0]}</a>'


def _together(found: re.Match[str]) -> str:
    return found[1] or f'<code class="short">{found[2]}</code>'
