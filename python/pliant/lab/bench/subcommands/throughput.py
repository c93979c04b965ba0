# SPDX-License-Identifier: MIT
"""``pliant lab bench throughput``."""

from __future__ import annotations

import argparse

from pliant.base import console

ORDER = 3
SUMMARY = "conformers made whole per second, on one thread and on several"
DESCRIPTION = """\
Breaks copies of a molecule and repairs them on one thread and on several, each with its
own copies and plans. Times are wall times. It also checks that one thread
and several give the same bits.

With --frames it makes frames of pliant sample instead, of one protein or of many, each with
polar and with all hydrogens: milliseconds of a core, and how they grow with the number of
atoms. Every frame is measured again; where one is broken the exit code is 1."""
EPILOG = """\
examples:
  pliant lab bench throughput protein.pdb --tolerance 1e-10
  pliant lab bench throughput adk_open.pdb adk_closed.pdb --frames 200
"""


def add_options(parser: console.Parser) -> None:
    """Those of this subcommand."""
    from pliant.lab.bench.frames import SAMPLER
    from pliant.lab.bench.throughput import REPEATS, TECHNIQUES, THREADS

    add = parser.add_argument
    text = "molecule file, as for pliant run; several with --frames"
    add("files", metavar="FILE", nargs="+", help=text)
    text = "make N frames of pliant sample instead"
    add("--frames", metavar="N", type=console.whole_number(2), help=text)
    text = f"with --frames: see pliant.samplers() (default {SAMPLER})"
    add("--sampler", metavar="NAME", default=SAMPLER, help=text)
    text = "what becomes a bar (default bonds)"
    add("--bars", choices=["bonds", "angles"], default="bonds", help=text)
    text = f"techniques (see pliant lab techniques; default {','.join(TECHNIQUES)})"
    add("--technique", metavar="NAME,...", type=console.words, default=TECHNIQUES, help=text)
    text = "weighting of the techniques (default 1)"
    add("--weighting", metavar="W", type=console.positive_number, default=1.0, help=text)
    text = "relative tolerance (default 1e-6)"
    add("--tolerance", metavar="T", type=console.positive_number, default=1e-6, help=text)
    text = "standard deviation of each coordinate, Angstrom (default 0.1)"
    add("--displacement", metavar="A", type=console.positive_number, default=0.1, help=text)
    text = "numbers of threads (default 1,2)"
    add("--threads", metavar="N,N,...", type=console.positive_numbers, default=THREADS, help=text)
    text = f"number of rounds; the median is reported (default {REPEATS})"
    add("--repeats", metavar="N", type=console.whole_number(1), default=REPEATS, help=text)
    add("--csv", metavar="FILE", help="write the rows as CSV")
    text = "other programs to measure (default openmm)"
    add("--peers", choices=["openmm", "none"], default="openmm", help=text)


def run(arguments: argparse.Namespace) -> int:
    """Measures and prints; returns the exit code."""
    import pliant

    if arguments.frames is not None:
        return _run_frames(arguments)
    if len(arguments.files) > 1:
        raise pliant.OptionError("several files need --frames")
    from pliant.lab.bench.rows import write_csv
    from pliant.lab.bench.throughput import print_report, throughput

    found = throughput(
        arguments.files[0],
        bars=arguments.bars,
        techniques=arguments.technique,
        weighting=arguments.weighting,
        tolerance=arguments.tolerance,
        displacement=arguments.displacement,
        threads=tuple(round(count) for count in arguments.threads),
        repeats=arguments.repeats,
        openmm=arguments.peers == "openmm",
    )
    if arguments.csv:
        write_csv(found.rows, arguments.csv)
    console.print_json(found.as_json()) if arguments.json else print_report(found)
    return console.EXIT_FAILED if found.wrong() else console.EXIT_OK


def _run_frames(arguments: argparse.Namespace) -> int:
    from pliant.lab.bench.frames import frame_costs, print_report
    from pliant.lab.bench.rows import write_csv

    with console.progress("rounds", arguments.quiet or arguments.json) as show:
        found = frame_costs(
            arguments.files,
            sampler=arguments.sampler,
            frames=arguments.frames,
            rounds=arguments.repeats,
            progress=show,
        )
    if arguments.csv:
        write_csv(found.rows, arguments.csv)
    console.print_json(found.as_json()) if arguments.json else print_report(found)
    return console.EXIT_FAILED if found.faults else console.EXIT_OK
