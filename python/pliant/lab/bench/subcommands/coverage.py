# SPDX-License-Identifier: MIT
"""``pliant lab bench coverage``."""

from __future__ import annotations

import argparse

from pliant.base import console

ORDER = 7
SUMMARY = "whether the ensemble of one known structure contains the other, with ANM"
DESCRIPTION = """\
Takes pairs of known structures of one protein. Frames are made from each of the two; does one of
them come near the other? A domain motion is covered by a frame within 3 Angstrom (r.m.s. over
the backbone), a pocket by one within 1.5 (mean distance of the backbone of the pocket, the
rest superposed). Each pair is a subfolder of --data with two files (PDB or mmCIF); pockets have a
local.json with alignment_resid_ranges and metric_resid_ranges. Ensembles: reach, turns and modes
of pliant sample, modes twice as wide, and straight displacements along the modes of ANM and of
our own network, 2.8 Angstrom r.m.s., without repair."""
EPILOG = """\
examples:
  pliant lab bench coverage --data pairs -o coverage.png
  pliant lab bench coverage --data pairs --only reach,ANM --frames 200 --csv coverage.csv"""


def add_options(parser: console.Parser) -> None:
    """Those of this subcommand."""
    add = parser.add_argument
    add("--data", metavar="FOLDER", required=True, help="folder of subfolders with two structures")
    add("--only", metavar="NAME,...", type=console.words, default=(), help="default: all")
    add("--frames", metavar="N,...", type=console.words, default=("200", "1000"),
        help="frames of each ensemble (default 200,1000)")  # fmt: skip
    add("--seed", metavar="N", type=console.whole_number(0), default=0, help="default 0")
    add("--workers", metavar="N", type=console.whole_number(1), default=1,
        help="processes that share the directions (default 1)")  # fmt: skip
    add("--csv", metavar="FILE", help="write a row for each direction as CSV")
    add("-o", "--output", metavar="FILE", help="draw nearest frames by distance (PNG)")


def run(arguments: argparse.Namespace) -> int:
    """Measures and prints; returns the exit code."""
    from pliant.base.extras import need

    need("pliant lab bench coverage", "scipy")
    from pliant._core import OptionError
    from pliant.lab.bench.rows import write_csv
    from pliant.lab.coverage.ensembles import ENSEMBLES
    from pliant.lab.coverage.measure import coverage
    from pliant.lab.coverage.report import print_report

    known = [one.name for one in ENSEMBLES]
    for name in arguments.only:
        if name not in known:
            raise OptionError(f"--only {name}: must be one of {', '.join(known)}")
    frames = []
    for word in arguments.frames:
        if not word.isdigit() or int(word) < 1:
            raise OptionError(f"--frames {word}: must be whole numbers from 1, as in 200,1000")
        frames.append(int(word))
    with console.progress("directions", arguments.quiet or arguments.json) as show:
        found = coverage(
            arguments.data,
            arguments.only,
            frames,
            seed=arguments.seed,
            processes=arguments.workers,
            progress=show,
        )
    if arguments.csv:
        write_csv(found.directions, arguments.csv)
    if arguments.output:
        from pliant.lab.coverage.picture import draw

        draw(found, arguments.output)
    console.print_json(found.as_json()) if arguments.json else print_report(found)
    return console.EXIT_OK
