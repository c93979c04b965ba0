# SPDX-License-Identifier: MIT
"""Runs and samples that are stopped again and again, and gone on with."""

import os
import random
import signal
import subprocess
import time

import h5py
import numpy as np
from h5md_contents import assert_same_runs

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
