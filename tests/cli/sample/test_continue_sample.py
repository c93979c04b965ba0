# SPDX-License-Identifier: MIT
"""pliant sample --continue, and logs of commits: the bits of one sample, after any kill."""

import json
import os
import random
import signal
import subprocess

import numpy as np
import pytest
from commit_logs import commits_in, stopped, words_of_job
from h5md_contents import check_interruptions, contents
from real_files import HEXAPEPTIDE, PEPTIDE

COMMON = ["--amplitude", "0.4", "--topology", "none", "--quiet"]


def test_it_names_the_model_of_the_file(pliant, tmp_path):
    pliant("sample", HEXAPEPTIDE, "-o", "part.h5md", "--frames", 2, "--model", "molecule", *COMMON)
    ended = pliant("sample", "--continue", "part.h5md", "--frames", 3, "--json")
    assert json.loads(ended.out)["model"] == "molecule"
    ended = pliant("sample", "--continue", "part.h5md", "--frames", 4, "--verbose")
    assert "model           molecule: " in ended.out


def test_it_needs_no_other_file_and_says_what_it_added(pliant, tmp_path):
    (tmp_path / "in.pdb").write_bytes(HEXAPEPTIDE.read_bytes())
    pliant("sample", "in.pdb", "-o", "part.h5md", "--frames", 3, *COMMON)
    (tmp_path / "in.pdb").unlink()
    ended = pliant("sample", "--continue", "part.h5md", "--frames", 5, "--seed", 0)
    assert ended.code == 0, ended.err
    assert "frames          2 added by sampler modes; amplitude " in ended.out
    assert os.listdir(tmp_path) == ["part.h5md"]


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["--amplitude", 1], "--amplitude: is 0.4 in the run of o.h5md, not 1; "
                             "a run goes on as it began"),
        (["--sampler", "turns"], "--sampler: is modes in the run of o.h5md, not turns; "
                                 "a run goes on as it began"),
        (["--model", "angles"], "--model: is protein in the run of o.h5md, not angles; "
                                "a run goes on as it began"),
        (["--assembly", 1], "--assembly: is none in the run of o.h5md, not 1; "
                            "a run goes on as it began"),
        (["--frames", 2], "--frames 2: o.h5md has 3 frames already; "
                          "frames are counted from the start of the sample"),
    ],
)  # fmt: skip  # a table: a row a line
def test_what_contradicts_the_file_is_refused(pliant, tmp_path, words, message):
    pliant("sample", HEXAPEPTIDE, "-o", "o.h5md", "--frames", 3, *COMMON)
    before = (tmp_path / "o.h5md").read_bytes()
    ended = pliant("sample", "--continue", "o.h5md", *words)
    assert (ended.code, ended.err) == (2, f"pliant: error: {message}\n")
    assert (tmp_path / "o.h5md").read_bytes() == before


def test_runs_and_samples_are_not_mixed_up(pliant, ethanol):
    pliant("run", ethanol, "-o", "run.h5md", "--steps", 3)
    pliant("sample", HEXAPEPTIDE, "-o", "sample.h5md", "--frames", 2, *COMMON)
    ended = pliant("sample", "--continue", "run.h5md")
    assert (ended.code, ended.err) == (
        1,
        "pliant: error: run.h5md: holds steps of a run: pliant run --continue and continue_run go "
        "on with them\n",
    )
    ended = pliant("run", "--continue", "sample.h5md")
    assert (ended.code, ended.err) == (
        1,
        "pliant: error: sample.h5md: holds frames of a sample: pliant sample --continue and "
        "continue_sample go on with them\n",
    )
    ended = pliant("sample", "--continue", "none.h5md")
    assert (ended.code, ended.err) == (1, "pliant: error: none.h5md: is not there\n")


@pytest.mark.parametrize("command", ["run", "sample"])
def test_what_was_ended_before_its_first_frame_is_named(pliant, tmp_path, command):
    (tmp_path / ".o.h5md.partial").write_bytes(b"as a killed writer leaves it")
    ended = pliant(command, "--continue", "o.h5md")
    assert (ended.code, ended.err) == (
        1,
        "pliant: error: o.h5md: is not there, but .o.h5md.partial is: its writer was ended before "
        "the first frame; begin anew\n",
    )


def test_a_sample_that_is_done_has_nothing_to_do(pliant, tmp_path):
    pliant("sample", HEXAPEPTIDE, "-o", "o.h5md", "--frames", 3, *COMMON)
    before = (tmp_path / "o.h5md").read_bytes()
    ended = pliant("sample", "--continue", "o.h5md")
    assert ended.code == 0
    assert "o.h5md has all of its 3 frames; --frames N goes on up to N in all" in ended.err
    assert (tmp_path / "o.h5md").read_bytes() == before


@pytest.mark.parametrize(
    ("times", "seed"),
    [(8, 1), *(pytest.param(25, seed, marks=pytest.mark.long) for seed in range(10))],
)
def test_interruptions_leave_no_trace(command, tmp_path, times, seed):
    words = ["sample", str(HEXAPEPTIDE), "--frames", "250", "--threads", "1", *COMMON]
    check_interruptions(command, tmp_path, words, 1, times, seed)


def test_redraws_and_contacts_are_recorded(pliant, tmp_path):
    """Counts of contacts by NumPy, from positions and the limits of the file."""
    pliant("sample", HEXAPEPTIDE, "-o", "m.h5md", "--frames", 20, "--amplitude", 1, "--quiet")
    options = (
        "--frames 20 --amplitude 1 --quiet --sampler dilute --contact-energy 9.6 --topology none"
    )
    pliant("sample", HEXAPEPTIDE, "-o", "d.h5md", *options.split())
    for name in ("m.h5md", "d.h5md"):
        found = contents(tmp_path / name)
        held, broken, off, redraws = (
            found[f"observables/{what}/value"]
            for what in ("contacts_held", "contacts_broken", "contacts_off", "redraws")
        )
        groups = found["parameters/limit/group"]
        assert groups.min() >= 0
        count = len(np.unique(groups))
        assert count > 0 and np.array_equal(held + broken + off, np.full(20, count))
        assert redraws.min() >= 0 and redraws.dtype == np.int64
        places = found["particles/trajectory/position/value"]
        ends = places[:, found["connectivity/limits"]]
        lengths = np.linalg.norm(ends[:, :, 1] - ends[:, :, 0], axis=2)
        out = (lengths > found["parameters/limit/most"] + 0.1) | (
            lengths < found["parameters/limit/least"] - 0.1
        )
        wrong = np.array([len(np.unique(groups[row])) for row in out])
        assert (broken == 0).all()  # such a frame is not written
        assert (wrong <= off).all()
        assert (off == 0).all() if name == "m.h5md" else off.max() > 0
        states = found["connectivity/contact_states/value"]
        for k, count in enumerate((held, broken, off)):
            assert np.array_equal((states == k).sum(axis=1), count)
        for c, group in enumerate(dict.fromkeys(groups.tolist())):
            is_out = out[:, groups == group].any(axis=1)
            assert (states[is_out, c] == 2).all()  # what is out of its interval is switched off


FRAMES, FIRST = 400, 20
SAMPLE = {"input": PEPTIDE, "first_frame": FIRST, "frames": FRAMES, "threads": 1}


def words_of(**more):
    return words_of_job("sample", SAMPLE | {"topology": "none"} | more)


@pytest.mark.parametrize("how", [signal.SIGKILL, signal.SIGUSR1])
def test_stopped_after_any_number_of_commits(tmp_path, how):
    draw = random.Random(how)
    words = words_of(output="whole.h5md", commits="whole.log")
    subprocess.run(words, cwd=tmp_path, check=True, stdout=subprocess.DEVNULL)
    words = words_of(output="o.h5md", commits="o.log", commit_seconds=0)
    for _ in range(4):
        assert stopped(words, tmp_path, draw.randrange(1, 60), how) in (-how, 130)
    done = commits_in(tmp_path / "o.log")[-1].step + 1 - FIRST
    assert 0 < done < FRAMES
    words = words_of(output="o.h5md", commits="o.log")
    ended = subprocess.run(words, cwd=tmp_path, capture_output=True, text=True, check=True)
    assert json.loads(ended.stdout)["frames"] == FRAMES - done
    assert (tmp_path / "o.h5md").read_bytes() == (tmp_path / "whole.h5md").read_bytes()
    assert not list(tmp_path.glob("*.log"))
