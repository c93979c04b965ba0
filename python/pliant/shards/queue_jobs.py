# SPDX-License-Identifier: MIT
"""Jobs of a queue, by a file that describes it: started by dask-jobqueue, refused by the queue."""

from __future__ import annotations

import importlib
import re
import shutil
import signal
import threading
from collections.abc import Callable
from typing import Any

from pliant._core import InputError
from pliant.base.console import counted, warn
from pliant.base.extras import late, need
from pliant.base.input_files import open_file

dask, spec = late("dask"), late("distributed.deploy.spec")
yaml = late("yaml")

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


class Queue:
    """A queue and the jobs that it took. Raises InputError where its file is at fault."""

    def __init__(self, path: str) -> None:
        need("--cluster", "dask_jobqueue")
        self._path = path
        self._settings = _settings(path)
        self._kind = _kind(path, self._settings.pop("queue_system", None))
        self._asked = self._settings.pop("jobs", None)
        self._submitting = 0
        self._taken: set[Any] = set()  #: jobs that wait or run, as far as is known
        self._refusals: list[str] = []  #: that were not shown yet
        self._is_reported = False

    def jobs(self, asked: int | None, shards: int) -> tuple[Any, Callable[[], None]]:
        """The cluster, which has begun to submit jobs, and a function that replaces lost ones.

        There are no more jobs than shards. Raises InputError.
        """
        path = self._path
        count = self._asked if asked is None else asked
        if not isinstance(count, int) or count < 1:
            raise InputError(f"{path}: jobs: expected a whole number from 1, found {count!r}")
        own = {"scheduler_options": self._scheduler_options(), "job_cls": self._watched_job()}
        try:
            cluster = self._kind(**{**self._settings, **own})
        except (TypeError, ValueError) as error:
            raise InputError(f"{path}: {_first_sentence(error)}") from None
        try:
            _expect_program(path, self._program)
        except InputError:
            cluster.close()  # whose threads would have their say when Python ends
            raise
        count = min(count, shards)
        cluster.scale(jobs=count)
        return cluster, lambda: cluster.scale(jobs=count)

    def expect_jobs(self) -> None:
        """Raises InputError with the words of the queue if no job is left; else warns once."""
        if self._submitting or not self._refusals:
            return
        words = self._refusals[-1].removeprefix(f"{self._program}: ")
        self._refusals.clear()
        what = f"{self._path}: {self._program}: {words}"
        if not self._taken:
            raise InputError(what)
        if not self._is_reported:
            warn(f"{what}: goes on with {counted(len(self._taken), 'job')}")
        self._is_reported = True

    def _scheduler_options(self) -> dict[str, Any]:
        """Options of the file, or of Dask's settings, with any free port for the dashboard.

        Dask's usual port is taken where another ensemble is under way.
        """
        name = self._settings.get("config_name") or self._kind.job_cls.default_config_name()
        usual = dask.config.get(f"jobqueue.{name}.scheduler-options", {})
        return {"dashboard_address": ":0", **(self._settings.get("scheduler_options") or usual)}

    @property
    def _program(self) -> str:
        words: str = self._kind.job_cls.submit_command
        return words.split()[0]

    def _watched_job(self) -> Any:
        """dask-jobqueue's class of jobs, which keeps what the queue says instead of logging it."""
        queue, kind = self, self._kind.job_cls

        class Job(kind):  # type: ignore[misc, valid-type]
            async def start(self) -> None:
                queue._submitting += 1
                try:
                    await super().start()
                    queue._taken.add(self)
                except (RuntimeError, ValueError, OSError) as error:
                    queue._refusals.append(_words_of_queue(error))
                    await spec.ProcessInterface.start(self)  # as one that never comes
                finally:
                    queue._submitting -= 1

            async def close(self) -> None:
                queue._taken.discard(self)
                await super().close()

        return Job


def _words_of_queue(error: Exception) -> str:
    """What a program that submits jobs printed, in one line."""
    text = str(error)
    for part in (r"\nstderr:\n(.+)", r"\nstdout:\n(.+)\nstderr:", r"output is:\n(.*)", r"(.*)"):
        found = re.search(part, text, re.DOTALL)
        words = " ".join(found[1].split()) if found else ""
        if words and not words.startswith("Command exited"):
            return words
    code = re.search(r"Exit code: (\S+)", text)
    return f"ended with {code[1]}" if code else type(error).__name__


def _kind(path: str, name: object) -> Any:
    """The class of clusters of that queue."""
    if not isinstance(name, str) or name not in _QUEUES:
        known = ", ".join(_QUEUES)
        raise InputError(f"{path}: queue_system: expected one of {known}, found {name!r}")
    return getattr(_dask_jobqueue(), _QUEUES[name])


def _dask_jobqueue() -> Any:
    """The module, without what it does to signals: importing it makes SIGINT end the program."""
    before = {number: signal.getsignal(number) for number in (signal.SIGINT, signal.SIGTERM)}
    module = importlib.import_module("dask_jobqueue")
    if threading.current_thread() is threading.main_thread():
        for number, handler in before.items():
            signal.signal(number, handler)
    return module


def _first_sentence(error: Exception) -> str:
    """Without the example in Python that dask-jobqueue adds for its own users."""
    return re.split(r"\. Very likely|, for example:|\n", str(error))[0]


def _expect_program(path: str, program: str) -> None:
    if shutil.which(program) is None:
        raise InputError(
            f"{path}: queue_system: its program {program} is not on PATH: "
            "run this where jobs are submitted"
        )


def _settings(path: str) -> dict[str, Any]:
    try:
        with open(path, encoding="utf-8", opener=open_file) as file:
            found = yaml.safe_load(file)
    except OSError as error:
        raise InputError(f"{path}: {error.strerror}") from None
    except yaml.MarkedYAMLError as error:
        line = f":{error.problem_mark.line + 1}" if error.problem_mark else ""
        raise InputError(f"{path}{line}: expected YAML: {error.problem}") from None
    except RecursionError:
        raise InputError(f"{path}: expected YAML: nested too deeply") from None
    except (yaml.YAMLError, UnicodeDecodeError) as error:
        raise InputError(f"{path}: {error}") from None
    if not isinstance(found, dict):
        raise InputError(f"{path}: expected settings such as queue_system: slurm")
    return found
