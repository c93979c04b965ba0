# SPDX-License-Identifier: MIT
"""`pliant check --reference` with a structure that its periodic box cuts."""

import numpy as np
import pytest
from pliant.checks.force_field.minimise import start_of

import pliant

cut_by_box = pytest.importorskip("cut_by_box")


@pytest.fixture
def peptide():
    return pliant.read("data/molecules/peptide_20.pdb")


@pytest.fixture
def cut(peptide, tmp_path):
    def write(**options):
        path = tmp_path / "cut.pdb"
        path.write_text(cut_by_box.cut_pdb(peptide, cut_by_box.BOXES["right"], **options))
        return path

    return write


def test_it_is_made_whole(peptide, cut):
    ends = start_of("none.h5md", peptide, cut())[peptide.bonds]
    assert np.linalg.norm(ends[:, 0] - ends[:, 1], axis=1).max() < 2.5


def test_without_a_cell_it_is_refused(peptide, cut):
    with (
        pytest.warns(pliant.PliantWarning, match="cut by a periodic box"),
        pytest.raises(pliant.InputError, match=r"cut\.pdb: bond A:.* cut by a periodic box; make"),
    ):
        start_of("none.h5md", peptide, cut(with_cell=False))
