# SPDX-License-Identifier: MIT
"""The ensemble of a study: ``pliant sample`` with what it does by default."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from pliant._core import InputError
from pliant.console import command_path

#: left behind is the whole ensemble, but for frames that could not be made
DONE = (0, 3)


@dataclass(frozen=True)
class Sampled:
    """What `pliant sample` did."""

    facts: dict[str, Any]  #: its JSON
    ensemble: Path


def sampled(file: str | os.PathLike[str], folder: Path, options: Sequence[str]) -> Sampled:
    """Samples FILE into folder/ensemble.h5md, replacing what is there.

    In a process of its own, so that frames go to the file one by one, however large the molecule.
    Raises InputError with what `pliant sample` said where it fails.
    """
    ensemble = folder / "ensemble.h5md"
    words = ["sample", os.fspath(file), "-o", str(ensemble), "--overwrite", "--json", *options]
    shown = sys.stderr.isatty()  # its progress bar
    ended = subprocess.run(
        [command_path(), *words], stdout=subprocess.PIPE, stderr=None if shown else subprocess.PIPE
    )
    if ended.returncode not in DONE:
        raise InputError(_last_line(ended.stderr) or "pliant sample failed, as said above")
    return Sampled(json.loads(ended.stdout), ensemble)


def _last_line(errors: bytes | None) -> str:
    """What a command said when it failed, without the name of the command."""
    lines = (errors or b"").decode(errors="replace").strip().splitlines()
    return lines[-1].rpartition("error: ")[2] if lines else ""
