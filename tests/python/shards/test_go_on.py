# SPDX-License-Identifier: MIT
"""Shards go on from their last commit: after kills, signals, and when the time is nearly over."""

import contextlib
import random
import shutil
import signal
import subprocess
import sys
import time

import psutil
import pytest
from commit_logs import TRIES, steps_in
from ensembles import COMMAND, PEPTIDE, call, made, same_files, shards_of, start
from pliant.shards.commits import take_log
from pliant.shards.make_shard import Making, make_shard
from pliant.shards.time_limit import OutOfTimeError, deadline_of, parse_walltime
from pliant.trajectory.shards.plan import load_plan

from pliant import OptionError

WORDS = ("--walkers", 16, "--shard-size", 8, "--steps", 3000, "--every", 500)
ALL_STEPS = 16 * 3000
OFTEN = ("--commit-seconds", "0.01")


@pytest.fixture(scope="module")
def whole(tmp_path_factory, there):
    """An ensemble that nobody disturbed."""
    folder = tmp_path_factory.mktemp("whole") / "many"
    made(PEPTIDE, "-o", folder, *WORDS, *there)
    return folder


def plan_of(tmp_path, *words):
    script = ("--slurm-script", tmp_path / "jobs.sh")
    assert call("ensemble", PEPTIDE, "-o", tmp_path / "many", *words, *script).returncode == 0
    return tmp_path / "many"


@pytest.fixture
def planned(tmp_path):
    """The folder of an ensemble without shards."""
    return plan_of(tmp_path, *WORDS)


@pytest.fixture
def endless(tmp_path):
    """Likewise; no shard of it is ever whole, so that a signal meets one at work, however late."""
    return plan_of(tmp_path, "--walkers", 8, "--steps", 10**9, "--every", 10**8)


def committed_steps(folder):
    return sum(steps_in(log) for log in (folder / "making").glob("*.commits"))


def done_steps(folder):
    """Those of whole shards, too."""
    return committed_steps(folder) + 8 * 3000 * len(shards_of(folder))


def commands_below(process):
    """The processes that make shards."""
    try:
        children = psutil.Process(process.pid).children(recursive=True)
        return [child for child in children if "--job" in child.cmdline()]
    except psutil.Error:
        return []


def cpu_seconds(processes):
    """What they have worked, however busy the machine is."""
    try:
        return sum(process.cpu_times().user for process in processes)
    except psutil.Error:
        return 0.0


def wait_for_steps(process, folder, steps):
    while committed_steps(folder) < steps and process.poll() is None:
        time.sleep(0.01)


def only(folder, shard, *words):
    words = [COMMAND, "ensemble", "-o", folder, "--shard", shard, *OFTEN, *words]
    return subprocess.Popen([*map(str, words)], stderr=subprocess.PIPE, text=True)


def test_commands_that_are_killed_are_gone_on_with(tmp_path, whole):
    folder, draw = tmp_path / "many", random.Random(1)
    for _ in range(TRIES):  # anew, if all was done before three were met
        killed = 0
        shutil.rmtree(folder, ignore_errors=True)
        client = start(PEPTIDE, "-o", folder, *WORDS, *OFTEN, "--workers", 1, "--retries", 20)
        while client.poll() is None and killed < 6:
            wait_for_steps(client, folder, committed_steps(folder) + draw.randrange(1, 3000))
            for command in commands_below(client)[:1]:
                with contextlib.suppress(psutil.NoSuchProcess):  # it has ended meanwhile
                    command.kill()
                    killed += 1
        _, err = client.communicate(timeout=900)
        assert client.returncode == 0, err
        if killed >= 3:
            break
    assert killed >= 3
    assert same_files(folder, whole)
    assert not list((folder / "making").iterdir())


def ended(folder, steps, how):
    """Has shard 0 made until there are so many steps, then ended; exit code and what was said."""
    with only(folder, 0) as job:
        wait_for_steps(job, folder, steps)
        commands = commands_below(job)
        job.send_signal(how)
        err = job.stderr.read()
    assert not psutil.wait_procs(commands, timeout=900)[1]
    return job.returncode, err


@pytest.mark.parametrize(
    ("how", "code"),
    [(signal.SIGUSR1, 75), (signal.SIGTERM, 143), (signal.SIGINT, 130), (signal.SIGKILL, -9)],
)
def test_one_shard_is_told_to_end(endless, how, code):
    found, err = ended(endless, 4000, how)
    assert found == code, err
    assert committed_steps(endless) >= 4000
    if how == signal.SIGUSR1:
        assert err == "pliant ensemble: ended by SIGUSR1: the same command goes on\n"


def test_a_shard_that_was_ended_goes_on_to_the_same_files(planned, whole):
    """Also where one was whole before it could be told to end."""
    for how in (signal.SIGUSR1, signal.SIGTERM, signal.SIGINT, signal.SIGKILL):
        ended(planned, committed_steps(planned) + 4000, how)
    for shard in (0, 1):
        with only(planned, shard) as job:
            assert job.wait(900) == 0
    assert same_files(planned, whole)


def test_the_time_is_over_again_and_again(tmp_path, whole):
    """Each start does a part, which is the reason that it ends at all.

    Where too little fits into the time, as on a busy machine, the next start has twice as much.
    """
    folder, done, seconds, code = tmp_path / "many", 0, 4, 75
    words = (PEPTIDE, "-o", folder, *WORDS, *OFTEN, "--workers", 1)
    while code == 75:
        before, time_limit = done, f"{seconds // 60}:{seconds % 60:02}"
        ended = call("ensemble", *words, "--walltime", time_limit)
        code, done = ended.returncode, done_steps(folder)
        if code == 75:
            text = f"--walltime {time_limit} is nearly over: the same command goes on"
            assert ended.stderr.splitlines()[-1] == f"pliant ensemble: {text}"
            assert before <= done <= ALL_STEPS
        if done - before < ALL_STEPS / 8:
            seconds *= 2
    assert code == 0, ended.stderr
    assert same_files(folder, whole)


@pytest.mark.long
@pytest.mark.parametrize("how", [signal.SIGUSR1, signal.SIGTERM])
def test_a_signal_to_the_ensemble_has_its_shards_committed(tmp_path, how):
    folder = tmp_path / "many"
    words = ("--walkers", 16, "--shard-size", 8, "--steps", 100_000, "--every", 20_000)
    client = start(PEPTIDE, "-o", folder, *words, "--commit-seconds", 1000, "--workers", 1)
    while cpu_seconds(commands_below(client)) < 0.3 and client.poll() is None:
        time.sleep(0.01)
    commands = commands_below(client)
    client.send_signal(how)
    client.communicate(timeout=900)
    assert client.returncode == {signal.SIGUSR1: 75, signal.SIGTERM: 143}[how]
    assert not psutil.wait_procs(commands, timeout=900)[1]
    assert shards_of(folder) or committed_steps(folder) > 0
    made(PEPTIDE, "-o", folder, *words)
    made(PEPTIDE, "-o", tmp_path / "whole", *words)
    assert same_files(folder, tmp_path / "whole")


def test_a_time_that_is_over_at_once_is_no_failure(planned):
    """The signal comes before the command listens to it."""
    plan = load_plan(planned)
    with pytest.raises(OutOfTimeError):
        make_shard(plan, plan.shard(0), str(planned), Making(deadline=0.0))


def test_one_of_two_takes_a_log(planned):
    plan = load_plan(planned)
    first = take_log(planned, plan, plan.shard(0))
    first.write_bytes(bytes(100))
    second = take_log(planned, plan, plan.shard(0))
    assert not first.exists() and second.stat().st_size == 100
    assert not take_log(planned, plan, plan.shard(1)).exists()
    plan.options["seed"] = 7
    assert not take_log(planned, plan, plan.shard(0)).exists()


@pytest.mark.parametrize(
    ("text", "seconds"),
    [
        ("90", 5400),
        ("0:04", 4),
        ("12:00:00", 43200),
        ("1-12", 129600),
        ("2-0:30", 174600),
        ("1-02:03:04", 93784),
    ],
)
def test_a_time_is_read_as_slurm_reads_it(text, seconds):
    assert parse_walltime(text) == seconds
    assert deadline_of(text, 100.0) == 100 + seconds - min(60, seconds / 10)


@pytest.mark.parametrize("text", ["", "0", "1h", "-1", "1:2:3:4", "1-", "infinite", "1.5"])
def test_what_is_no_time_is_refused(text):
    with pytest.raises(OptionError, match="expected a time as Slurm takes it"):
        parse_walltime(text)


def test_a_script_with_a_time(tmp_path):
    script = tmp_path / "jobs.sh"
    words = ("--walltime", "6:00:00", "--scratch", "--slurm-script", script)
    assert call("ensemble", PEPTIDE, "-o", tmp_path / "many", *WORDS, *words).returncode == 0
    text = script.read_text()
    for line in ("time=6:00:00", "signal=B:USR1@120", "requeue", "open-mode=append"):
        assert f"#SBATCH --{line}\n" in text
    assert "--scratch '$TMPDIR' --shard \"$shard\" &" in text
    subprocess.run(["sh", "-n", script], check=True)


SBATCH = """\
import os, signal, subprocess, sys
folder = sys.argv[1]
os.environ["PATH"] = folder + ":" + os.environ["PATH"]
os.environ.update(SLURM_ARRAY_TASK_ID="0", SLURM_JOB_ID="17")
os.execvp("sh", ["sh", folder + "/jobs.sh"])
"""


def job_of(folder):
    return [sys.executable, "-c", SBATCH, str(folder.parent)]


def test_the_script_makes_its_shard(planned, whole):
    subprocess.run(job_of(planned), check=True, stdout=subprocess.DEVNULL)
    assert shards_of(planned)[0].read_bytes() == shards_of(whole)[0].read_bytes()


def test_the_script_requeues_its_job(endless):
    """With a stand-in for scontrol, which notes what it is asked for."""
    scontrol = endless.parent / "scontrol"
    scontrol.write_text(f'#!/bin/sh\necho "$@" >> {endless.parent}/asked\n')
    scontrol.chmod(0o755)
    script = endless.parent / "jobs.sh"
    script.write_text(script.read_text().replace("--shard", f"{' '.join(OFTEN)} --shard"))
    for _ in range(2):
        with subprocess.Popen(job_of(endless)) as job:
            wait_for_steps(job, endless, committed_steps(endless) + 4000)
            job.send_signal(signal.SIGUSR1)
            assert job.wait(900) == 75
    assert (endless.parent / "asked").read_text() == 2 * "requeue 17\n"
