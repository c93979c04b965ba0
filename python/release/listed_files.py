# SPDX-License-Identifier: MIT
"""What is in files as lines: datasets of H5MD files, keys of JSON, words of force files.

``tests/python/trajectory/test_promised_files.py`` compares the list with what commands write.
"""

from __future__ import annotations

from project import Project

LIST = "tests/python/trajectory/promised_files.ref"


def broken(before: Project, now: Project) -> list[str]:
    """What is in a file keeps its name, type and rank."""
    there = set(now.text(LIST).splitlines())
    return [f"{line}: is gone" for line in before.text(LIST).splitlines() if line not in there]
