# SPDX-License-Identifier: MIT
"""``pliant bench auto``."""

from __future__ import annotations

import argparse

from pliant import console

ORDER = 5
SUMMARY = "technique auto against every fixed technique, on every molecule of data/molecules"
DESCRIPTION = """\
Makes a few broken copies of each molecule, with bars for bonds and with bars for angles,
and has auto and every fixed technique with every weighting repair them. Trial runs show
which make every copy whole, as measured independently. The fastest then take turns
in many short rounds. Times are of one repair, by the library's own clock: the call from
Python takes longer than the repair of a small molecule and would distort the ratios.
The exit code is 1 where auto leaves a bar broken that a fixed technique repairs, or a
technique says 'converged' beyond the tolerance; each such case is named. A large ratio
alone is no failure; the worst one is printed last."""
EPILOG = """\
examples:
  pliant bench auto
  pliant bench auto protein.pdb --bars angles --csv auto.csv
"""


def add_options(parser: console.Parser) -> None:
    """Those of this subcommand."""
    from pliant.lab.bench.auto import BARS, COPIES, ROUNDS

    add = parser.add_argument
    add("files", metavar="FILE", nargs="*",
        help="molecules (default: every molecule of data/molecules)")  # fmt: skip
    add("--bars", metavar="NAME,...", type=console.words, default=BARS,
        help=f"what becomes a bar (default {','.join(BARS)})")  # fmt: skip
    add("--tolerances", metavar="T,T,...", type=console.positive_numbers, default="1e-6,1e-10",
        help="relative tolerances (default 1e-6,1e-10)")  # fmt: skip
    add("--displacement", metavar="A", type=console.positive_number, default=0.1,
        help="standard deviation of each coordinate, Angstrom (default 0.1)")  # fmt: skip
    add("--copies", metavar="N", type=console.whole_number(1), default=COPIES,
        help=f"number of broken copies, the same for all (default {COPIES})")  # fmt: skip
    add("--rounds", metavar="N", type=console.whole_number(1), default=ROUNDS,
        help=f"number of rounds; the median is reported (default {ROUNDS})")  # fmt: skip
    add("--seed", metavar="N", type=console.whole_number(0), default=0,
        help="seed of the displacements (default 0)")  # fmt: skip
    add("--csv", metavar="FILE", help="write the rows as CSV")


def run(arguments: argparse.Namespace) -> int:
    """Measures and tells; returns the exit code."""
    from pliant.lab.bench.auto import auto, print_report
    from pliant.lab.bench.rows import write_csv

    with console.progress("races", arguments.quiet or arguments.json) as show:
        found = auto(
            arguments.files,
            bars=arguments.bars,
            tolerances=arguments.tolerances,
            displacement=arguments.displacement,
            copies=arguments.copies,
            rounds=arguments.rounds,
            seed=arguments.seed,
            progress=show,
        )
    if arguments.csv:
        write_csv(found.rows, arguments.csv)
    console.print_json(found.as_json()) if arguments.json else print_report(found)
    return console.EXIT_FAILED if found.faults else console.EXIT_OK
