# SPDX-License-Identifier: MIT
"""What is resolved stays near, on real files: the table of the page on methods holds."""

import re
from pathlib import Path

import numpy as np
import pytest
from nearness import (
    MOLECULES,
    MOST_SWEEPS,
    all_cases,
    cases_of,
    growths,
    large_files,
    largest_growth,
    measure_row,
)

import pliant

FILES = sorted(MOLECULES.iterdir())
PAGE = (Path(__file__).parents[3] / "src" / "pliant" / "resolve" / "README.md").read_text()
MOST_GROWTH = 20.0
ROWS = {row.name: row for row in pliant.techniques()}
#: What the page has of each technique: a row names all that have the same. Rounded up to tenths.
CELLS = {
    name: match[2]
    for match in re.finditer(r"^\| (`.+`)((?: \| \d+\.\d){4} \| [^|]+ \|)$", PAGE, re.MULTILINE)
    for name in re.findall(r"`(\w+)`", match[1])
}
LIMITS = {
    name: np.array([float(cell) for cell in cells.split("|")[1:5]]) for name, cells in CELLS.items()
}
pytestmark = pytest.mark.filterwarnings("ignore::pliant.PliantWarning")


def test_the_page_has_every_technique_and_none_goes_further_than_20() -> None:
    assert set(CELLS) == set(ROWS)
    assert np.max(list(LIMITS.values())) <= MOST_GROWTH


@pytest.mark.parametrize("name", ROWS)
def test_molecules_stay_as_near_as_the_page_says(name: str) -> None:
    for first, kind in ((0, "bonds"), (2, "angles")):
        allowed = LIMITS[name][first : first + 2]
        for case in (case for file in FILES for case in cases_of(file, kind)):
            if ROWS[name].forests_only and not case.framework.graph_facts().is_forest:
                continue
            found = growths(case, name, range(1), max_sweeps=MOST_SWEEPS)
            assert (found <= allowed).all(), (case.name, kind, found)


@pytest.mark.parametrize("name", ["auto", "units"])
def test_proteins_stay_as_near_as_the_page_says(name: str) -> None:
    cases = [case for file in large_files() for case in cases_of(file)]
    if not cases:
        pytest.skip("MDAnalysisTests and Biopython's tests are not installed")
    for case in cases:
        assert largest_growth(case, name, range(1)) <= LIMITS[name].max(), case.name


@pytest.mark.long
@pytest.mark.parametrize("name", ROWS)
def test_the_page_says_what_is_measured(name: str) -> None:
    if len(large_files()) < 3:
        pytest.skip("MDAnalysisTests or Biopython's tests are not installed")
    assert str(measure_row(ROWS[name], all_cases())) == f"| `{name}`{CELLS[name]}"
