# SPDX-License-Identifier: MIT
"""Systems without chains: MDAnalysis calls their one segment SYSTEM, which is no chain."""

import csv
import warnings

import pytest
from pliant.trajectory.chains import chain_of

import pliant

mda = pytest.importorskip("MDAnalysis")
pytest.importorskip("MDAnalysisTests")


def test_chains_are_what_segments_mean():
    assert [chain_of(name) for name in ("SYSTEM", "", "A", "4AKE")] == ["", "", "A", "4AKE"]


@pytest.fixture(scope="module")
def chainless():
    """The first residues of a protein in a GRO file, which has no chains."""
    from MDAnalysisTests.datafiles import GRO

    group = mda.Universe(GRO).select_atoms("protein and resid 1-6")
    assert set(group.segids) == {"SYSTEM"}
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return pliant.from_mdanalysis(group)


def test_no_chain_comes_over(chainless):
    assert set(chainless.chains) == {""}
    assert chainless.label(1).startswith("MET1:")


def test_no_table_names_it(chainless, tmp_path, no_drawing):
    path = tmp_path / "run.h5md"
    pliant.run(chainless, output=path, steps=5, perturb="displacement", displacement=0.05)
    pliant.analyse(path, tmp_path / "out", dpi=50)
    for table in ("atoms", "residues"):
        with (tmp_path / "out" / f"{table}.csv").open() as file:
            assert {row["chain"] for row in csv.DictReader(file)} == {""}
    for written in (tmp_path / "out").glob("*.csv"):
        assert "SYSTEM" not in written.read_text()
    assert ">SYSTEM" not in (tmp_path / "out" / "report.html").read_text()
