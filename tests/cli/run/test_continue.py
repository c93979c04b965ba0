# SPDX-License-Identifier: MIT
"""pliant run --continue: the bits of one run, after its end, Ctrl-C and any kill."""

import h5py
import pytest
from h5md_contents import assert_same_runs, check_interruptions


@pytest.mark.parametrize("options", [[], ["--every", 7], ["--precision", 0.01]])
def test_two_parts_are_the_whole(pliant, ethanol, tmp_path, options):
    pliant("run", ethanol, "-o", "whole.h5md", "--steps", 50, *options)
    pliant("run", ethanol, "-o", "part.h5md", "--steps", 25, *options)
    ended = pliant("run", "--continue", "part.h5md", "--steps", 50)
    assert (ended.code, ended.err) == (0, "")
    assert_same_runs(tmp_path / "whole.h5md", tmp_path / "part.h5md")


def test_a_replay_and_an_ordering_need_no_other_file(pliant, ethanol, tmp_path):
    pliant("run", ethanol, "-o", "a.h5md", "--steps", 12, "--record-forces", "forces.txt")
    pliant("lab", "order", ethanol, "-o", "order.txt")
    words = ["run", ethanol, "--forces", "forces.txt", "--ordering", "order.txt"]
    assert pliant(*words, "-o", "whole.h5md").code == 0
    pliant(*words, "-o", "part.h5md", "--steps", 5)
    for name in ("forces.txt", "order.txt"):
        (tmp_path / name).unlink()
    assert pliant("run", "--continue", "part.h5md", "--steps", 12).code == 0
    assert_same_runs(tmp_path / "whole.h5md", tmp_path / "part.h5md")


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["--seed", 5], "--seed: is 0 in the run of o.h5md, not 5; a run goes on as it began"),
        (["--technique", "shake"], "--technique: is auto in the run of o.h5md, not shake; "
                                   "a run goes on as it began"),
        (["--overwrite"], "--overwrite: does not go with --continue, which adds to o.h5md"),
        (["--steps", 3], "--steps 3: o.h5md has 5 steps already; "
                         "steps are counted from the start of the run"),
        (["other.xyz"], "FILE: is ethanol.xyz in the run of o.h5md, not other.xyz; "
                        "a run goes on as it began"),
        (["-o", "p.h5md"], "--output p.h5md: --continue adds to o.h5md itself"),
    ],
)  # fmt: skip  # a table: a row a line
def test_what_contradicts_the_file_is_refused(pliant, ethanol, tmp_path, words, message):
    pliant("run", ethanol, "-o", "o.h5md", "--steps", 5)
    before = (tmp_path / "o.h5md").read_bytes()
    ended = pliant("run", "--continue", "o.h5md", *words)
    assert (ended.code, ended.err) == (2, f"pliant: error: {message}\n")
    assert (tmp_path / "o.h5md").read_bytes() == before


def test_a_file_without_a_checkpoint_is_reported(pliant, ethanol, tmp_path):
    pliant("run", ethanol, "-o", "o.h5md", "--steps", 5)
    with h5py.File(tmp_path / "o.h5md", "r+") as file:
        del file["parameters/checkpoint"]
    ended = pliant("run", "--continue", "o.h5md", "--steps", 9)
    assert ended.code == 1
    assert ended.err == (
        "pliant: error: o.h5md: has no checkpoint, so that its run cannot go on: it was written "
        "by another program, or not by a run\n"
    )


def test_a_run_that_is_done_has_nothing_to_do(pliant, ethanol, tmp_path):
    pliant("run", ethanol, "-o", "o.h5md", "--steps", 5)
    before = (tmp_path / "o.h5md").read_bytes()
    ended = pliant("run", "--continue", "o.h5md")
    assert ended.code == 0
    assert "o.h5md has all of its 5 steps" in ended.err
    assert (tmp_path / "o.h5md").read_bytes() == before


@pytest.mark.parametrize(
    ("times", "seed"),
    [(10, 1), *(pytest.param(25, seed, marks=pytest.mark.long) for seed in range(20))],
)
def test_interruptions_leave_no_trace(command, ethanol, tmp_path, times, seed):
    words = ["run", ethanol.name, *"--steps 40000 --every 3 --topology none --quiet".split()]
    check_interruptions(command, tmp_path, words, 3, times, seed)
