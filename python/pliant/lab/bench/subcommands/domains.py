# SPDX-License-Identifier: MIT
"""``pliant lab bench domains``."""

from __future__ import annotations

import argparse

from pliant.base import console

ORDER = 8
SUMMARY = "whether reported domains repeat between seeds, and are those of known pairs"
DESCRIPTION = """\
Takes pairs of known structures of one protein. From each of the two, ensembles of several seeds are
made (pliant sample --sampler modes), and domains found as pliant analyse reports them. No seed
should contradict another, and the domains should be those that turn between the two structures by
DynDom's criterion (Hayward and Berendsen 1998). Each pair is a subfolder of --data with two files
(PDB or mmCIF); those with a local.json are pockets and are left out."""
EPILOG = """\
examples:
  pliant lab bench domains --data pairs
  pliant lab bench domains --data pairs --repeats 3 --also 4E43.pdb,1hvr.pdb --csv domains.csv"""


def add_options(parser: console.Parser) -> None:
    """Those of this subcommand."""
    add = parser.add_argument
    add("--data", metavar="FOLDER", required=True, help="folder of subfolders with two structures")
    add("--also", metavar="FILE,...", type=console.words, default=(),
        help="structures without a pair, to compare seeds only")  # fmt: skip
    add("--repeats", metavar="N", type=console.whole_number(1), default=10,
        help="ensembles of different seeds that are compared (default 10)")  # fmt: skip
    add("--frames", metavar="N", type=console.whole_number(4), default=200,
        help="frames of each ensemble (default 200)")  # fmt: skip
    add("--workers", metavar="N", type=console.whole_number(1), default=1,
        help="processes that share the structures (default 1)")  # fmt: skip
    add("--csv", metavar="FILE", help="write a row for each structure as CSV")


def run(arguments: argparse.Namespace) -> int:
    """Measures and prints; returns the exit code."""
    from pliant.base.extras import need

    need("pliant lab bench domains", "scipy")
    from pliant.lab.bench.rows import write_csv
    from pliant.lab.domains.measure import domains
    from pliant.lab.domains.report import print_report

    with console.progress("structures", arguments.quiet or arguments.json) as show:
        table = domains(
            arguments.data,
            arguments.repeats,
            arguments.frames,
            arguments.also,
            processes=arguments.workers,
            progress=show,
        )
    if arguments.csv:
        write_csv(table.rows, arguments.csv)
    console.print_json(table.as_json()) if arguments.json else print_report(table)
    return console.EXIT_OK
