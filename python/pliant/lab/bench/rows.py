# SPDX-License-Identifier: MIT
"""Rows of a benchmark, dataclasses of one kind, as CSV."""

from __future__ import annotations

import csv
import math
import os
from collections.abc import Sequence
from dataclasses import asdict, fields
from typing import Any

from pliant.base.csv_cells import harmless
from pliant.base.new_file import new_text


def write_csv(rows: Sequence[Any], path: str | os.PathLike[str]) -> None:
    """All rows under the names of their fields; what is not known is empty."""
    with new_text(path, overwrite=True) as file:
        writer = csv.writer(file, lineterminator="\n")
        if rows:
            writer.writerow([field.name for field in fields(rows[0])])
        for row in rows:
            writer.writerow([_cell(value) for value in asdict(row).values()])


def _cell(value: object) -> object:
    if isinstance(value, (list, tuple)):
        return harmless("; ".join(map(str, value)))
    unknown = value is None or (isinstance(value, float) and not math.isfinite(value))
    return "" if unknown else harmless(value)
