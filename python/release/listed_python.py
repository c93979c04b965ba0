# SPDX-License-Identifier: MIT
"""The Python interface, compared by griffe: names, parameters, their order and their defaults.

It is read from the committed reference, which a test compares with the package. Types are not part
of the promise, for they only get wider.
"""

from __future__ import annotations

import re
from collections import Counter
from pathlib import Path

import griffe
from project import Project

REFERENCE = "tests/python/pliant.pyi.ref"
TYPES = {griffe.BreakageKind.RETURN_CHANGED_TYPE, griffe.BreakageKind.ATTRIBUTE_CHANGED_TYPE}
COLOUR = re.compile(r"\x1b\[\d+m")


def numbered(text: str) -> str:
    """The reference with a number behind each function that it has again, as overloads are written:
    of one name griffe keeps the last."""
    seen: Counter[str] = Counter()

    def told_apart(found: re.Match[str]) -> str:
        seen[found[1]] += 1
        return f"def {found[1]}" + (f"_{seen[found[1]]}" if seen[found[1]] > 1 else "")

    return re.sub(r"^def (\w+)", told_apart, text, flags=re.MULTILINE)


def broken(before: Project, now: Project) -> list[str]:
    """One text for each use that the old reference allows and the new one does not."""
    old, new = (
        griffe.visit("pliant", Path("pliant.pyi"), numbered(one.text(REFERENCE)))
        for one in (before, now)
    )
    return [
        COLOUR.sub("", change.explain(griffe.ExplanationStyle.ONE_LINE)).split(": ", 1)[1]
        for change in griffe.find_breaking_changes(old, new)
        if change.kind not in TYPES
    ]
