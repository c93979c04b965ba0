# SPDX-License-Identifier: MIT
"""``pliant lab bench scaling``."""

from __future__ import annotations

import argparse

from pliant.base import console

ORDER = 2
SUMMARY = "time and memory from a thousand to ten million joints"
DESCRIPTION = """\
Repairs chains, branched trees and protein-like frameworks of growing size, each in a
process of its own. Prints the time per bar, the bytes per joint or bar (growth of
resident memory), and the exponent with which time grows, with its confidence interval.
Sizes that do not fit into the free memory are skipped, with a note."""
EPILOG = """\
examples:
  pliant lab bench scaling --sizes 1e3,1e4,1e5
  pliant lab bench scaling --technique bfs_cycle --weighting 1 --kinds chain,tree
"""


def add_options(parser: console.Parser) -> None:
    """Those of this subcommand."""
    from pliant.lab.bench.large_frameworks import KINDS

    add = parser.add_argument
    text, sizes = "numbers of joints (default 1e3,1e4,1e5,1e6,1e7)", "1e3,1e4,1e5,1e6,1e7"
    add("--sizes", metavar="N,N,...", type=console.positive_numbers, default=sizes, help=text)
    text = f"kinds of framework: {', '.join(KINDS)} (default: all)"
    add("--kinds", metavar="NAME,...", type=console.words, default=tuple(KINDS), help=text)
    text = "technique (default: auto where there is one, else blocks)"
    add("--technique", metavar="NAME", default="", help=text)
    text = "weighting of the technique (default 0.5)"
    add("--weighting", metavar="W", type=console.positive_number, default=0.5, help=text)
    text = "relative tolerance (default 1e-6)"
    add("--tolerance", metavar="T", type=console.positive_number, default=1e-6, help=text)
    text = "number of repairs; the median is reported (default 3)"
    add("--repeats", metavar="N", type=console.whole_number(1), default=3, help=text)


def run(arguments: argparse.Namespace) -> int:
    """Measures and prints; returns the exit code."""
    from pliant.lab.bench.scaling import print_report, scaling

    with console.progress("sizes", arguments.quiet or arguments.json) as show:
        found = scaling(
            arguments.sizes,
            kinds=arguments.kinds,
            technique=arguments.technique,
            weighting=arguments.weighting,
            tolerance=arguments.tolerance,
            repeats=arguments.repeats,
            progress=show,
        )
    console.print_json(found.as_json()) if arguments.json else print_report(found)
    return console.EXIT_FAILED if found.faults else console.EXIT_OK
