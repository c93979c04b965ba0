# SPDX-License-Identifier: MIT
"""What a system has of its own is asked for in one folder: src/pliant/base/system."""

import re
from collections.abc import Iterator
from pathlib import Path

import pytest
from sources import CPP, ROOT, files, numbered_lines, place, refuse

LAYER = ROOT / "src/pliant/base/system"

# Headers that no standard of C++ has, and the one that it has only in part (csignal).
HEADER = re.compile(
    r"#\s*include\s*<((sys|arpa|netinet|net|mach|mach-o|linux)/.*|csignal|signal\.h|unistd\.h|"
    r"fcntl\.h|pthread\.h|poll\.h|netdb\.h|dlfcn\.h|spawn\.h|glob\.h|pwd\.h|termios\.h|malloc\.h|"
    r"io\.h|direct\.h|process\.h|windows\.h|winsock2?\.h|ws2tcpip\.h|shellapi\.h)>"
)
MACRO = re.compile(
    r"\b(__linux__|__APPLE__|__unix__|__GLIBC__|_WIN32|_WIN64|_MSC_VER|__MINGW\w+__)\b"
)
PLACE = re.compile(r'"/(proc|dev|sys|tmp|usr|etc)/')
# On Windows the narrow text of a path has the code page of the machine, and may not exist at all.
NARROW_PATH = re.compile(r"(\.|->)(generic_)?(string|u8string)\(\)|\bfs::path\(|filesystem::path\(")


def knowing(line: str) -> str:
    """What a line of C++ knows of its system; empty if nothing."""
    found = HEADER.search(line) or MACRO.search(line) or PLACE.search(line)
    return found[0] if found else ""


def outside() -> Iterator[Path]:
    """The C++ files of the product that are not in the layer."""
    for path in files(*CPP, folders=("src", "apps", "python")):
        if LAYER not in path.parents and "test" not in path.relative_to(ROOT).parts:
            yield path


def test_only_the_layer_knows_its_system():
    refuse(
        [
            f"{place(path, number)}: {what}: ask base/system for it"
            for path in outside()
            for number, line in numbered_lines(path)
            if (what := knowing(line))
        ]
    )


def test_paths_become_text_in_the_layer():
    refuse(
        [
            f"{place(path, number)}: path_text() and path_of() know the encoding"
            for path in outside()
            for number, line in numbered_lines(path)
            if NARROW_PATH.search(line)
        ]
    )


def test_each_system_answers_every_header():
    public = {path.stem for path in LAYER.glob("*.hpp") if not path.stem.endswith("_internal")}
    headers = public - {path.stem for path in LAYER.glob("*.cpp")}
    for system in ("posix", "windows"):
        sources = {path.stem for path in (LAYER / system).glob("*.cpp")}
        assert headers <= sources, f"{system} lacks {sorted(headers - sources)}"


@pytest.mark.parametrize(
    ("line", "what"),
    [
        ("#include <unistd.h>", "#include <unistd.h>"),
        ("#  include <sys/stat.h>", "#  include <sys/stat.h>"),
        ("#if defined(_WIN32)", "_WIN32"),
        ('open("/proc/self/exe")', '"/proc/'),
        ("#include <string>", ""),
        ('#include "pliant/base/system/signals.hpp"', ""),
    ],
)
def test_a_line_that_knows_its_system_is_seen(line, what):
    assert knowing(line) == what
