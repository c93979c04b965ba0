# SPDX-License-Identifier: MIT
"""The command ``pliant ensemble``, what it made, and whether one process makes the same."""

import contextlib
import json
import os
import random
import signal
import subprocess
import sys
import time
from pathlib import Path

import h5py
import numpy as np
import psutil
from forked import ended_command, is_forkable
from real_files import PEPTIDE

COMMAND = Path(os.environ.get("PLIANT_COMMAND", Path(sys.executable).parent / "pliant"))
POSITION = "particles/trajectory/position"


def call(*words, **options):
    """Runs pliant with these words; the process that has ended."""
    words = [*map(str, words)]
    if is_forkable(words, **options):
        return ended_command(words, timeout=900, **options)
    return subprocess.run([COMMAND, *words], capture_output=True, text=True, timeout=900, **options)


def made(*words, code=0, **options):
    """What ``pliant ensemble ... --json`` says."""
    ended = call("ensemble", *words, "--json", **options)
    assert ended.returncode == code, ended.stderr
    return json.loads(ended.stdout)


def run_in_one_file(path, walkers, steps, every):
    """What one process makes of the walkers that shards have."""
    job = {"input": str(PEPTIDE), "output": str(path), "walkers": walkers, "one_file": True}
    file = path.with_suffix(".json")
    file.write_text(json.dumps({**job, "steps": steps, "every": every}))
    ended = call("run", "--job", file, "--quiet")
    assert ended.returncode == 0, ended.stdout


def frames_of(paths, names=("walker", "sweeps", "max_residual")):
    """Positions, steps and observables of files, one after another."""
    parts = []
    for path in paths:
        with h5py.File(path) as file:
            datasets = [f"{POSITION}/value", f"{POSITION}/step", f"{POSITION}/time"]
            datasets += [f"observables/{name}/value" for name in names]
            parts.append([file[name][:] for name in datasets])
    return [np.concatenate(one) for one in zip(*parts, strict=True)]


def shards_of(folder):
    return sorted((Path(folder) / "shards").glob("shard-*.h5md"))


def same_bits(folder, whole, **names):
    """Whether the shards have, together, the bits of one file."""
    ours, theirs = frames_of(shards_of(folder), **names), frames_of([whole], **names)
    return all(
        a.dtype == b.dtype and a.tobytes() == b.tobytes() for a, b in zip(ours, theirs, strict=True)
    )


def same_files(folder, other):
    """Whether two folders have the same shards, byte by byte."""
    pairs = list(zip(shards_of(folder), shards_of(other), strict=True))
    return bool(pairs) and all(a.read_bytes() == b.read_bytes() for a, b in pairs)


def workers_of(client):
    """The processes in which the workers of a command that runs are.

    Not those below: a worker's copy that is about to become a command looks like a worker.
    """
    try:
        children = psutil.Process(client.pid).children()
        return [child for child in children if "spawn_main" in " ".join(child.cmdline())]
    except psutil.Error:
        return []


def counted(folder):
    """Shards that the manifest has."""
    manifest = Path(folder) / "shards.jsonl"
    return manifest.read_bytes().count(b"\n") if manifest.exists() else 0


def wait_for_shards(client, folder, count):
    """Until so many shards are counted; not if the command ends before."""
    while counted(folder) < count and client.poll() is None:
        time.sleep(0.02)


def heed_hangups():
    """Undoes the nohup under which tests may run: what it starts would ignore SIGHUP."""
    signal.signal(signal.SIGHUP, signal.SIG_DFL)


def start(*words, command=COMMAND, **options):
    """The command ``pliant ensemble``, under way."""
    pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE}
    options.setdefault("preexec_fn", heed_hangups)
    return subprocess.Popen([command, "ensemble", *map(str, words)], **pipes, **options)


def kill_workers(client, folder, kills, first, gap, seed):
    """Kills a worker at random after each `gap` shards; how many were killed."""
    choice, killed = random.Random(seed), 0
    for k in range(kills):
        wait_for_shards(client, folder, first + k * gap)
        there = workers_of(client)
        while not there and client.poll() is None:  # the one before is being replaced
            time.sleep(0.02)
            there = workers_of(client)
        if there:
            with contextlib.suppress(psutil.NoSuchProcess):  # it has ended meanwhile
                choice.choice(there).kill()
                killed += 1
    return killed
