# SPDX-License-Identifier: MIT
"""The table of the records of a library that failed."""

import pytest

pytest.importorskip("rdkit")
from libraries import library

BROKEN = "broken\n\n\n  1  0\nnot an atom line\n$$$$\n"
FAST = ("--max", 3, "--frames", 20, "--starts", 1)


def test_tables_have_the_numbers_of_the_library_and_old_ones_go(pliant, tmp_path):
    whole = library(2)
    (tmp_path / "library.sdf").write_text(whole + BROKEN + whole)
    for shard in (1, 2):
        pliant("conformers", "library.sdf", "-o", f"{shard}.SDF.gz", *FAST, "--shard", f"{shard}/2")
    assert (tmp_path / "1-failed.csv").read_text() == (
        "number,name,reason\n"
        '3,broken,"line 5: atom 1 of 1: x (columns 1-10) ""not an ato"" is not a finite number"\n'
    )
    assert not (tmp_path / "2-failed.csv").exists()
    (tmp_path / "whole.sdf").write_text(whole)
    pliant("conformers", "whole.sdf", "-o", "1.SDF.gz", *FAST, "--overwrite")
    assert not (tmp_path / "1-failed.csv").exists()
