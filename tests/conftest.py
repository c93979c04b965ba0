# SPDX-License-Identifier: MIT
"""What holds for every test."""

import os
import signal


def pytest_configure():
    """Shells start background jobs with Ctrl-C ignored; the tests that send it want it heard."""
    if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
        signal.signal(signal.SIGINT, signal.default_int_handler)


def pytest_collection_modifyitems(config, items):
    """Tests marked `long` run if PLIANT_ALL is set: ./dev test --all sets it."""
    if os.environ.get("PLIANT_ALL"):
        return
    left_out = [item for item in items if item.get_closest_marker("long")]
    if left_out:
        config.hook.pytest_deselected(items=left_out)
        items[:] = [item for item in items if not item.get_closest_marker("long")]
