# SPDX-License-Identifier: MIT
"""The modules of the 3-D view as one script: those of this folder and of pliant play's page."""

from __future__ import annotations

import functools
import re
from importlib import resources

_IMPORT = re.compile(r"^import \{([^}]+)\} from '[^']*?(\w+)\.mjs';\n", re.MULTILINE)
_EXPORT = re.compile(r"^export (?:const|function|class) \[?([\w, ]+)", re.MULTILINE)
_COMMENT = re.compile(r"^\s*//.*\n|^\s*/\*\*(?:.|\n)*?\*/\n", re.MULTILINE)
_INDENT = re.compile(r"^[ \t]+", re.MULTILINE)


@functools.cache
def viewer_script() -> str:
    """What draws the scene of a page, as text of JavaScript."""
    made: dict[str, str] = {}
    _take("viewer", made)
    return "\n".join(['"use strict";', *made.values()])


def _take(name: str, made: dict[str, str]) -> None:
    """Puts a module after those that it imports; each is a function, so that names stay apart."""
    text = _INDENT.sub("", _COMMENT.sub("", _source(name)))
    for _, other in _IMPORT.findall(text):
        if other not in made:
            _take(other, made)
    told = ", ".join(names.strip() for names in _EXPORT.findall(text))
    body = _IMPORT.sub(r"const {\1} = from_\2;\n", text)
    body = re.sub(r"^export ", "", body, flags=re.MULTILINE)
    made[name] = f"const from_{name} = (() => {{\n{body}return {{{told}}};\n}})();"


def _source(name: str) -> str:
    here = resources.files("pliant.report.page") / f"{name}.mjs"
    shared = resources.files("pliant") / "static" / "view" / f"{name}.mjs"
    return (here if here.is_file() else shared).read_text(encoding="utf-8")
