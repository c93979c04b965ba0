# SPDX-License-Identifier: MIT
"""What holds for every test."""

import signal


def pytest_configure():
    """Shells start background jobs with Ctrl-C ignored; the tests that send it want it heard."""
    if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
        signal.signal(signal.SIGINT, signal.default_int_handler)
