# SPDX-License-Identifier: MIT
"""What benches find: rows as CSV, all of it as JSON, tables for people."""

from __future__ import annotations

import csv
import math
import os
from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict, fields
from typing import Any

import pliant
from pliant.base import console
from pliant.base.csv_cells import harmless
from pliant.base.new_file import new_text

#: A field of a row, with a format after a colon where it is a number; or what gives a cell.
Cell = str | Callable[[Any], object]


class Results:
    """All that a bench found: a dataclass whose rows are dataclasses of one kind."""

    rows: Sequence[Any]

    @property
    def faults(self) -> Sequence[str]:
        """What must not be: a line each. The command then ends with 1."""
        return ()

    def as_json(self) -> dict[str, Any]:
        """All of it as one JSON object."""
        return {"pliant": pliant.__version__, **asdict(self)}  # type: ignore[call-overload]

    def print_report(self) -> None:
        """Prints what people read."""
        raise NotImplementedError


def write_csv(rows: Sequence[Any], path: str | os.PathLike[str]) -> None:
    """All rows under the names of their fields; what is not known is empty."""
    with new_text(path, overwrite=True) as file:
        writer = csv.writer(file, lineterminator="\n")
        if rows:
            writer.writerow([field.name for field in fields(rows[0])])
        writer.writerows(map(_values, rows))


def _values(row: Any) -> list[object]:
    return [_value(value) for value in asdict(row).values()]


def _value(value: object) -> object:
    if isinstance(value, (list, tuple)):
        return harmless("; ".join(map(str, value)))
    return "" if _is_unknown(value) else harmless(value)


def _is_unknown(value: object) -> bool:
    return value is None or (isinstance(value, float) and not math.isfinite(value))


def text_of(value: object, form: str = "") -> str:
    """A cell: nothing for what is not known."""
    return "" if _is_unknown(value) else format(value, form)


def print_table(rows: Sequence[Any], columns: Mapping[str, Cell]) -> None:
    """A line a row under the names of the columns; nothing where there is no row.

    Columns whose cells are words are left-aligned.
    """
    if not rows:
        return
    cells = [[_cell(row, made) for made in columns.values()] for row in rows]
    words = [k for k, column in enumerate(zip(*cells, strict=True)) if _are_words(column)]
    table = console.Table("", list(columns), text_columns=words)
    table.rows += cells
    table.print()


def _cell(row: Any, made: Cell) -> str:
    if callable(made):
        return text_of(made(row))
    name, _, form = made.partition(":")
    return text_of(getattr(row, name), form)


def _are_words(column: Sequence[str]) -> bool:
    return any(cell[:1].isalpha() for cell in column)
