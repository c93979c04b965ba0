# SPDX-License-Identifier: MIT
"""What a client of IMD costs the run that it follows.

    .venv/bin/python tests/bench/live_cost.py FILE --pairs 7 --run "--technique blocks"

One run, in windows that take turns: nobody follows it, then a client does. Compared is the time
that a step takes, by the clock and by the processor time of the thread that makes them; printed
is the median of the ratios, with the least and the largest. A window with a client is compared with
the mean of the two beside it, so that a machine that grows busier counts on neither side. The row
``nobody`` compares no client with no client: what scatters there means nothing in the other rows.
"""

from __future__ import annotations

import argparse
import re
import statistics
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

from pliant.play.imd import Client
from pliant.play.upstream import Upstream

COMMAND = Path(sys.executable).parent / "pliant"
FRAMES = 30  #: a second, of clients that take no more


@dataclass
class Cost:
    """Of a step: seconds by the clock, and of the processor."""

    clock: float
    processor: float


class Run:
    """An endless run that listens."""

    def __init__(self, molecule: str, options: list[str], folder: str) -> None:
        words = ["run", Path(molecule).resolve(), "-o", "run.h5md", "--steps", str(10**12)]
        words += ["--every", str(10**12), "--imd", "0", *options]
        self.process = subprocess.Popen(
            [str(word) for word in [COMMAND, *words]],
            cwd=folder,
            text=True,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
        )
        assert self.process.stderr is not None
        for line in self.process.stderr:
            if found := re.search(r"IMD version \d on \S+:(\d+)", line):
                self.port = int(found[1])
                return
        raise SystemExit("the run has ended before it listened")

    def now(self) -> tuple[int, float, float]:
        """The step, the clock, and the processor time of the run's thread (not the server's)."""
        with Client("127.0.0.1", self.port) as client:
            frame = client.read()
            number = self.process.pid
            used = Path(f"/proc/{number}/task/{number}/schedstat").read_text().split()[0]
            clock = time.monotonic()
        assert frame is not None and frame.step is not None
        return frame.step, clock, 1e-9 * int(used)

    def window(self, seconds: float, follow: Callable[[int, float], int]) -> tuple[Cost, int]:
        """What a step costs while `follow` does; and what it returns."""
        first = self.now()
        result = follow(self.port, seconds)
        last = self.now()
        steps = last[0] - first[0]
        return Cost((last[1] - first[1]) / steps, (last[2] - first[2]) / steps), result


def nobody(_: int, seconds: float) -> int:
    """No client."""
    time.sleep(seconds)
    return 0


def slow_reader(port: int, seconds: float) -> int:
    """A client that takes FRAMES frames a second of all that there are; the others are dropped."""
    return _read(Client("127.0.0.1", port), seconds)


def greedy(port: int, seconds: float) -> int:
    """A client that reads all that it can."""
    return _read(Client("127.0.0.1", port), seconds, pause=0.0)


def page(port: int, seconds: float) -> int:
    """What follows a run for the page: it asks the run for a rate (TRATE)."""
    upstream = Follower("127.0.0.1", port)
    reading = threading.Thread(target=upstream._follow)
    reading.start()
    time.sleep(seconds)
    count = upstream.newest[0]
    upstream.close()
    reading.join()
    return count


class Follower(Upstream):
    """Without a page that waits for frames."""

    def _tell(self, *_: object) -> None:
        pass


def _read(client: Client, seconds: float, pause: float = 1 / FRAMES) -> int:
    count = 0
    end = time.monotonic() + seconds
    with client:
        while time.monotonic() < end:
            client.read()
            count += 1
            if pause:
                time.sleep(pause)
    return count


CLIENTS = {"nobody": nobody, "slow": slow_reader, "all": greedy, "page": page}


def percent(ratios: list[float]) -> str:
    low, middle, high = min(ratios), statistics.median(ratios), max(ratios)
    return f"{100 * middle - 100:+6.1f} % ({100 * low - 100:+.1f} to {100 * high - 100:+.1f})"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("molecule")
    parser.add_argument("--pairs", type=int, default=7)
    parser.add_argument("--seconds", type=float, default=2.0, help="of a window")
    parser.add_argument("--run", default="--technique blocks", help="options of the run")
    parser.add_argument("--clients", default="nobody,slow,page", help=", ".join(CLIENTS))
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        run = Run(options.molecule, options.run.split(), folder)
        try:
            for name in options.clients.split(","):
                compare(run, name, options)
        finally:
            run.process.kill()
            with suppress(Exception):
                run.process.communicate()


def compare(run: Run, name: str, options: argparse.Namespace) -> None:
    alone = [run.window(options.seconds, nobody)[0]]
    followed, frames = [], []
    for _ in range(options.pairs):
        cost, count = run.window(options.seconds, CLIENTS[name])
        followed.append(cost)
        frames.append(count / options.seconds)
        alone.append(run.window(options.seconds, nobody)[0])
    pairs = list(zip(followed, alone, alone[1:], strict=False))
    clock = [2 * own.clock / (a.clock + b.clock) for own, a, b in pairs]
    used = [2 * own.processor / (a.processor + b.processor) for own, a, b in pairs]
    step = statistics.median(cost.processor for cost in alone)
    print(
        f"{name:8s}{statistics.median(frames):7.0f} frames/s  step {1e6 * step:8.2f} us"
        f"  processor {percent(used)}  clock {percent(clock)}",
        flush=True,
    )


if __name__ == "__main__":
    main()
