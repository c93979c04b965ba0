# SPDX-License-Identifier: MIT
"""The page of all help texts, from those that tests compare with what the commands print."""

from __future__ import annotations

from pathlib import Path

TEXTS = Path(__file__).resolve().parents[2] / "tests" / "cli" / "help"

INTRODUCTION = """# What --help prints

Command by command, and `--help-all` where `--help` does not list all options.
[Commands](commands.md) says which one is for what.
"""


def page() -> str:
    """One section for each command."""
    texts = sorted(TEXTS.glob("*.help.txt"), key=lambda path: path.name.removesuffix(".help.txt"))
    return "\n".join([INTRODUCTION, *(_section(path) for path in texts)])


def _section(path: Path) -> str:
    name = path.name.removesuffix(".help.txt").replace("-", " ", 1)
    for group in ("lab", "bench", "experiment"):
        name = name.replace(f"{group}-", f"{group} ")
    name = name.replace("-all", " --help-all")
    return f"## {name}\n\n```text\n{path.read_text().rstrip()}\n```\n"
