# SPDX-License-Identifier: MIT
"""``pliant lab experiment``: techniques on random graphs, their report and sweep."""

from __future__ import annotations

import argparse
import dataclasses
import functools
import sys
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from pliant.base import console
from pliant.base.processes import usual_workers
from pliant.lab.experiment import folders, laboratory
from pliant.lab.experiment import table as tables
from pliant.lab.experiment.settings import Settings
from pliant.lab.experiment.sweep import SWEEP_CSV, run_sweep
from pliant.lab.options import How, flag, number, whole, word

EPILOG = """\
Writes table.csv and table.h5 into DIR: the same options give the same bytes. After a kill at any
moment, the same command continues where it stopped.

pliant lab experiment report DIR   draw the results and judge the claims of the thesis, on a page
pliant lab experiment sweep DIR    find for which tolerances, forces, sizes, boxes each claim holds

Exit code: 0 if the table is complete, 1 if a file cannot be read or written or a test set holds
different results, 2 for a bad option.

examples:
  pliant lab experiment -o study --seed 1
  pliant lab experiment -o study --test-set thesis-set
  pliant lab experiment -o fine --tolerance-length 1e-4 --class 1-cycle-ring --technique bfs_cycle
"""

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

USUAL = Settings()


def several(name: str, text: str, metavar: str = "NAME", kind: Callable[[str], Any] = str) -> How:
    """What may be given several times."""
    text = f"{text}; may be given several times"
    return {"dest": name, "metavar": metavar, "type": kind, "action": "append", "help": text}


#: Fields of Settings; what is not given is as there, or as a test set has it.
SETTINGS: dict[str, How] = {
    "--seed": whole(0, USUAL.seed, "seed of all random numbers"),
    "--graphs": whole(1, USUAL.graphs, "graphs of each class"),
    "--forces": whole(1, USUAL.forces, "forces on each graph, each from the start"),
    "--consecutive": flag(
        "each force acts on what the last one left, as in pliant run; the starts then differ "
        "between techniques"
    ),
    "--class": several("classes", "class of graphs (default: all)"),
    "--technique": several("techniques", "technique (default: all that apply)"),
    "--weighting": several("weightings", "weighting (default 0.5, 0.75, 1)", "W", float),
    "--depth": whole(1, USUAL.depth, "levels of a tree below its root"),
    "--children": whole(1, USUAL.children, "most children of a joint"),
    "--ring": whole(3, USUAL.ring, "most joints of a closed chain"),
    "--cycles": whole(0, USUAL.cycles, "non-tree bars of an n-cycle"),
    "--joints": whole(0, None, "joints of a tree, in place of depth and children"),
    "--box": number(USUAL.box, "edge of the box of positions, Angstrom", "L"),
    "--force": number(USUAL.force, "size of a force, kJ/(mol Angstrom)", "F"),
    "--timestep": number(USUAL.timestep, "length of a step, ps", "T"),
    "--tolerance-length": number(
        USUAL.tolerance_length, "largest |length - rest| of a whole bar, Angstrom", "E"
    ),
    "--max-sweeps": whole(1, USUAL.max_sweeps, "give up after this many sweeps"),
}
EXPERIMENT: dict[str, How] = {
    "-o --output": word(
        "DIR", "folder of the table; an unfinished table is continued", kind=Path, required=True
    ),
    **{name: {**how, "default": None} for name, how in SETTINGS.items()},
    "--test-set": word(
        "FOLDER",
        "take graphs, forces and settings from a test set (pliant lab structgen --test-set) and "
        "write the results into its folders; results already there are compared. If FOLDER does "
        "not exist, it is made from the graphs and forces of this experiment",
        kind=Path,
    ),
}
FOLDER = word("DIR", "folder of pliant lab experiment", kind=Path)
QUICK = flag("small sizes: for a look, not to be cited")
RUNNING: dict[str, How] = {
    "--workers": {
        "metavar": "N",
        "type": console.whole_number(1, most=console.MOST_PROCESSES),
        "help": "number of processes (default: one per core)",
    },
    "--quiet": flag("show no progress"),
    "--json": flag("print the summary as JSON"),
}


@dataclass(frozen=True)
class Command:
    """The command itself, or one below it."""

    description: str
    epilog: str
    options: Mapping[str, How]
    run: Callable[[argparse.Namespace], int]
    common: Sequence[str] = ()  #: options that --help shows


def main(words: Sequence[str] | None = None) -> int:
    """Runs the command; returns its exit code."""
    words = list(sys.argv[1:] if words is None else words)
    name = words.pop(0) if words and words[0] in COMMANDS else ""
    command, title = COMMANDS[name], f"lab experiment {name}".strip()
    parser = console.Parser(title, command.description, command.epilog, command.common)
    for option, how in {**command.options, **RUNNING}.items():
        parser.add_argument(*option.split(), **how)
    arguments = parser.parse_args(words)
    arguments.workers = arguments.workers or usual_workers()
    return console.run_command(title, lambda: command.run(arguments))


def settings_of(arguments: argparse.Namespace, start: Settings | None = None) -> Settings:
    """`start` (default: Settings()) with the options that were given."""
    given: dict[str, Any] = {}
    for field in dataclasses.fields(Settings):
        value = getattr(arguments, field.name, None)
        if value is not None:
            given[field.name] = tuple(value) if isinstance(value, list) else value
    return dataclasses.replace(start or Settings(), **given)


def _experiment(arguments: argparse.Namespace) -> int:
    begin = time.monotonic()
    settings, options = _sources(arguments)
    options["workers"] = arguments.workers
    with console.progress("experiment, graphs", arguments.quiet) as show:
        table = laboratory.run_experiment(settings, arguments.output, show=show, **options)
    filled = folders.fill(arguments.test_set, table) if arguments.test_set else None
    _say(arguments, table, filled, time.monotonic() - begin)
    return console.EXIT_FAILED if filled and filled.different else console.EXIT_OK


def _sources(arguments: argparse.Namespace) -> tuple[Settings, dict[str, Any]]:
    """Settings, and where graphs and forces come from."""
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
    arguments: argparse.Namespace,
    table: tables.Table,
    filled: folders.Filled | None,
    seconds: float,
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


def _report(arguments: argparse.Namespace) -> int:
    from pliant.lab.experiment.report import make_report  # by matplotlib: the table needs none

    made = make_report(
        arguments.folder,
        sweep=not arguments.no_sweep,
        questions=not arguments.no_questions,
        quick=arguments.quick,
        workers=arguments.workers,
        quiet=arguments.quiet,
    )
    console.print_json(made.as_json()) if arguments.json else made.print_claims()
    return console.EXIT_FAILED if made.failed_questions else console.EXIT_OK


def _sweep(arguments: argparse.Namespace) -> int:
    start = tables.read(arguments.folder).settings
    with console.progress("sweep, settings", arguments.quiet) as show:
        points = run_sweep(start, arguments.folder, arguments.workers, arguments.quick, show)
    path = arguments.folder / SWEEP_CSV
    if arguments.json:
        console.print_json({"sweep": str(path), "rows": len(points)})
    else:
        print(f"{console.printable_name(path)}: {len(points)} rows")
    return console.EXIT_OK


COMMANDS = {
    "": Command(
        "Applies the same random forces to the same random graphs, restores the broken bars with\n"
        "every technique and weighting, and writes one tidy table (thesis, chapter 5).",
        EPILOG,
        EXPERIMENT,
        _experiment,
        ("--output", "--graphs", "--technique", "--test-set", "--seed"),
    ),
    "report": Command(
        "Draws the thesis' figures from the table of an experiment, judges its sixteen claims on\n"
        "that table and over a range of settings, and answers its open questions. Writes one\n"
        "HTML page.",
        REPORT_EPILOG,
        {
            "folder": FOLDER,
            "--no-sweep": flag("leave out the range of settings"),
            "--no-questions": flag("leave out the open questions"),
            "--quick": QUICK,
        },
        _report,
    ),
    "sweep": Command(
        "Repeats the experiment of DIR for a range of tolerances, forces, graph sizes and boxes,\n"
        "and says where each claim of the thesis holds.",
        SWEEP_EPILOG,
        {"folder": FOLDER, "--quick": QUICK},
        _sweep,
    ),
}

if __name__ == "__main__":
    sys.exit(main())
