# SPDX-License-Identifier: MIT
"""Samples that are written to files and go on from them."""

import numpy as np
import pytest
from h5md_contents import assert_same_runs
from real_files import PEPTIDE

import pliant


@pytest.fixture(scope="module")
def peptide():
    return pliant.read(PEPTIDE)


@pytest.mark.parametrize("sampler", ["modes", "dilute"])
def test_three_parts_are_the_whole(peptide, tmp_path, sampler):
    options = {"sampler": sampler, "amplitude": 0.4, "seed": 2**64 - 1}
    whole = pliant.sample(peptide, 9, output=tmp_path / "whole.h5md", **options)
    pliant.sample(peptide, 2, output=tmp_path / "part.h5md", **options)
    pliant.continue_sample(tmp_path / "part.h5md", 5, threads=2)
    summary = pliant.continue_sample(tmp_path / "part.h5md", 9)
    assert (summary.frames, summary.failed) == (4, 0)
    assert 0 <= summary.max_residual < 1e-10
    assert summary.rmsf.shape == (len(peptide.positions),)
    assert_same_runs(tmp_path / "whole.h5md", tmp_path / "part.h5md")
    reader = pliant.H5mdReader(tmp_path / "part.h5md")
    recorded = np.array([reader.positions(k) for k in range(len(reader))])
    assert np.array_equal(recorded, whole.positions)


def test_what_cannot_go_on_is_reported(peptide, tmp_path):
    path = tmp_path / "a.h5md"
    pliant.sample(peptide, 3, amplitude=0.4, output=path)
    with pytest.raises(pliant.OptionError, match=r"frames = 2: .*a\.h5md has 3 frames already"):
        pliant.continue_sample(path, 2)
    with pytest.raises(pliant.OptionError, match="threads = 0: must be from 1"):
        pliant.continue_sample(path, 5, threads=0)
    assert pliant.continue_sample(path).frames == 0
    with pytest.raises(pliant.InputError, match="holds frames of a sample: pliant sample"):
        pliant.continue_run(path, 5)
    pliant.run(peptide, output=tmp_path / "run.h5md", steps=2)
    with pytest.raises(
        pliant.InputError,
        match="holds steps of a run: pliant run --continue and continue_run go on",
    ):
        pliant.continue_sample(tmp_path / "run.h5md")


def test_files_are_not_replaced_unasked(peptide, tmp_path):
    path = tmp_path / "a.h5md"
    path.write_text("mine")
    with pytest.raises(pliant.FileError, match="exists"):
        pliant.sample(peptide, 2, amplitude=0.4, output=path)
    assert path.read_text() == "mine"
    pliant.sample(peptide, 2, amplitude=0.4, output=path, overwrite=True)
    assert len(pliant.H5mdReader(path)) == 2
    with pytest.raises(pliant.OptionError, match=r"expected a name that ends in \.h5md"):
        pliant.sample(peptide, 2, output=tmp_path / "a.dcd")
