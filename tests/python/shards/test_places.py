# SPDX-License-Identifier: MIT
"""Where shards are made: a scheduler that is there, jobs of a queue, a job array without Dask."""

import importlib.util
import os
import re
import subprocess
import time

import pytest
from ensembles import PEPTIDE, call, made, same_files
from forked import HEAVY, ended_code

WORDS = ("--walkers", 24, "--shard-size", 4, "--steps", 40, "--every", 10)


def test_a_scheduler_that_is_there(ensemble, tmp_path, there):
    made(PEPTIDE, "-o", tmp_path / "many", *WORDS, *there)
    assert same_files(tmp_path / "many", ensemble)


def test_no_worker_is_reported_once(capfd, monkeypatch):
    from distributed import LocalCluster
    from pliant.shards import cluster as places

    is_lonely, looks = places._is_lonely, []
    monkeypatch.setattr(places, "_REGROW_SECONDS", 0.1)
    monkeypatch.setattr(places, "_IDLE_SECONDS", 0.3)
    monkeypatch.setattr(places, "_is_lonely", lambda one: looks.append(one) or is_lonely(one))
    with (
        LocalCluster(n_workers=0, dashboard_address=None) as cluster,
        places.open_place(None, cluster.scheduler_address, None, 1),
    ):
        while len(looks) < 12:
            time.sleep(0.02)
    lines = [line for line in capfd.readouterr().err.splitlines() if "no worker for" in line]
    assert len(lines) == 1
    assert "jobs wait in their queue, or end before they begin" in lines[0]


@pytest.mark.parametrize("is_drawn", [False, True])
def test_the_dashboard_is_reported_where_something_draws_it(is_drawn, tmp_path):
    env = None
    if is_drawn:  # enough for Dask to look for it, and to say what is missing
        (tmp_path / "bokeh.py").write_text("__version__ = '0'\n")
        path = os.pathsep.join([str(tmp_path), os.environ.get("PYTHONPATH", "")])
        env = {**os.environ, "PYTHONPATH": path}
    ended = call("ensemble", PEPTIDE, "-o", tmp_path / "many", *WORDS, "--workers", 1, env=env)
    assert ended.returncode == 0, ended.stderr
    lines = re.findall(r"note: Dask's dashboard: http://127\.0\.0\.1:\d+/status\n", ended.stderr)
    if is_drawn or importlib.util.find_spec("bokeh") is None:
        assert len(lines) == is_drawn


def test_a_scheduler_that_is_not_there(tmp_path):
    words = [str(PEPTIDE), "-o", "many", *map(str, WORDS), "--scheduler", "tcp://127.0.0.1:1"]
    code = "from pliant.shards import cluster, command\ncluster._ANSWER_SECONDS = 0.5\n"
    ended = ended_code(f"{code}raise SystemExit(command.main({words!r}))", *HEAVY, cwd=tmp_path)
    assert (ended.returncode, ended.stderr.count("\n")) == (2, 1)
    assert "--scheduler tcp://127.0.0.1:1: " in ended.stderr


def test_a_scheduler_without_a_port(tmp_path):
    ended = call("ensemble", PEPTIDE, "-o", tmp_path / "many", *WORDS, "--scheduler", "foo")
    assert (ended.returncode, ended.stderr.count("\n")) == (2, 1)
    assert "--scheduler foo: " in ended.stderr


def test_two_places_are_refused(tmp_path):
    words = ("--scheduler", "tcp://127.0.0.1:1", "--cluster", "slurm.yaml")
    ended = call("ensemble", PEPTIDE, "-o", tmp_path / "many", *WORDS, *words)
    assert (ended.returncode, ended.stderr.count("\n")) == (2, 1)
    assert "--scheduler: does not go with --cluster: expected one place" in ended.stderr
    assert not (tmp_path / "many").exists()


@pytest.mark.parametrize("form", ["{} {}", "{}={}"])
def test_the_script_names_the_command_without_itself(tmp_path, form):
    folder, script = tmp_path / "many", tmp_path / "jobs.sh"
    words = form.format("--slurm-script", script).split()
    ended = call("ensemble", PEPTIDE, "-o", folder, *WORDS, *words)
    assert ended.returncode == 0, ended.stderr
    again = next(line for line in script.read_text().splitlines() if "pliant ensemble" in line)
    assert "slurm-script" not in again and again.endswith("--steps 40 --every 10")


@pytest.mark.parametrize(
    ("words", "code", "message"),
    [
        (("--modle", "protein"), 2, "did you mean --model?"),
        (("--model", "protein", "--contacts", "none.csv"), 1, "none.csv: "),
        (("--slurm-script", "no/jobs.sh"), 1, "no/jobs.sh: No such file or directory"),
    ],
)
def test_a_script_whose_jobs_would_fail_is_not_written(tmp_path, words, code, message):
    script = tmp_path / "jobs.sh"
    words = ["--walkers", 4, "--slurm-script", script, *words]
    ended = call("ensemble", PEPTIDE, "-o", tmp_path / "many", *words, cwd=tmp_path)
    assert (ended.returncode, ended.stderr.count("\n")) == (code, 1), ended.stderr
    assert message in ended.stderr
    assert not script.exists() and not (tmp_path / "many" / "ensemble.pliant").exists()


def test_a_plan_binds_before_its_first_shard(tmp_path):
    """Jobs of a queue may be waiting to make its shards."""
    words = (PEPTIDE, "-o", tmp_path / "many", *WORDS, "--slurm-script", tmp_path / "jobs.sh")
    assert call("ensemble", *words).returncode == 0
    plan = (tmp_path / "many" / "ensemble.pliant").read_bytes()
    ended = call("ensemble", *words, "--seed", 7)
    assert ended.returncode == 2
    assert "found --seed 7; no shard is made yet: remove the folder to begin anew" in ended.stderr
    assert (tmp_path / "many" / "ensemble.pliant").read_bytes() == plan
    assert call("ensemble", *words).returncode == 0


@pytest.mark.long
def test_a_job_array_of_slurm_needs_no_dask(ensemble, tmp_path):
    folder, script = tmp_path / "many", tmp_path / "jobs.sh"
    ended = call("ensemble", PEPTIDE, "-o", folder, *WORDS, "--slurm-script", script)
    assert ended.returncode == 0, ended.stderr
    text = script.read_text()
    assert "#SBATCH --array=0-5\n" in text
    assert text.isascii()
    for job in range(6):
        environment = {**os.environ, "SLURM_ARRAY_TASK_ID": str(job)}
        subprocess.run(["sh", script], env=environment, check=True, capture_output=True)
    assert same_files(folder, ensemble)
    again = made(PEPTIDE, "-o", folder, *WORDS, "--scheduler", "tcp://127.0.0.1:1")
    assert (again["shards_found"], again["shards_made"]) == (6, 0)
    assert call("ensemble", "--verify", folder).returncode == 0


def test_more_shards_than_an_array_has_jobs(tmp_path):
    folder, script = tmp_path / "many", tmp_path / "jobs.sh"
    words = ("--walkers", 2500, "--shard-size", 1, "--slurm-script", script)
    assert call("ensemble", PEPTIDE, "-o", folder, *words).returncode == 0
    text = script.read_text()
    assert "--array=0-999\n" in text
    # Each job takes every 1000th shard: with a program that only tells them.
    tell = re.sub(r"\S+ ensemble -o .*--shard", "echo", text)
    assert "echo" in tell
    for job, shards in ((0, [0, 1000, 2000]), (499, [499, 1499, 2499]), (500, [500, 1500])):
        environment = {"SLURM_ARRAY_TASK_ID": str(job)}
        lines = subprocess.run(
            ["/bin/sh", "-c", tell], env=environment, check=True, capture_output=True, text=True
        ).stdout.split()
        assert [int(number) for number in lines] == shards
