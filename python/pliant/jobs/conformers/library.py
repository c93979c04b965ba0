# SPDX-License-Identifier: MIT
"""A library in, ranked conformers out: on all cores, one SDF in the order of the input."""

from __future__ import annotations

import itertools
import time
from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from pliant._core import InputError, OptionError
from pliant.base.csv_cells import write_csv
from pliant.base.input_files import file_digest
from pliant.jobs.conformers.journal import Journal
from pliant.jobs.conformers.options import ConformerOptions
from pliant.jobs.conformers.records import Record, read_records, smiles_record
from pliant.jobs.conformers.repeated import Repeated
from pliant.jobs.conformers.workers import Outcome, outcomes

OnDone = Callable[[Outcome], None]
FAILURE = ("number", "name", "reason")


@dataclass(frozen=True)
class Source:
    """Where molecules come from: a file, or one SMILES; and which of them."""

    file: str = ""
    smiles: str = ""
    shard: tuple[int, int] = (1, 1)  #: (i, n): each n-th record from the i-th on

    def records(self, options: ConformerOptions) -> Iterator[Record]:
        """Those of this shard."""
        if self.smiles:
            return iter([smiles_record(self.smiles, self.smiles)])
        first, of = self.shard
        return itertools.islice(read_records(self.file, options), first - 1, None, of)

    def asked(self) -> dict[str, Any]:
        """For the journal."""
        known = {"sha256": file_digest(self.file)} if self.file else {}
        return {"file": self.file, "smiles": self.smiles, "shard": self.shard, **known}


@dataclass
class LibraryDone:
    """What became of a library."""

    source: Source
    options: ConformerOptions
    output: Path
    outcomes: list[Outcome]
    seconds: float  #: of this run
    resumed: int = 0  #: molecules that an earlier run had done

    @property
    def failed(self) -> list[Outcome]:
        """Records without conformers."""
        return [one for one in self.outcomes if one.reason]

    @property
    def failures(self) -> Path:
        """A table of the records that failed, beside the output; is there if some of several did.

        Numbers are those of the library, so that the tables of shards can be put together.
        """
        name = self.output.name
        return self.output.with_name(f"{name[: name.lower().rindex('.sdf')]}-failed.csv")

    def write_failures(self) -> None:
        """An earlier table of the same name goes."""
        if self.failed and len(self.outcomes) > 1:
            columns = {at: [getattr(one, at) for one in self.failed] for at in FAILURE}
            write_csv(self.failures, columns)
        else:
            self.failures.unlink(missing_ok=True)

    @property
    def done(self) -> list[Outcome]:
        """Those with conformers."""
        return [one for one in self.outcomes if not one.reason]

    @property
    def conformers(self) -> int:
        """Of all molecules."""
        return sum(one.conformers for one in self.outcomes)

    @property
    def short(self) -> list[Outcome]:
        """Molecules with fewer conformers than asked for."""
        return [one for one in self.done if one.conformers < self.options.max]

    def cpu(self) -> dict[str, float]:
        """CPU seconds by stage."""
        total: Counter[str] = Counter()
        for one in self.outcomes:
            total.update(one.seconds)
        return dict(total)

    def as_json(self) -> dict[str, Any]:
        """For ``--json``."""
        return {
            "input": self.source.file or self.source.smiles,
            "shard": list(self.source.shard),
            "output": str(self.output) if self.conformers else None,
            "options": self.options.as_json(),
            "records": len(self.outcomes),
            "molecules": len(self.done),
            "conformers": self.conformers,
            "missing": sum(self.options.max - one.conformers for one in self.short),
            "resumed": self.resumed,
            "seconds": self.seconds,
            "cpu_seconds": self.cpu(),
            "failed": [{at: getattr(one, at) for at in FAILURE} for one in self.failed],
            "made": [
                {
                    "number": one.number,
                    "name": one.name,
                    "conformers": one.conformers,
                    "missing": self.options.max - one.conformers,
                    "energy": one.energy or None,
                    "notes": one.notes,
                    "warnings": one.warnings,
                }
                for one in self.done
            ],
        }


def begin(source: Source, options: ConformerOptions, output: Path, overwrite: bool) -> Journal:
    """A new output. Raises as Journal.expect_free, read_records, and InputError without a record.

    The whole input is read before it is begun: what is wrong with a file is said at once.
    """
    if source.file and output.exists() and output.samefile(source.file):
        raise OptionError(f"--output {output}: is the input")
    if not overwrite:
        Journal.expect_free(output)
    count = sum(1 for _ in source.records(options))
    if not count:
        where = "" if source.shard == (1, 1) else f" in shard {source.shard[0]}/{source.shard[1]}"
        raise InputError(f"{source.file}: holds no record{where}")
    asked = {**source.asked(), "records": count, "options": options.as_json()}
    return Journal.begin(output, asked, overwrite)


def resume(output: Path) -> Journal:
    """An unfinished one. Raises as Journal.resume, and InputError where the input has changed."""
    journal = Journal.resume(output)
    source, _ = what_was_asked(journal)
    if source.file and file_digest(source.file) != journal.asked["sha256"]:
        journal.close()
        raise InputError(f"{source.file}: is not the file that {output} was begun with")
    return journal


def what_was_asked(journal: Journal) -> tuple[Source, ConformerOptions]:
    """As the journal has it."""
    asked = journal.asked
    first, of = asked["shard"]
    options = ConformerOptions("--", **asked["options"])
    return Source(asked["file"], asked["smiles"], (first, of)), options


def complete(journal: Journal, threads: int | None, on_done: OnDone) -> LibraryDone:
    """Makes what is missing, and publishes the output. Both files stay where it is ended early."""
    began = time.monotonic()
    source, options = what_was_asked(journal)
    resumed = len(journal.outcomes)
    records = itertools.islice(source.records(options), resumed, None)
    is_zipped = journal.output.suffix.lower() == ".gz"
    repeated = Repeated()
    for one in journal.outcomes:
        repeated.warnings(one.smiles, one.called)
    try:
        for outcome in outcomes(records, options, threads or options.threads, is_zipped):
            outcome.warnings += repeated.warnings(outcome.smiles, outcome.called)
            journal.add(outcome)
            on_done(outcome)
        found = LibraryDone(source, options, journal.output, journal.outcomes, 0.0, resumed)
        found.write_failures()
        journal.publish()
    finally:
        journal.close()
    found.seconds = time.monotonic() - began
    return found
