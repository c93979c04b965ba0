# SPDX-License-Identifier: MIT
"""``pliant lab bench study``."""

from __future__ import annotations

from typing import Any

from pliant.lab.bench.studying import FRAMES, ROUNDS, Studying, studying
from pliant.lab.options import whole, word

DESCRIPTION = """\
Studies a molecule, without the check by OpenMM, by the command and in this process: seconds
and processor seconds of the whole and of each stage, the least of all rounds. Where an answer
is not the same each time the exit code is 1."""
EPILOG = """\
examples:
  pliant lab bench study protein.pdb
  pliant lab bench study protein.pdb --frames 100 --rounds 3
"""
OPTIONS = {
    "file": word("FILE", "molecule file, as for pliant study"),
    "--frames": whole(4, FRAMES, "number of frames"),
    "--rounds": whole(1, ROUNDS, "number of rounds"),
}


def measure(file: str, progress: Any, **options: Any) -> Studying:
    """All rounds in turn."""
    return studying(file, progress=progress, **options)
