# SPDX-License-Identifier: MIT
"""Where the shards are made: processes of this machine, a scheduler of Dask, or jobs of a queue."""

from __future__ import annotations

import contextlib
import importlib.util
import logging
import sys
import threading
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

from pliant._core import OptionError
from pliant.base.console import warn
from pliant.base.extras import late, need
from pliant.base.processes import usual_workers
from pliant.shards.make_shard import END_SECONDS
from pliant.shards.queue_jobs import Queue

dask, distributed = late("dask"), late("distributed")
addressing = late("distributed.comm.addressing")

#: Workers that die with a shard before it is given up: a machine that fails takes many along.
_DEATHS = 20

_REGROW_SECONDS = 5.0

#: A scheduler that does not answer for so long is not there.
_ANSWER_SECONDS = 10.0

#: Without a worker for so long there is a warning: jobs wait in a queue, or die at the start.
_IDLE_SECONDS = 60.0

_WHY_NO_WORKER = (
    "jobs wait in their queue, or end before they begin (their logs say why). "
    "Ctrl-C stops; the same command goes on from the shards that are there"
)


@dataclass(frozen=True)
class Place:
    """Where shards are made."""

    client: Any  #: of Dask
    #: raises InputError with what a queue said that took no job; else returns
    expect_workers: Callable[[], None] = lambda: None
    #: what its workers have started on this machine ends so many seconds after them at most
    end_seconds: float = 0.0


@contextlib.contextmanager
def open_place(
    workers: int | None, scheduler: str | None, cluster: str | None, shards: int
) -> Iterator[Place]:
    """Where so many shards can be made. Raises MissingPackageError, OptionError, InputError.

    There are no more workers than shards, and no more than cores unless `workers` says so.
    """
    need("pliant ensemble", "dask", "distributed")
    dask.config.set({"distributed.scheduler.allowed-failures": _DEATHS})
    dask.config.set({"distributed.deploy.lost-worker-timeout": f"{2 * _REGROW_SECONDS:.0f} s"})
    # Lost workers show by what they did not bring; no pages of stack traces.
    for name in ("distributed", "distributed.worker", "distributed.nanny"):
        logging.getLogger(name).setLevel(logging.CRITICAL)
    if scheduler:
        with _client_of_scheduler(scheduler) as client, _watched(client, lambda: None):
            yield Place(client)
        return
    queue = Queue(cluster) if cluster else None
    if queue:
        made, grow = queue.jobs(workers, shards)
    else:
        made, grow = _local(min(workers or usual_workers(), shards))
    with (
        made as place,
        distributed.Client(place, set_as_default=False) as client,
        _watched(client, grow),
    ):
        # On Linux commands end with their workers, after a commit.
        here = Place(client, end_seconds=END_SECONDS if sys.platform == "linux" else 0.0)
        yield Place(client, queue.expect_jobs) if queue else here


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
    try:
        # A client that fails later leaves a trace.
        addressing.get_address_host_port(address, strict=True)
        return distributed.Client(address, timeout=_ANSWER_SECONDS, set_as_default=False)
    except (OSError, ValueError) as error:
        raise OptionError(f"--scheduler {address}: {error}") from None


def _local(workers: int) -> tuple[Any, Callable[[], None]]:
    cluster = distributed.LocalCluster(
        n_workers=workers,
        threads_per_worker=1,
        processes=True,
        memory_limit=0,  # the commands, which need the memory, are no workers
        dashboard_address="127.0.0.1:0",
        silence_logs=logging.CRITICAL,
    )
    return cluster, lambda: cluster.scale(workers)
