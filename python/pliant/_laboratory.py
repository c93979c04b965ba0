# SPDX-License-Identifier: MIT
"""The laboratory from outside: its commands and names, or why an installation has none of them.

A wheel may leave out ``pliant.lab`` and what of the library the thesis needs: see
``python/wheel/README.md``.
"""

from __future__ import annotations

import importlib
import sys
from collections.abc import Callable, Sequence
from typing import Any

MISSING = (
    "needs the laboratory, which this installation leaves out: "
    "pip install --force-reinstall --no-deps pliant"
)
#: Names of ``pliant`` that only a library with its laboratory has.
NAMES = (
    "GraphClass",
    "TestClass",
    "TestGraph",
    "TestHeuristic",
    "TestResults",
    "TestSet",
    "generate",
    "graph_classes",
    "read_test_set",
    "write_test_set",
)


def bench(words: Sequence[str] | None = None) -> int:
    """Runs ``pliant bench`` with these words, or those of the command; returns its exit code."""
    return _run("bench", words)


def experiment(words: Sequence[str] | None = None) -> int:
    """Runs ``pliant experiment``, as bench() does."""
    return _run("experiment", words)


def _run(command: str, words: Sequence[str] | None) -> int:
    module = f"pliant.lab.{command}.command"
    try:
        main: Callable[[Sequence[str] | None], int] = importlib.import_module(module).main
    except ModuleNotFoundError as error:
        if not module.startswith(f"{error.name}"):
            raise
        print(f"pliant {command}: error: {MISSING}", file=sys.stderr)
        return 1
    return main(words)


def leave_out(package: dict[str, Any]) -> None:
    """Takes NAMES from what a package offers, given by its globals; asked for, they say why."""

    def missing(name: str) -> Any:
        if name in NAMES:
            raise AttributeError(f"pliant.{name} {MISSING}")
        raise AttributeError(f"module 'pliant' has no attribute '{name}'")

    package["__all__"] = [name for name in package["__all__"] if name not in NAMES]
    package["__getattr__"] = missing
