# SPDX-License-Identifier: MIT
"""Commands of build/portable as `./dev wheel --all` compiles them, by emulators where needed."""

import os
import shutil
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
sys.path.insert(0, str(ROOT / "python/wheel"))
from targets import targets  # noqa: E402

#: Debian's C library for aarch64, of libc6-arm64-cross.
AARCH64_LIBRARIES = "/usr/aarch64-linux-gnu"
RUNNERS = {"python": [], "qemu": ["qemu-aarch64-static", "-L", AARCH64_LIBRARIES], "wine": ["wine"]}


@dataclass
class Command:
    """`pliant` of a target and what runs it."""

    words: list[str]
    environment: dict[str, str]

    def start(self, *arguments, cwd, **options):
        return subprocess.Popen(
            [*self.words, *map(str, arguments)],
            cwd=cwd,
            env=self.environment,
            stdin=subprocess.DEVNULL,
            **options,
        )

    def run(self, *arguments, cwd):
        """Its result; output as bytes."""
        process = self.start(*arguments, cwd=cwd, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        out, errors = process.communicate(timeout=600)
        return subprocess.CompletedProcess(process.args, process.returncode, out, errors)

    def succeed(self, *arguments, cwd):
        done = self.run(*arguments, cwd=cwd)
        assert done.returncode == 0, f"{done.args}\n{done.stdout}\n{done.stderr}"
        return done.stdout.replace(b"\r\n", b"\n")


def program(target):
    """Its path; None where it is not built."""
    folder = ROOT / "build/portable" / target / "cmake/apps"
    found = [folder / name for name in ("pliant", "pliant.exe")]
    return next((path for path in found if path.is_file()), None)


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
