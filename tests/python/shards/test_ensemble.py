# SPDX-License-Identifier: MIT
"""Shards of an ensemble: the bits of one process, and each walker once."""

import json
import shutil

import pytest
from ensembles import PEPTIDE, call, made, run_in_one_file, same_bits, same_files, shards_of
from pliant.shards import scratch
from pliant.trajectory.shards.plan import load_plan

RUN = ("--steps", 40, "--every", 10)


def test_shards_have_the_bits_of_one_process(ensemble, tmp_path):
    run_in_one_file(tmp_path / "whole.h5md", 24, steps=40, every=10)
    assert len(shards_of(ensemble)) == 6
    assert same_bits(ensemble, tmp_path / "whole.h5md")


def test_the_same_shards_are_the_same_bytes_wherever_they_are_made(ensemble, tmp_path):
    made(PEPTIDE, "-o", tmp_path / "b", "--walkers", 24, "--shard-size", 4, *RUN, "--workers", 1)
    assert same_files(ensemble, tmp_path / "b")


def test_frames_of_a_sample_are_sharded_too(tmp_path, there):
    result = made(
        PEPTIDE, "-o", tmp_path / "s", "--frames", 25, "--shard-size", 10, "--seed", 3, *there
    )
    assert (result["shards"], result["frames"]) == (3, 25)
    words = ("--frames", 25, "--seed", 3, "-o", tmp_path / "whole.h5md")
    assert call("sample", PEPTIDE, *words).returncode == 0
    names = ("max_residual", "redraws", "max_overlap")
    assert same_bits(tmp_path / "s", tmp_path / "whole.h5md", names=names)
    assert call("ensemble", "--verify", tmp_path / "s").returncode == 0


def test_options_are_in_the_plan_by_their_names(tmp_path):
    """With values that look like options, names and files."""
    (tmp_path / "c.csv").write_text(call("contacts", PEPTIDE, "--csv").stdout)
    words = ("--model", "protein", "--contacts", "c.csv", "--keep", "GOL,SO4", "--mass-weighted")
    words += ("--no-distance-bonds", "--hbond-cutoff", -2, "--tolerance", "1e-7", "--steps", 9)
    where = ("-o", "many", "--walkers", 1, "--slurm-script", "jobs.sh")
    ended = call("ensemble", *where, *words, PEPTIDE, cwd=tmp_path)
    assert ended.returncode == 0, ended.stderr
    plan = load_plan(tmp_path / "many")
    assert plan.options == {
        "model": "protein",
        "contacts": str(tmp_path / "c.csv"),
        "keep": ["GOL", "SO4"],
        "mass_weighted": True,
        "distance_bonds": False,
        "hbond_cutoff": -2.0,
        "tolerance": 1e-7,
        "steps": 9,
    }
    assert set(plan.digests) == {"input", "contacts"}
    assert made("-o", tmp_path / "many", "--shard", 0)["frames"] == 10
    (tmp_path / "c.csv").write_text("")
    ended = call("ensemble", *where, *words, PEPTIDE, cwd=tmp_path)
    assert f"was begun when --contacts {tmp_path}/c.csv had other contents" in ended.stderr


def test_the_same_command_again_makes_nothing_and_needs_no_dask(ensemble, tmp_path):
    folder = tmp_path / "copy"
    shutil.copytree(ensemble, folder)
    words = (PEPTIDE, "-o", folder, "--walkers", 24, *RUN)
    again = made(*words, "--scheduler", "tcp://127.0.0.1:1")  # where there is none
    assert (again["shards_made"], again["shards_found"]) == (0, 6)


def test_what_the_manifest_lost_is_found_by_its_own_check(ensemble, tmp_path, there):
    folder = tmp_path / "copy"
    shutil.copytree(ensemble, folder)
    lines = (folder / "shards.jsonl").read_bytes().splitlines(keepends=True)
    (folder / "shards.jsonl").write_bytes(b"".join(lines[:2]) + lines[2][:30])  # cut by a crash
    shards_of(folder)[-1].unlink()
    (folder / "making").mkdir(exist_ok=True)
    dead = folder / "making" / f"{scratch._name_of(folder)}-worker-1.h5md"
    dead.write_bytes(b"half")
    dead.with_name(f"{dead.name}.lock").touch()
    assert call("ensemble", "--verify", folder).returncode == 1
    result = made(PEPTIDE, "-o", folder, "--walkers", 24, *RUN, *there)
    assert (result["shards_found"], result["shards_made"]) == (5, 1)
    numbers = [json.loads(line)["shard"] for line in (folder / "shards.jsonl").open()]
    assert sorted(set(numbers)) == list(range(6))
    assert not list((folder / "making").iterdir())
    assert same_files(folder, ensemble)


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (("--walkers", 24, "--steps", 50, "--every", 10), "--steps: expected --steps 40"),
        (("--walkers", 24, "--steps", 40), "--every: expected --every 10, found no --every"),
        (("--walkers", 24, *RUN, "--seed", 1), "--seed: expected no --seed, found --seed 1"),
        (("--walkers", 25, *RUN), "--walkers: expected 24, found 25"),
        (("--walkers", 24, *RUN, "--shard-size", 5), "--shard-size: expected 4, found 5"),
        (("--frames", 24), "the command: expected pliant run, found pliant sample"),
        (
            ("--walkers", 24, *RUN, "--keep", "GOL"),
            '--keep: expected no --keep, found --keep ["GOL"]',
        ),
    ],
)
def test_another_option_in_the_same_folder_is_refused(ensemble, words, message):
    ended = call("ensemble", PEPTIDE, "-o", ensemble, *words)
    assert ended.returncode == 2
    assert ended.stderr.count("\n") == 1
    assert f"was begun with another {message}" in ended.stderr


def test_another_content_of_the_input_is_refused(ensemble, tmp_path):
    other = tmp_path / "peptide_20.pdb"
    other.write_bytes(PEPTIDE.read_bytes() + b"REMARK\n")
    ended = call("ensemble", other, "-o", ensemble, "--walkers", 24, *RUN)
    assert ended.returncode == 2
    assert "was begun when input" in ended.stderr


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (("--walkers", 4, "--threads", 2), "--threads: is not passed on to pliant run"),
        (("--walkers", 4, "--dry-run"), "--dry-run: is not passed on to pliant run: try"),
        (("--walkers", 4, "more.pdb"), 'unexpected argument "more.pdb"'),
        (("--walkers", 4, "--frames", 4), "expected --walkers N"),
        ((), "expected --walkers N"),
        (("--walkers", 0), "expected a whole number from 1"),
        (("--walkers", 4, "--stepz", 3), "did you mean --steps?"),
    ],
)
def test_bad_options_are_one_line_and_leave_no_shard(tmp_path, words, message):
    ended = call("ensemble", PEPTIDE, "-o", tmp_path / "d", *words)
    assert ended.returncode == 2, ended.stderr
    assert message in ended.stderr.splitlines()[0]
    assert not shards_of(tmp_path / "d")


def test_a_bad_input_is_reported_in_one_line(tmp_path, there):
    (tmp_path / "bad.pdb").write_text("ATOM\n")
    words = ("-o", tmp_path / "d", "--walkers", 4, "--retries", 0, *there)
    ended = call("ensemble", tmp_path / "bad.pdb", *words)
    assert (ended.returncode, ended.stderr.count("\n")) == (1, 1)
    assert "bad.pdb:1: x (columns 31-38) is blank" in ended.stderr
    # Nothing was made: the folder takes another plan.
    ended = call("ensemble", PEPTIDE, *words, "--steps", 2)
    assert (ended.returncode, " in 1 shard\n" in ended.stdout) == (0, True)


def test_frames_that_are_not_whole_are_counted(tmp_path, there):
    words = ("--walkers", 4, "--steps", 5, "--max-sweeps", 1, "--technique", "bfs_cycle", *there)
    result = made(PEPTIDE, "-o", tmp_path / "d", *words, "--tolerance", "1e-14", code=3)
    assert result["unconverged"] > 0
    assert call("ensemble", "--verify", tmp_path / "d").returncode == 0
