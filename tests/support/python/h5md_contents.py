# SPDX-License-Identifier: MIT
"""What H5MD files hold, dataset by dataset, and whether it is the same after interruptions."""

import os
import random
import signal
import subprocess
import time

import h5py
import numpy as np


def contents(path):
    """Every dataset of a file by name."""
    found = {}

    def take(name, item):
        if isinstance(item, h5py.Dataset):
            found[name] = item[()]

    with h5py.File(path) as file:
        file.visititems(take)
    return found


def positions_in(path):
    """(F, n, 3), as they are stored."""
    with h5py.File(path) as file:
        return file["particles/trajectory/position/value"][:]


def stored(path):
    """Type, shape and bytes of every dataset by name, and every attribute by NAME@KEY."""
    found = {}

    def take(name, item):
        if isinstance(item, h5py.Dataset):
            value = np.asarray(item[()])
            bits = repr(value.tolist()) if value.dtype == object else value.tobytes()
            found[name] = (str(item.dtype), item.shape, bits)
        for key, value in item.attrs.items():
            found[f"{name}@{key}"] = repr(np.asarray(value).tolist())

    with h5py.File(path) as file:
        file.visititems(take)
    return found


def assert_same_runs(one, other):
    """Two files have the same bits, but for what their runs go on from."""
    first, second = (
        {name: value for name, value in contents(path).items() if "checkpoint" not in name}
        for path in (one, other)
    )
    assert first.keys() == second.keys()
    for name, value in first.items():
        assert np.array_equal(value, second[name]), name


ENDS = (0, 130, -signal.SIGKILL, -signal.SIGINT, -signal.SIGHUP)


def check_interruptions(command, folder, words, every, times, seed):
    """Left.h5md, stopped by kills and Ctrl-C and gone on with, ends as whole.h5md, which nobody
    stops; the step of each frame but the last is a multiple of `every`.

    words: of the command that begins it; the first, `run` or `sample`, goes on with it too.
    """
    there = set(os.listdir(folder))
    before = time.monotonic()
    subprocess.run([command, *words, "-o", "whole.h5md"], cwd=folder, check=True)
    seconds = 1.5 * (time.monotonic() - before) / times
    output = folder / "left.h5md"
    start = [*words, "-o", "left.h5md"]
    draw = random.Random(seed)
    for _ in range(times):
        child = subprocess.Popen([command, *_words(start, output)], cwd=folder)
        time.sleep(draw.uniform(0.0, seconds))
        child.send_signal(draw.choice([signal.SIGKILL, signal.SIGINT, signal.SIGHUP]))
        assert child.wait() in ENDS
        if output.exists():
            with h5py.File(output) as file:
                steps = file["particles/trajectory/position/step"][:]
            assert len(steps) > 0
            assert np.array_equal(steps[:-1], every * np.arange(len(steps) - 1))
    subprocess.run([command, *_words(start, output)], cwd=folder, check=True)
    assert_same_runs(folder / "whole.h5md", output)
    assert set(os.listdir(folder)) == there | {"left.h5md", "whole.h5md"}


def _words(start, output):
    return [start[0], "--continue", output, "--quiet"] if output.exists() else start
