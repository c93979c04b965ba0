# SPDX-License-Identifier: MIT
"""Molecules over processes: in the order of the file, none lost, whatever befalls a process."""

from __future__ import annotations

import contextlib
import gzip
import os
import re
import signal
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from multiprocessing import get_context
from multiprocessing.connection import Connection, wait
from typing import Any

from pliant._core import Error
from pliant.base.extras import MissingPackageError
from pliant.base.processes import end_with_parent
from pliant.jobs.conformers.make import as_sdf, make
from pliant.jobs.conformers.options import ConformerOptions
from pliant.jobs.conformers.records import Record, short
from pliant.jobs.conformers.repeated import canonical_smiles
from pliant.jobs.conformers.subject import subject_of

AHEAD = 16  #: molecules a process that may be done before the one that is written next


@dataclass
class Outcome:
    """What became of one record."""

    number: int
    name: str
    conformers: int = 0
    reason: str = ""  #: why there are none
    energy: str = ""  #: its name
    notes: list[str] = field(default_factory=list)
    warnings: list[str] = field(default_factory=list)
    smiles: str = ""  #: canonical, of the isomer that was made; "" where RDKit is not installed
    seconds: dict[str, float] = field(default_factory=dict)  #: CPU, by stage
    text: bytes = b""  #: the records to write

    @property
    def called(self) -> str:
        """ "record 3 (aspirin)", for messages."""
        return f"record {self.number}" + (f" ({short(self.name)})" if self.name else "")


def outcome_of(
    record: Record,
    options: ConformerOptions,
    is_zipped: bool,
    threads: int = 1,
    *,
    is_alone: bool = False,
) -> Outcome:
    """Makes the conformers of a record; errors become the reason why there are none.

    The SMILES of one that `is_alone` is not asked for.
    """
    outcome = Outcome(record.number, record.name)
    try:
        subject = subject_of(record, options)
        made = make(subject, options, threads)
        text = as_sdf(made).encode("utf-8", "surrogateescape")
        outcome.smiles = "" if is_alone else canonical_smiles(subject)
    except MissingPackageError:
        raise
    except (Error, OSError) as error:
        outcome.reason = _without_place(str(error), record)
        return outcome
    except Exception as error:  # of RDKit, say: the others go on
        outcome.reason = f"{type(error).__name__}: {error}"
        return outcome
    outcome.conformers, outcome.energy = len(made.positions), made.energy_name
    outcome.notes, outcome.seconds = made.notes, made.seconds
    outcome.warnings = subject.warnings
    outcome.text = gzip.compress(text, 6, mtime=0) if is_zipped else text
    return outcome


def _without_place(text: str, record: Record) -> str:
    text = text.removeprefix(record.place)
    return re.sub(r"^:(\d+)?:? ", lambda at: f"line {at[1]}: " if at[1] else "", text)


class _Worker:
    """A process with at most one record."""

    def __init__(self, options: ConformerOptions, is_zipped: bool) -> None:
        context = get_context("spawn")
        self.ours, theirs = context.Pipe()
        self._process = context.Process(target=_serve, args=(theirs, options, is_zipped))
        self._process.daemon = True
        self._process.start()
        theirs.close()
        self.record: Record | None = None

    def give(self, record: Record) -> None:
        self.record = record
        with contextlib.suppress(OSError):  # where it has ended take() says so
            self.ours.send(record)

    def take(self) -> Outcome | BaseException:
        record, self.record = self.record, None
        assert record is not None
        try:
            found: Outcome | BaseException = self.ours.recv()
            return found
        except (EOFError, OSError):
            self._process.join()
            code = self._process.exitcode
            reason = f"the process that worked on it ended with code {code}"
            return Outcome(record.number, record.name, reason=reason)

    @property
    def is_alive(self) -> bool:
        return self._process.exitcode is None

    def end(self) -> None:
        self.ours.close()
        self._process.terminate()
        self._process.join()


def _serve(ours: Connection, options: ConformerOptions, is_zipped: bool) -> None:
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is for the parent
    end_with_parent()
    os.environ.setdefault("OMP_NUM_THREADS", "1")  # for tblite: there is a worker for each core
    while True:
        try:
            record = ours.recv()
        except EOFError:
            return
        try:
            answer: Any = outcome_of(record, options, is_zipped)
        except MissingPackageError as error:
            answer = error
        ours.send(answer)


def outcomes(
    records: Iterable[Record], options: ConformerOptions, workers: int, is_zipped: bool
) -> Iterator[Outcome]:
    """What becomes of each record, in their order; the bytes do not depend on `workers`.

    A single record is worked on in this process. Raises MissingPackageError.
    """
    waiting = iter(records)
    first = next(waiting, None)
    second = next(waiting, None)
    if first is None:
        return
    if second is None:
        yield outcome_of(first, options, is_zipped, workers, is_alone=first.number == 1)
        return
    pool = _Pool(options, is_zipped, workers)
    try:
        yield from _over(pool, _chained(first, second, waiting))
    finally:
        pool.end()


def _chained(first: Record, second: Record, rest: Iterator[Record]) -> Iterator[Record]:
    yield first
    yield second
    yield from rest


class _Pool:
    """Processes, each started when there is a record for it."""

    def __init__(self, options: ConformerOptions, is_zipped: bool, most: int) -> None:
        self._given, self.most = (options, is_zipped), most
        self._workers: list[_Worker] = []

    @property
    def busy(self) -> dict[Connection, _Worker]:
        return {worker.ours: worker for worker in self._workers if worker.record is not None}

    def give(self, record: Record) -> None:
        """To a process that waits, or a new one. There are fewer busy ones than `most`."""
        worker = next((one for one in self._workers if one.record is None), None)
        if worker is not None and not worker.is_alive:
            worker.end()
            self._workers.remove(worker)
            worker = None
        if worker is None:
            worker = _Worker(*self._given)
            self._workers.append(worker)
        worker.give(record)

    def end(self) -> None:
        for worker in self._workers:
            worker.end()


def _over(pool: _Pool, records: Iterator[Record]) -> Iterator[Outcome]:
    order: list[int] = []  # numbers that are under way or done, and not yet yielded
    done: dict[int, Outcome] = {}
    is_more = True
    while is_more or order:
        while is_more and len(pool.busy) < pool.most and len(order) < AHEAD * pool.most:
            record = next(records, None)
            if record is None:
                is_more = False
                break
            pool.give(record)
            order.append(record.number)
        busy = pool.busy
        for ready in wait(list(busy)) if busy else ():
            assert isinstance(ready, Connection)
            found = busy[ready].take()
            if isinstance(found, BaseException):
                raise found
            done[found.number] = found
        while order and order[0] in done:
            yield done.pop(order.pop(0))
