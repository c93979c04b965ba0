# SPDX-License-Identifier: MIT
"""Texts of a molecule or a file name must not become formulas in a spreadsheet."""

import csv
from dataclasses import dataclass

import pytest
from pliant.base.csv_cells import write_csv
from pliant.lab.results import write_csv as write_rows

BAD = ["=1+1", "+cmd", "-x", "@SUM(A1)"]
GOOD = ["", "CA", "A-1", "-1.5", "+2", "1=1"]


@dataclass
class Row:
    name: str
    parts: tuple[str, ...]
    size: float


def rows_of(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.reader(file))


@pytest.mark.parametrize("text", BAD + GOOD)
def test_tables_have_no_formulas(text, tmp_path):
    expected = "'" + text if text in BAD else text
    write_csv(tmp_path / "a.csv", {"atom": [text, "CB"], "change": [-1.5, 2.0]})
    assert rows_of(tmp_path / "a.csv")[1:] == [[expected, "-1.5"], ["CB", "2.0"]]
    write_rows([Row(text, (text, "b"), -1.5)], tmp_path / "b.csv")
    (row,) = rows_of(tmp_path / "b.csv")[1:]
    assert (row[0], row[2]) == (expected, "-1.5")
    assert not row[1].startswith(("=", "+", "-", "@"))
