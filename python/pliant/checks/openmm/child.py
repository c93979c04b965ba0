# SPDX-License-Identifier: MIT
"""Runs jobs in child processes: an abort or a hang there is a result like any other."""

from __future__ import annotations

import contextlib
import json
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from pliant._core import InputError
from pliant.base.new_file import new_file, write_text

WORKER = pathlib.Path(__file__).with_name("worker.py")
TIME_LIMIT = 300.0  #: seconds for one job
START_LIMIT = 120.0  #: seconds until the process says that it is there


@dataclass
class Job:
    """Something to do: a name in the KINDS of the worker, and what it works on."""

    kind: str
    values: Mapping[str, float | int | str]
    arrays: Mapping[str, np.ndarray]


@dataclass
class Outcome:
    """What became of a job: "done", "raised" (an exception), "died" or "too_slow"."""

    event: str
    message: str = ""
    arrays: dict[str, np.ndarray] = field(default_factory=dict)

    @property
    def done(self) -> bool:
        """The job came to its end, which says nothing of the result."""
        return self.event == "done"

    def brief(self) -> str:
        """What happened, in a few words."""
        words = {"done": "done", "raised": "raised an exception", "died": "died", "too_slow": ""}
        return ": ".join(text for text in (words[self.event], self.message) if text)


def run_jobs(
    jobs: Sequence[Job],
    time_limit: float = TIME_LIMIT,
    progress: Callable[[int, int], None] = lambda *_: None,
    worker: pathlib.Path | None = None,
) -> tuple[list[Outcome], str]:
    """Does the jobs, each `time_limit` seconds at most; outcomes, and the version of OpenMM.

    A job that ends its process or takes too long costs no other job anything: a new process goes
    on with the next. `worker` is the script that does them (default: WORKER, OpenMM's jobs).
    Raises InputError when OpenMM cannot be imported at all.
    """
    script = worker or WORKER
    with tempfile.TemporaryDirectory(prefix="pliant-jobs-") as name:
        folder = pathlib.Path(name)
        _write_jobs(folder, jobs)
        outcomes: list[Outcome] = []
        version = ""
        while len(outcomes) < len(jobs):
            version = _run_from(script, folder, len(jobs), time_limit, outcomes, progress)
        return outcomes, version


def _write_jobs(folder: pathlib.Path, jobs: Sequence[Job]) -> None:
    names: dict[int, str] = {}  # an array that several jobs share is written once

    def saved(values: np.ndarray) -> str:
        if id(values) not in names:
            names[id(values)] = f"array-{len(names)}.npy"
            with new_file(folder / names[id(values)]) as file:
                np.save(file, values)
        return names[id(values)]

    lines = [
        {
            "kind": job.kind,
            "values": dict(job.values),
            "arrays": {name: saved(values) for name, values in job.arrays.items()},
        }
        for job in jobs
    ]
    write_text(folder / "jobs.json", json.dumps(lines))


def _run_from(
    script: pathlib.Path,
    folder: pathlib.Path,
    count: int,
    time_limit: float,
    outcomes: list[Outcome],
    progress: Callable[[int, int], None],
) -> str:
    """Runs one child over the jobs without an outcome and adds those of all that it began."""
    first = len(outcomes)
    journal = folder / "journal.jsonl"
    journal.write_text("")
    command = [sys.executable, str(script), str(folder), str(first)]
    errors = folder / "stderr.txt"
    with open(errors, "wb") as stderr:
        child = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=stderr)
        too_slow = _wait(child, journal, time_limit, lambda done: progress(first + done, count))
    events = _events(journal)
    if not events:
        raise InputError(f"OpenMM could not be started: {_last_line(errors)}")
    ends = [line for line in events if "job" in line and line["event"] != "started"]
    outcomes.extend(_outcome(folder, line) for line in ends)
    if len(outcomes) < count:
        outcomes.append(_death(child.returncode, too_slow, time_limit, errors))
    return str(events[0]["version"])


def _wait(
    child: subprocess.Popen[bytes],
    journal: pathlib.Path,
    time_limit: float,
    progress: Callable[[int], None],
) -> bool:
    """Waits for the end; kills the child and says so once the journal is still for too long."""
    size, since = -1, time.monotonic()
    try:
        while child.poll() is None:
            if journal.stat().st_size != size:
                size, since = journal.stat().st_size, time.monotonic()
                progress(sum(line.get("event") == "started" for line in _events(journal)))
            limit = time_limit if size > 0 else max(time_limit, START_LIMIT)
            if time.monotonic() - since > limit:
                return True
            with contextlib.suppress(subprocess.TimeoutExpired):
                child.wait(min(0.2, time_limit))
        return False
    finally:
        child.kill()
        child.wait()


def _events(journal: pathlib.Path) -> list[dict[str, Any]]:
    """The whole lines of the journal; a torn last line is not one."""
    text = journal.read_text(encoding="utf-8")
    return [json.loads(line) for line in text.splitlines(keepends=True) if line.endswith("\n")]


def _outcome(folder: pathlib.Path, line: dict[str, Any]) -> Outcome:
    files = line.get("files", {})
    arrays = {name: np.load(folder / file) for name, file in files.items()}
    for file in files.values():
        (folder / file).unlink()
    return Outcome(line["event"], line.get("message", ""), arrays)


def _death(code: int, too_slow: bool, time_limit: float, errors: pathlib.Path) -> Outcome:
    if too_slow:
        return Outcome("too_slow", f"took more than {time_limit:g} s")
    how = signal.Signals(-code).name if code < 0 else f"exit code {code}"
    last = _last_line(errors)
    return Outcome("died", f"{how}, {last}" if last else how)


def _last_line(path: pathlib.Path) -> str:
    lines = path.read_text(encoding="utf-8", errors="replace").strip().splitlines()
    return lines[-1].strip()[:200] if lines else ""
