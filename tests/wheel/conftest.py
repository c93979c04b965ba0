# SPDX-License-Identifier: MIT
import os
import shutil
import subprocess

import pytest
from emulated import RUNNERS, THIS, Command, program, targets


@pytest.fixture(scope="session")
def system(tmp_path_factory):
    """The environment of commands. Wine makes its disk there once, and says so."""
    folder = tmp_path_factory.mktemp("wine")
    words = {"WINEPREFIX": str(folder), "WINEDEBUG": "-all", "LC_ALL": "C.UTF-8"}
    environment = {**os.environ, **words}
    if shutil.which("wine"):
        subprocess.run(["wine", "cmd", "/c", "exit"], env=environment, capture_output=True)
    return environment


@pytest.fixture(scope="session")
def command(system):
    """The command of another target; skips where it is not built or nothing here runs it."""

    def of(target):
        path, runner = program(target), RUNNERS[targets()[target].tried]
        if path is None:
            pytest.skip(f"build/portable has no command of {target}: ./dev wheel --all builds it")
        if not shutil.which(runner[0]):
            pytest.skip(f"{runner[0]} is not installed")
        return Command([*runner, str(path)], system)

    return of


@pytest.fixture(scope="session")
def native():
    """That of this machine, by the same compiler."""
    path = program(THIS)
    if path is None:
        pytest.skip("build/portable has no command of this machine: ./dev wheel --all builds it")
    return Command([str(path)], dict(os.environ))
