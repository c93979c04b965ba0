# SPDX-License-Identifier: MIT
"""Where files of the repository are on the site, and links between them."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PAGES = ROOT / "docs" / "pages"

#: pages of the repository that are shown as they are
INCLUDED = {
    "src/pliant/resolve/README.md": "inside/methods.md",
    "src/pliant/model/README.md": "inside/model.md",
    "src/pliant/sample/README.md": "inside/sampling.md",
    "src/pliant/path/README.md": "inside/paths.md",
    "src/pliant/stream/README.md": "inside/live.md",
    "apps/play/README.md": "inside/play.md",
    "apps/play/wasm/README.md": "inside/wasm.md",
    "python/wheel/README.md": "inside/wheel.md",
    "src/pliant/README.md": "inside/structure.md",
    "data/README.md": "inside/data.md",
    "CONTRIBUTING.md": "inside/contributing.md",
    "src/pliant/ADDING.md": "inside/adding.md",
    "tests/README.md": "inside/tests.md",
    "docs/README.md": "inside/documentation.md",
    "python/release/README.md": "inside/release.md",
    "CHANGELOG.md": "inside/changelog.md",
}
#: what stands for these on the site
SAME = {
    "README.md": "index.md",
    "src/pliant/pliant.hpp": "api/cpp/index.md",
    "tests/cli/help": "help.md",
}
PICTURES = ("data/pictures", "docs/pictures")

LINK = re.compile(r"(!?)\[((?:[^\[\]]|\[[^\]]*\])*)\]\(([^)\s]+)\)(\{[^}]*\})?")
FENCED = re.compile(r"^( *(?:```|~~~)[\s\S]*?\n *(?:```|~~~)[ \t]*$)", re.MULTILINE)
ELSEWHERE = re.compile(r"[a-z]+:|#")


def included() -> Iterator[tuple[Path, str]]:
    """Files that lie outside docs/pages, and their names on the site."""
    for source, name in INCLUDED.items():
        yield ROOT / source, name
    for folder in PICTURES:
        for path in sorted((ROOT / folder).iterdir()):
            if path.suffix in (".png", ".svg", ".webp"):
                yield path, f"pictures/{path.name}"


def notebooks() -> list[Path]:
    """Every notebook, in a fixed order."""
    return sorted((ROOT / "docs" / "notebooks").glob("*.ipynb"))


def site_name(path: Path) -> str | None:
    """The name on the site of a file of the repository; None if it is not there."""
    name = path.relative_to(ROOT).as_posix()
    if name in INCLUDED or name in SAME:
        return (INCLUDED | SAME)[name]
    if path.suffix == ".ipynb":
        return f"notebooks/{path.stem}.md"
    if path.parent.relative_to(ROOT).as_posix() in PICTURES:
        return f"pictures/{path.name}"
    return path.relative_to(PAGES).as_posix() if path.is_relative_to(PAGES) else None


def source_of(name: str) -> Path:
    """The file of the repository that a page of the site is made of."""
    for path, other in included():
        if other == name:
            return path
    if name.startswith("notebooks/"):
        return ROOT / "docs" / name.replace(".md", ".ipynb")
    return PAGES / name


def with_links_of_the_site(markdown: str, name: str) -> str:
    """A page's text with its links as the site has them; what it has not loses its link."""
    folder = source_of(name).parent
    parts = FENCED.split(markdown)  # text and fenced code by turns
    parts[::2] = [LINK.sub(lambda found: _led(found, folder, name), text) for text in parts[::2]]
    return "".join(parts)


def _led(found: re.Match[str], folder: Path, name: str) -> str:
    picture, text, target, attributes = found.groups()
    if ELSEWHERE.match(target):
        return found[0]
    path, _, anchor = target.partition("#")
    resolved = Path(os.path.normpath(folder / path))
    if not resolved.is_relative_to(ROOT):
        return found[0]
    there = site_name(resolved)
    if there is None:
        return text if resolved.exists() else found[0]
    link = os.path.relpath(there, os.path.dirname(name) or ".") + ("#" + anchor if anchor else "")
    return f"{picture}[{text}]({link}){attributes or ''}"
