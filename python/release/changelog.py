# SPDX-License-Identifier: MIT
"""The section of a version in CHANGELOG.md: one line a change, for those who use Pliant."""

from __future__ import annotations

import re

KINDS = ("Added", "Changed", "Deprecated", "Removed", "Fixed")  # in this order
LONGEST = 230  # characters of a change


def section(text: str, version: str) -> list[str]:
    """The lines below the heading of a version; none if it has no section."""
    lines = text.splitlines()
    starts = [k for k, line in enumerate(lines) if line.startswith("## ")]
    for start, end in zip(starts, [*starts[1:], len(lines)], strict=True):
        if lines[start].startswith(f"## {version} "):
            return lines[start + 1 : end]
    return []


def changes(lines: list[str]) -> list[str]:
    """The changes of a section."""
    return [line for line in lines if line.startswith("- ")]


def problems(lines: list[str]) -> list[str]:
    """What is not one line a change, sorted by kind."""
    if not changes(lines):
        return ["no changes"]
    kinds = [line[4:] for line in lines if line.startswith("### ")]
    found = []
    if kinds != [kind for kind in KINDS if kind in kinds]:
        found.append(f"headings {', '.join(kinds)}: must be of {', '.join(KINDS)}, in this order")
    first = next((k for k, line in enumerate(lines) if line.startswith("### ")), 0)
    for line in filter(None, lines[first:]):
        if not re.match(r"- \S|### ", line):
            found.append(f"a change of more than one line: {line.strip()[:60]}")
        elif len(line) > LONGEST:
            found.append(f"{len(line)} characters, at most {LONGEST}: {line[:60]}")
        elif line.startswith("- ") and not line.endswith("."):
            found.append(f"no full stop: {line[:60]}")
    return found + _empty_kinds(lines)


def _empty_kinds(lines: list[str]) -> list[str]:
    text = "\n".join(lines) + "\n"
    return [f"nothing under {kind}" for kind in re.findall(r"^### (\w+)\n(?!\n*- )", text, re.M)]


def notes(lines: list[str], name: str) -> str:
    """The same as the notes of a release."""
    body = "\n".join(lines).strip().replace("\n### ", "\n## ")
    body = re.sub(r"\[([^\]]+)\]\((?!https)[^)]+\)", r"\1", body)  # links of the repository
    return f"{name}\n\n{body}\n"
