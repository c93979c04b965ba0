# SPDX-License-Identifier: MIT
"""CSV files, in which no spreadsheet takes a cell for a formula."""

from __future__ import annotations

import csv
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from pliant.base.new_file import new_text

MARKS = ("=", "+", "-", "@")
#: cells of a table that are made into numbers and text at once
CELLS_AT_ONCE = 1 << 15


def write_csv(path: Path, columns: Mapping[str, Any]) -> None:
    """Writes columns {header: values of equal length} with a header line, replacing a file."""
    count = max(map(len, columns.values()))
    rows = max(1, CELLS_AT_ONCE // len(columns))
    with new_text(path, overwrite=True) as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(map(harmless, columns))
        for first in range(0, count, rows):
            values = [_cells(column[first : first + rows]) for column in columns.values()]
            writer.writerows(zip(*values, strict=True))


def _cells(column: Any) -> list[Any]:
    """The values of a column; text that a spreadsheet would run is made harmless."""
    if isinstance(column, np.ndarray) and column.dtype.kind in "fiub":
        return list(column.tolist())
    return [harmless(cell) for cell in (column.tolist() if hasattr(column, "tolist") else column)]


def harmless(value: object) -> object:
    """A text that begins with ``= + - @`` gets an apostrophe before it; numbers stay as they are.

    Spreadsheets run such a text as a formula; after an apostrophe it is text.
    """
    if not isinstance(value, str) or not value.startswith(MARKS) or _is_number(value):
        return value
    return "'" + value


def _is_number(text: str) -> bool:
    try:
        float(text)
    except ValueError:
        return False
    return True
