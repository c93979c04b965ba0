# SPDX-License-Identifier: MIT
"""``pliant ensemble --verify`` finds whatever is not as it was made."""

import json
import shutil

import h5py
import pytest
from ensembles import call, made, shards_of


@pytest.fixture
def copy(ensemble, tmp_path):
    return shutil.copytree(ensemble, tmp_path / "copy")


def problems(folder):
    return made("--verify", folder, code=1)["problems"]


def test_a_whole_ensemble_passes(ensemble):
    found = made("--verify", ensemble)
    assert (found["shards"], found["shards_whole"], found["frames"]) == (6, 6, 24 * 5)
    assert found["problems"] == []


def test_a_flipped_bit_of_a_coordinate(copy):
    path = shards_of(copy)[2]
    with h5py.File(path, "r+") as file:
        file["particles/trajectory/position/value"][7, 100, 1] += 1e-9
    assert [path.name in one for one in problems(copy)] == [True]
    assert "is not what the manifest says: sha256" in problems(copy)[0]


def test_a_shard_cut_short(copy):
    path = shards_of(copy)[0]
    data = path.read_bytes()
    path.write_bytes(data[: len(data) // 2])
    assert len(problems(copy)) == 1
    ended = call("ensemble", "--verify", copy)
    assert path.name in ended.stderr


def test_a_shard_lost_and_one_too_many(copy):
    first, second, *_ = shards_of(copy)
    shutil.copy(second, copy / "shards" / "shard-000000000-000000007.h5md")
    first.unlink()
    lost, stranger = problems(copy)
    assert lost.endswith("is not there: the same command makes it")
    assert stranger.endswith("is no shard of this ensemble: remove it")


def test_a_shard_in_the_place_of_another(copy):
    first, second, *_ = shards_of(copy)
    shutil.copy(second, first)
    again = "the same pliant ensemble command makes it again"
    assert problems(copy) == [f"{first}: expected walkers 0 to 3, found 4 to 7; {again}"]


@pytest.mark.parametrize("change", ["twice", "missing"])
def test_a_frame_twice_or_missing(copy, change):
    path = shards_of(copy)[1]
    with h5py.File(path, "r+") as file:
        steps, walkers = file["particles/trajectory/position/step"], file["observables/walker"]
        if change == "twice":
            steps[3] = steps[2]
        else:
            walkers["value"][5:10] = 4
            steps[:] = range(len(steps))
    assert len(problems(copy)) == 1
    wanted = {
        "twice": "expected each frame once, in order",
        "missing": "1 of 4 walkers are missing",
    }
    assert wanted[change] in problems(copy)[0]


def test_a_manifest_that_is_none(copy):
    with (copy / "shards.jsonl").open("a") as file:
        file.write(json.dumps({"shard": 1}) + "\n")
    ended = call("ensemble", "--verify", copy)
    assert ended.returncode == 1
    assert "shards.jsonl:7: expected the record of a shard" in ended.stderr


def test_no_folder_of_shards(copy):
    shutil.rmtree(copy / "shards")
    assert len(problems(copy)) == 6


def test_no_ensemble(tmp_path):
    ended = call("ensemble", "--verify", tmp_path)
    assert ended.returncode == 1
    assert "expected the folder of an ensemble" in ended.stderr
