# SPDX-License-Identifier: MIT
"""Commands of build/portable as `./dev wheel --all` compiles them, by emulators where needed."""

import os
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).parents[3]
sys.path.insert(0, str(ROOT / "python/wheel"))
from targets import targets  # noqa: E402

PORTABLE = ROOT / "build/portable"
#: Debian's C library for aarch64, of libc6-arm64-cross.
AARCH64_LIBRARIES = "/usr/aarch64-linux-gnu"
RUNNERS = {"qemu": ["qemu-aarch64-static", "-L", AARCH64_LIBRARIES], "wine": ["wine"]}
THIS = f"linux-{os.uname().machine}"
EMULATED = [name for name, row in targets().items() if row.tried in ("qemu", "wine")]


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
        out, errors = process.communicate(timeout=1800)
        return subprocess.CompletedProcess(process.args, process.returncode, out, errors)

    def succeed(self, *arguments, cwd):
        done = self.run(*arguments, cwd=cwd)
        assert done.returncode == 0, f"{done.args}\n{done.stdout}\n{done.stderr}"
        return done.stdout.replace(b"\r\n", b"\n")


def program(target):
    """Its path; None where it is not built."""
    folder = PORTABLE / target / "cmake/apps"
    found = [folder / name for name in ("pliant", "pliant.exe")]
    return next((path for path in found if path.is_file()), None)
