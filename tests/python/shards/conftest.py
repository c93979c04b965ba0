# SPDX-License-Identifier: MIT
"""An ensemble that is whole, and a scheduler for those that tests make."""

import subprocess
import sys

import pytest
from ensembles import PEPTIDE, made

#: It looks after itself seldom: as Dask has it, that takes 8 % of a processor as long as tests run.
CLUSTER = """
import sys
import dask
from distributed import LocalCluster
dask.config.set({"distributed.worker.profile.enabled": False})
seldom = "admin.tick.interval", "admin.system-monitor.interval", "worker.memory.monitor-interval"
for what in seldom:
    dask.config.set({f"distributed.{what}": "5s"})
if __name__ == "__main__":
    one = LocalCluster(n_workers=1, threads_per_worker=2, dashboard_address=":0", silence_logs=50)
    print(one.scheduler_address, flush=True)
    sys.stdin.read()
    one.close()
"""


@pytest.fixture(scope="session")
def there(tmp_path_factory):
    """Words of a command that makes its shards where a scheduler is already, which is quicker."""
    script = tmp_path_factory.mktemp("cluster") / "cluster.py"
    script.write_text(CLUSTER)
    pipes = {"stdin": subprocess.PIPE, "stdout": subprocess.PIPE}
    with subprocess.Popen([sys.executable, script], text=True, **pipes) as cluster:
        yield ("--scheduler", cluster.stdout.readline().strip())
        cluster.stdin.close()


@pytest.fixture(scope="session")
def ensemble(tmp_path_factory):
    """A folder with 24 walkers in 6 shards. Not to be changed."""
    folder = tmp_path_factory.mktemp("ensemble") / "many"
    made(PEPTIDE, "-o", folder, "--walkers", 24, "--shard-size", 4, "--steps", 40, "--every", 10)
    return folder
