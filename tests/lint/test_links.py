# SPDX-License-Identifier: MIT
"""Every page's links within the project lead somewhere, and headers that it names are there."""

import re
from collections.abc import Iterator
from pathlib import Path

from sources import FOLDERS, ROOT, files, numbered_lines, place, refuse

LINK = re.compile(r"\]\(([^)\s]+)\)")
HEADING = re.compile(r"#+ +(.*)")
HEADER = re.compile(r"`(?:src/pliant/|pliant/)?((?:[a-z0-9_]+/)+[a-z0-9_]+\.hpp)`")
NOT_OURS = ("http://", "https://", "mailto:")
HEADERS_FROM = (ROOT, ROOT / "src" / "pliant")


def pages() -> list[Path]:
    """All that is written as Markdown."""
    return [*sorted(ROOT.glob("*.md")), *files(".md", folders=(*FOLDERS, "data"))]


def prose(path: Path) -> Iterator[tuple[int, str]]:
    """Numbered lines that are no code."""
    is_code = False
    for number, line in numbered_lines(path):
        if line.startswith("```"):
            is_code = not is_code
        elif not is_code:
            yield number, line


def anchors(path: Path) -> set[str]:
    """What GitHub calls the headings of a page."""
    headings = [found[1] for _, line in prose(path) if (found := HEADING.match(line))]
    return {re.sub(r"[^\w\- ]", "", text.lower()).strip().replace(" ", "-") for text in headings}


def leads_somewhere(path: Path, target: str) -> bool:
    """Whether a file, and the heading in it if one is named, is there."""
    name, _, anchor = target.partition("#")
    file = path.parent / name if name else path
    return file.exists() and (not anchor or anchor in anchors(file))


def test_links_lead_somewhere():
    refuse(
        [
            f"{place(path, number)}: {target} leads nowhere"
            for path in pages()
            for number, line in prose(path)
            for target in LINK.findall(line)
            if not target.startswith(NOT_OURS) and not leads_somewhere(path, target)
        ]
    )


def test_headers_that_pages_name_are_there():
    refuse(
        [
            f"{place(path, number)}: there is no {name}"
            for path in pages()
            for number, line in prose(path)
            for name in HEADER.findall(line)
            if not any((folder / name).is_file() for folder in HEADERS_FROM)
        ]
    )


def test_anchors_are_those_of_github(tmp_path):
    page = tmp_path / "page.md"
    page.write_text("# How it is\n## `bfs_tree` and `b`\n```\n# no heading\n```\n### A, b: c?\n")
    assert anchors(page) == {"how-it-is", "bfs_tree-and-b", "a-b-c"}
    assert leads_somewhere(page, "#a-b-c")
    assert leads_somewhere(page, "page.md#how-it-is")
    assert not leads_somewhere(page, "#no-heading")
    assert not leads_somewhere(page, "other.md")
