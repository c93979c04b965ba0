# SPDX-License-Identifier: MIT
"""``pliant bench record``."""

from __future__ import annotations

import argparse

from pliant import console

ORDER = 7
SUMMARY = "cost of recording every frame, compared with the run and with plain writing"
DESCRIPTION = """\
Runs a molecule with every frame recorded, and says which share of the run's wall time
the H5MD file took, according to the run's own summary: measuring the frame, gathering
it and writing it. For comparison it writes as many bytes to a plain file, a megabyte at
a time, which is what the file system alone needs. Where a push moves one joint,
technique auto needs a few microseconds, less than copying the frame, so that nearly all
of the time goes into writing. Each file is read back to check the number of frames, the
bits of the last positions, and the bars of some frames. Faults are named, and the exit
code is then 1.

With --formats it writes the frames of an ensemble as H5MD with each option that makes
files smaller, as DCD and as XTC: bytes, times to write and read, and errors."""
EPILOG = """\
examples:
  pliant bench record
  pliant bench record --formats
  pliant bench record protein.pdb --perturb displacement --single --folder /scratch
"""


def add_options(parser: console.Parser) -> None:
    """Those of this subcommand."""
    from pliant.lab.bench.record import PERTURBATIONS, REPEATS, STEPS, TECHNIQUES

    add = parser.add_argument
    add("file", metavar="FILE", nargs="?", default="",
        help="molecule (default: adenylate kinase of MDAnalysisTests)")  # fmt: skip
    add("--perturb", metavar="NAME,...", type=console.words, default=PERTURBATIONS,
        help=f"perturbations of pliant run (default {','.join(PERTURBATIONS)})")  # fmt: skip
    add("--techniques", metavar="NAME,...", type=console.words, default=TECHNIQUES,
        help=f"techniques (see pliant techniques; default {','.join(TECHNIQUES)})")  # fmt: skip
    add("--tolerance", metavar="T", type=console.positive_number, default=1e-6,
        help="relative tolerance (default 1e-6)")  # fmt: skip
    add("--steps", metavar="N", type=console.whole_number(1), default=STEPS,
        help=f"steps of each run (default {STEPS})")  # fmt: skip
    add("--repeats", metavar="N", type=console.whole_number(1), default=REPEATS,
        help=f"number of rounds; the median is reported (default {REPEATS})")  # fmt: skip
    add("--single", action="store_true", help="positions as 32-bit floats")
    add("--compress", action="store_true", help="gzip positions")
    add("--formats", action="store_true",
        help="compare formats: H5MD with its options, DCD, XTC")  # fmt: skip
    add("--folder", metavar="DIR", default=None,
        help="folder for the files, which are removed (default: a temporary one)")  # fmt: skip
    add("--csv", metavar="FILE", help="write the rows as CSV")


def run(arguments: argparse.Namespace) -> int:
    """Measures and tells; returns the exit code."""
    return _formats(arguments) if arguments.formats else _record(arguments)


def _formats(arguments: argparse.Namespace) -> int:
    from pliant.lab.bench.record_formats import print_formats, record_formats
    from pliant.lab.bench.rows import write_csv

    with console.progress("files", arguments.quiet or arguments.json) as show:
        found = record_formats(
            arguments.file, repeats=arguments.repeats, folder=arguments.folder, progress=show
        )
    if arguments.csv:
        write_csv(found.rows, arguments.csv)
    console.print_json(found.as_json()) if arguments.json else print_formats(found)
    return console.EXIT_OK


def _record(arguments: argparse.Namespace) -> int:
    from pliant.lab.bench.record import print_report, record
    from pliant.lab.bench.rows import write_csv

    with console.progress("runs", arguments.quiet or arguments.json) as show:
        found = record(
            arguments.file,
            perturbations=arguments.perturb,
            techniques=arguments.techniques,
            tolerance=arguments.tolerance,
            steps=arguments.steps,
            repeats=arguments.repeats,
            single=arguments.single,
            compress=arguments.compress,
            folder=arguments.folder,
            progress=show,
        )
    if arguments.csv:
        write_csv(found.rows, arguments.csv)
    console.print_json(found.as_json()) if arguments.json else print_report(found)
    return console.EXIT_FAILED if found.faults else console.EXIT_OK
