# SPDX-License-Identifier: MIT
"""Options of a model: the command and Python's function of the same name make the same frames."""

from pathlib import Path

import h5py
import numpy as np
import pytest
from real_files import PEPTIDE

import pliant as library


@pytest.fixture
def heavy(tmp_path):
    """Nine residues without hydrogens."""
    with PEPTIDE.open() as file:
        rows = [row for row in file if row.startswith("ATOM") and int(row[22:26]) < 10]
    path = tmp_path / "heavy.pdb"
    path.write_text("".join(row for row in rows if row[76:78] != " H") + "END\n")
    return path


@pytest.mark.filterwarnings("ignore")
@pytest.mark.parametrize(
    ("words", "options"),
    [
        ("--all-hydrogens", {"all_hydrogens": True}),
        (
            "--protonate GLU3:GLH --hbond-cutoff -2 --select protein --free-torsions",
            {"protonate": ["GLU3:GLH"], "hbond_cutoff": -2.0, "select": "protein",
             "free_torsions": True},
        ),
        ("--contacts one.csv", {"contacts": "one.csv"}),
    ],
)  # fmt: skip  # a row
def test_frames_are_those_of_the_command(pliant, heavy, tmp_path, monkeypatch, words, options):
    monkeypatch.chdir(tmp_path)
    table = pliant("contacts", heavy, "--csv").out.splitlines(keepends=True)
    Path("one.csv").write_text("".join(table[:2]))
    ended = pliant("sample", heavy, *words.split(), *"--frames 2 -o o.h5md --quiet".split())
    assert ended.code == 0, ended.err
    with h5py.File("o.h5md") as file:
        written = file["particles/trajectory/position/value"][:]
    made = library.sample(heavy, frames=2, **options)
    np.testing.assert_array_equal(made.positions, written)
    plain = library.sample(heavy, frames=2).positions
    assert plain.shape != written.shape or not np.array_equal(plain, written)
    if "contacts" in options:
        assert len(made.model.contacts) == 1
        assert len(library.rigidity(heavy, contacts="one.csv").contacts) == 1
