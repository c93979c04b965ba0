# SPDX-License-Identifier: MIT
"""Rows of the table of pliant bench that measure runs and choices: auto, step, record."""

from __future__ import annotations

import argparse

from pliant import console
from pliant.lab.bench.subcommands import Subcommand, names, numbers


def _auto_options(parser: console.Parser) -> None:
    from pliant.lab.bench.auto import BARS, COPIES, ROUNDS

    add = parser.add_argument
    add("files", metavar="FILE", nargs="*",
        help="molecules (default: every molecule of data/molecules)")  # fmt: skip
    add("--bars", metavar="NAME,...", type=names, default=BARS,
        help=f"what becomes a bar (default {','.join(BARS)})")  # fmt: skip
    add("--tolerances", metavar="T,T,...", type=numbers, default="1e-6,1e-10",
        help="relative (default 1e-6,1e-10)")  # fmt: skip
    add("--displacement", metavar="A", type=console.positive_number, default=0.1,
        help="Angstrom, standard deviation of each coordinate (default 0.1)")  # fmt: skip
    add("--copies", metavar="N", type=console.whole_number(1), default=COPIES,
        help=f"broken copies, the same for all (default {COPIES})")  # fmt: skip
    add("--rounds", metavar="N", type=console.whole_number(1), default=ROUNDS,
        help=f"of which the median counts (default {ROUNDS})")  # fmt: skip
    add("--seed", metavar="N", type=console.whole_number(0), default=0,
        help="of the displacements (default 0)")  # fmt: skip
    add("--csv", metavar="FILE", help="write the rows as CSV")


def _auto(arguments: argparse.Namespace) -> int:
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


def _step_options(parser: console.Parser) -> None:
    from pliant.lab.bench.large_frameworks import KINDS
    from pliant.lab.bench.step import ROUNDS, STEPS, TECHNIQUES

    add = parser.add_argument
    add("--sizes", metavar="N,N,...", type=numbers, default="1e4,1e6",
        help="joints (default 1e4,1e6)")  # fmt: skip
    add("--kinds", metavar="NAME,...", type=names, default=("protein",),
        help=f"of {', '.join(KINDS)} (default protein)")  # fmt: skip
    add("--techniques", metavar="NAME,...", type=names, default=TECHNIQUES,
        help=f"of pliant techniques (default {','.join(TECHNIQUES)})")  # fmt: skip
    add("--weighting", metavar="W", type=console.positive_number, default=0.5,
        help="of the techniques (default 0.5)")  # fmt: skip
    add("--tolerance", metavar="T", type=console.positive_number, default=1e-6,
        help="relative (default 1e-6)")  # fmt: skip
    add("--steps", metavar="N", type=console.whole_number(1), default=STEPS,
        help=f"of a round (default {STEPS})")  # fmt: skip
    add("--rounds", metavar="N", type=console.whole_number(1), default=ROUNDS,
        help=f"of which the median counts (default {ROUNDS})")  # fmt: skip
    add("--csv", metavar="FILE", help="write the rows as CSV")


def _step(arguments: argparse.Namespace) -> int:
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


def _record_options(parser: console.Parser) -> None:
    from pliant.lab.bench.record import PERTURBATIONS, REPEATS, STEPS, TECHNIQUES

    add = parser.add_argument
    add("file", metavar="FILE", nargs="?", default="",
        help="molecule (default: adenylate kinase of MDAnalysisTests)")  # fmt: skip
    add("--perturb", metavar="NAME,...", type=names, default=PERTURBATIONS,
        help=f"as of pliant run (default {','.join(PERTURBATIONS)})")  # fmt: skip
    add("--techniques", metavar="NAME,...", type=names, default=TECHNIQUES,
        help=f"of pliant techniques (default {','.join(TECHNIQUES)})")  # fmt: skip
    add("--tolerance", metavar="T", type=console.positive_number, default=1e-6,
        help="relative (default 1e-6)")  # fmt: skip
    add("--steps", metavar="N", type=console.whole_number(1), default=STEPS,
        help=f"of each run (default {STEPS})")  # fmt: skip
    add("--repeats", metavar="N", type=console.whole_number(1), default=REPEATS,
        help=f"rounds, of which the median counts (default {REPEATS})")  # fmt: skip
    add("--single", action="store_true", help="positions as 32-bit floats")
    add("--compress", action="store_true", help="gzip positions")
    add("--folder", metavar="DIR", default=None,
        help="where files are written and removed (default: for temporary files)")  # fmt: skip
    add("--csv", metavar="FILE", help="write the rows as CSV")


def _record(arguments: argparse.Namespace) -> int:
    from pliant.lab.bench.record import print_report, record
    from pliant.lab.bench.rows import write_csv

    with console.progress("runs", arguments.quiet or arguments.json) as show:
        found = record(
            arguments.file,
            perturbations=arguments.perturb,
            techniques=arguments.techniques,
            tolerance=arguments.tolerance,
            steps=arguments.steps,
            repeats=arguments.repeats,
            single=arguments.single,
            compress=arguments.compress,
            folder=arguments.folder,
            progress=show,
        )
    if arguments.csv:
        write_csv(found.rows, arguments.csv)
    console.print_json(found.as_json()) if arguments.json else print_report(found)
    return console.EXIT_FAILED if found.faults else console.EXIT_OK


RUN_SUBCOMMANDS = (
    Subcommand(
        "auto",
        "technique auto beside every fixed technique, on every molecule of data/molecules",
        "Breaks each molecule into a few copies, with bars of bonds and with those of angles;\n"
        "auto and every fixed technique with every weighting repair them. Trials sort out who\n"
        "makes every copy whole, measured anew; those who may be quickest then take turns in\n"
        "many short rounds. A time is that of one repair by the library's own clock, so that the\n"
        "call from Python, longer than the repair of a small molecule, neither hides a ratio nor\n"
        "makes one. Where auto leaves a bar broken that a fixed technique mends, or a technique\n"
        "says 'converged' beyond the tolerance, it is named, and the exit code is 1. A ratio\n"
        "alone is no failure: the worst is told last.",
        "examples:\n"
        "  pliant bench auto\n"
        "  pliant bench auto protein.pdb --bars angles --csv auto.csv\n",
        _auto_options,
        _auto,
    ),
    Subcommand(
        "step",
        "what a step costs after a push of one joint, in 10^4 and in 10^6 joints",
        "Runs large frameworks on and on, one joint pushed in each step, small and large ones by\n"
        "turns. A time is that of push and resolve, of the run's own summary, without recording;\n"
        "the ratio is that of the medians, and its span that of the quartiles. Techniques that\n"
        "look at the region of the push alone cost the same in any size but for what the caches\n"
        "of the processor no longer hold. Bars are measured anew in the end; where one is broken\n"
        "or a step did not converge, it is named, and the exit code is 1.",
        "examples:\n"
        "  pliant bench step\n"
        "  pliant bench step --kinds chain --techniques bfs_cycle --sizes 1e3,1e4 --steps 100\n",
        _step_options,
        _step,
    ),
    Subcommand(
        "record",
        "what recording every frame costs, beside the run and beside plain writing",
        "Runs a molecule with every frame recorded, and tells which share of the run's wall time\n"
        "the H5MD file took: to measure the frame, gather it and write it, of the run's own\n"
        "summary. Beside it as many bytes are written to a plain file, a megabyte a write: what\n"
        "the file system takes by itself. Where a push moves one joint, technique auto needs a\n"
        "few microseconds, less than copying the frame, so that writing is nearly all. Each file\n"
        "is read back: frames, the last positions bit by bit, bars of some frames measured anew.\n"
        "What is wrong is named, and the exit code is 1.",
        "examples:\n"
        "  pliant bench record\n"
        "  pliant bench record protein.pdb --perturb displacement --single --folder /scratch\n",
        _record_options,
        _record,
    ),
)
