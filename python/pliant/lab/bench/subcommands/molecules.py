# SPDX-License-Identifier: MIT
"""``pliant lab bench molecules``."""

from __future__ import annotations

import argparse

from pliant.base import console

ORDER = 10
SUMMARY = "the loop of the thesis on 30 small molecules, by every technique"
DESCRIPTION = """\
Makes 30 well-known molecules by RDKit, from ethanol to cyclosporin. In each, one random joint after
the other is pushed by a random force, and the bars resolved by every technique, with a bar for each
bond and with bars for the angles too. Each runs in a child process, and has two minutes."""
EPILOG = """\
examples:
  pliant lab bench molecules
  pliant lab bench molecules --only aspirin,C60 --technique auto,bfs_cycle --csv loops.csv"""


def add_options(parser: console.Parser) -> None:
    """Those of this subcommand."""
    from pliant.lab.bench.molecules import STEPS

    add = parser.add_argument
    add("--only", metavar="NAME,...", type=console.words, default=(), help="default: all 30")
    add("--technique", metavar="NAME,...", type=console.words, default=(), help="default: all")
    add("--steps", metavar="N", type=console.whole_number(1), default=STEPS,
        help=f"pushes of each molecule (default {STEPS})")  # fmt: skip
    add("--csv", metavar="FILE", help="write a row for each molecule and technique as CSV")


def run(arguments: argparse.Namespace) -> int:
    """Measures and prints; returns the exit code."""
    from pliant.base.extras import need

    need("pliant lab bench molecules", "rdkit", "openmm")
    import pliant
    from pliant.lab.bench.molecules import molecule_loops, print_report
    from pliant.lab.bench.rows import write_csv
    from pliant.lab.bench.well_known_molecules import MOLECULES

    for option, known in (
        ("only", list(MOLECULES)),
        ("technique", [entry.name for entry in pliant.techniques()]),
    ):
        for name in getattr(arguments, option):
            if name not in known:
                raise pliant.OptionError(f"--{option} {name}: must be one of {', '.join(known)}")
    with console.progress("runs", arguments.quiet or arguments.json) as show:
        found = molecule_loops(
            arguments.only, arguments.technique, steps=arguments.steps, progress=show
        )
    if arguments.csv:
        write_csv(found.rows, arguments.csv)
    console.print_json(found.as_json()) if arguments.json else print_report(found)
    return console.EXIT_OK
