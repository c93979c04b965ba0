# SPDX-License-Identifier: MIT
"""CPython's stable ABI: the names that python3.dll has and that every later version keeps.

The list is CPython's own (Misc/stable_abi.toml), as the Python package abi3info brings it.
"""

from typing import Any, NamedTuple

FIRST = (3, 12)  # the first version whose stable ABI is enough for nanobind


class Names(NamedTuple):
    """What a library shows."""

    functions: set[str]
    data: set[str]


def _numbers(version: str) -> tuple[int, int]:
    major, minor = version.split(".")
    return int(major), int(minor)


def has(version: str) -> bool:
    """Whether an extension for this version is built against the stable ABI."""
    return _numbers(version) >= FIRST


def names(version: str) -> Names:
    """Those that python3.dll has since this version or before."""
    from abi3info import DATAS, FUNCTIONS

    since = min(_numbers(version), FIRST)

    def of(table: dict[Any, Any]) -> set[str]:
        return {
            symbol.name
            for symbol, row in table.items()
            if (row.added.major, row.added.minor) <= since
            and (row.ifdef is None or row.ifdef.windows is True)
        }

    return Names(of(FUNCTIONS), of(DATAS))
