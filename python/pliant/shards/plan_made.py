# SPDX-License-Identifier: MIT
"""Plans of ensembles that are made, kept in their folders, and held to."""

from __future__ import annotations

import json
import os
from dataclasses import asdict
from pathlib import Path

from pliant import _core
from pliant._core import FileError, OptionError
from pliant.base.input_files import file_digest
from pliant.shards.options import Options, files_among, flag_of, text_of
from pliant.trajectory.shards.plan import FORMAT, PLAN, SHARDS, USUAL_SHARD, EnsemblePlan, load_plan

MAKING = "making"  #: folder of what is being made: logs of commits, and shards without a name
LOG = ".commits"  #: how the name of a log of commits ends
_EMPTY_LOG = 16  #: bytes of one without commits


def make_plan(
    command: str, input_file: str, count: int, shard_size: int | None, options: Options
) -> EnsemblePlan:
    """A plan with the digests of all files that it names. Raises FileError if one is not there."""
    digests = {"input": file_digest(input_file)}
    for name in files_among(command, options):
        digests[name] = file_digest(options[name])
        options[name] = os.path.abspath(options[name])
    size = shard_size or USUAL_SHARD[command]
    path = os.path.abspath(input_file)
    return EnsemblePlan(command, path, count, size, options, digests, _core.version())


def settled(folder: Path, plan: EnsemblePlan, asked_size: int | None) -> EnsemblePlan | None:
    """The plan of the folder, if there is one and it is that plan; None if there is none yet.

    A plan binds from the moment that it is written: jobs of a queue may be waiting to make its
    shards. Raises OptionError naming what differs.
    """
    if not (folder / PLAN).exists():
        if has_shards(folder):
            raise FileError(f"{folder}: holds shards but no {PLAN}: give another folder")
        return None
    there = load_plan(folder)
    if asked_size is None:
        plan.shard_size = there.shard_size
    _expect_same(folder, there, plan)
    return there


def write_plan(folder: Path, plan: EnsemblePlan) -> None:
    """Writes the plan to its folder. Raises FileError."""
    text = json.dumps({"pliant_ensemble": FORMAT, **asdict(plan)}, indent=1) + "\n"
    (folder / SHARDS).mkdir(exist_ok=True)
    write_whole(folder / PLAN, text)


def withdraw(folder: Path) -> None:
    """Removes a plan that came to nothing: it binds nobody."""
    if not has_begun(folder):
        (folder / PLAN).unlink(missing_ok=True)


def has_shards(folder: Path) -> bool:
    """Whether some shard is there."""
    return any((folder / SHARDS).glob("shard-*"))


def has_begun(folder: Path) -> bool:
    """Whether some shard is there, or a part of one."""
    logs = (folder / MAKING).glob(f"*{LOG}")
    return has_shards(folder) or any(log.stat().st_size > _EMPTY_LOG for log in logs)


def write_whole(path: Path, text: str) -> None:
    """Writes a file that is there with all its text, or not at all. Raises FileError."""
    partial = path.with_name(f".{path.name}.{os.getpid()}")
    try:
        with open(partial, "w", encoding="utf-8") as file:
            file.write(text)
            file.flush()
            os.fsync(file.fileno())
        partial.replace(path)
    except OSError as error:
        raise FileError(f"{path}: {error.strerror}") from None


def _expect_same(folder: Path, there: EnsemblePlan, asked: EnsemblePlan) -> None:
    rows = [
        ("pliant", there.version, asked.version),
        ("the command", f"pliant {there.command}", f"pliant {asked.command}"),
        (f"--{asked.what}", str(there.count), str(asked.count)),
        ("--shard-size", str(there.shard_size), str(asked.shard_size)),
    ]
    for name, one, other in rows:
        if one != other:
            raise _differs(folder, name, one, other)
    for name in [*there.options, *asked.options]:
        one, other = (text_of(name, plan.options) for plan in (there, asked))
        if one != other:
            raise _differs(folder, flag_of(name), one, other)
    for name, digest in there.digests.items():
        if asked.digests.get(name) != digest:
            file = f"input {there.input}" if name == "input" else text_of(name, there.options)
            raise OptionError(f"{folder}: was begun when {file} had other contents")


def _differs(folder: Path, name: str, one: str, other: str) -> OptionError:
    anew = "" if has_shards(folder) else "; no shard is made yet: remove the folder to begin anew"
    text = f"was begun with another {name}: expected {one}, found {other}"
    return OptionError(f"{folder}: {text}{anew}")
