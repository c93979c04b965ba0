# SPDX-License-Identifier: MIT
"""A run of the tests leaves nothing in the checkout. Git shows no empty folders; this does."""

import fnmatch

import pytest

#: what tools keep there, besides what .gitignore names
KEPT = [".git", ".mypy_cache", ".coverage*"]


def entries(root):
    """What is in a folder and in its folders, but for what git ignores."""
    ignore = root / ".gitignore"
    lines = ignore.read_text().split() if ignore.exists() else []
    patterns = KEPT + [line.strip("/") for line in lines]

    def listed(folder):
        for path in folder.iterdir():
            name = path.relative_to(root).as_posix()
            if not any(fnmatch.fnmatch(one, p) for one in (path.name, name) for p in patterns):
                yield path

    first = list(listed(root))
    below = [path for folder in first if folder.is_dir() for path in listed(folder)]
    return {path.relative_to(root).as_posix() for path in first + below}


class Leftovers:
    """A plugin of pytest: fails the run if there is more in a folder after it than before."""

    def __init__(self, root):
        self.root = root
        self.before = entries(root)
        self.left = []

    @pytest.hookimpl(trylast=True)  # when pytest-xdist has ended its workers
    def pytest_sessionfinish(self, session):
        self.left = sorted(entries(self.root) - self.before)
        if self.left and session.exitstatus in (0, pytest.ExitCode.NO_TESTS_COLLECTED):
            session.exitstatus = pytest.ExitCode.TESTS_FAILED

    def pytest_terminal_summary(self, terminalreporter):
        for name in self.left:
            terminalreporter.write_line(f"left behind by the tests: {name}", red=True)


def watch(config, root):
    """Once for a run: not in the workers of pytest-xdist."""
    if not hasattr(config, "workerinput"):
        config.pluginmanager.register(Leftovers(root), "leftovers")
