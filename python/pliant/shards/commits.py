# SPDX-License-Identifier: MIT
"""Logs of commits: what unfinished shards have reached, for whoever makes them next.

A log is never locked. Whoever goes on from it first gives it another name, which only one can do;
the one before, should it still be alive, finds its log gone and goes on without.
"""

from __future__ import annotations

import hashlib
import json
import uuid
from collections.abc import Iterable
from dataclasses import asdict
from pathlib import Path

from pliant.shards.plan_made import LOG, MAKING
from pliant.trajectory.shards.plan import EnsemblePlan, Shard


def take_log(folder: Path, plan: EnsemblePlan, shard: Shard) -> Path:
    """Where to commit a shard: the log of an attempt that ended, under a new name, if there is one.

    Of several the largest is taken.
    """
    making = folder / MAKING
    making.mkdir(exist_ok=True)
    begin = f"{_stem(shard)}.{_key(plan)}."
    mine = making / f"{begin}{uuid.uuid4().hex}{LOG}"
    for _, log in sorted(_with_sizes(making.glob(f"{begin}*{LOG}")), reverse=True):
        try:
            log.rename(mine)
            break
        except FileNotFoundError:  # taken by another
            continue
    return mine


def remove_logs(folder: Path, shard: Shard) -> None:
    """Once the shard is complete."""
    for log in (folder / MAKING).glob(f"{_stem(shard)}.*{LOG}"):
        log.unlink(missing_ok=True)


def _with_sizes(logs: Iterable[Path]) -> list[tuple[int, Path]]:
    found = []
    for log in logs:
        try:
            found.append((log.stat().st_size, log))
        except FileNotFoundError:
            continue
    return found


def _stem(shard: Shard) -> str:
    return Path(shard.name).stem


def _key(plan: EnsemblePlan) -> str:
    """A plan that began anew in the same folder has other logs."""
    return hashlib.sha256(json.dumps(asdict(plan), sort_keys=True).encode()).hexdigest()[:12]
