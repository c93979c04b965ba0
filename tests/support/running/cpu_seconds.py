# SPDX-License-Identifier: MIT
"""Each test's JUnit report has its CPU seconds, with those of its processes, and its file.

/proc may leave out a child while another ends, so that all of its seconds would seem to be of the
next test: a test has no more than its time on all processors.
"""

import os
import time
from pathlib import Path

import pytest

_TICK = 1.0 / os.sysconf("SC_CLK_TCK") if hasattr(os, "sysconf") else 0.0


def children(process: str) -> list[str]:
    """Of a process, those that run."""
    return [
        child
        for task in Path(f"/proc/{process}/task").glob("*/children")
        for child in task.read_text().split()
    ]


def seconds_of(process: str) -> float:
    """CPU seconds of a process, of its children that run and of those that have ended."""
    try:
        after_name = Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()
        own = sum(map(int, after_name[11:15])) * _TICK  # utime, stime, cutime, cstime of proc(5)
        return own + sum(map(seconds_of, children(process)))
    except OSError:  # ended meanwhile; its parent has its seconds
        return 0.0


class CpuSeconds:
    """A plugin of pytest."""

    def __init__(self):
        self.before = self.began = 0.0

    @pytest.hookimpl(tryfirst=True)
    def pytest_runtest_setup(self):
        self.before, self.began = seconds_of("self"), time.monotonic()

    @pytest.hookimpl(tryfirst=True)
    def pytest_runtest_makereport(self, item, call):
        """The report of the end of a test has what is known then."""
        if call.when == "teardown":
            most = (time.monotonic() - self.began) * (os.cpu_count() or 1)
            spent = min(seconds_of("self") - self.before, most)
            item.user_properties.append(("cpu", f"{max(spent, 0.0):.2f}"))
            item.user_properties.append(("source", item.nodeid.partition("::")[0]))
