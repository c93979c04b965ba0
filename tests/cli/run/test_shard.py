# SPDX-License-Identifier: MIT
"""Shards: an ensemble in parts, which may run on several machines."""

import h5py
import numpy as np
import pytest


def test_two_shards_are_the_whole(pliant, ethanol, tmp_path):
    options = "--perturb displacement --steps 12 --every 5 --technique shake"
    words = ("run", ethanol, *options.split())
    for folder, shards in (("whole", ["0..11"]), ("parts", ["0..4", "5..11"])):
        (tmp_path / folder).mkdir()
        for shard in shards:
            ended = pliant(*words, "-o", f"{folder}/o.h5md", "--shard", shard)
            assert ended.code == 0, ended.err
    names = sorted(path.name for path in (tmp_path / "whole").iterdir())
    assert names == sorted([f"o-{walker}.h5md" for walker in range(12)] + ["o.pdb"])
    for name in names:
        whole, part = (tmp_path / folder / name for folder in ("whole", "parts"))
        assert whole.read_bytes() == part.read_bytes(), name


def test_a_shard_names_its_files_by_the_numbers_of_its_walkers(pliant, ethanol, tmp_path):
    ended = pliant("run", ethanol, "-o", "o.h5md", "--shard", "800..801", "--steps", 2, "--json")
    assert ended.code == 0
    assert sorted(path.name for path in tmp_path.glob("o*")) == ["o-800.h5md", "o-801.h5md"]
    assert '"o-800.h5md"' in ended.out
    ended = pliant(
        "run", ethanol, "-o", "p.h5md", "--shard", "7..7", "--topology", "p.pdb", "--steps", 2
    )
    assert ended.code == 0
    assert sorted(path.name for path in tmp_path.glob("p*")) == ["p-7.h5md", "p.pdb"]


@pytest.mark.parametrize("shard", ["8", "8..", "..8", "9..8", "-1..3", "a..b", "0..1000000"])
def test_what_is_no_shard_is_refused(pliant, ethanol, shard):
    ended = pliant("run", ethanol, f"--shard={shard}", "--steps", 1)
    assert ended.code == 2
    assert "--shard: expected FIRST..LAST" in ended.err


def test_a_shard_and_walkers_exclude_each_other(pliant, ethanol):
    ended = pliant("run", ethanol, "--shard", "0..3", "--walkers", 4, "--steps", 1)
    assert ended.code == 2
    assert "--shard: is given in place of --walkers" in ended.err


def positions_and_walkers(path):
    with h5py.File(path) as file:
        walkers = file["observables/walker/value"][:] if "walker" in file["observables"] else None
        position = file["particles/trajectory/position"]
        return position["value"][:], position["step"][:], walkers


@pytest.mark.parametrize("threads", [1, 3])
def test_one_file_has_all_walkers_one_after_another(pliant, ethanol, tmp_path, threads):
    words = ("run", ethanol, "--perturb", "displacement", "--steps", 12, "--every", 5)
    assert pliant(*words, "--shard", "3..20", "-o", "o.h5md").code == 0
    whole = ("--shard", "3..20", "--one-file", "-o", "one.h5md", "--threads", threads)
    ended = pliant(*words, *whole)
    assert ended.code == 0, ended.err
    positions, steps, walkers = positions_and_walkers(tmp_path / "one.h5md")
    assert list(walkers) == [walker for walker in range(3, 21) for _ in range(4)]
    for walker in range(3, 21):
        alone = positions_and_walkers(tmp_path / f"o-{walker}.h5md")
        assert np.array_equal(positions[walkers == walker], alone[0])
        assert np.array_equal(steps[walkers == walker], alone[1])
    with h5py.File(tmp_path / "one.h5md") as file:
        run = file["parameters/run"]
        assert (run["walker"][()], run["walkers"][()]) == (3, 18)


def test_one_file_has_the_same_bytes_on_any_number_of_threads(pliant, ethanol, tmp_path):
    words = ("run", ethanol, "--walkers", 20, "--steps", 9, "--one-file")
    for threads in (1, 3):
        assert pliant(*words, "-o", f"{threads}.h5md", "--threads", threads).code == 0
    assert (tmp_path / "1.h5md").read_bytes() == (tmp_path / "3.h5md").read_bytes()


def test_one_file_needs_several_walkers_and_does_not_go_on(pliant, ethanol):
    ended = pliant("run", ethanol, "--one-file", "--steps", 1)
    assert (ended.code, "give --walkers or --shard" in ended.err) == (2, True)
    assert (
        pliant("run", ethanol, "--walkers", 2, "--one-file", "-o", "x.h5md", "--steps", 2).code == 0
    )
    ended = pliant("run", "--continue", "x.h5md", "--steps", 4)
    assert (ended.code, ended.err.count("\n")) == (1, 1)  # nothing of steps that begin anew
    assert "error: x.h5md: has no checkpoint" in ended.err
