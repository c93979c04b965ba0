# SPDX-License-Identifier: MIT
"""The command line as lines: every command and every option, from the committed help texts."""

from __future__ import annotations

import re

from project import Project

FOLDER = "tests/cli/help"
LABORATORY = ("bench", "experiment")  # not promised
OPTION = re.compile(r"^  (-[\w-]+(?:, ?-[\w-]+)*)(.*)$", re.MULTILINE)


def lines(project: Project) -> list[str]:
    """`pliant NAME` for each command, `pliant NAME --option` for each of its options."""
    found = set()
    for path in sorted((project.root / FOLDER).glob("pliant-*.help.txt")):
        name = path.name.removesuffix(".help.txt").removesuffix("-all").removeprefix("pliant-")
        if not name.startswith(LABORATORY):
            found |= {f"pliant {name}", *_options(name, path.read_text(encoding="utf-8"))}
    return sorted(found)


def _options(name: str, text: str) -> set[str]:
    return {
        f"pliant {name} {option.strip()}{' VALUE' if _takes_value(rest) else ''}"
        for options, rest in OPTION.findall(text)
        for option in options.split(",")
    }


def _takes_value(rest: str) -> bool:
    """Whether a word in capitals follows the option's name, before its meaning."""
    return bool(re.match(r" \S", rest))


def serves(new: str, old: str) -> bool:
    """An option stays what it is."""
    return new == old
