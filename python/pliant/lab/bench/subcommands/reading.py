# SPDX-License-Identifier: MIT
"""``pliant lab bench reading``."""

from __future__ import annotations

from typing import Any

from pliant.lab.bench.reading import FRAMES, REPEATS, Reading, reading
from pliant.lab.options import whole, word

DESCRIPTION = """\
Records copies of a molecule, each moved a little, as an H5MD file of Pliant and as a DCD
file, and lets MDAnalysis read both, frame by frame: microseconds of processor time, the
least of all rounds. Where positions differ by a bit the exit code is 1."""
EPILOG = """\
examples:
  pliant lab bench reading protein.pdb
  pliant lab bench reading small.pdb large.pdb --frames 10000
"""
OPTIONS = {
    "files": word("FILE", "molecule files, as for pliant run", nargs="+"),
    "--frames": whole(2, FRAMES, "number of frames"),
    "--repeats": whole(1, REPEATS, "number of rounds"),
}


def measure(files: list[str], progress: Any, **options: Any) -> Reading:
    """All files in turn."""
    return reading(files, **options)
