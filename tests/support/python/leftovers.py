# SPDX-License-Identifier: MIT
"""A run of the tests leaves nothing in the checkout: what git sees afterwards was there before."""

import subprocess

import pytest


def untracked(root):
    """Files that git neither tracks nor ignores; none where this is no clone."""
    command = ["git", "ls-files", "--others", "--exclude-standard", "--directory"]
    done = subprocess.run(command, cwd=root, capture_output=True, text=True, check=False)
    return set(done.stdout.splitlines())


class Leftovers:
    """A plugin of pytest: fails the run if there is more in a folder after it than before."""

    def __init__(self, root):
        self.root = root
        self.before = untracked(root)
        self.left = []

    @pytest.hookimpl(trylast=True)  # when pytest-xdist has ended its workers
    def pytest_sessionfinish(self, session):
        self.left = sorted(untracked(self.root) - self.before)
        if self.left and session.exitstatus in (0, pytest.ExitCode.NO_TESTS_COLLECTED):
            session.exitstatus = pytest.ExitCode.TESTS_FAILED

    def pytest_terminal_summary(self, terminalreporter):
        for name in self.left:
            terminalreporter.write_line(f"left behind by the tests: {name}", red=True)


def watch(config, root):
    """Once for a run: not in the workers of pytest-xdist."""
    if not hasattr(config, "workerinput"):
        config.pluginmanager.register(Leftovers(root), "leftovers")
