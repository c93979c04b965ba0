# SPDX-License-Identifier: MIT
"""Every library that the build looks for has its licence in the notices."""

import re

from sources import ROOT, files

LOOKED_FOR = re.compile(r"^\s*find_(?:package|dependency)\((\w+)", re.MULTILINE)
HEADERS = re.compile(r"^\s*find_path\((\w+)_INCLUDE_DIR", re.MULTILINE)
LISTS = re.compile(r"^\s*foreach\(package (?!IN )([A-Z]\w+(?: \w+)*)\)", re.MULTILINE)
#: tools, and what every system has
NO_PART_OF_PLIANT = {"Threads", "Python", "GTest", "benchmark", "pliant", "ZIG"}


def builds():
    """The texts of what CMake reads for the library, the command and the Python package."""
    paths = [ROOT / "CMakeLists.txt", *files(".cmake", folders=("src/cmake",))]
    paths += [
        path
        for path in files(".txt", folders=("src", "apps", "python"))
        if path.name == "CMakeLists.txt"
    ]
    return [path.read_text() for path in paths]


def test_every_library_has_a_notice():
    texts = builds()
    named = {name for text in texts for name in LOOKED_FOR.findall(text) + HEADERS.findall(text)}
    named |= {name for text in texts for names in LISTS.findall(text) for name in names.split()}
    table = (ROOT / "src/cmake/PliantNotices.cmake").read_text()
    known = set(re.findall(r'^  "(\w+)\|[^|]+\|https://[^|]+\|[\w.-]*"', table, re.MULTILINE))
    assert {"HDF5", "Eigen3", "GEMMI", "CLI11", "BZip2"} <= named
    assert named - NO_PART_OF_PLIANT <= known
