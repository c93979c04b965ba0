# SPDX-License-Identifier: MIT
"""What Pliant promises, compared with what the last tagged version promised.

Each part is read from files of the repository, as they are now and as they were at the tag; tests
hold that these files say what is there. Within a major version nothing goes, and what changes
serves those who used it.
"""

from __future__ import annotations

from collections.abc import Callable

import listed_commands
import listed_cpp
import listed_files
import listed_python
from project import Project

#: what breaks users of a part: one text for each thing, of the project before and after
PARTS: dict[str, Callable[[Project, Project], list[str]]] = {
    "python": listed_python.broken,
    "cpp": listed_cpp.broken,
    "commands": listed_commands.broken,
    "files": listed_files.broken,
}


def last_tag(project: Project) -> str:
    """The tag of the highest version that the commit stands on; empty if there is none."""
    return project.git(
        "tag", "--list", "v[0-9]*", "--merged", "HEAD", "--sort=-version:refname"
    ).partition("\n")[0]


def problems(project: Project) -> list[str]:
    """One line for each promise of the last tagged version that is not kept."""
    tag = last_tag(project)
    if not tag:
        return []
    before = project._replace(tag=tag)
    if before.version().partition(".")[0] != project.version().partition(".")[0]:
        return []
    return [
        f"{part}: {text} (since {tag})"
        for part, broken in PARTS.items()
        for text in broken(before, project)
    ]
