# SPDX-License-Identifier: MIT
"""``pliant lab bench work-precision``."""

from __future__ import annotations

import argparse

from pliant.base import console
from pliant.base.extras import need

ORDER = 1
SUMMARY = "run time against error: every technique and OpenMM on one broken molecule"
DESCRIPTION = """\
Breaks a molecule once. Every technique with every weighting, and OpenMM's CCMA in the
same process, repair it to one tolerance after another. All take turns, and the median
processor time counts, so that other load on the machine affects all alike. Errors are
measured again in double precision. Contenders that take too long or do not reach a
tolerance are named and not tried again. CCMA runs twice: as in
Context.applyConstraints, which starts from what the techniques start from, and as in
dynamics, where it is given the intact structure. Where gmx or gmx_d is installed, LINCS
and SHAKE of GROMACS' mdrun take part, as in dynamics. Their times are those for
constraints in its log, their errors those of its trajectory. Of LINCS's settings, the
fastest that meets a tolerance counts."""
EPILOG = """\
examples:
  pliant lab bench work-precision protein.pdb -o race.png --csv race.csv
  pliant lab bench work-precision protein.pdb --bars angles --technique blocks,bfs_reverse
"""


def add_options(parser: console.Parser) -> None:
    """Those of this subcommand."""
    from pliant.lab.bench.work_precision import REPEATS

    add = parser.add_argument
    add("file", metavar="FILE", help="molecule file, as for pliant run")
    text = "what becomes a bar (default bonds)"
    add("--bars", choices=["bonds", "angles"], default="bonds", help=text)
    text = "standard deviation of each coordinate, Angstrom (default 0.1)"
    add("--displacement", metavar="A", type=console.positive_number, default=0.1, help=text)
    text = "seed of the displacement (default 0)"
    add("--seed", metavar="N", type=console.whole_number(0), default=0, help=text)
    add(
        "--tolerance",
        metavar="T,T,...",
        type=console.positive_numbers,
        default=",".join(f"1e-{k}" for k in range(2, 13)),
        help="relative tolerances, the largest first (default 1e-2,1e-3,...,1e-12)",
    )
    text = "techniques (default: all)"
    add("--technique", metavar="NAME,...", type=console.words, default=(), help=text)
    text = f"number of rounds; the median is reported (default {REPEATS})"
    add("--repeats", metavar="N", type=console.whole_number(1), default=REPEATS, help=text)
    add(
        "--mass-weighted",
        action="store_true",
        help="also share corrections in proportion to inverse mass",
    )
    text = "other programs to measure (default all: OpenMM and, where it is installed, GROMACS)"
    add("--peers", choices=["all", "openmm", "none"], default="all", help=text)
    add("--csv", metavar="FILE", help="write the rows as CSV")
    add("-o", "--output", metavar="FILE", help="draw run time against error (PNG)")


def run(arguments: argparse.Namespace) -> int:
    """Measures and prints; returns the exit code."""
    from pliant.lab.bench.rows import write_csv
    from pliant.lab.bench.work_precision import work_precision
    from pliant.lab.bench.work_precision_report import print_report

    if arguments.output:
        need("a picture of pliant lab bench", "matplotlib", extra="lab")
    with console.progress("race", arguments.quiet or arguments.json) as show:
        found = work_precision(
            arguments.file,
            bars=arguments.bars,
            displacement=arguments.displacement,
            seed=arguments.seed,
            tolerances=arguments.tolerance,
            techniques=arguments.technique,
            repeats=arguments.repeats,
            mass_weighted=arguments.mass_weighted,
            openmm=arguments.peers != "none",
            gromacs=arguments.peers == "all",
            progress=show,
        )
    if arguments.csv:
        write_csv(found.rows, arguments.csv)
    if arguments.output:
        from pliant.lab.bench.work_precision_picture import draw

        draw(found, arguments.output)
    if arguments.json:
        console.print_json(found.as_json())
    else:
        print_report(found)
    return console.EXIT_OK
