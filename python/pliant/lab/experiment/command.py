# SPDX-License-Identifier: MIT
"""``pliant lab experiment``: techniques on random graphs, on the command line."""

from __future__ import annotations

import argparse
import dataclasses
import functools
import sys
import time
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from pliant.base import console
from pliant.lab.experiment.options import add_running
from pliant.lab.experiment.pool import usable_cores
from pliant.lab.experiment.settings import Settings

if TYPE_CHECKING:
    from pliant.lab.experiment.folders import Filled
    from pliant.lab.experiment.table import Table

EPILOG = """\
Writes table.csv and table.h5 into DIR (the same options give the same bytes), and the wall time of
each resolve into seconds.csv and seconds.h5: paste -d, DIR/table.csv DIR/seconds.csv. After a kill
at any moment, the same command continues where it stopped.

pliant lab experiment report DIR   draw the results and judge the claims of the thesis, on a page
pliant lab experiment sweep DIR    find for which tolerances, forces, sizes, boxes each claim holds

Exit code: 0 if the table is complete, 1 if a file cannot be read or written or a test set holds
different results, 2 for a bad option.

examples:
  pliant lab experiment -o study --seed 1
  pliant lab experiment -o study --test-set thesis-set
  pliant lab experiment -o fine --tolerance-length 1e-4 --class 1-cycle-ring --technique bfs_cycle
"""

#: options that --help shows
COMMON = ("--output", "--graphs", "--technique", "--test-set", "--seed")


def make_parser() -> console.Parser:
    """The options of pliant lab experiment."""
    parser = console.Parser(
        "lab experiment",
        "Applies the same random forces to the same random graphs, restores the broken bars with\n"
        "every technique and weighting, and writes one tidy table (thesis, chapter 5).",
        EPILOG,
        COMMON,
    )
    text = "folder of the table; an unfinished table is continued"
    parser.add_argument("-o", "--output", metavar="DIR", type=Path, required=True, help=text)
    _add_counts(parser)
    _add_sizes(parser)
    _add_forces(parser)
    _add_test_set(parser)
    add_running(parser)
    return parser


def _add_counts(parser: console.Parser) -> None:
    add = parser.add_argument
    default = Settings()
    whole = console.whole_number
    add(
        "--seed",
        metavar="S",
        type=whole(0),
        help=f"seed of all random numbers (default {default.seed})",
    )
    add(
        "--graphs",
        metavar="N",
        type=whole(1),
        help=f"graphs of each class (default {default.graphs})",
    )
    text = f"forces on each graph, each from the start (default {default.forces})"
    add("--forces", metavar="N", type=whole(1), help=text)
    add(
        "--consecutive",
        action="store_true",
        default=None,
        help="each force acts on what the last one left, as in pliant run; the starts then "
        "differ between techniques",
    )
    text = "class of graphs; may be given several times (default: all)"
    add("--class", dest="classes", metavar="NAME", action="append", help=text)
    text = "technique; may be given several times (default: all that apply)"
    add("--technique", dest="techniques", metavar="NAME", action="append", help=text)
    text = "weighting; may be given several times (default 0.5, 0.75, 1)"
    add("--weighting", dest="weightings", metavar="W", type=float, action="append", help=text)


def _add_sizes(parser: console.Parser) -> None:
    add = parser.add_argument
    default = Settings()
    whole = console.whole_number
    text = f"levels of a tree below its root (default {default.depth})"
    add("--depth", type=whole(1), metavar="N", help=text)
    text = f"most children of a joint (default {default.children})"
    add("--children", type=whole(1), metavar="N", help=text)
    text = f"most joints of a closed chain (default {default.ring})"
    add("--ring", type=whole(3), metavar="N", help=text)
    text = f"non-tree bars of an n-cycle (default {default.cycles})"
    add("--cycles", type=whole(0), metavar="N", help=text)
    text = "joints of a tree, in place of depth and children"
    add("--joints", type=whole(0), metavar="N", help=text)
    text = f"edge of the box of positions, Angstrom (default {default.box:g})"
    add("--box", type=console.positive_number, metavar="L", help=text)


def _add_forces(parser: console.Parser) -> None:
    add = parser.add_argument
    default = Settings()
    positive = console.positive_number
    text = f"size of a force, kJ/(mol Angstrom) (default {default.force:g})"
    add("--force", type=positive, metavar="F", help=text)
    add(
        "--timestep",
        type=positive,
        metavar="T",
        help=f"length of a step, ps (default {default.timestep:g})",
    )
    text = (
        f"largest |length - rest| of a whole bar, Angstrom (default {default.tolerance_length:g})"
    )
    add("--tolerance-length", type=positive, metavar="E", help=text)
    text = f"give up after this many sweeps (default {default.max_sweeps})"
    add("--max-sweeps", type=console.whole_number(1), metavar="N", help=text)


def _add_test_set(parser: console.Parser) -> None:
    add = parser.add_argument
    add(
        "--test-set",
        metavar="FOLDER",
        type=Path,
        help="take graphs, forces and settings from a test set (pliant lab structgen --test-set) "
        "and write the results into its folders; results already there are compared. If FOLDER "
        "does not exist, it is made from the graphs and forces of this experiment",
    )


def main(words: Sequence[str] | None = None) -> int:
    """Runs the command; returns its exit code."""
    words = list(sys.argv[1:] if words is None else words)
    if words[:1] in (["report"], ["sweep"]):
        from pliant.lab.experiment import report_command

        run = report_command.report_main if words[0] == "report" else report_command.sweep_main
        return run(words[1:])
    arguments = make_parser().parse_args(words)
    return console.run_command("lab experiment", lambda: _experiment(arguments))


def settings_of(arguments: argparse.Namespace, start: Settings | None = None) -> Settings:
    """`start` (default: Settings()) with the options that were given."""
    given: dict[str, Any] = {}
    for field in dataclasses.fields(Settings):
        value = getattr(arguments, field.name, None)
        if value is not None:
            given[field.name] = tuple(value) if isinstance(value, list) else value
    return dataclasses.replace(start or Settings(), **given)


def _experiment(arguments: argparse.Namespace) -> int:
    from pliant.lab.experiment import folders, laboratory

    begin = time.monotonic()
    settings, options = _sources(arguments)
    options["workers"] = arguments.workers or usable_cores()
    with console.progress("experiment, graphs", arguments.quiet) as show:
        table = laboratory.run_experiment(settings, arguments.output, show=show, **options)
    filled = folders.fill(arguments.test_set, table) if arguments.test_set else None
    _say(arguments, table, filled, time.monotonic() - begin)
    return console.EXIT_FAILED if filled and filled.different else console.EXIT_OK


def _sources(arguments: argparse.Namespace) -> tuple[Settings, dict[str, Any]]:
    """Settings, and where graphs and forces come from."""
    from pliant.lab.experiment import folders

    folder: Path | None = arguments.test_set
    of_the_set = ("graphs", "forces", "classes", "consecutive", *folders.OF_THE_SET)
    is_said = any(getattr(arguments, name, None) is not None for name in of_the_set)
    if folder is None or is_said or not folder.exists():
        settings = settings_of(arguments)
        settings.check()
        if folder is not None:
            (folders.check_set if folder.exists() else folders.make_set)(settings, folder)
        return settings, {}
    settings = settings_of(arguments, folders.settings_of_set(folder))
    source = functools.partial(folders.subject_of_set, folder)
    return settings, {"graphs": folders.graphs_of_set(folder), "source": source}


def _say(
    arguments: argparse.Namespace, table: Table, filled: Filled | None, seconds: float
) -> None:
    count = len(table)
    stuck = int(count - table.columns["converged"].sum())
    if arguments.json:
        report = {"output": str(arguments.output), "resolves": count, "unconverged": stuck}
        report |= {"seconds": seconds, "folders": vars(filled) if filled else None}
        console.print_json(report)
        return
    where = console.printable_name(arguments.output)
    print(f"{where}: {count} resolves, {stuck} of them not converged; {seconds:.1f} s")
    if filled:
        folder = console.printable_name(arguments.test_set)
        print(
            f"{folder}: {filled.written} results written, {filled.same} there already and the "
            f"same, {len(filled.different)} different"
        )
        for path in filled.different:
            console.warn(f"{path}: holds other numbers; they were left")
    print(f"next: pliant lab experiment report {where}")


if __name__ == "__main__":
    sys.exit(main())
