# SPDX-License-Identifier: MIT
"""How options of benches are taken: what ``add_argument`` gets, the default in the help."""

from __future__ import annotations

import argparse
from collections.abc import Callable, Mapping, Sequence
from typing import Any

from pliant._core import OptionError
from pliant.base import console

How = Mapping[str, Any]


def flag(text: str) -> How:
    """What is on or off."""
    return {"action": "store_true", "help": text}


def word(
    metavar: str,
    text: str,
    default: str | None = None,
    kind: Callable[[str], Any] = str,
    **more: Any,
) -> How:
    """A word as it is."""
    return _taken(metavar, kind, default, text) | more


def among(choices: Sequence[str], default: str | None, text: str) -> How:
    """One of some words."""
    return _taken(None, str, default, text) | {"choices": choices}


def whole(least: int, default: int | None, text: str, **more: Any) -> How:
    """A whole number."""
    return _taken("N", console.whole_number(least), default, text) | more


def number(default: float, text: str, metavar: str = "X") -> How:
    """A number above 0."""
    return _taken(metavar, console.positive_number, default, text)


def numbers(default: str, text: str, metavar: str = "X,X,...", **more: Any) -> How:
    """Numbers above 0."""
    return _taken(metavar, console.positive_numbers, default, text) | more


def counts(default: str, text: str, **more: Any) -> How:
    """Whole numbers from 1."""
    return _taken("N,...", _counts, default, text) | more


def names(text: str, default: Sequence[str] = (), metavar: str = "NAME,...", **more: Any) -> How:
    """Words between commas."""
    return _taken(metavar, console.words, ",".join(default), text) | more


def _taken(
    metavar: str | None, kind: Callable[[str], Any], default: Any, text: str
) -> dict[str, Any]:
    if default not in (None, ""):
        text += f" (default {default:g})" if isinstance(default, float) else f" (default {default})"
    return {"metavar": metavar, "type": kind, "default": default, "help": text}


def _counts(text: str) -> list[int]:
    words = text.split(",")
    if not all(word.isdigit() and int(word) > 0 for word in words):
        expected = "expected whole numbers from 1 between commas"
        raise argparse.ArgumentTypeError(f"{expected}, found '{text}'")
    return sorted({int(word) for word in words})


BARS = among(("bonds", "angles"), "bonds", "what becomes a bar")
TECHNIQUES = names("techniques (see pliant lab techniques; default: all)", dest="techniques")
TOLERANCE = number(1e-6, "relative tolerance", "T")
DISPLACEMENT = number(0.1, "standard deviation of each coordinate, Angstrom", "A")
PAIRS = word(
    "FOLDER", "folder of subfolders with two structures each", required=True, dest="folder"
)
WORKERS = whole(1, 1, "processes that share the work", dest="processes")


def chosen(rows: Sequence[Any], asked: Sequence[str]) -> list[Any]:
    """The rows with these names, all if none is asked for. Raises OptionError for another name."""
    known = {row.name: row for row in rows}
    for name in asked:
        if name not in known:
            raise OptionError(f"--only {name}: must be one of {', '.join(known)}")
    return [row for name, row in known.items() if not asked or name in asked]
