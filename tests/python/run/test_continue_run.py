# SPDX-License-Identifier: MIT
"""pliant.continue_run: the bits of one run in several parts; times of frames."""

import h5py
import numpy as np
import pytest
from h5md_contents import assert_same_runs

import pliant

WATER = pliant.read_text("3\nwater\nO 0 0 0\nH 0.96 0 0\nH -0.24 0.93 0\n", "water.xyz")


@pytest.mark.parametrize("technique", ["auto", "bfs_adapt", "random", "anderson", "shake"])
@pytest.mark.parametrize("perturb", ["force", "force_all", "displacement"])
def test_three_parts_are_the_whole(tmp_path, technique, perturb):
    options = {"technique": technique, "perturb": perturb, "seed": 4, "every": 3}
    pliant.run(WATER, output=tmp_path / "whole.h5md", steps=40, **options)
    pliant.run(WATER, output=tmp_path / "part.h5md", steps=11, **options)
    pliant.continue_run(tmp_path / "part.h5md", 25)
    summary = pliant.continue_run(tmp_path / "part.h5md", 40)
    assert summary.converged
    assert_same_runs(tmp_path / "whole.h5md", tmp_path / "part.h5md")


def test_observers_see_what_is_added(tmp_path):
    pliant.run(WATER, output=tmp_path / "a.h5md", steps=5)
    steps = []
    pliant.continue_run(tmp_path / "a.h5md", 8, observers=[lambda frame: steps.append(frame.step)])
    assert steps[-3:] == [6, 7, 8]


def test_times_are_products_and_no_sums(tmp_path):
    timestep = 0.1
    pliant.run(WATER, output=tmp_path / "a.h5md", steps=1000, timestep=timestep)
    with h5py.File(tmp_path / "a.h5md") as file:
        group = file["particles/trajectory/position"]
        assert np.array_equal(group["time"][:], group["step"][:] * timestep)


def test_what_cannot_go_on_is_reported(tmp_path):
    pliant.run(WATER, output=tmp_path / "a.h5md", steps=5)
    with pytest.raises(pliant.OptionError, match="has 5 steps already"):
        pliant.continue_run(tmp_path / "a.h5md", 3)
    with pliant.H5mdRecorder(tmp_path / "b.h5md", WATER.framework()) as recorder:
        recorder.record(pliant.Frame(0, 0.0, WATER.positions))
    with pytest.raises(pliant.InputError, match="checkpoint"):
        pliant.continue_run(tmp_path / "b.h5md", 3)
