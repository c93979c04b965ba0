# SPDX-License-Identifier: MIT
"""Nothing is lost or counted twice, whoever is killed in the midst of it."""

import contextlib
import signal
import subprocess
import sys
import time

import psutil
import pytest
from ensembles import (
    PEPTIDE,
    call,
    counted,
    kill_workers,
    made,
    run_in_one_file,
    same_bits,
    shards_of,
    start,
    wait_for_shards,
    workers_of,
)

RUN = ("--steps", 300, "--every", 100)
LONG = ("--walkers", 256, "--steps", 3000)
MANY = ("--walkers", 256, "--shard-size", 8, *RUN)


@pytest.fixture(scope="module")
def whole(tmp_path_factory):
    """What one process makes of it."""
    path = tmp_path_factory.mktemp("whole") / "whole.h5md"
    run_in_one_file(path, 256, steps=300, every=100)
    return path


def expect_all(folder, whole, count=32):
    found = made("--verify", folder)
    assert found["shards_whole"] == found["shards"] == count
    assert counted(folder) == count
    assert same_bits(folder, whole)


@pytest.mark.long
def test_workers_killed_at_random(tmp_path, whole):
    folder = tmp_path / "many"
    client = start(PEPTIDE, "-o", folder, *MANY, "--workers", 2)
    assert kill_workers(client, folder, kills=3, first=2, gap=6, seed=1) == 3
    _, err = client.communicate(timeout=900)
    assert client.returncode == 0, err
    expect_all(folder, whole)


@pytest.mark.long
def test_all_workers_killed_while_they_start(tmp_path, whole):
    folder = tmp_path / "many"
    client = start(PEPTIDE, "-o", folder, *MANY, "--workers", 2)
    wait_for_shards(client, folder, 2)
    for _ in range(4):  # those that come in their place, too, before they can do anything
        for worker in workers_of(client):
            with contextlib.suppress(psutil.NoSuchProcess):  # it has ended meanwhile
                worker.kill()
        time.sleep(0.2)
    _, err = client.communicate(timeout=900)
    assert client.returncode == 0, err
    expect_all(folder, whole)


@pytest.mark.parametrize(
    "how", [signal.SIGKILL, pytest.param(signal.SIGINT, marks=pytest.mark.long)]
)
def test_the_same_command_goes_on_after_the_death_of_the_first(tmp_path, whole, how):
    folder = tmp_path / "many"
    client = start(PEPTIDE, "-o", folder, *MANY, "--workers", 1)
    wait_for_shards(client, folder, 3)
    client.send_signal(how)
    _, err = client.communicate(timeout=900)
    before = len(shards_of(folder))
    assert 3 <= before < 32
    if how == signal.SIGINT:
        assert (client.returncode, err) == (130, b"pliant ensemble: interrupted\n")
    result = made(PEPTIDE, "-o", folder, *MANY)
    assert result["shards_found"] >= before
    expect_all(folder, whole)


@pytest.mark.long
@pytest.mark.parametrize("how", [signal.SIGKILL, signal.SIGTERM])
@pytest.mark.parametrize("shards", [0, 2])
def test_nothing_outlives_the_command(tmp_path, how, shards):
    folder = tmp_path / "many"
    client = start(PEPTIDE, "-o", folder, *LONG, "--shard-size", 8, "--workers", 2)
    wait_for_shards(client, folder, shards)
    children = []
    while len(workers_of(client)) < 2 or len(children) < 2 + bool(shards):
        assert client.poll() is None
        time.sleep(0.02)
        children = psutil.Process(client.pid).children(recursive=True)
    client.send_signal(how)
    assert not psutil.wait_procs(children, timeout=900)[1]
    client.communicate(timeout=900)
    assert client.returncode == {signal.SIGKILL: -signal.SIGKILL, signal.SIGTERM: 143}[how]


def test_one_shard_has_one_worker(tmp_path):
    words = ("--walkers", 256, "--shard-size", 256, "--steps", 10**9, "--every", 10**8)
    client = start(PEPTIDE, "-o", tmp_path / "many", *words, "--workers", 60)
    while not list((tmp_path / "many").glob("making/*")) and client.poll() is None:
        time.sleep(0.02)
    assert len(workers_of(client)) == 1
    client.kill()
    client.communicate(timeout=900)


@pytest.mark.long
def test_processes_of_an_analysis_end_with_it():
    """Those that wait for work would do so for ever: they hold both ends of their queue."""
    code = "import time; from pliant.shards.over_shards import each_part; "
    code += "print(list(each_part(time.sleep, [0, 0, 600, 600], 2)))"
    client = subprocess.Popen([sys.executable, "-c", code])
    while len(workers_of(client)) < 2 and client.poll() is None:
        time.sleep(0.02)
    children = psutil.Process(client.pid).children(recursive=True)
    time.sleep(1)  # whether they have begun or not
    client.kill()
    client.wait(900)
    assert not psutil.wait_procs(children, timeout=900)[1]


def test_a_second_command_leaves_the_plan_of_the_first(tmp_path):
    """Also before the first shard is whole."""
    plan = tmp_path / "many" / "ensemble.pliant"
    client = start(PEPTIDE, "-o", tmp_path / "many", *MANY, "--workers", 1)
    while not plan.exists() and client.poll() is None:
        time.sleep(0.02)
    client.send_signal(signal.SIGSTOP)
    before = plan.read_bytes()
    second = call("ensemble", PEPTIDE, "-o", tmp_path / "many", *MANY, "--seed", 7)
    client.kill()
    client.communicate()
    assert second.returncode == 1 and "another pliant ensemble is at work" in second.stderr
    assert plan.read_bytes() == before


@pytest.mark.long
def test_ten_thousand_walkers_and_twenty_kills(tmp_path):
    folder, whole = tmp_path / "many", tmp_path / "whole.h5md"
    run = ("--steps", 100, "--every", 50)
    client = start(PEPTIDE, "-o", folder, "--walkers", 10_000, "--shard-size", 50, *run)
    assert kill_workers(client, folder, kills=20, first=4, gap=9, seed=5) == 20
    _, err = client.communicate(timeout=1200)
    assert client.returncode == 0, err
    run_in_one_file(whole, 10_000, steps=100, every=50)
    expect_all(folder, whole, count=200)
