# SPDX-License-Identifier: MIT
"""Where the shards are made: processes of this machine, a scheduler of Dask, or jobs of a queue."""

from __future__ import annotations

import contextlib
import importlib
import importlib.util
import logging
import os
import re
import shutil
import threading
from collections.abc import Callable, Iterator
from typing import Any

from pliant._core import InputError, OptionError
from pliant._extras import need
from pliant.console import warn

#: Queues that dask-jobqueue knows, by what a cluster file calls them.
_QUEUES = {
    "slurm": "SLURMCluster",
    "pbs": "PBSCluster",
    "lsf": "LSFCluster",
    "sge": "SGECluster",
    "oar": "OARCluster",
    "moab": "MoabCluster",
    "htcondor": "HTCondorCluster",
}

#: Workers that die with a shard before it is given up: a machine that fails takes many along.
_DEATHS = 20

_REGROW_SECONDS = 5.0

#: Without a worker for so long, the user is told: jobs wait in a queue, or die before they begin.
_IDLE_SECONDS = 60.0

_WHY_NO_WORKER = (
    "jobs wait in their queue, or end before they begin (their logs say why). "
    "Ctrl-C stops; the same command goes on from the shards that are there"
)


def usual_workers() -> int:
    """As many as this process may use cores."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


@contextlib.contextmanager
def open_client(workers: int | None, scheduler: str | None, cluster: str | None) -> Iterator[Any]:
    """A client of Dask. Raises MissingPackageError, OptionError, InputError."""
    need("pliant ensemble", "dask", "distributed")
    import dask

    dask.config.set({"distributed.scheduler.allowed-failures": _DEATHS})
    dask.config.set({"distributed.deploy.lost-worker-timeout": f"{2 * _REGROW_SECONDS:.0f} s"})
    # Lost workers are told by what they did not bring, not by pages of stack traces.
    for name in ("distributed", "distributed.worker", "distributed.nanny"):
        logging.getLogger(name).setLevel(logging.CRITICAL)
    if scheduler:
        with _client_of_scheduler(scheduler) as client, _watched(client, lambda: None):
            yield client
        return
    from distributed import Client

    made, grow = _jobs(cluster, workers) if cluster else _local(workers or usual_workers())
    with made as place, Client(place, set_as_default=False) as client, _watched(client, grow):
        yield client


@contextlib.contextmanager
def _watched(client: Any, grow: Callable[[], None]) -> Iterator[None]:
    """Asks for the full number of workers again and again, and warns where there are none.

    Dask replaces a worker that dies at work, but may give up one that cannot start, as while the
    package is installed anew: with the last of them, everything would wait for ever. A job of a
    queue that dies before it reaches the scheduler looks like one that waits in the queue.
    """
    ended = threading.Event()

    def watch() -> None:
        idle = 0.0
        while not ended.wait(_REGROW_SECONDS):
            grow()
            before, idle = idle, idle + _REGROW_SECONDS if _is_lonely(client) else 0.0
            if before < _IDLE_SECONDS <= idle:
                warn(f"no worker for {idle:.0f} s: {_WHY_NO_WORKER}")

    watcher = threading.Thread(target=watch, daemon=True)
    watcher.start()
    try:
        yield
    finally:
        ended.set()
        watcher.join(timeout=_REGROW_SECONDS)  # of a scheduler that hangs no answer comes


def _is_lonely(client: Any) -> bool:
    try:
        return not client.scheduler_info()["workers"]
    except Exception:  # whatever a lost scheduler raises: the watch goes on
        return False


def dashboard_of(client: Any) -> str | None:
    """Where a browser sees what Dask does; None without Bokeh, which draws it."""
    if importlib.util.find_spec("bokeh") is None:
        return None
    try:
        link: str = client.dashboard_link
        return link
    except (KeyError, OSError):  # a setting for links that names what the environment lacks
        return None


def _client_of_scheduler(address: str) -> Any:
    from distributed import Client
    from distributed.comm.addressing import get_address_host_port

    try:
        get_address_host_port(address, strict=True)  # a client that fails later leaves a trace
        return Client(address, timeout="10s", set_as_default=False)
    except (OSError, ValueError) as error:
        raise OptionError(f"--scheduler {address}: {error}") from None


def _local(workers: int) -> tuple[Any, Callable[[], None]]:
    from distributed import LocalCluster

    cluster = LocalCluster(
        n_workers=workers,
        threads_per_worker=1,
        processes=True,
        memory_limit=0,  # the commands, which need the memory, are no workers
        dashboard_address="127.0.0.1:0",
        silence_logs=logging.CRITICAL,
    )
    return cluster, lambda: cluster.scale(workers)


def _jobs(path: str, jobs: int | None) -> tuple[Any, Callable[[], None]]:
    need("--cluster", "dask_jobqueue")
    settings = _settings(path)
    kind = _queue(path, settings.pop("queue_system", None))
    asked = settings.pop("jobs", None)
    count = asked if jobs is None else jobs
    if not isinstance(count, int) or count < 1:
        raise InputError(f"{path}: jobs: expected a whole number from 1, found {count!r}")
    try:
        cluster = kind(**settings)
    except (TypeError, ValueError) as error:
        raise InputError(f"{path}: {_first_sentence(error)}") from None
    _expect_program(path, kind.job_cls.submit_command)
    cluster.scale(jobs=count)
    return cluster, lambda: cluster.scale(jobs=count)


def _queue(path: str, name: object) -> Any:
    """The class of clusters of that queue."""
    if not isinstance(name, str) or name not in _QUEUES:
        known = ", ".join(_QUEUES)
        raise InputError(f"{path}: queue_system: expected one of {known}, found {name!r}")
    return getattr(importlib.import_module("dask_jobqueue"), _QUEUES[name])


def _first_sentence(error: Exception) -> str:
    """Without the example in Python that dask-jobqueue adds for its own users."""
    return re.split(r"\. Very likely|, for example:|\n", str(error))[0]


def _expect_program(path: str, submit: str) -> None:
    program = submit.split()[0]
    if shutil.which(program) is None:
        raise InputError(f"{path}: queue_system: its program {program} is not on PATH: "
                         "run this where jobs are submitted")  # fmt: skip


def _settings(path: str) -> dict[str, Any]:
    import yaml  # which Dask needs

    try:
        with open(path, encoding="utf-8") as file:
            found = yaml.safe_load(file)
    except OSError as error:
        raise InputError(f"{path}: {error.strerror}") from None
    except yaml.MarkedYAMLError as error:
        line = f":{error.problem_mark.line + 1}" if error.problem_mark else ""
        raise InputError(f"{path}{line}: expected YAML: {error.problem}") from None
    except (yaml.YAMLError, UnicodeDecodeError) as error:
        raise InputError(f"{path}: {error}") from None
    if not isinstance(found, dict):
        raise InputError(f"{path}: expected settings such as queue_system: slurm")
    return found
