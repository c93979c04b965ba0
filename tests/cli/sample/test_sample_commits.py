# SPDX-License-Identifier: MIT
"""A sample goes on from its last commit, with the bytes of one that nobody disturbed."""

import json
import random
import signal
import subprocess

import pytest
from commit_logs import commits_in, stopped, words_of_job
from ensembles import PEPTIDE

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
