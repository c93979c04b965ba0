# SPDX-License-Identifier: MIT
"""The table of what pliant bench measures: one row, one function for its options, one to run it."""

from __future__ import annotations

import argparse
from collections.abc import Callable
from dataclasses import dataclass

from pliant import OptionError, console
from pliant._extras import need


@dataclass(frozen=True)
class Subcommand:
    """A row of the table."""

    name: str
    summary: str
    description: str
    epilog: str
    add_options: Callable[[console.Parser], None]
    run: Callable[[argparse.Namespace], int]  #: returns the exit code


def numbers(text: str) -> tuple[float, ...]:
    """For ``type=``: numbers above 0 between commas."""
    try:
        return tuple(console.positive_number(word) for word in text.split(","))
    except argparse.ArgumentTypeError:
        wanted = "numbers above 0 between commas"
        raise argparse.ArgumentTypeError(f"expected {wanted}, found '{text}'") from None


def names(text: str) -> tuple[str, ...]:
    """For ``type=``: words between commas."""
    return tuple(word for word in text.split(",") if word)


def _race_options(parser: console.Parser) -> None:
    from pliant.lab.bench.work_precision import LIMIT_SECONDS, REPEATS

    add = parser.add_argument
    add("file", metavar="FILE", help="molecule, as of pliant run")
    add("--bars", choices=["bonds", "angles"], default="bonds",
        help="what becomes a bar (default bonds)")  # fmt: skip
    add("--displacement", metavar="A", type=console.positive_number, default=0.1,
        help="Angstrom, standard deviation of each coordinate (default 0.1)")  # fmt: skip
    add("--seed", metavar="N", type=console.whole_number(0), default=0,
        help="of the displacement (default 0)")  # fmt: skip
    add("--tolerances", metavar="T,T,...", type=numbers,
        default=",".join(f"1e-{k}" for k in range(2, 13)),
        help="relative, tried from the largest (default 1e-2,1e-3,...,1e-12)")  # fmt: skip
    add("--techniques", metavar="NAME,...", type=names, default=(),
        help="of pliant techniques (default: all)")  # fmt: skip
    add("--repeats", metavar="N", type=console.whole_number(1), default=REPEATS,
        help=f"rounds, of which the median counts (default {REPEATS})")  # fmt: skip
    add("--time-limit", metavar="S", type=console.positive_number, default=LIMIT_SECONDS,
        help=f"seconds for one technique at one tolerance (default {LIMIT_SECONDS:g})")  # fmt: skip
    add("--mass-weighted", action="store_true", help="share corrections by inverse masses too")
    add("--no-openmm", action="store_true", help="leave OpenMM out")
    add("--no-gromacs", action="store_true", help="leave GROMACS out")
    add("--csv", metavar="FILE", help="write the rows as CSV")
    add("--png", metavar="FILE", help="draw run time against error")


def _race(arguments: argparse.Namespace) -> int:
    from pliant.lab.bench.rows import write_csv
    from pliant.lab.bench.work_precision import work_precision
    from pliant.lab.bench.work_precision_report import print_report

    if arguments.png:
        need("a picture of pliant bench", "matplotlib", extra="lab")
    with console.progress("race", arguments.quiet or arguments.json) as show:
        found = work_precision(
            arguments.file,
            bars=arguments.bars,
            displacement=arguments.displacement,
            seed=arguments.seed,
            tolerances=arguments.tolerances,
            techniques=arguments.techniques,
            repeats=arguments.repeats,
            limit_seconds=arguments.time_limit,
            mass_weighted=arguments.mass_weighted,
            openmm=not arguments.no_openmm,
            gromacs=not arguments.no_gromacs,
            progress=show,
        )
    if arguments.csv:
        write_csv(found.rows, arguments.csv)
    if arguments.png:
        from pliant.lab.bench.work_precision_picture import draw

        draw(found, arguments.png)
    if arguments.json:
        console.print_json(found.as_json())
    else:
        print_report(found)
    return console.EXIT_OK


def _scaling_options(parser: console.Parser) -> None:
    from pliant.lab.bench.large_frameworks import KINDS
    from pliant.lab.bench.scaling import LIMIT_SECONDS

    add = parser.add_argument
    add("--sizes", metavar="N,N,...", type=numbers, default="1e3,1e4,1e5,1e6,1e7",
        help="joints (default 1e3,1e4,1e5,1e6,1e7)")  # fmt: skip
    add("--kinds", metavar="NAME,...", type=names, default=tuple(KINDS),
        help=f"of {', '.join(KINDS)} (default: all)")  # fmt: skip
    add("--technique", metavar="NAME", default="",
        help="of pliant techniques (default: auto where there is one, else blocks)")  # fmt: skip
    add("--weighting", metavar="W", type=console.positive_number, default=0.5,
        help="of the technique (default 0.5)")  # fmt: skip
    add("--tolerance", metavar="T", type=console.positive_number, default=1e-6,
        help="relative (default 1e-6)")  # fmt: skip
    add("--repeats", metavar="N", type=console.whole_number(1), default=3,
        help="repairs, of which the median counts (default 3)")  # fmt: skip
    add("--time-limit", metavar="S", type=console.positive_number, default=LIMIT_SECONDS,
        help=f"seconds for one size of one kind (default {LIMIT_SECONDS:g})")  # fmt: skip


def _scaling(arguments: argparse.Namespace) -> int:
    from pliant.lab.bench.scaling import print_report, scaling

    with console.progress("sizes", arguments.quiet or arguments.json) as show:
        found = scaling(
            arguments.sizes,
            kinds=arguments.kinds,
            technique=arguments.technique,
            weighting=arguments.weighting,
            tolerance=arguments.tolerance,
            repeats=arguments.repeats,
            limit_seconds=arguments.time_limit,
            progress=show,
        )
    console.print_json(found.as_json()) if arguments.json else print_report(found)
    return console.EXIT_FAILED if found.faults else console.EXIT_OK


def _throughput_options(parser: console.Parser) -> None:
    from pliant.lab.bench.throughput import CONFORMERS, REPEATS, TECHNIQUES, THREADS

    add = parser.add_argument
    add("file", metavar="FILE", help="molecule, as of pliant run")
    add("--bars", choices=["bonds", "angles"], default="bonds",
        help="what becomes a bar (default bonds)")  # fmt: skip
    add("--techniques", metavar="NAME,...", type=names, default=TECHNIQUES,
        help=f"of pliant techniques (default {','.join(TECHNIQUES)})")  # fmt: skip
    add("--weighting", metavar="W", type=console.positive_number, default=1.0,
        help="of the techniques (default 1)")  # fmt: skip
    add("--tolerance", metavar="T", type=console.positive_number, default=1e-6,
        help="relative (default 1e-6)")  # fmt: skip
    add("--displacement", metavar="A", type=console.positive_number, default=0.1,
        help="Angstrom, standard deviation of each coordinate (default 0.1)")  # fmt: skip
    add("--threads", metavar="N,N,...", type=numbers, default=THREADS,
        help="(default 1,2)")  # fmt: skip
    add("--conformers", metavar="N", type=console.whole_number(1), default=CONFORMERS,
        help=f"broken copies for each thread (default {CONFORMERS})")  # fmt: skip
    add("--repeats", metavar="N", type=console.whole_number(1), default=REPEATS,
        help=f"rounds, of which the median counts (default {REPEATS})")  # fmt: skip
    add("--csv", metavar="FILE", help="write the rows as CSV")
    add("--without-openmm", action="store_true", help="time our techniques alone")


def _throughput(arguments: argparse.Namespace) -> int:
    from pliant.lab.bench.rows import write_csv
    from pliant.lab.bench.throughput import print_report, throughput

    found = throughput(
        arguments.file,
        bars=arguments.bars,
        techniques=arguments.techniques,
        weighting=arguments.weighting,
        tolerance=arguments.tolerance,
        displacement=arguments.displacement,
        threads=tuple(round(count) for count in arguments.threads),
        conformers=arguments.conformers,
        repeats=arguments.repeats,
        openmm=not arguments.without_openmm,
    )
    if arguments.csv:
        write_csv(found.rows, arguments.csv)
    console.print_json(found.as_json()) if arguments.json else print_report(found)
    return console.EXIT_FAILED if found.wrong() else console.EXIT_OK


def _stress_options(parser: console.Parser) -> None:
    from pliant.lab.bench.stress import LIMIT_SECONDS
    from pliant.lab.bench.stress_table import FULL_STEPS, STEPS

    add = parser.add_argument
    add("--cases", metavar="WORD", default="", help="only cases whose name or group has this word")
    add("--techniques", metavar="NAME,...", type=names, default=(),
        help="of pliant techniques (default: all)")  # fmt: skip
    add("--weightings", metavar="W,W,...", type=numbers, default=(0.5,),
        help="of these techniques (default 0.5)")  # fmt: skip
    add("--steps", metavar="N", type=console.whole_number(1), default=STEPS,
        help=f"of the runs of closed mechanisms (default {STEPS})")  # fmt: skip
    add("--full", action="store_true", help=f"{FULL_STEPS} steps: hours")
    add("--shrink", metavar="N", type=console.whole_number(1), default=1,
        help="make the large frameworks so many times smaller (default 1)")  # fmt: skip
    add("--time-limit", metavar="S", type=console.positive_number, default=LIMIT_SECONDS,
        help=f"seconds for one technique on one case (default {LIMIT_SECONDS:g})")  # fmt: skip
    add("--no-openmm", action="store_true", help="leave OpenMM out")


def _stress(arguments: argparse.Namespace) -> int:
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


SUBCOMMANDS = (
    Subcommand(
        "work-precision",
        "run time against error: every technique and OpenMM on one broken molecule",
        "Breaks a molecule once. Every technique with every weighting, and OpenMM's CCMA in the\n"
        "same process, repair it to tolerance after tolerance. All take turns, and medians of\n"
        "processor time count, so that what else the machine does falls on all. Errors are\n"
        "measured anew in double precision. Who takes too long or does not get there is told, and\n"
        "asked no more. CCMA runs twice: as Context.applyConstraints has it, which sees what the\n"
        "techniques see, and as in dynamics, where it is told the intact structure. Where gmx or\n"
        "gmx_d is installed, LINCS and SHAKE of GROMACS' mdrun take part, as in dynamics: times\n"
        "are those of its log for constraints, errors those of its trajectory, and of the\n"
        "settings of LINCS the quickest that meets a tolerance counts.",
        "examples:\n"
        "  pliant bench work-precision protein.pdb --png race.png --csv race.csv\n"
        "  pliant bench work-precision protein.pdb --bars angles --techniques blocks,bfs_reverse\n",
        _race_options,
        _race,
    ),
    Subcommand(
        "scaling",
        "time and memory from a thousand to ten million joints",
        "Repairs chains, branched trees and protein-like frameworks of growing size, each in a\n"
        "process of its own: time for a bar, bytes for a joint or bar (growth of resident\n"
        "memory), and the exponent with which time grows, with its confidence. Sizes that do not\n"
        "fit into the memory that is free are told and left out.",
        "examples:\n"
        "  pliant bench scaling --sizes 1e3,1e4,1e5\n"
        "  pliant bench scaling --technique bfs_cycle --weighting 1 --kinds chain,tree\n",
        _scaling_options,
        _scaling,
    ),
    Subcommand(
        "throughput",
        "conformers made whole in a second, on one and on several threads",
        "Breaks a molecule into many copies and makes them whole, on one thread and on several,\n"
        "each with copies and plans of its own; wall time. That the same bits come out of one\n"
        "thread and of several is looked at too.",
        "example:\n  pliant bench throughput protein.pdb --tolerance 1e-10\n",
        _throughput_options,
        _throughput,
    ),
    Subcommand(
        "stress",
        "every technique, and OpenMM, on what is hard: far, tiny, huge, redundant, impossible",
        "Tries every technique on frameworks chosen to break it, each in a child process, and\n"
        "OpenMM's CCMA on the same. Told are the outcome, the worst bar measured anew, and where\n"
        "someone fell short how nearly least squares can make all bars whole. A process that\n"
        "dies, a position that is no number, a pinned joint that moved, or 'converged' beyond the\n"
        "tolerance is a violation: it is named, and the exit code is 1.",
        "examples:\n"
        "  pliant bench stress --cases offset\n"
        "  pliant bench stress --techniques blocks,bfs_cycle --json > stress.json\n",
        _stress_options,
        _stress,
    ),
)
