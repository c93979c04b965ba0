# SPDX-License-Identifier: MIT
"""Time and memory of the whole command, from a file to a trajectory."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
from dataclasses import dataclass

from pliant._core import FileError
from pliant.console import command_path

# A process takes over the largest resident size of the one that started it: a small one does.
STARTER = """\
import json, resource, subprocess, sys, time
began = time.perf_counter()
code = subprocess.call(sys.argv[1:], stdout=subprocess.DEVNULL)
seconds = time.perf_counter() - began
used = resource.getrusage(resource.RUSAGE_CHILDREN)
unit = 1 if sys.platform == "darwin" else 1024
print(json.dumps([code, seconds, used.ru_utime + used.ru_stime, used.ru_maxrss * unit / 1e6]))
"""
SOME_FRAMES_LEFT_OUT = 3  #: exit code


@dataclass(frozen=True)
class Cost:
    """Of one call of the command."""

    seconds: float  #: by the clock on the wall
    core_seconds: float  #: of processor time
    megabytes: float  #: largest resident size


def cost_of(path: str | os.PathLike[str], frames: int) -> Cost:
    """Of ``pliant sample`` on one thread. Raises FileError with what it said if it fails."""
    with tempfile.TemporaryDirectory() as folder:
        words = [command_path(), "sample", os.fspath(path), "-o", os.path.join(folder, "x.h5md")]
        words += ["--frames", str(frames), "--sampler", "modes", "--threads", "1", "--quiet"]
        done = subprocess.run(
            [sys.executable, "-c", STARTER, *words], capture_output=True, text=True, check=True
        )
    code, *figures = json.loads(done.stdout)
    if code not in (0, SOME_FRAMES_LEFT_OUT):
        raise FileError(f"pliant sample {os.fspath(path)} failed: {done.stderr.strip()[-300:]}")
    return Cost(*figures)
