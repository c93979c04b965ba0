# SPDX-License-Identifier: MIT
"""Whatever ends ``pliant ensemble``, and when: its exit code; and nothing is left of shards."""

import fcntl
import os
import shutil
import signal
import sys
import time

import pytest
from ensembles import COMMAND, PEPTIDE, heed_hangups, start

#: exit code and what is said
ENDS = {
    "SIGHUP": (129, "ended by SIGHUP"),
    "SIGTERM": (143, "ended by SIGTERM"),
    "SIGUSR1": (75, "ended by SIGUSR1: the same command goes on"),
    "SIGINT": (130, "interrupted"),
}
LONG = ("--walkers", 8, "--steps", 10**6, "--every", 10**5, "--workers", 1)


def at_work(folder, disk):
    """The command, which makes a shard on its scratch disk, and has committed a part of one."""
    before = set(disk.iterdir())
    client = start(PEPTIDE, "-o", folder, *LONG, "--scratch", disk, "--commit-seconds", "0.01")
    while not (
        any(log.stat().st_size > 16 for log in folder.glob("making/*.commits"))
        and any(path.suffix == ".partial" for path in {*disk.iterdir()} - before)
    ):
        assert client.poll() is None
        time.sleep(0.01)
    return client


def expect_end(client, name):
    code, said = ENDS[name]
    _, err = client.communicate(timeout=900)
    assert (client.returncode, err.decode()) == (code, f"pliant ensemble: {said}\n")


@pytest.mark.parametrize(
    "name", ["SIGHUP", *(pytest.param(name, marks=pytest.mark.long) for name in list(ENDS)[1:])]
)
def test_nothing_is_left_on_the_scratch_disk(tmp_path, name):
    disk, folder = tmp_path / "disk", tmp_path / "many"
    disk.mkdir()
    client = at_work(folder, disk)
    assert {path.suffix for path in disk.iterdir()} == {".lock", ".partial"}
    assert not list(folder.glob("making/*.h5md*"))
    client.send_signal(getattr(signal, name))
    expect_end(client, name)
    assert not any(disk.iterdir())
    assert {path.suffix for path in folder.glob("making/*")} == {".commits"}


def test_what_a_killed_command_has_left_goes_with_the_next_start(tmp_path):
    disk, folder = tmp_path / "disk", tmp_path / "many"
    disk.mkdir()
    (disk / "mine.h5md").touch()
    client = at_work(folder, disk)
    client.kill()
    client.communicate()
    (lock,) = disk.glob("*.lock")
    with open(lock, "rb") as file:
        fcntl.flock(file, fcntl.LOCK_EX)  # until its command has committed and ended, too
    client = at_work(folder, disk)
    client.send_signal(signal.SIGTERM)
    expect_end(client, "SIGTERM")
    assert [path.name for path in disk.iterdir()] == ["mine.h5md"]


@pytest.mark.parametrize("name", ENDS)
def test_signals_that_come_before_python_has_started(tmp_path, name):
    """Held back, as the command in C++ does: each is answered, and nothing is begun."""
    number = getattr(signal, name)

    def send():
        heed_hangups()
        signal.pthread_sigmask(signal.SIG_BLOCK, [number])
        os.kill(os.getpid(), number)

    client = start(PEPTIDE, "-o", tmp_path / "many", *LONG, preexec_fn=send)
    expect_end(client, name)
    assert not any(tmp_path.iterdir())


@pytest.mark.skipif(sys.platform != "linux", reason="asks /proc")
def test_the_command_in_cpp_holds_them_back(tmp_path):
    shutil.copy(COMMAND, tmp_path / "pliant")
    (tmp_path / "pliant-ensemble").write_text("#!/bin/sh\nexec grep SigBlk: /proc/self/status\n")
    (tmp_path / "pliant-ensemble").chmod(0o755)
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)}
    client = start("x", command=tmp_path / "pliant", env=environment)
    held = int(client.communicate()[0].split()[1], 16)
    assert all(held >> getattr(signal, name) - 1 & 1 for name in ENDS)


def test_a_signal_that_is_ignored_stays_so(tmp_path):
    """nohup: the end of the terminal is not for this command."""

    def send():
        signal.signal(signal.SIGHUP, signal.SIG_IGN)
        signal.pthread_sigmask(signal.SIG_BLOCK, [signal.SIGTERM])
        os.kill(os.getpid(), signal.SIGHUP)
        os.kill(os.getpid(), signal.SIGTERM)

    expect_end(start(PEPTIDE, "-o", tmp_path / "many", *LONG, preexec_fn=send), "SIGTERM")
