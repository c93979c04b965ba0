# SPDX-License-Identifier: MIT
"""What is resolved stays near, on real files, as the page on methods says."""

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
#: The largest K, rounded up to tenths: bonds, one joint and all; angles, one and all; largest on.
TABLE = {
    "auto units": "1.1 | 2.5 | 2.9 | 14.9 | adk_open.pdb, angles",
    "random bfs_cycle dfs_cycle bfs_reverse dfs_reverse bfs_adapt bfs_random input": (
        "0.7 | 1.5 | 1.0 | 1.6 | 4E43.pdb, angles"
    ),
    "bfs_tree dfs_tree": "0.7 | 1.4 | 0.4 | 0.6 | alanine_dipeptide.pdb, bonds",
    "blocks": "1.1 | 2.5 | 2.6 | 5.9 | 4E43.pdb, angles",
    "anderson": "0.7 | 1.5 | 1.0 | 1.6 | adamantane.mol without H, angles",
    "newton": "0.9 | 2.0 | 1.0 | 12.6 | 1A8O.pdb.gz, angles",
    "shake": "0.9 | 2.1 | 1.4 | 12.6 | 1A8O.pdb.gz, angles",
    "froda": "0.9 | 1.5 | 1.0 | 1.6 | adk_open.pdb, angles",
}
CELLS = {name: cells for names, cells in TABLE.items() for name in names.split()}
LIMITS = {
    name: np.array([float(cell) for cell in cells.split("|")[:4]]) for name, cells in CELLS.items()
}
pytestmark = pytest.mark.filterwarnings("ignore::pliant.PliantWarning")


def test_every_technique_is_measured_and_the_page_has_the_largest() -> None:
    assert set(CELLS) == set(ROWS)
    section = PAGE.split("\n## How near\n")[1].split("\n## ")[0]
    for name, limits in LIMITS.items():
        assert limits.max() <= MOST_GROWTH
        assert "tree" in name or str(limits[2:].max()) in section, name


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
    assert str(measure_row(ROWS[name], all_cases())) == f"| `{name}` | {CELLS[name]} |"
