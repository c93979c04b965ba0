# SPDX-License-Identifier: MIT
import os
import shutil

import pytest
from emulated import RUNNERS, Command, program, targets


@pytest.fixture(scope="session")
def command(tmp_path_factory):
    """The command of a target by its name; skips where it is not built or nothing here runs it."""
    wine = tmp_path_factory.mktemp("wine")

    def of(target):
        path, runner = program(target), RUNNERS[targets()[target].tried]
        if path is None:
            pytest.skip(f"build/portable has no command of {target}: ./dev wheel --all builds it")
        if runner and not shutil.which(runner[0]):
            pytest.skip(f"{runner[0]} is not installed")
        environment = {"WINEPREFIX": str(wine), "WINEDEBUG": "-all", "LC_ALL": "C.UTF-8"}
        environment = {**os.environ, **environment}
        return Command([*runner, str(path)], environment)

    return of


@pytest.fixture(scope="session")
def native(command):
    """That of this machine, by the same compiler."""
    return command(f"linux-{os.uname().machine}")
