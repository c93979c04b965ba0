# SPDX-License-Identifier: MIT
"""``pliant bench stress``."""

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
  pliant bench stress --cases offset
  pliant bench stress --techniques blocks,bfs_cycle --json > stress.json
"""


def add_options(parser: console.Parser) -> None:
    """Those of this subcommand."""
    from pliant.lab.bench.stress import LIMIT_SECONDS
    from pliant.lab.bench.stress_table import FULL_STEPS, STEPS

    add = parser.add_argument
    add(
        "--cases",
        metavar="WORD",
        default="",
        help="only cases with this word in their name or group",
    )
    text = "techniques (default: all)"
    add("--techniques", metavar="NAME,...", type=console.words, default=(), help=text)
    text = "weightings of these techniques (default 0.5)"
    add("--weightings", metavar="W,W,...", type=console.positive_numbers, default=(0.5,), help=text)
    text = f"steps of the runs of closed mechanisms (default {STEPS})"
    add("--steps", metavar="N", type=console.whole_number(1), default=STEPS, help=text)
    add("--full", action="store_true", help=f"make {FULL_STEPS} steps, which takes hours")
    text = "make the large frameworks N times smaller (default 1)"
    add("--shrink", metavar="N", type=console.whole_number(1), default=1, help=text)
    text = f"seconds for one technique on one case (default {LIMIT_SECONDS:g})"
    add("--time-limit", metavar="S", type=console.positive_number, default=LIMIT_SECONDS, help=text)
    add("--no-openmm", action="store_true", help="leave OpenMM out")


def run(arguments: argparse.Namespace) -> int:
    """Measures and prints; returns the exit code."""
    from pliant.lab.bench.stress import stress
    from pliant.lab.bench.stress_report import print_report
    from pliant.lab.bench.stress_table import FULL_STEPS, all_cases

    cases = all_cases(arguments.shrink, FULL_STEPS if arguments.full else arguments.steps)
    word = arguments.cases
    chosen = [case for case in cases if word in case.name or word in case.group]
    if not chosen:
        raise OptionError(f"--cases: no case has '{word}' in its name or group")
    with console.progress("cases", arguments.quiet or arguments.json) as show:
        found = stress(
            chosen,
            techniques=arguments.techniques,
            weightings=arguments.weightings,
            limit_seconds=arguments.time_limit * (100 if arguments.full else 1),
            openmm=not arguments.no_openmm,
            progress=show,
        )
    console.print_json(found.as_json()) if arguments.json else print_report(found)
    return console.EXIT_FAILED if found.violations else console.EXIT_OK
