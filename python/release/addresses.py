# SPDX-License-Identifier: MIT
"""The address of the repository stands in one line of pyproject.toml, and nowhere else."""

from __future__ import annotations

import re

from project import Project

PLACEHOLDER = re.compile(
    r"(?:https?://|git@)[\w.-]*\bexample(?:\.(?:com|org|net))?(?=[/\s:\"')>]|$)"
)
OF_TESTS = re.compile(r"tests/|.*/tests?/")  # which need addresses that lead nowhere
TEXT = (".md", ".py", ".toml", ".yml", ".yaml", ".cff", ".ipynb", ".cpp", ".hpp", ".mjs", ".js")


def problems(project: Project) -> list[str]:
    """One line for each address that is invented, or is written twice."""
    address, found = project.address(), []
    if address and not re.fullmatch(r"https://[\w.-]+(/[\w.-]+)+", address):
        found.append(f"pyproject.toml: repository = {address!r} is no https address")
    for name in project.files():
        if not name.endswith(TEXT) or OF_TESTS.match(name):
            continue
        for number, line in enumerate(project.text(name).splitlines(), start=1):
            if PLACEHOLDER.search(line):
                found.append(f"{name}:{number}: an invented address: {line.strip()[:60]}")
            if address and address in line and not line.startswith("repository = "):
                found.append(f"{name}:{number}: the address stands in pyproject.toml already")
    return found
