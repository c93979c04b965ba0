# SPDX-License-Identifier: MIT
"""Shards that jobs of a queue make: taken, refused, and ended with the command."""

import importlib.util
import os
import signal
import stat

import psutil
import pytest
from ensembles import PEPTIDE, call, made, same_files, shards_of, start, wait_for_shards
from pliant.shards.queue_jobs import Queue

# Not by importing it: that would change what SIGINT does in all tests that follow.
if importlib.util.find_spec("dask_jobqueue") is None:
    pytest.skip("dask-jobqueue is not installed", allow_module_level=True)

WORDS = ("--walkers", 24, "--shard-size", 4, "--steps", 40, "--every", 10)

# A queue of Slurm as far as dask-jobqueue sees it: jobs begin at once, on this machine. The script
# is copied, as Slurm does: dask-jobqueue removes it as soon as it is submitted.
SBATCH = """#!/bin/sh
script=$(mktemp "{folder}/script.XXXXXX") && cp "$1" "$script"
(exec setsid sh "$script" > /dev/null 2>&1) &
echo $! >> "{folder}/jobs"
echo "Submitted batch job $!"
"""
SCANCEL = """#!/bin/sh
kill -- "-$1" 2> /dev/null
exit 0
"""


def with_programs(folder, **texts):
    """An environment in which these programs come before all others."""
    programs = folder / "bin"
    programs.mkdir()
    for name, text in texts.items():
        (programs / name).write_text(text)
        (programs / name).chmod(stat.S_IRWXU)
    return {**os.environ, "PATH": f"{programs}:{os.environ['PATH']}"}


def queue_in(folder):
    return with_programs(
        folder, sbatch=SBATCH.format(folder=folder), scancel=SCANCEL.format(folder=folder)
    )


def jobs_in(folder):
    """The processes of the jobs, as psutil has them, that are there."""
    path = folder / "jobs"
    numbers = [int(word) for word in path.read_text().split()] if path.exists() else []
    return [psutil.Process(number) for number in numbers if psutil.pid_exists(number)]


@pytest.fixture
def settings(tmp_path):
    path = tmp_path / "slurm.yaml"
    path.write_text("queue_system: slurm\njobs: 2\ncores: 1\nmemory: 1GB\n")
    return path


def test_jobs_of_a_queue(ensemble, tmp_path, settings):
    env = queue_in(tmp_path)
    made(PEPTIDE, "-o", tmp_path / "many", *WORDS, "--cluster", settings, env=env, cwd=tmp_path)
    assert len((tmp_path / "jobs").read_text().split()) >= 2
    assert same_files(tmp_path / "many", ensemble)


def test_no_more_jobs_than_shards(tmp_path, settings):
    words = ("--walkers", 4, "--steps", 5, "--workers", 60)
    words += ("--cluster", settings)
    made(PEPTIDE, "-o", tmp_path / "many", *words, env=queue_in(tmp_path), cwd=tmp_path)
    assert len((tmp_path / "jobs").read_text().split()) == 1


REFUSED = "Batch job submission failed: Invalid account"


@pytest.mark.parametrize(
    ("sbatch", "words"),
    [
        (f"echo 'sbatch: error: {REFUSED}' >&2; exit 1", f"error: {REFUSED}"),
        ("echo 'closed for the night'; exit 1", "closed for the night"),
        ("echo 'be welcome'", "be welcome"),  # in which no number of a job is found
        ("exit 7", "ended with 7"),
    ],
)
def test_a_queue_that_takes_no_job_has_the_last_word(tmp_path, settings, sbatch, words):
    environment = with_programs(tmp_path, sbatch=f"#!/bin/sh\n{sbatch}\n")
    ended = call(
        "ensemble", PEPTIDE, "-o", tmp_path / "many", *WORDS, "--cluster", settings, env=environment
    )
    assert ended.stderr == f"pliant ensemble: error: {settings}: sbatch: {words}\n"
    assert ended.returncode == 1
    assert not (tmp_path / "many" / "ensemble.pliant").exists()


def test_a_queue_that_takes_some_jobs(ensemble, tmp_path, settings):
    """The first that comes is taken, all others are refused."""
    refuse = f"{{ echo '{REFUSED}' >&2; exit 1; }}"
    sbatch = f"#!/bin/sh\nmkdir {tmp_path}/first 2> /dev/null || {refuse}\n"
    sbatch += SBATCH.format(folder=tmp_path)
    environment = with_programs(tmp_path, sbatch=sbatch, scancel=SCANCEL)
    words = ["ensemble", PEPTIDE, "-o", tmp_path / "many", *WORDS, "--cluster", settings]
    ended = call(*words, env=environment, cwd=tmp_path)
    assert ended.returncode == 0, ended.stderr
    lines = [line for line in ended.stderr.splitlines() if "note: Dask" not in line]
    assert lines == [f"warning: {settings}: sbatch: {REFUSED}: goes on with 1 job"]
    assert len(shards_of(tmp_path / "many")) == len(shards_of(ensemble))


@pytest.mark.parametrize(
    ("text", "expected"), [("", ":0"), ("scheduler_options: {dashboard_address: ':9'}", ":9")]
)
def test_two_ensembles_need_no_port_in_common(settings, text, expected):
    settings.write_text(settings.read_text() + text)
    assert Queue(str(settings))._scheduler_options() == {"dashboard_address": expected}


@pytest.mark.long
@pytest.mark.parametrize("how", [signal.SIGTERM, signal.SIGKILL])
def test_jobs_end_with_the_command(tmp_path, settings, how):
    words = ("--walkers", 400, "--shard-size", 4, "--steps", 3000, "--cluster", settings)
    client = start(PEPTIDE, "-o", tmp_path / "many", *words, env=queue_in(tmp_path), cwd=tmp_path)
    wait_for_shards(client, tmp_path / "many", 1)
    jobs = jobs_in(tmp_path)
    assert jobs
    client.send_signal(how)
    _, err = client.communicate(timeout=900)
    if how == signal.SIGTERM:
        assert (client.returncode, err) == (143, b"pliant ensemble: ended by SIGTERM\n")
    assert not psutil.wait_procs(jobs, timeout=900)[1]


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("queue_system: bus\n", "queue_system: expected one of slurm, pbs"),
        ("queue_system: slurm\n", "jobs: expected a whole number from 1"),
        ("queue_system: [slurm]\n", "queue_system: expected one of slurm, pbs"),
        (
            "queue_system: slurm\njobs: 2\ncores: 1\n",
            "You must specify how much cores and memory per job you want to use",
        ),
        (
            "queue_system: slurm\njobs: 2\ncores: 1\nmemory: 1GB\nwaltime: 1\n",
            "Got unexpected keyword argument 'waltime'",
        ),
        (
            "queue_system: slurm\njobs: 2\ncores: 1\nmemory: 1GB\n",
            "its program sbatch is not on PATH: run this where jobs are submitted",
        ),
        ("[1, 2]\n", "expected settings"),
        ("a: [\n", "slurm.yaml:2: expected YAML: "),
    ],
)
def test_a_bad_cluster_file(tmp_path, text, message):
    path = tmp_path / "slurm.yaml"
    path.write_text(text)
    # Whether there is a queue on this machine makes no difference.
    words = ["ensemble", PEPTIDE, "-o", tmp_path / "many", *WORDS, "--cluster", path]
    ended = call(*words, env={**os.environ, "PATH": str(tmp_path)})
    assert ended.returncode == 1, ended.stderr
    assert message in ended.stderr and ended.stderr.count("\n") == 1, ended.stderr
    assert not (tmp_path / "many" / "ensemble.pliant").exists()
