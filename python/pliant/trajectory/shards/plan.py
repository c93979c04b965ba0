# SPDX-License-Identifier: MIT
"""The plan of an ensemble: what is asked for, kept in its folder, and its division into shards."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from pliant import _core
from pliant._core import FileError, InputError
from pliant.base.input_files import json_object, open_file

PLAN = "ensemble.pliant"  #: file of the plan; MDAnalysis opens the ensemble by this name
SHARDS = "shards"  #: folder of the shards
FORMAT = 2
_MOST_BYTES = 1 << 24  #: of a plan
MOST = 10**9  #: walkers or frames

#: What is wrong with a file among the shards that the plan does not have.
NO_SHARD = "is no shard of this ensemble: remove it"

USUAL_SHARD = {"run": 128, "sample": 1024}  #: walkers, frames


@dataclass(frozen=True)
class Shard:
    """Walkers (of ``pliant run``) or frames (of ``pliant sample``) from `first` to `last`."""

    number: int
    first: int
    last: int

    @property
    def size(self) -> int:
        """Walkers or frames."""
        return self.last - self.first + 1

    @property
    def name(self) -> str:
        """The file's name, below the ensemble's folder."""
        return f"{SHARDS}/shard-{self.first:09d}-{self.last:09d}.h5md"


@dataclass
class EnsemblePlan:
    """What an ensemble is; shards depend on nothing else."""

    command: str  #: "run" or "sample"
    input: str  #: absolute path
    count: int  #: walkers of a run, frames of a sample
    shard_size: int
    options: dict[str, Any] = field(default_factory=dict)
    digests: dict[str, str] = field(default_factory=dict)  #: SHA-256 of "input" and option's files
    version: str = ""  #: of Pliant

    @property
    def what(self) -> str:
        """What is counted: "walkers" or "frames"."""
        return "walkers" if self.command == "run" else "frames"

    @property
    def seed(self) -> int:
        """The seed of all random numbers."""
        return int(self.options.get("seed", 0))

    @property
    def may_reach(self) -> bool:
        """Whether some frames of a sample may go further than those around the start."""
        reaching = [row.name for row in _core.samplers() if row.near_sampler]
        sampler = self.options.get("sampler", "auto")
        return self.command == "sample" and sampler in ("auto", *reaching)

    @property
    def shard_count(self) -> int:
        """How many shards there are in all."""
        return -(-self.count // self.shard_size)

    def shard(self, number: int) -> Shard:
        """The shard of that number, from 0."""
        first = number * self.shard_size
        return Shard(number, first, min(first + self.shard_size, self.count) - 1)

    def shards(self) -> Iterator[Shard]:
        """All shards, by their numbers."""
        return map(self.shard, range(self.shard_count))

    def job(self, shard: Shard, output: str) -> dict[str, Any]:
        """The job that makes the shard."""
        own = {"threads": 1, "topology": "none", "output": output}
        if self.command == "run":
            own |= {"shard": f"{shard.first}..{shard.last}", "one_file": True}
        else:
            own |= {"first_frame": shard.first, "frames": shard.size}
        if self.may_reach and "near_frames" not in self.options:
            own["near_frames"] = _core.near_frames(self.count)
        return {"task": self.command, "input": self.input, **self.options, **own}


def is_ensemble(path: str | os.PathLike[str]) -> bool:
    """Whether a path is the folder of an ensemble, or the plan in it."""
    return Path(path, PLAN).exists() or Path(path).suffix == Path(PLAN).suffix


def folder_of(path: str | os.PathLike[str]) -> Path:
    """The folder of an ensemble, of which `path` is this folder or the plan in it."""
    return Path(path) if Path(path).is_dir() else Path(path).parent


def load_plan(folder: str | os.PathLike[str]) -> EnsemblePlan:
    """The plan of a folder. Raises FileError if there is none, InputError if it is not complete."""
    path = Path(folder, PLAN)
    try:
        with open(path, "rb", opener=open_file) as file:
            found = json_object(file.read(_MOST_BYTES))
        if (version := found.pop("pliant_ensemble")) != FORMAT:
            raise ValueError(f"expected version {FORMAT} of the format, found {version!r:.40}")
        plan = EnsemblePlan(**found)
        _check_values(plan)
        return plan
    except OSError as error:
        raise FileError(f"{path}: {error.strerror}: expected the folder of an ensemble") from None
    except (ValueError, TypeError, KeyError, AttributeError) as error:
        raise InputError(f"{path}: expected the plan of an ensemble: {error}") from None


def _check_values(plan: EnsemblePlan) -> None:
    """Raises ValueError for what no command would have written."""
    if plan.command not in USUAL_SHARD:
        raise ValueError(f"command: expected run or sample, found {plan.command!r:.40}")
    if not isinstance(plan.options, dict):
        raise ValueError(f"options: expected a JSON object, found {plan.options!r:.40}")
    for name in ("count", "shard_size"):
        value = getattr(plan, name)
        if type(value) is not int or not 1 <= value <= MOST:
            raise ValueError(
                f"{name}: expected a whole number from 1 to {MOST}, found {value!r:.40}"
            )


def strangers(folder: Path, plan: EnsemblePlan) -> list[Path]:
    """Files among the shards that the plan does not have: their frames would be there twice."""
    found = (folder / SHARDS).glob("[!.]*")  # file systems keep names with a dot for themselves
    return sorted(path for path in found if shard_named(path.name, plan) is None)


def shards_there(folder: Path, plan: EnsemblePlan) -> list[Shard]:
    """Shards that have a file, by their numbers."""
    found = [shard_named(path.name, plan) for path in (folder / SHARDS).glob("shard-*")]
    there = [shard for shard in found if shard is not None and (folder / shard.name).exists()]
    return sorted(there, key=lambda shard: shard.number)


def shard_named(name: str, plan: EnsemblePlan) -> Shard | None:
    """The shard of the plan whose file has this name."""
    found = re.match(r"shard-(\d{9,10})-", name)
    if found is None or int(found[1]) >= plan.count:
        return None
    shard = plan.shard(int(found[1]) // plan.shard_size)
    return shard if Path(shard.name).name == name else None
