# SPDX-License-Identifier: MIT
"""Runs and samples that are stopped again and again, and gone on with."""

import random
import signal
import subprocess
import time

import h5py

ENDS = (0, 130, -signal.SIGKILL, -signal.SIGINT, -signal.SIGHUP)


def interrupt_again_and_again(command, folder, start, times, seconds, seed, is_whole):
    """Stops left.h5md by kills and Ctrl-C, goes on with it each time, and lets it end at last.

    start: words of the command that begins it; the first, `run` or `sample`, goes on with it too.
    is_whole: whether the recorded steps are as they should be, whenever it was stopped.
    """
    output = folder / "left.h5md"
    draw = random.Random(seed)
    for _ in range(times):
        child = subprocess.Popen([command, *_words(start, output)], cwd=folder)
        time.sleep(draw.uniform(0.0, seconds))
        child.send_signal(draw.choice([signal.SIGKILL, signal.SIGINT, signal.SIGHUP]))
        assert child.wait() in ENDS
        if output.exists():
            with h5py.File(output) as file:
                steps = file["particles/trajectory/position/step"][:]
            assert len(steps) > 0 and is_whole(steps)
    subprocess.run([command, *_words(start, output)], cwd=folder, check=True)


def _words(start, output):
    return [start[0], "--continue", output, "--quiet"] if output.exists() else start
