# SPDX-License-Identifier: MIT
"""Commands that take a trajectory take an ensemble, too, or say what to give instead."""

import json

import MDAnalysis
import numpy as np
import pytest
from ensembles import PEPTIDE, call, frames_of, made, shards_of
from pliant.report.representatives import representatives
from pliant.trajectory.opened import one_file

import pliant
from pliant import convert


@pytest.mark.long
@pytest.mark.parametrize("name", ["", "ensemble.pliant"])
def test_all_frames_are_converted(ensemble, tmp_path, name):
    done = convert(ensemble / name, tmp_path / "all.trr")
    positions, steps, times, _ = frames_of(shards_of(ensemble), names=("walker",))
    assert (done.frames, done.atoms) == (len(positions), positions.shape[1])
    read = MDAnalysis.Universe(str(PEPTIDE), str(tmp_path / "all.trr")).trajectory
    assert np.abs([frame.positions.copy() for frame in read] - positions).max() < 4e-6
    assert [frame.data["step"] for frame in read] == steps.tolist()
    assert [frame.time for frame in read] == pytest.approx(times)


def test_a_selection_of_atoms_is_converted(ensemble, tmp_path):
    ended = call("convert", ensemble, "-o", tmp_path / "ca.pdb", "--select", "name CA", "--json")
    assert (json.loads(ended.stdout)["frames"], json.loads(ended.stdout)["atoms"]) == (120, 20)
    assert list(pliant.read(tmp_path / "ca.pdb").names) == 20 * ["CA"]


@pytest.mark.parametrize("name", ["", "ensemble.pliant"])
def test_representatives_of_all_frames(ensemble, tmp_path, name):
    found = representatives(ensemble / name, 3, tmp_path / "three.pdb")
    assert found.compared == 120
    assert found.notes == ("these frames are no independent draws: see pliant sample",)
    assert len(MDAnalysis.Universe(tmp_path / "three.pdb").trajectory) == 3


def test_frames_of_a_sample_are_independent_draws(tmp_path, there):
    made(PEPTIDE, "-o", tmp_path / "s", "--frames", 6, "--shard-size", 3, *there)
    found = representatives(tmp_path / "s", 2)
    assert (found.compared, found.notes) == (6, ())


@pytest.mark.parametrize("name", ["", "ensemble.pliant"])
def test_what_wants_one_file_says_what_to_give(ensemble, tmp_path, name):
    with pytest.raises(pliant.InputError, match="is an ensemble: give one of its shards") as caught:
        one_file(ensemble / name)  # of pliant check, and of OURS of pliant compare
    assert str(ensemble / "shards") in str(caught.value)
