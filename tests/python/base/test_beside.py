# SPDX-License-Identifier: MIT
"""Work in a copy of this process: its result comes back, or nothing does."""

import os
import signal
import sys
import threading

import numpy as np
import pytest

from pliant.base import beside

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="forks on Linux only")


@pytest.fixture(autouse=True)
def two_processors(monkeypatch):
    monkeypatch.setattr(beside, "may_fork", lambda: True)
    monkeypatch.setenv("OPENBLAS_NUM_THREADS", "1")


def test_a_result_comes_from_another_process_and_keeps_what_both_have():
    shared = [object(), threading.Lock()]  # a lock cannot be pickled
    with beside.Beside(lambda: (os.getpid(), np.arange(3), shared[1]), shared) as work:
        number, array, lock = work.result()
    assert number != os.getpid()
    assert array.tolist() == [0, 1, 2]
    assert lock is shared[1]


@pytest.mark.parametrize(
    "work",
    [
        lambda: sys.exit("an error"),
        lambda: os.kill(os.getpid(), signal.SIGKILL),
        lambda: threading.Lock(),
    ],
)
def test_nothing_comes_of_what_failed(work):
    with beside.Beside(work) as failed:
        assert failed.result() is None


def test_nothing_is_left_when_nobody_waits():
    with pytest.raises(RuntimeError), beside.Beside(threading.Event().wait) as work:
        child = work._child
        raise RuntimeError
    with pytest.raises(ChildProcessError):
        os.waitpid(child, 0)


def test_no_process_beside_threads_of_numpy(monkeypatch):
    monkeypatch.setenv("OPENBLAS_NUM_THREADS", "2")
    with beside.Beside(os.getpid) as work:
        assert work.result() is None
