# SPDX-License-Identifier: MIT
"""What holds for every test."""

import gc
import os
import signal
from pathlib import Path

import leftovers
import pytest
from cpu_seconds import CpuSeconds

# How many objects are made between searches for those that only hold each other: with Python's 700
# that is a third of the time of some tests, for all that pytest and the packages made is searched.
gc.set_threshold(50_000, 10, 20)


def pytest_collection_finish():
    """What is there before the first test stays until the last."""
    gc.freeze()


def pytest_configure(config):
    """Nothing may be left behind. And shells start background jobs with Ctrl-C ignored; the tests
    that send it want it heard."""
    leftovers.watch(config, Path(__file__).parents[1])
    if Path("/proc/self/task").exists():
        config.pluginmanager.register(CpuSeconds(), "cpu_seconds")
    if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
        signal.signal(signal.SIGINT, signal.default_int_handler)


@pytest.fixture(autouse=True)
def own_signals():
    """imdclient takes Ctrl-C and SIGTERM for itself and keeps them: later tests want theirs."""
    kept = {number: signal.getsignal(number) for number in (signal.SIGINT, signal.SIGTERM)}
    yield
    for number, handler in kept.items():
        if signal.getsignal(number) is not handler:
            signal.signal(number, handler)


#: seconds after which a test marked `long` hangs, on a machine that does other things too
LONG_TIMEOUT = 3600


def pytest_collection_modifyitems(config, items):
    """Tests marked `long` run if PLIANT_ALL is set: ./dev test --all sets it."""
    long = [item for item in items if item.get_closest_marker("long")]
    if os.environ.get("PLIANT_ALL"):
        for item in long:
            item.add_marker(pytest.mark.timeout(LONG_TIMEOUT))
    elif long:
        config.hook.pytest_deselected(items=long)
        items[:] = [item for item in items if not item.get_closest_marker("long")]
