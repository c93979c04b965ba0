# SPDX-License-Identifier: MIT
"""Every picture that a page shows is there, is made by a script, and every one there is shown."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator

from project import Project

FOLDERS = ("data/pictures", "docs/pictures")
PAGES = (".md", ".ipynb")
SCRIPTS = re.compile(r"(data|docs|python/pliant/lab)/.*\.py|data/README\.md")
SHOWN = re.compile(r"!\[[^\]]*\]\(([^)\s]+)\)|<img [^>]*src=\"([^\"]+)\"")


def shown(project: Project) -> Iterator[tuple[str, str]]:
    """(page, path of a picture from the top) of all that pages show."""
    for page in project.files():
        if page.endswith(PAGES):
            for pair in SHOWN.findall(project.text(page)):
                target = next(filter(None, pair))
                if not re.match(r"[a-z]+:", target):
                    yield page, posixpath.normpath(posixpath.join(posixpath.dirname(page), target))


def problems(project: Project) -> list[str]:
    """One line for each picture that is missing, made by nothing or shown nowhere."""
    pairs = list(shown(project))
    files = project.files()
    there = [name for name in files if name.startswith(tuple(f"{f}/" for f in FOLDERS))]
    scripts = "\n".join(project.text(name) for name in files if SCRIPTS.fullmatch(name))
    found = [f"{page}: there is no picture {name}" for page, name in pairs if name not in files]
    found += [f"{n}: no script makes it" for n in there if posixpath.basename(n) not in scripts]
    named = {name for _, name in pairs} | _linked(project, files)
    return found + [f"{name}: no page shows it" for name in there if name not in named]


def _linked(project: Project, files: list[str]) -> set[str]:
    """Pictures that a page links to, or a script of ours names by its path."""
    texts = "\n".join(project.text(n) for n in files if n.endswith((*PAGES, ".py")) or n == "dev")
    return {name for name in files if name.startswith(FOLDERS) and name in texts}
