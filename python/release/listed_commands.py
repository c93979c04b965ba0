# SPDX-License-Identifier: MIT
"""The command line as lines: commands, and the options that their --help names.

Read from the committed help texts: an option counts where --help explains it, or uses it in a
sentence or an example. What --help-all alone explains is not promised, nor is the laboratory.
"""

from __future__ import annotations

import re

from project import Project

FOLDER = "tests/cli/help"
EXPLAINED = re.compile(r"^  (?:-\w, ?)?(--[\w-]+)", re.MULTILINE)
NAMED = re.compile(r"--[\w-]+")
OF_ALL = {"--help", "--help-all"}


def lines(project: Project) -> list[str]:
    """`pliant NAME` for each command, `pliant NAME --option` for each of its options."""
    found = {f"pliant COMMAND {option}" for option in OF_ALL}
    for name in re.findall(rf"^{FOLDER}/pliant-(.+)\.help\.txt$", "\n".join(project.files()), re.M):
        if name.startswith("lab") or name.endswith("-all"):
            continue
        text = project.text(f"{FOLDER}/pliant-{name}.help.txt")
        its = EXPLAINED.findall(text + project.text(f"{FOLDER}/pliant-{name}-all.help.txt"))
        usual = set(NAMED.findall(text)).intersection(its) - OF_ALL
        found |= {f"pliant {name}", *(f"pliant {name} {option}" for option in usual)}
    return sorted(found)


def broken(before: Project, now: Project) -> list[str]:
    """A command or option stays what it is."""
    there = lines(now)
    return [f"{line}: is gone" for line in lines(before) if line not in there]
