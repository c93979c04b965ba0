# SPDX-License-Identifier: MIT
"""A script for a job array of Slurm, whose jobs make the shards without Dask."""

from __future__ import annotations

import os
import shlex
from pathlib import Path

from pliant.base.console import command_path, counted
from pliant.shards.make_shard import Making
from pliant.shards.time_limit import EXIT_AGAIN, parse_walltime
from pliant.trajectory.shards.plan import EnsemblePlan

#: Slurm takes up to 1001 jobs in an array unless it is set otherwise (MaxArraySize).
MOST_JOBS = 1000

#: Seconds before the end at which Slurm sends SIGUSR1; less of a short time. It may come a minute
#: earlier than asked.
SIGNAL_SECONDS = 120


def slurm_script(
    plan: EnsemblePlan, folder: Path, words: list[str], how: Making, walltime: str | None
) -> str:
    """The script; `words` are the arguments of the command that asked for it."""
    jobs = min(plan.shard_count, MOST_JOBS)
    time, early = "", SIGNAL_SECONDS
    if walltime is not None:
        time = f"#SBATCH --time={walltime}\n"
        early = min(early, int(parse_walltime(walltime) / 4))
    return f"""\
#!/bin/sh
#SBATCH --job-name=pliant
#SBATCH --array=0-{jobs - 1}
#SBATCH --ntasks=1
#SBATCH --cpus-per-task=1
#SBATCH --requeue
#SBATCH --open-mode=append
#SBATCH --signal=B:USR1@{early}
{time}{_comment(plan, words, is_timed=walltime is not None)}
shard=$SLURM_ARRAY_TASK_ID
child= again=
trap 'again=1; [ -z "$child" ] || kill -USR1 "$child"' USR1
trap '[ -z "$child" ] || kill -TERM "$child"' TERM
while [ "$shard" -lt {plan.shard_count} ]; do
  {_command(folder, how)} --shard "$shard" &
  child=$!
  wait "$child"
  code=$?
  while [ "$code" -gt 128 ] && kill -0 "$child" 2>/dev/null; do  # a signal ended the wait
    wait "$child"
    code=$?
  done
  child=
  if [ "$code" -eq 0 ]; then
    shard=$((shard + {jobs}))
  elif [ "$code" -eq {EXIT_AGAIN} ]; then
    again=1
  elif [ -z "$again" ]; then
    exit "$code"
  fi
  if [ -n "$again" ] && [ "$shard" -lt {plan.shard_count} ]; then  # the next start goes on
    scontrol requeue "$SLURM_JOB_ID"
    exit {EXIT_AGAIN}
  fi
done
"""


def _comment(plan: EnsemblePlan, words: list[str], *, is_timed: bool) -> str:
    shards = counted(plan.shard_count, "shard")
    asks = "account and the partition" if is_timed else "account, the partition, --time"
    return f"""\
# Makes {shards} of {plan.count} {plan.what}. Add what your queue asks for: the
# {asks}. Before the time is up, and where another job needs the place, a job
# commits what it has done and goes back to the queue; the next start goes on. A job that is
# repeated makes what is missing only. Once all have ended, this counts the shards, and makes those
# whose job was lost:
#   {shlex.join(["pliant", "ensemble", *words])}"""


def _command(folder: Path, how: Making) -> str:
    words = [command_path(), "ensemble", "-o", os.path.abspath(folder)]
    if how.scratch is not None:
        words += ["--scratch", how.scratch]
    if how.commit_seconds is not None:
        words += ["--commit-seconds", str(how.commit_seconds)]
    return shlex.join(words)
