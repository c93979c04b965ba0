# SPDX-License-Identifier: MIT
"""The page of all commands, from the help texts that tests compare with what the commands print."""

from __future__ import annotations

from pathlib import Path

TEXTS = Path(__file__).resolve().parents[2] / "tests" / "cli"

INTRODUCTION = """# Commands

What `--help` prints, command by command. Every command takes `--json`. It ends with 0 if all went
well, 1 if the input is wrong and 2 for a bad option; other codes stand with the command.
"""


def page() -> str:
    """One section for each command."""
    texts = sorted(TEXTS.glob("*.help.txt"), key=lambda path: path.name.removesuffix(".help.txt"))
    return "\n".join([INTRODUCTION, *(_section(path) for path in texts)])


def _section(path: Path) -> str:
    name = path.name.removesuffix(".help.txt").replace("-", " ", 1).replace("bench-", "bench ")
    name = name.replace("experiment-", "experiment ")
    return f"## {name}\n\n```text\n{path.read_text().rstrip()}\n```\n"
