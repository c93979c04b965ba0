# SPDX-License-Identifier: MIT
"""Every page's links lead somewhere, pictures are made and shown, and no address is invented."""

import posixpath
import re
from collections.abc import Iterator
from pathlib import Path

import pytest
from sources import FOLDERS, ROOT, files, numbered_lines, place, refuse, tracked

LINK = re.compile(r"\]\(([^)\s]+)\)")
HEADING = re.compile(r"#+ +(.*)")
HEADER = re.compile(r"`(?:src/pliant/|pliant/)?((?:[a-z0-9_]+/)+[a-z0-9_]+\.hpp)`")
NOT_OURS = ("http://", "https://", "mailto:")
NO_TEXT = {".png", ".webp", ".gz", ".h5md", ".xtc", ".zip"}
HEADERS_FROM = (ROOT, ROOT / "src" / "pliant")


def text_of(name: str) -> str:
    """A file by its path from the top; nothing of what is no text."""
    path = ROOT / name
    return "" if path.suffix in NO_TEXT else path.read_text(encoding="utf-8", errors="ignore")


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


SHOWN = re.compile(r"!\[[^\]]*\]\(([^)\s]+)\)|<img [^>]*src=\"([^\"]+)\"")
PICTURES = ("data/pictures/", "docs/pictures/")
MAKES = re.compile(r"(data|docs|python/pliant/lab)/.*\.py|data/README\.md")


def missing_pictures(texts: dict[str, str]) -> Iterator[str]:
    """One text for each picture of a page that is not there."""
    for name, text in texts.items():
        if name.endswith((".md", ".ipynb")):
            for target in map("".join, SHOWN.findall(text)):
                there = posixpath.normpath(posixpath.join(posixpath.dirname(name), target))
                if not target.startswith(NOT_OURS) and there not in texts:
                    yield f"{name}: there is no picture {target}"


def idle_pictures(texts: dict[str, str]) -> Iterator[str]:
    """One text for each picture that no script makes, or nothing shows."""
    made = "\n".join(text for name, text in texts.items() if MAKES.fullmatch(name))
    for name in texts:
        if name.startswith(PICTURES):
            file = posixpath.basename(name)
            if file not in made:
                yield f"{name}: no script makes it"
            if not any(f"pictures/{file}" in text for text in texts.values()):
                yield f"{name}: no page shows it"


def test_pictures_are_there_and_made_and_shown():
    texts = {name: text_of(name) for name in tracked()}
    refuse([*missing_pictures(texts), *idle_pictures(texts)])


@pytest.mark.parametrize(
    ("name", "text", "said"),
    [
        (
            "docs/page.md",
            "![A](pictures/two.png)",
            "docs/page.md: there is no picture pictures/two",
        ),
        ("docs/page.md", "<img alt='' src=\"three.png\">", "there is no picture three.png"),
        ("docs/page.md", "none", "docs/pictures/one.png: no page shows it"),
        ("docs/make.py", "", "docs/pictures/one.png: no script makes it"),
    ],
)
def test_a_picture_that_is_missing_or_idle_is_found(name, text, said):
    texts = {
        "docs/page.md": "![A](pictures/one.png)",
        "docs/pictures/one.png": "",
        "docs/make.py": '"one.png"',
    }
    assert [*missing_pictures(texts), *idle_pictures(texts)] == []
    found = [*missing_pictures(texts | {name: text}), *idle_pictures(texts | {name: text})]
    assert said in found[0]


INVENTED = re.compile(r"(?:https?://|git@)[\w.-]*\bexample(?:\.(?:com|org|net))?(?=[/\s:\"')>]|$)")
OF_TESTS = re.compile(r"tests/|.*/tests?/")  # which need addresses that lead nowhere


def wrong_addresses(name: str, text: str, ours: str) -> Iterator[str]:
    """One text for each line with an invented address, or with that of pyproject.toml once more."""
    for number, line in enumerate(text.splitlines(), start=1):
        if INVENTED.search(line):
            yield f"{name}:{number}: an invented address"
        if ours and ours in line and not line.startswith("Source = "):
            yield f"{name}:{number}: the address stands in pyproject.toml already"


def test_addresses_are_real_and_ours_is_written_once():
    found = re.search(r'^Source = "(.*)"', text_of("pyproject.toml"), re.MULTILINE)
    ours = found[1] if found else ""
    assert not ours or re.fullmatch(r"https://[\w.-]+(/[\w.-]+)+", ours)
    names = [name for name in tracked() if not OF_TESTS.match(name)]
    refuse([found for name in names for found in wrong_addresses(name, text_of(name), ours)])


def test_an_address_that_is_invented_or_twice_is_found():
    (found,) = wrong_addresses("a.md", "see\nhttps://pliant.example/it for more", "")
    assert found == "a.md:2: an invented address"
    ours = "https://git.invalid/pliant"
    assert len([*wrong_addresses("a.md", f"home: {ours}\nSource = '{ours}'", ours)]) == 1


def test_anchors_are_those_of_github(tmp_path):
    page = tmp_path / "page.md"
    page.write_text("# How it is\n## `bfs_tree` and `b`\n```\n# no heading\n```\n### A, b: c?\n")
    assert anchors(page) == {"how-it-is", "bfs_tree-and-b", "a-b-c"}
    assert leads_somewhere(page, "#a-b-c")
    assert leads_somewhere(page, "page.md#how-it-is")
    assert not leads_somewhere(page, "#no-heading")
    assert not leads_somewhere(page, "other.md")
