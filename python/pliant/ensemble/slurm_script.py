# SPDX-License-Identifier: MIT
"""A script for a job array of Slurm, whose jobs make the shards without Dask."""

from __future__ import annotations

import os
import shlex
import sys
from pathlib import Path

from pliant.console import counted
from pliant.ensemble.plan import EnsemblePlan

#: Slurm takes up to 1001 jobs in an array unless it is set otherwise (MaxArraySize).
MOST_JOBS = 1000


def slurm_script(plan: EnsemblePlan, folder: Path, words: list[str]) -> str:
    """The script; `words` are the arguments of the command that asked for it."""
    jobs = min(plan.shard_count, MOST_JOBS)
    shards = counted(plan.shard_count, "shard")
    where = shlex.quote(os.path.abspath(folder))
    python = shlex.quote(sys.executable)
    return f"""\
#!/bin/sh
#SBATCH --job-name=pliant
#SBATCH --array=0-{jobs - 1}
#SBATCH --ntasks=1
#SBATCH --cpus-per-task=1
#SBATCH --requeue
# Makes {shards} of {plan.count} {plan.what}. Add what your queue asks for: the
# account, the partition, --time. A job that is repeated makes what is missing only. Once all have
# ended, this counts the shards, and makes those whose job was lost:
#   {shlex.join(["pliant", "ensemble", *words])}
set -e
shard=$SLURM_ARRAY_TASK_ID
while [ "$shard" -lt {plan.shard_count} ]; do
  {python} -m pliant.ensemble.command -o {where} --only "$shard"
  shard=$((shard + {jobs}))
done
"""
