# SPDX-License-Identifier: MIT
"""``pliant lab bench stress``."""

from __future__ import annotations

import argparse

from pliant import OptionError
from pliant.base import console

ORDER = 4
SUMMARY = "every technique and OpenMM on hard cases: far, tiny, huge, redundant, impossible"
DESCRIPTION = """\
Tries every technique on frameworks chosen to break it, each in a child process, and
OpenMM's CCMA on the same ones. Prints how each ended, the worst bar measured again and,
where one fell short, how close to whole least squares can bring all bars. It is a
violation if a process dies, a position is not a number, a pinned joint has moved, or a
technique says 'converged' beyond the tolerance. Violations are named, and the exit code
is then 1."""
EPILOG = """\
examples:
  pliant lab bench stress --only offset
  pliant lab bench stress --technique blocks,bfs_cycle --json > stress.json
"""


def add_options(parser: console.Parser) -> None:
    """Those of this subcommand."""
    from pliant.lab.bench.stress_table import STEPS

    add = parser.add_argument
    add(
        "--only",
        metavar="WORD",
        default="",
        help="only cases with this word in their name or group",
    )
    text = "techniques (default: all)"
    add("--technique", metavar="NAME,...", type=console.words, default=(), help=text)
    text = "weightings of these techniques (default 0.5)"
    add("--weighting", metavar="W,W,...", type=console.positive_numbers, default=(0.5,), help=text)
    text = f"steps of the runs of closed mechanisms (default {STEPS})"
    add("--steps", metavar="N", type=console.whole_number(1), default=STEPS, help=text)
    text = "make the large frameworks N times smaller (default 1)"
    add("--shrink", metavar="N", type=console.whole_number(1), default=1, help=text)
    text = "other programs to measure (default openmm)"
    add("--peers", choices=["openmm", "none"], default="openmm", help=text)


def run(arguments: argparse.Namespace) -> int:
    """Measures and prints; returns the exit code."""
    from pliant.lab.bench.stress import stress
    from pliant.lab.bench.stress_report import print_report
    from pliant.lab.bench.stress_table import all_cases

    cases = all_cases(arguments.shrink, arguments.steps)
    word = arguments.only
    chosen = [case for case in cases if word in case.name or word in case.group]
    if not chosen:
        raise OptionError(f"--only: no case has '{word}' in its name or group")
    with console.progress("cases", arguments.quiet or arguments.json) as show:
        found = stress(
            chosen,
            techniques=arguments.technique,
            weightings=arguments.weighting,
            openmm=arguments.peers == "openmm",
            progress=show,
        )
    console.print_json(found.as_json()) if arguments.json else print_report(found)
    return console.EXIT_FAILED if found.violations else console.EXIT_OK
