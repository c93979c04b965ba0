# SPDX-License-Identifier: MIT
"""How many shards a second the driver of ``pliant ensemble`` and Dask's scheduler hand out.

    .venv/bin/python tests/bench/shards_of_no_work.py 100000 --workers 2

Shards that do nothing go the whole way: submitted, sent to a worker, brought back, put into the
manifest. What a shard takes here is what it costs besides its work.
"""

from __future__ import annotations

import argparse
import resource
import tempfile
import time
from pathlib import Path

from pliant.shards.cluster import open_place
from pliant.shards.drive import made_by
from pliant.trajectory.shards.inspect_shard import ShardRecord
from pliant.trajectory.shards.manifest import Manifest
from pliant.trajectory.shards.plan import EnsemblePlan, Shard


def nothing(plan: EnsemblePlan, shard: Shard, folder: str) -> ShardRecord:
    """The record of a shard that nobody made."""
    return ShardRecord(shard.number, shard.first, shard.last, shard.name, 0, 0, 0, 0, "0" * 64)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("shards", type=int)
    parser.add_argument("--workers", type=int, default=2)
    options = parser.parse_args()
    plan = EnsemblePlan("run", "/none", options.shards, 1)
    with (
        tempfile.TemporaryDirectory() as folder,
        open_place(options.workers, None, None, options.shards) as place,
    ):
        manifest = Manifest(Path(folder), plan)
        began, used = time.perf_counter(), time.process_time()
        for record in made_by(place, nothing, plan, Path(folder), plan.shards(), 0):
            manifest.add(record)
        seconds = time.perf_counter() - began
        of_driver = time.process_time() - used
        size = manifest.path.stat().st_size
        again = time.perf_counter()
        count = len(Manifest(Path(folder), plan).records)
        print(f"{count} shards, {seconds:.1f} s: {count / seconds:.0f} shards a second")
        print(f"driver and scheduler: {1e3 * of_driver / count:.2f} ms of a core a shard")
        print(f"manifest: {size / 1e6:.1f} MB, read in {time.perf_counter() - again:.2f} s")
        most = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
        print(f"memory of driver and scheduler: {most:.0f} MB")


if __name__ == "__main__":
    main()
