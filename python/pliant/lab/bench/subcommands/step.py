# SPDX-License-Identifier: MIT
"""``pliant bench step``."""

from __future__ import annotations

import argparse

from pliant import console

ORDER = 5
SUMMARY = "cost of a step after a push of one joint, with 10^4 and with 10^6 joints"
DESCRIPTION = """\
Runs large frameworks for many steps with one joint pushed in each, small and large
frameworks by turns. Times are those of push and resolve in the run's own summary,
without recording. The ratio is that of the medians, and its range that of the
quartiles. Techniques that visit only the region of a push cost the same in any size,
except for what no longer fits into the caches of the processor. At the end bars are
measured again. Where one is broken, or a step did not converge, it is named, and the
exit code is 1."""
EPILOG = """\
examples:
  pliant bench step
  pliant bench step --kinds chain --techniques bfs_cycle --sizes 1e3,1e4 --steps 100
"""


def add_options(parser: console.Parser) -> None:
    """Those of this subcommand."""
    from pliant.lab.bench.large_frameworks import KINDS
    from pliant.lab.bench.step import ROUNDS, STEPS, TECHNIQUES

    add = parser.add_argument
    text = "numbers of joints (default 1e4,1e6)"
    add("--sizes", metavar="N,N,...", type=console.positive_numbers, default="1e4,1e6", help=text)
    text = f"kinds of framework: {', '.join(KINDS)} (default protein)"
    add("--kinds", metavar="NAME,...", type=console.words, default=("protein",), help=text)
    text = f"techniques (see pliant techniques; default {','.join(TECHNIQUES)})"
    add("--techniques", metavar="NAME,...", type=console.words, default=TECHNIQUES, help=text)
    text = "weighting of the techniques (default 0.5)"
    add("--weighting", metavar="W", type=console.positive_number, default=0.5, help=text)
    text = "relative tolerance (default 1e-6)"
    add("--tolerance", metavar="T", type=console.positive_number, default=1e-6, help=text)
    text = f"steps of a round (default {STEPS})"
    add("--steps", metavar="N", type=console.whole_number(1), default=STEPS, help=text)
    text = f"number of rounds; the median is reported (default {ROUNDS})"
    add("--rounds", metavar="N", type=console.whole_number(1), default=ROUNDS, help=text)
    add("--csv", metavar="FILE", help="write the rows as CSV")


def run(arguments: argparse.Namespace) -> int:
    """Measures and prints; returns the exit code."""
    from pliant.lab.bench.rows import write_csv
    from pliant.lab.bench.step import print_report, steps_of_pushes

    with console.progress("techniques", arguments.quiet or arguments.json) as show:
        found = steps_of_pushes(
            arguments.sizes,
            kinds=arguments.kinds,
            techniques=arguments.techniques,
            weighting=arguments.weighting,
            tolerance=arguments.tolerance,
            steps=arguments.steps,
            rounds=arguments.rounds,
            progress=show,
        )
    if arguments.csv:
        write_csv(found.rows, arguments.csv)
    console.print_json(found.as_json()) if arguments.json else print_report(found)
    return console.EXIT_FAILED if found.faults else console.EXIT_OK
