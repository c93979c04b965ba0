# SPDX-License-Identifier: MIT
"""``pliant lab experiment report`` and ``pliant lab experiment sweep``, on the command line."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from pliant.base import console
from pliant.lab.experiment.options import add_running
from pliant.lab.experiment.pool import usable_cores

if TYPE_CHECKING:
    from pliant.lab.experiment.settled import Settled

REPORT_EPILOG = """\
Writes report.html, which needs no other file, figures/ and sweep.csv into DIR. A sweep.csv that
exists is used again.

Exit code: 0 if the report is written, 1 if the table cannot be read, a file cannot be written or a
question could not be answered, 2 for a bad option.

examples:
  pliant lab experiment report study
  pliant lab experiment report study --no-questions --no-sweep
"""

SWEEP_EPILOG = """\
Writes sweep.csv into DIR: how many of a claim's statements hold, for each setting, claim and
yardstick. pliant lab experiment report draws it.

examples:
  pliant lab experiment sweep study
"""


def make_report_parser() -> console.Parser:
    """The options of pliant lab experiment report."""
    parser = console.Parser(
        "lab experiment report",
        "Draws the thesis' figures from the table of an experiment, judges its sixteen claims on\n"
        "that table and over a range of settings, and answers its open questions. Writes one\n"
        "HTML page.",
        REPORT_EPILOG,
    )
    parser.add_argument("folder", metavar="DIR", type=Path, help="folder of pliant lab experiment")
    parser.add_argument("--no-sweep", action="store_true", help="leave out the range of settings")
    parser.add_argument("--no-questions", action="store_true", help="leave out the open questions")
    parser.add_argument(
        "--quick", action="store_true", help="small sizes: for a look, not to be cited"
    )
    add_running(parser)
    return parser


def make_sweep_parser() -> console.Parser:
    """The options of pliant lab experiment sweep."""
    parser = console.Parser(
        "lab experiment sweep",
        "Repeats the experiment of DIR for a range of tolerances, forces, graph sizes and boxes,\n"
        "and says where each claim of the thesis holds.",
        SWEEP_EPILOG,
    )
    parser.add_argument("folder", metavar="DIR", type=Path, help="folder of pliant lab experiment")
    parser.add_argument(
        "--quick", action="store_true", help="small sizes: for a look, not to be cited"
    )
    add_running(parser)
    return parser


def report_main(words: Sequence[str]) -> int:
    """Runs pliant lab experiment report; returns its exit code."""
    arguments = make_report_parser().parse_args(words)
    return console.run_command("lab experiment report", lambda: _report(arguments))


def sweep_main(words: Sequence[str]) -> int:
    """Runs pliant lab experiment sweep; returns its exit code."""
    arguments = make_sweep_parser().parse_args(words)
    return console.run_command("lab experiment sweep", lambda: _sweep(arguments))


def _report(arguments: argparse.Namespace) -> int:
    from pliant.lab.experiment import sections
    from pliant.lab.experiment.choices import Choices
    from pliant.lab.experiment.report import make_report

    workers = arguments.workers or usable_cores()
    choices = Choices(
        sweep=not arguments.no_sweep,
        questions=not arguments.no_questions,
        quick=arguments.quick,
        workers=workers,
        progress=lambda what: console.progress(what, arguments.quiet),
    )
    report = make_report(arguments.folder, choices)
    if arguments.json:
        claims = sections.as_json(report.settled)
        console.print_json(
            {"report": str(report.path), "seconds": report.seconds, "claims": claims}
        )
    else:
        _print_claims(report.settled)
        _warn_of_open(report.settled)
        print(f"\n{console.printable_name(report.path)}  ({report.seconds:.0f} s)")
    return console.EXIT_FAILED if report.failed_questions else console.EXIT_OK


def _print_claims(settled: Sequence[Settled]) -> None:
    from pliant.lab.experiment.settled import settings_text

    table = console.Table(
        "claims of the thesis",
        ["id", "verdict", "settings", "depends on"],
        text_columns=(0, 1, 2, 3),
    )
    for one in settled:
        table.rows.append((one.claim.id, one.word, settings_text(one), one.on_what))
    table.print()


def _warn_of_open(settled: Sequence[Settled]) -> None:
    """The sweep that must confirm these was too small, in this report or when it was made."""
    left_open = [one.claim.id for one in settled if one.word == "open"]
    if left_open:
        console.warn(
            f"cannot judge {', '.join(left_open)}: the sweep has too few graphs and forces"
            "; remove sweep.csv and make the report without --quick"
        )


def _sweep(arguments: argparse.Namespace) -> int:
    from pliant.lab.experiment import table as tables
    from pliant.lab.experiment.sweep import SWEEP_CSV, run_sweep

    start = tables.read(arguments.folder).settings
    workers = arguments.workers or usable_cores()
    with console.progress("sweep, settings", arguments.quiet) as show:
        points = run_sweep(start, arguments.folder, workers, arguments.quick, show)
    path = arguments.folder / SWEEP_CSV
    if arguments.json:
        console.print_json({"sweep": str(path), "rows": len(points)})
    else:
        print(f"{console.printable_name(path)}: {len(points)} rows")
    return console.EXIT_OK
