# SPDX-License-Identifier: MIT
"""The command line as lines: commands, and the options that their --help names.

Read from the committed help texts: an option counts where --help explains it, or uses it in a
sentence or an example. What --help-all alone explains is not promised, nor is the laboratory.
"""

from __future__ import annotations

import re

from project import Project

FOLDER = "tests/cli/help"
LABORATORY = ("bench", "experiment", "forcegen", "order", "structgen", "techniques")
EXPLAINED = re.compile(r"^  (?:-\w, ?)?(--[\w-]+)", re.MULTILINE)
NAMED = re.compile(r"--[\w-]+")
OF_ALL = {"--help", "--help-all"}


def lines(project: Project) -> list[str]:
    """`pliant NAME` for each command, `pliant NAME --option` for each of its options."""
    found = {f"pliant COMMAND {option}" for option in OF_ALL}
    for path in sorted((project.root / FOLDER).glob("pliant-*.help.txt")):
        name = path.name.removesuffix(".help.txt").removeprefix("pliant-")
        if name.startswith(LABORATORY) or name.endswith("-all"):
            continue
        text = path.read_text(encoding="utf-8")
        its = EXPLAINED.findall(text + project.text(f"{FOLDER}/pliant-{name}-all.help.txt"))
        usual = set(NAMED.findall(text)).intersection(its) - OF_ALL
        found |= {f"pliant {name}", *(f"pliant {name} {option}" for option in usual)}
    return sorted(found)


def serves(new: str, old: str) -> bool:
    """An option stays what it is."""
    return new == old
