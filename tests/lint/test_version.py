# SPDX-License-Identifier: MIT
"""The version is written in CMakeLists.txt; what else names it must agree."""

import re

from sources import ROOT


def found(name: str, pattern: str) -> str:
    """The first group of the pattern in a file of the top folder."""
    match = re.search(pattern, (ROOT / name).read_text(encoding="utf-8"), re.MULTILINE)
    assert match, f"{name} names no version"
    return match[1]


def test_files_name_one_version():
    version = found("CMakeLists.txt", r"^project\(pliant VERSION ([\d.]+)")
    assert found("CITATION.cff", r"^version: ([\d.]+)") == version
    assert found("CHANGELOG.md", r"^## ([\d.]+)") == version
