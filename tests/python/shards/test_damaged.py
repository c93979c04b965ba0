# SPDX-License-Identifier: MIT
"""An ensemble that is not as it was made, and `--verify`, which finds that.

Whatever reads it names it, and the same command makes it again, with the same bytes.
"""

import json
import re
import shutil

import h5py
import MDAnalysis
import pliant.mdanalysis
import pytest
from ensembles import PEPTIDE, call, made, same_files, shards_of
from pliant.trajectory.opened import frames_of
from pliant.trajectory.shards import inspect_shard
from pliant.trajectory.shards.inspect_shard import check_shard

WORDS = ("--walkers", 24, "--shard-size", 4, "--steps", 40, "--every", 10)
AGAIN = "the same pliant ensemble command makes it again"


@pytest.fixture
def copy(ensemble, tmp_path):
    return shutil.copytree(ensemble, tmp_path / "copy")


def swap(folder):
    """Puts the third shard in the place of the second: walkers 4 to 7 are 8 to 11."""
    _, second, third, *_ = shards_of(folder)
    shutil.copy(third, second)
    return second, f"{second}: expected walkers 4 to 7, found 8 to 11"


def flip(folder):
    """Flips the lowest bit of a coordinate in the middle of a shard."""
    path = shards_of(folder)[1]
    data = bytearray(path.read_bytes())
    data[len(data) // 2] ^= 1
    path.write_bytes(data)
    return path, f"{path}: is not what the manifest says: sha256"


def cut(folder):
    path = shards_of(folder)[1]
    path.write_bytes(path.read_bytes()[:-4096])
    return path, f"{path}: "


DAMAGE = pytest.mark.parametrize("damage", [swap, flip, cut])


@DAMAGE
@pytest.mark.parametrize(
    ("command", "output", "words"),
    [("analyse", "r", ()), ("convert", "all.dcd", ()), ("convert", "k.pdb", ("-k", 3))],
)
def test_what_reads_an_ensemble_names_it(copy, tmp_path, damage, command, output, words):
    _, why = damage(copy)
    ended = call(command, copy, "-o", tmp_path / output, *words)
    assert ended.returncode == 1
    assert ended.stderr.startswith(f"pliant {command}: error: {why}"), ended.stderr
    assert ended.stderr.endswith(f"; {AGAIN}\n") and ended.stderr.count("\n") == 1
    assert not (tmp_path / output).exists()


@pytest.mark.parametrize("workers", [1, 2])
def test_a_flipped_bit_is_found_with_any_number_of_processes(copy, tmp_path, workers):
    _, why = flip(copy)
    ended = call("analyse", copy, "-o", tmp_path / "r", "--workers", workers)
    assert (ended.returncode, ended.stderr) == (1, f"pliant analyse: error: {why}; {AGAIN}\n")


@DAMAGE
def test_mdanalysis_gets_no_frame_of_it(copy, damage):
    path, why = damage(copy)
    universe = MDAnalysis.Universe(copy / "ensemble.pliant")
    assert universe.trajectory[19].data["walker"] == 3
    with pytest.raises(pliant.InputError, match=f"^{re.escape(why)}"):
        universe.trajectory[20]
    assert universe.trajectory[40].data["walker"] == 8
    with pytest.raises(pliant.InputError, match=re.escape(path.name)):
        frames_of(copy).positions(20)


@DAMAGE
def test_the_same_command_makes_it_again(ensemble, copy, damage, there):
    path, why = damage(copy)
    ended = call("ensemble", PEPTIDE, "-o", copy, *WORDS, *there, "--json")
    assert ended.returncode == 0, ended.stderr
    assert ended.stderr.startswith(f"warning: {why}")
    assert ended.stderr.endswith(": it is made again\n") and ended.stderr.count("\n") == 1
    result = json.loads(ended.stdout)
    assert (result["shards_found"], result["shards_made"]) == (5, 1)
    assert path.read_bytes() == (ensemble / "shards" / path.name).read_bytes()
    assert call("ensemble", "--verify", copy).returncode == 0


def test_two_shards_that_changed_places_are_both_made_again(ensemble, copy, there):
    _, second, third, *_ = shards_of(copy)
    kept = second.read_bytes()
    third.replace(second)
    third.write_bytes(kept)
    (copy / "shards.jsonl").unlink()  # without which only the walkers in the files tell
    result = made(PEPTIDE, "-o", copy, *WORDS, *there)
    assert (result["shards_found"], result["shards_made"]) == (4, 2)
    assert same_files(copy, ensemble)


def test_a_shard_of_another_seed_is_no_shard_of_this_ensemble(copy, tmp_path, there):
    other = tmp_path / "other"
    made(PEPTIDE, "-o", other, *WORDS, "--seed", 7, *there)
    path = shards_of(copy)[1]
    shutil.copy(shards_of(other)[1], path)
    (copy / "shards.jsonl").unlink()
    ended = call("ensemble", PEPTIDE, "-o", copy, *WORDS, *there)
    assert ended.stderr == f"warning: {path}: expected --seed 0, found 7: it is made again\n"


def test_a_job_of_an_array_replaces_a_damaged_shard(ensemble, copy):
    path, why = swap(copy)
    ended = call("ensemble", "-o", copy, "--shard", 1)
    assert (ended.returncode, ended.stderr) == (0, f"warning: {why}: it is made again\n")
    assert path.read_bytes() == (ensemble / "shards" / path.name).read_bytes()


def test_one_shard_too_many(copy, tmp_path):
    stranger = copy / "shards" / "shard-000000000-000000007.h5md"
    shutil.copy(shards_of(copy)[1], stranger)
    why = f"{stranger}: is no shard of this ensemble: remove it"
    ended = call("analyse", copy, "-o", tmp_path / "r")
    assert (ended.returncode, ended.stderr) == (1, f"pliant analyse: error: {why}\n")
    ended = call("ensemble", PEPTIDE, "-o", copy, *WORDS)
    assert (ended.returncode, ended.stderr) == (0, f"warning: {why}\n")


def lines_of(folder):
    return [json.loads(line) for line in (folder / "shards.jsonl").open()]


def write_lines(folder, lines):
    (folder / "shards.jsonl").write_text("".join(json.dumps(line) + "\n" for line in lines))


def test_a_manifest_without_sums_is_read(copy):
    """Its fields, in its order."""
    numbers = ["frames", "left_out", "unconverged", "bytes"]
    fields = ["shard", "first", "last", "file", *numbers, "sha256"]
    write_lines(copy, [{name: line[name] for name in fields} for line in lines_of(copy)])
    assert made("--verify", copy)["shards_whole"] == 6


@pytest.mark.parametrize("damage", [None, swap])
def test_without_checksums_the_walkers_and_sizes_tell(copy, tmp_path, damage):
    write_lines(copy, [{k: v for k, v in line.items() if k != "sha256"} for line in lines_of(copy)])
    why = f"pliant analyse: error: {damage(copy)[1]}; {AGAIN}\n" if damage else ""
    ended = call("analyse", copy, "-o", tmp_path / "r")
    assert (ended.returncode, ended.stderr) == (bool(damage), why)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"shard": 6}, ":7: shard: expected 0 to 5, found 6"),
        ({"first": 4, "last": 7}, ":7: shard 0: expected walkers 0 to 3, found 4 to 7"),
        ({"frames": "20"}, ":7: expected the record of a shard"),
        ({"frames": -1}, ":7: expected the record of a shard"),
        ({"sha256": None}, ":7: expected the record of a shard"),
    ],
)
def test_a_line_of_the_manifest_that_cannot_be(copy, change, message):
    lines = lines_of(copy)
    first = min(lines, key=lambda line: line["shard"])
    write_lines(copy, [*lines, {**first, **change}])
    with pytest.raises(pliant.InputError, match=f"shards.jsonl{message}"):
        frames_of(copy)


def test_another_number_of_frames_than_the_manifest_says(copy):
    lines = lines_of(copy)
    lines[0]["frames"] = 5
    write_lines(copy, lines)
    with pytest.raises(pliant.InputError, match="is not what the manifest says: frames"):
        frames_of(copy).positions(5 * 4 * lines[0]["shard"])


def test_bytes_are_looked_at_once(copy, monkeypatch):
    looks = []

    def check(*what):
        looks.append(what)
        return check_shard(*what)

    monkeypatch.setattr(inspect_shard, "check_shard", check)
    for _ in range(2):
        frames = frames_of(copy)
        for place in range(6):
            frames.numbers(20 * place)
    assert len(looks) == 6


def problems(folder):
    return made("--verify", folder, code=1)["problems"]


def test_a_whole_ensemble_passes(ensemble):
    found = made("--verify", ensemble)
    assert (found["shards"], found["shards_whole"], found["frames"]) == (6, 6, 24 * 5)
    assert found["problems"] == []


@DAMAGE
def test_verify_names_it(copy, damage):
    _, why = damage(copy)
    (said,) = problems(copy)
    assert said.startswith(why)


def test_a_shard_lost_and_one_too_many(copy):
    first, second, *_ = shards_of(copy)
    shutil.copy(second, copy / "shards" / "shard-000000000-000000007.h5md")
    first.unlink()
    lost, stranger = problems(copy)
    assert lost.endswith("is not there: the same command makes it")
    assert stranger.endswith("is no shard of this ensemble: remove it")


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


def test_no_folder_of_shards(copy):
    shutil.rmtree(copy / "shards")
    assert len(problems(copy)) == 6


def test_no_ensemble(tmp_path):
    ended = call("ensemble", "--verify", tmp_path)
    assert ended.returncode == 1
    assert "expected the folder of an ensemble" in ended.stderr
