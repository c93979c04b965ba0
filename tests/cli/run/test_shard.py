# SPDX-License-Identifier: MIT
"""Shards: an ensemble in parts, which may run on several machines."""

import json

import h5py
import numpy as np
import pytest


@pytest.fixture
def job(pliant, ethanol, tmp_path):
    """Does a job, which stands in a file; what it printed."""

    def run(**asked):
        (tmp_path / "job.json").write_text(json.dumps({"input": str(ethanol), **asked}))
        return pliant("run", "--job", "job.json", "--json")

    return run


def test_a_shard_names_its_files_by_the_numbers_of_its_walkers(job, tmp_path):
    ended = job(output="o.h5md", shard="800..801", steps=2)
    assert ended.code == 0
    assert sorted(path.name for path in tmp_path.glob("o*")) == ["o-800.h5md", "o-801.h5md"]
    assert '"o-800.h5md"' in ended.out
    ended = job(output="p.h5md", shard="7..7", topology="p.pdb", steps=2)
    assert ended.code == 0
    assert sorted(path.name for path in tmp_path.glob("p*")) == ["p-7.h5md", "p.pdb"]


@pytest.mark.parametrize("shard", ["8", "8..", "..8", "9..8", "-1..3", "a..b", "0..1000000"])
def test_what_is_no_shard_is_refused(job, shard):
    ended = job(shard=shard, steps=1)
    assert ended.code == 2
    assert "shard: expected FIRST..LAST" in ended.out


def test_a_shard_and_walkers_exclude_each_other(job):
    ended = job(shard="0..3", walkers=4, steps=1)
    assert ended.code == 2
    assert "shard: is given in place of walkers" in ended.out


def positions_and_walkers(path):
    with h5py.File(path) as file:
        walkers = file["observables/walker/value"][:] if "walker" in file["observables"] else None
        position = file["particles/trajectory/position"]
        return position["value"][:], position["step"][:], walkers


@pytest.mark.parametrize("threads", [1, 3])
def test_one_file_has_all_walkers_one_after_another(job, tmp_path, threads):
    options = {"perturb": "displacement", "steps": 12, "every": 5, "shard": "3..20"}
    assert job(**options, output="o.h5md").code == 0
    ended = job(**options, one_file=True, output="one.h5md", threads=threads)
    assert ended.code == 0, ended.out
    positions, steps, walkers = positions_and_walkers(tmp_path / "one.h5md")
    assert list(walkers) == [walker for walker in range(3, 21) for _ in range(4)]
    for walker in range(3, 21):
        alone = positions_and_walkers(tmp_path / f"o-{walker}.h5md")
        assert np.array_equal(positions[walkers == walker], alone[0])
        assert np.array_equal(steps[walkers == walker], alone[1])
    with h5py.File(tmp_path / "one.h5md") as file:
        run = file["parameters/run"]
        assert (run["walker"][()], run["walkers"][()]) == (3, 18)


def test_one_file_has_the_same_bytes_on_any_number_of_threads(job, tmp_path):
    for threads in (1, 3):
        options = {"walkers": 20, "steps": 9, "output": f"{threads}.h5md", "threads": threads}
        assert job(**options, one_file=True).code == 0
    assert (tmp_path / "1.h5md").read_bytes() == (tmp_path / "3.h5md").read_bytes()


def test_one_file_needs_several_walkers_and_does_not_go_on(pliant, job):
    ended = job(one_file=True, steps=1)
    assert (ended.code, "give walkers or shard" in ended.out) == (2, True)
    assert job(walkers=2, one_file=True, output="x.h5md", steps=2).code == 0
    ended = pliant("run", "--continue", "x.h5md", "--steps", 4)
    assert (ended.code, ended.err.count("\n")) == (1, 1)  # nothing of steps that begin anew
    assert "error: x.h5md: has no checkpoint" in ended.err
