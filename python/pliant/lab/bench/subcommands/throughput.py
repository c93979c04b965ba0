# SPDX-License-Identifier: MIT
"""``pliant lab bench throughput``."""

from __future__ import annotations

from typing import Any

from pliant._core import OptionError
from pliant.lab.bench.frames import SAMPLER, frame_costs
from pliant.lab.bench.scaling import FRAMES, scaling
from pliant.lab.bench.throughput import REPEATS, TECHNIQUES, throughput
from pliant.lab.options import (
    BARS,
    DISPLACEMENT,
    TOLERANCE,
    counts,
    flag,
    names,
    number,
    whole,
    word,
)
from pliant.lab.results import Results

DESCRIPTION = """\
Breaks copies of a molecule and repairs them on one thread and on several, each with its
own copies and plans. Times are wall times. It also checks that one thread
and several give the same bits.

With --frames it makes frames of pliant sample instead, of one protein or of many, each with
polar and with all hydrogens: milliseconds of a core, and how they grow with the number of
atoms. Every frame is measured again; where one is broken the exit code is 1.

With --jobs it times whole commands: frames of modes and of reach and 64 walkers with contacts
of a protein, conformers of a library (SDF, SMILES). How much faster are more threads?"""
EPILOG = """\
examples:
  pliant lab bench throughput protein.pdb --tolerance 1e-10
  pliant lab bench throughput adk_open.pdb adk_closed.pdb --frames 200
  pliant lab bench throughput adk_open.pdb ligands.sdf --jobs --threads 1,2,4,8,16
"""
OPTIONS = {
    "files": word("FILE", "molecule file, as for pliant run; several with --frames", nargs="+"),
    "--frames": whole(2, None, f"make N frames of pliant sample instead (--jobs: {FRAMES})"),
    "--jobs": flag("time whole commands instead"),
    "--sampler": word("NAME", "with --frames: see pliant.samplers()", SAMPLER),
    "--bars": BARS,
    "--technique": names("techniques (see pliant lab techniques)", TECHNIQUES, dest="techniques"),
    "--weighting": number(1.0, "weighting of the techniques", "W"),
    "--tolerance": TOLERANCE,
    "--displacement": DISPLACEMENT,
    "--threads": counts("1,2", "numbers of threads"),
    "--repeats": whole(1, REPEATS, "number of rounds; the median is reported"),
}


def measure(
    files: list[str],
    frames: int | None,
    jobs: bool,
    sampler: str,
    repeats: int,
    progress: Any,
    **options: Any,
) -> Results:
    """Whole jobs or frames of all files, or conformers of one."""
    if jobs:
        return scaling(
            files,
            frames=frames or FRAMES,
            threads=options["threads"],
            rounds=repeats,
            progress=progress,
        )
    if frames is not None:
        return frame_costs(files, sampler=sampler, frames=frames, rounds=repeats, progress=progress)
    if len(files) > 1:
        raise OptionError("several files need --frames")
    return throughput(files[0], repeats=repeats, **options)
