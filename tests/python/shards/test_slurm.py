# SPDX-License-Identifier: MIT
"""Shards as jobs of a real Slurm on this machine: cancelled, killed, sent back to the queue."""

import contextlib
import os
import signal
import time

import psutil
import pytest
import slurm_machine
from ensembles import PEPTIDE, call, made, same_files, shards_of, start

pytestmark = pytest.mark.long

SHARDS = 6
WORDS = ("--walkers", 24, "--shard-size", 4, "--steps", 20_000, "--every", 1000)
#: bytes of a log with commits of all four walkers
A_COMMIT = 4 * 2 * 24 * 327


@pytest.fixture(scope="module")
def slurm(tmp_path_factory):
    if why := slurm_machine.what_is_missing():
        pytest.skip(f"no Slurm: {why}")
    with slurm_machine.slurm_in(tmp_path_factory.mktemp("slurm")) as there:
        yield there


@pytest.fixture(scope="module")
def whole(tmp_path_factory):
    """What one worker makes, which nobody disturbs."""
    folder = tmp_path_factory.mktemp("whole") / "many"
    made(PEPTIDE, "-o", folder, *WORDS, "--workers", 1)
    return folder


def expect_same_bytes(folder, whole):
    """Once the command that counts what jobs have made has found nothing to make."""
    assert made(PEPTIDE, "-o", folder, *WORDS)["shards_made"] == 0
    found = made("--verify", folder)
    assert found["shards_whole"] == found["shards"] == SHARDS
    assert len(shards_of(folder)) == SHARDS
    assert same_files(folder, whole)


def commands_of(folder):
    """Processes that make a shard of this ensemble, by their numbers in a job array."""
    found = {}
    for process in psutil.process_iter(["cmdline"]):
        with contextlib.suppress(psutil.Error):  # it has ended meanwhile
            files = process.open_files() if "--job" in (process.info["cmdline"] or []) else []
            if any(file.path.startswith(str(folder.parent)) for file in files):
                found[process.environ().get("SLURM_ARRAY_TASK_ID", process.pid)] = process
    return found


def wait_for(what, slurm, seconds=900):
    end = time.monotonic() + seconds
    while not (found := what()):
        assert time.monotonic() < end, slurm.call("scontrol", "show", "jobs")
        time.sleep(0.05)
    return found


def committed(folder):
    """Logs of commits with some of each walker."""
    logs = (folder / "making").glob("*.commits")
    return [log for log in logs if log.exists() and log.stat().st_size > A_COMMIT]


def job_script(tmp_path, slurm, *words):
    folder, script = tmp_path / "many", tmp_path / "jobs.sh"
    words = (*WORDS, "--commit-seconds", "0.1", "--slurm-script", script, *words)
    ended = call("ensemble", PEPTIDE, "-o", folder, *words, env=slurm.environment)
    assert ended.returncode == 0, ended.stderr
    return folder, script


def submit(slurm, script):
    return slurm.submit(script, f"--output={script.parent}/job-%A-%a.txt", "--mem=500")


def test_an_array_cancelled_and_killed(slurm, whole, tmp_path):
    folder, script = job_script(tmp_path, slurm, "--scratch", tmp_path)
    array = submit(slurm, script)
    wait_for(lambda: committed(folder), slurm)
    victims = wait_for(lambda: commands_of(folder), slurm)
    next(iter(victims.values())).kill()  # its job fails
    wait_for(lambda: committed(folder) and commands_of(folder), slurm)
    slurm.call("scancel", array)
    slurm.wait_until_empty()
    assert len(shards_of(folder)) < SHARDS
    assert committed(folder)  # what the next array goes on from
    submit(slurm, script)
    slurm.wait_until_empty()
    expect_same_bytes(folder, whole)
    assert not list((folder / "making").iterdir())


def test_a_signal_before_the_end_sends_jobs_back_to_the_queue(slurm, whole, tmp_path):
    folder, script = job_script(tmp_path, slurm, "--walltime", "20")
    array = submit(slurm, script)
    command = wait_for(lambda: committed(folder) and commands_of(folder).get("0"), slurm)
    shell = command.parent().parent()
    assert "slurm_script" in " ".join(shell.cmdline())
    shell.send_signal(signal.SIGUSR1)  # as --signal=B:USR1@... does
    job = ("scontrol", "show", "job", f"{array}_0")
    wait_for(lambda: "Restarts=1" in slurm.call(*job), slurm)
    slurm.wait_until_empty()
    said = (tmp_path / f"job-{array}-0.txt").read_text()
    assert said.count("ended by SIGUSR1: the same command goes on") == 1
    assert said.splitlines()[-1].startswith("shard ")  # appended by the second start
    expect_same_bytes(folder, whole)


def words_of_dask(folder):
    """Of a command that submits its jobs by Dask."""
    pytest.importorskip("dask_jobqueue")
    settings = folder / "slurm.yaml"
    text = "queue_system: slurm\njobs: 2\ncores: 1\nmemory: 500MB\nwalltime: '01:00:00'\n"
    settings.write_text(f"{text}interface: lo\nlog_directory: {folder}\n")
    return (*WORDS, "--commit-seconds", "0.1", "--cluster", settings)


def test_jobs_of_dask_cancelled_and_killed(slurm, whole, tmp_path):
    folder, words = tmp_path / "many", words_of_dask(tmp_path)
    client = start(PEPTIDE, "-o", folder, *words, env=slurm.environment, cwd=tmp_path)
    try:
        wait_for(lambda: committed(folder), slurm)
        victim = wait_for(lambda: commands_of(folder), slurm)
        next(iter(victim.values())).kill()
        wait_for(lambda: committed(folder) and "RUNNING" in slurm.jobs().values(), slurm)
        running = [number for number, state in slurm.jobs().items() if state == "RUNNING"]
        slurm.call("scancel", running[0])
        _, err = client.communicate(timeout=600)
    finally:
        client.kill()
    assert client.returncode == 0, err
    slurm.wait_until_empty()
    expect_same_bytes(folder, whole)


def test_the_parent_is_killed_and_its_jobs_end(slurm, whole, tmp_path):
    folder, words = tmp_path / "many", words_of_dask(tmp_path)
    client = start(PEPTIDE, "-o", folder, *words, env=slurm.environment, cwd=tmp_path)
    wait_for(lambda: committed(folder), slurm)
    os.kill(client.pid, signal.SIGKILL)
    client.communicate()
    slurm.wait_until_empty()
    made(PEPTIDE, "-o", folder, *words, env=slurm.environment, cwd=tmp_path)
    expect_same_bytes(folder, whole)
