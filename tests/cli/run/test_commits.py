# SPDX-License-Identifier: MIT
"""A run in one file goes on from its last commit, with the bytes of one that nobody disturbed."""

import json
import random
import signal
import subprocess

import commit_logs
import pytest
from commit_logs import commits_in, steps_in, wait_for_commits, words_of_job
from ensembles import PEPTIDE

WALKERS, STEPS = 12, 240
RUN = {"input": PEPTIDE, "shard": f"3..{2 + WALKERS}", "one_file": True, "threads": 1}
RUN |= {"topology": "none", "steps": STEPS, "every": 50, "output": "o.h5md"}
LOG = {"commits": "o.log"}
AT_ONCE = {**LOG, "commit_seconds": 0}


def words_of(more):
    return words_of_job("run", RUN | more)


def ran(folder, more=None, code=0):
    words = words_of(LOG | (more or {}))
    ended = subprocess.run(words, cwd=folder, capture_output=True, text=True, timeout=900)
    assert ended.returncode == code, ended.stderr
    return ended


def stopped(folder, count, how=signal.SIGKILL, more=None):
    return commit_logs.stopped(words_of(AT_ONCE | (more or {})), folder, count, how)


@pytest.fixture(scope="module")
def whole(tmp_path_factory):
    """The bytes that are wanted."""
    folder = tmp_path_factory.mktemp("whole")
    subprocess.run(words_of({}), cwd=folder, check=True, stdout=subprocess.DEVNULL)
    return (folder / "o.h5md").read_bytes()


@pytest.fixture(scope="module")
def log(tmp_path_factory):
    """What a run has left behind that was killed when some walkers were done. Not to be changed."""
    folder = tmp_path_factory.mktemp("log")
    assert stopped(folder, 8 * STEPS + 100) == -signal.SIGKILL
    done = [one for one in commits_in(folder / "o.log") if one.is_done]
    assert 0 < len(done) < WALKERS
    return folder / "o.log"


@pytest.mark.parametrize("seed", [1, pytest.param(2, marks=pytest.mark.long)])
def test_killed_after_any_number_of_commits(tmp_path, whole, seed):
    draw = random.Random(seed)
    for _ in range(6):
        assert stopped(tmp_path, draw.randrange(1, 400)) == -signal.SIGKILL
    before = steps_in(tmp_path / "o.log")
    assert before > 0
    result = json.loads(ran(tmp_path).stdout)
    assert result["steps"] == WALKERS * STEPS - before  # nothing that was committed is done again
    assert (tmp_path / "o.h5md").read_bytes() == whole
    assert not (tmp_path / "o.log").exists()


def test_a_log_that_is_cut_anywhere(tmp_path, whole, log):
    draw = random.Random(3)
    size = log.stat().st_size
    for length in [0, 7, 16, 17, size - 1, *(draw.randrange(size) for _ in range(6))]:
        (tmp_path / "o.log").write_bytes(log.read_bytes()[:length])
        before = steps_in(tmp_path / "o.log")
        result = json.loads(ran(tmp_path).stdout)
        assert result["steps"] == WALKERS * STEPS - before
        assert (tmp_path / "o.h5md").read_bytes() == whole, length
        (tmp_path / "o.h5md").unlink()


@pytest.mark.parametrize("how", [signal.SIGUSR1, signal.SIGTERM, signal.SIGINT])
def test_a_signal_commits_all_that_is_done(tmp_path, whole, how):
    for _ in range(3):
        assert stopped(tmp_path, 300, how) == 130
    before = steps_in(tmp_path / "o.log")
    result = json.loads(ran(tmp_path).stdout)
    assert result["steps"] == WALKERS * STEPS - before
    assert (tmp_path / "o.h5md").read_bytes() == whole


def test_sigusr1_may_come_again(tmp_path):
    words = words_of(AT_ONCE | {"steps": 10**6})
    with subprocess.Popen(words, cwd=tmp_path, stdout=subprocess.DEVNULL) as child:
        wait_for_commits(child, tmp_path / "o.log", 20)
        for number in (signal.SIGUSR1, signal.SIGTERM, signal.SIGUSR1):
            child.send_signal(number)
        assert child.wait() == 130
    assert {one.walker for one in commits_in(tmp_path / "o.log")} == set(range(3, 11))


def test_what_a_walker_has_done_is_kept_while_others_go_on(tmp_path):
    """With contacts one walker follows the other; between their ends nothing is committed here."""
    more = {"model": "protein", "steps": 3000, "every": 1000, "commit_seconds": 1000}
    subprocess.run(
        words_of(more | {"output": "whole.h5md"} | {"commits": "whole.log"}),
        cwd=tmp_path,
        check=True,
        stdout=subprocess.DEVNULL,
    )
    assert stopped(tmp_path, 3, signal.SIGKILL, more) == -signal.SIGKILL
    commits = commits_in(tmp_path / "o.log")
    assert len(commits) >= 3 and all(one.is_done and one.step == 3000 for one in commits)
    result = json.loads(ran(tmp_path, more).stdout)
    assert result["steps"] == 3000 * (WALKERS - len(commits))
    assert (tmp_path / "o.h5md").read_bytes() == (tmp_path / "whole.h5md").read_bytes()


@pytest.mark.long
@pytest.mark.parametrize(
    "more",
    [{"model": "protein", "every": 77}, {"save": "name CA"}, {"precision": 1e-2, "threads": 3}],
)
def test_other_options(tmp_path, more):
    words = words_of(more | {"output": "whole.h5md"})
    subprocess.run(words, cwd=tmp_path, check=True, stdout=subprocess.DEVNULL)
    for count in (3, 200, 500):
        assert stopped(tmp_path, count, signal.SIGKILL, more) == -signal.SIGKILL
    ran(tmp_path, more)
    assert (tmp_path / "o.h5md").read_bytes() == (tmp_path / "whole.h5md").read_bytes()


def test_what_is_no_log_is_refused(tmp_path):
    (tmp_path / "o.log").write_text("something that somebody has written down")
    assert "o.log: is no log of commits" in ran(tmp_path, code=1).stdout
    assert (tmp_path / "o.log").read_text().startswith("something")
