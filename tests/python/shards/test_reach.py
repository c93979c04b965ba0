# SPDX-License-Identifier: MIT
"""Frames that reach further, in shards: those of one sample; flexibility is of those near alone."""

import csv

import numpy as np
import pytest
from ensembles import PEPTIDE, call, frames_of, made, same_bits, shards_of
from pliant.trajectory.shards.plan import EnsemblePlan

REACH = ("--sampler", "reach")
FRAMES, NEAR, SHARD = 300, 100, 75
NAMES = ("sampler", "sweeps", "max_residual")


@pytest.fixture(scope="module")
def reached(tmp_path_factory, there):
    """Shards around the start, of both kinds, and further."""
    folder = tmp_path_factory.mktemp("reach") / "many"
    made(PEPTIDE, "-o", folder, "--frames", FRAMES, "--shard-size", SHARD, *REACH, *there)
    return folder


def test_shards_have_the_bits_of_one_sample(reached, tmp_path):
    whole = tmp_path / "whole.h5md"
    assert call("sample", PEPTIDE, "--frames", FRAMES, *REACH, "-o", whole).returncode == 0
    assert same_bits(reached, whole, names=NAMES)
    drawn_by = frames_of(shards_of(reached), NAMES)[3]
    assert (drawn_by[:NEAR] == 1).all() and (drawn_by[NEAR:] > 1).all()
    assert made("--verify", reached)["frames"] == FRAMES


def test_a_shard_that_is_lost_comes_out_the_same(reached, there):
    path = shards_of(reached)[1]
    before = path.read_bytes()
    path.unlink()
    words = ("--frames", FRAMES, "--shard-size", SHARD, *REACH, *there)
    assert made(PEPTIDE, "-o", reached, *words)["shards_made"] == 1
    assert path.read_bytes() == before


def rmsf(folder, output):
    ended = call("analyse", folder, "-o", output, "--json")
    assert ended.returncode == 0, ended.stderr
    with open(output / "flexibility.csv", newline="") as file:
        return np.array([float(row["rmsf_angstrom"]) for row in csv.DictReader(file)])


def test_flexibility_is_that_of_the_frames_around_the_start(reached, tmp_path, there):
    near = tmp_path / "near"
    made(PEPTIDE, "-o", near, "--frames", NEAR, "--sampler", "modes", *there)
    ours, theirs = rmsf(reached, tmp_path / "a"), rmsf(near, tmp_path / "b")
    assert np.allclose(ours, theirs, rtol=1e-6)
    said = call("analyse", reached, "-o", tmp_path / "c").stdout.splitlines()
    assert said[0] == f"frames          {FRAMES}, independent of each other"
    assert said[1].strip() == f"flexibility is that of the {NEAR} around the start"


@pytest.mark.parametrize(
    ("options", "count", "near"),
    [
        ({}, 1000, 500),
        ({}, 100, 100),
        ({"sampler": "reach"}, 399, 100),
        ({"sampler": "auto"}, 700, 300),
        ({"sampler": "turns"}, 1000, None),
        ({"near_frames": 7}, 1000, 7),
    ],
)
def test_each_shard_knows_how_many_frames_are_near(options, count, near):
    """Half of all, in hundreds: as one sample of all frames has it."""
    plan = EnsemblePlan("sample", "x.pdb", count, 64, options)
    assert plan.job(plan.shard(1), "out.h5md").get("near_frames") == near
