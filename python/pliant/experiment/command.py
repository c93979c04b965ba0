# SPDX-License-Identifier: MIT
"""``pliant experiment``: techniques on random graphs, on the command line."""

from __future__ import annotations

import argparse
import dataclasses
import sys
import time
from collections.abc import Sequence
from pathlib import Path

from pliant import console
from pliant.experiment.pool import usable_cores
from pliant.experiment.settings import Settings

EPILOG = """\
DIR gets table.csv and table.h5 (the same bytes whenever the options are the same), and the wall
time of each resolve in seconds.csv and seconds.h5: paste -d, DIR/table.csv DIR/seconds.csv.
Killed at any moment, the same command goes on where it was.

pliant experiment report DIR   draws it and judges the claims of the thesis: one HTML page
pliant experiment sweep DIR    where in the range of tolerance, force, size and box each one holds

Exit code: 0 when the table is complete, 1 when a file cannot be read or written, 2 for a bad
option.

examples:
  pliant experiment --out study --seed 1
  pliant experiment --out fine --tolerance-length 1e-4 --class 1-cycle-ring --technique bfs_cycle
"""


def make_parser() -> console.Parser:
    """The options of pliant experiment."""
    parser = console.Parser(
        "experiment",
        "Resolves the same random forces on the same random graphs with every technique and\n"
        "weighting, and writes one tidy table (thesis, chapter 5).",
        EPILOG,
    )
    parser.add_argument("-o", "--out", metavar="DIR", type=Path, required=True,
                        help="folder of the table; an unfinished one is finished")  # fmt: skip
    _add_counts(parser)
    _add_sizes(parser)
    _add_forces(parser)
    add_running(parser)
    return parser


def _add_counts(parser: console.Parser) -> None:
    add = parser.add_argument
    default = Settings()
    whole = console.whole_number
    add("--seed", metavar="S", type=whole(0), help=f"seed of everything (default {default.seed})")
    add("--graphs", metavar="N", type=whole(1), help=f"graphs a class (default {default.graphs})")
    add("--forces", metavar="N", type=whole(1),
        help=f"forces a graph, each from rest (default {default.forces})")  # fmt: skip
    add("--consecutive", action="store_true", default=None,
        help="each force acts where the last one led, as pliant run does; starts then differ "
             "between techniques")  # fmt: skip
    add("--class", dest="classes", metavar="NAME", action="append",
        help="class of graphs; may be repeated (default: all)")  # fmt: skip
    add("--technique", dest="techniques", metavar="NAME", action="append",
        help="technique; may be repeated (default: all that apply)")  # fmt: skip
    add("--weighting", dest="weightings", metavar="W", type=float, action="append",
        help="weighting; may be repeated (default 0.5, 0.75, 1)")  # fmt: skip


def _add_sizes(parser: console.Parser) -> None:
    add = parser.add_argument
    default = Settings()
    whole = console.whole_number
    add("--depth", type=whole(1), metavar="N",
        help=f"levels of a tree below its root (default {default.depth})")  # fmt: skip
    add("--children", type=whole(1), metavar="N",
        help=f"most children of a joint (default {default.children})")  # fmt: skip
    add("--ring", type=whole(3), metavar="N",
        help=f"most joints of a closed chain (default {default.ring})")  # fmt: skip
    add("--cycles", type=whole(0), metavar="N",
        help=f"non-tree bars of an n-cycle (default {default.cycles})")  # fmt: skip
    add("--joints", type=whole(0), metavar="N",
        help="joints of a tree, in place of depth and children")  # fmt: skip
    add("--box", type=console.positive_number, metavar="L",
        help=f"edge of the box of positions, Angstrom (default {default.box:g})")  # fmt: skip


def _add_forces(parser: console.Parser) -> None:
    add = parser.add_argument
    default = Settings()
    positive = console.positive_number
    add("--force", type=positive, metavar="F",
        help=f"size of a force, kJ/(mol Angstrom) (default {default.force:g})")  # fmt: skip
    add("--timestep", type=positive, metavar="T", help=f"ps (default {default.timestep:g})")
    add("--tolerance-length", type=positive, metavar="E",
        help="largest |length - rest| of a whole bar, Angstrom "
             f"(default {default.tolerance_length:g})")  # fmt: skip
    add("--max-sweeps", type=console.whole_number(1), metavar="N",
        help=f"give up after so many (default {default.max_sweeps})")  # fmt: skip


def add_running(parser: console.Parser) -> None:
    """Options on how, not what."""
    parser.add_argument("--workers", metavar="N", type=console.whole_number(1),
                        help="processes (default: one a core)")  # fmt: skip
    parser.add_argument("--quiet", action="store_true", help="show no progress")
    parser.add_argument("--json", action="store_true", help="print the summary as JSON")


def main(words: Sequence[str] | None = None) -> int:
    """Runs the command; returns its exit code."""
    words = list(sys.argv[1:] if words is None else words)
    if words[:1] in (["report"], ["sweep"]):
        from pliant.experiment import report_command

        run = report_command.report_main if words[0] == "report" else report_command.sweep_main
        return run(words[1:])
    arguments = make_parser().parse_args(words)
    return console.run_command("experiment", lambda: _experiment(arguments))


def settings_of(arguments: argparse.Namespace, start: Settings | None = None) -> Settings:
    """`start` (default: Settings()) with the options that were given."""
    given = {}
    for field in dataclasses.fields(Settings):
        value = getattr(arguments, field.name, None)
        if value is not None:
            given[field.name] = tuple(value) if isinstance(value, list) else value
    return dataclasses.replace(start or Settings(), **given)


def _experiment(arguments: argparse.Namespace) -> int:
    from pliant.experiment import laboratory

    workers = arguments.workers or usable_cores()
    begin = time.monotonic()
    settings = settings_of(arguments)
    with console.progress("experiment, graphs", arguments.quiet) as show:
        table = laboratory.run_experiment(settings, arguments.out, workers=workers, show=show)
    _say(arguments, table, time.monotonic() - begin)
    return console.EXIT_OK


def _say(arguments: argparse.Namespace, table, seconds: float) -> None:
    count = len(table)
    stuck = int(count - table.columns["converged"].sum())
    if arguments.json:
        console.print_json({"out": str(arguments.out), "resolves": count, "unconverged": stuck,
                            "seconds": seconds})  # fmt: skip
        return
    print(f"{arguments.out}: {count} resolves, {stuck} of them not converged; {seconds:.1f} s")
    print(f"next: pliant experiment report {arguments.out}")


if __name__ == "__main__":
    sys.exit(main())
