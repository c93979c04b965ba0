# SPDX-License-Identifier: MIT
"""``pliant lab bench validity``."""

from __future__ import annotations

import argparse

from pliant.base import console

ORDER = 6
SUMMARY = "sampled ensembles beside NMR, MD, crystals and known motions, with ANM and GNM"
DESCRIPTION = """\
Samples proteins whose flexibility is known, and compares: RMSF and principal components
with NMR models (ubiquitin) and MD (HIV-1 protease), the first ten modes with the change
from one known structure to another (adenylate kinase; --pairs for a folder of others),
estimates from networks with crystal B factors. ANM and GNM start from the same files and
go through the same code. Each frame is checked: bars, least distances, chirality, omega,
and the Ramachandran plot. Clashes of frames are compared with those of the start. From each of
two states with side chains (turns), twice as many frames of reach, turns and modes: which
come nearest to the other state, and how good is the geometry of turns? Time and memory
are measured last. The files come from the test data of installed packages, or from a
folder; a row whose file is missing says how to install it. The column 'data' says on
what the method was tuned. The exit code is 1 if a frame is not exact; other missed goals
are named, but are no failure."""
EPILOG = """\
examples:
  pliant lab bench validity -o validity.png --csv validity.csv
  pliant lab bench validity --only ubiquitin,adk_closed --frames 100
  pliant lab bench validity --only pairs --pairs domainmotion"""


def add_options(parser: console.Parser) -> None:
    """Those of this subcommand."""
    add = parser.add_argument
    text = (
        "groups: ubiquitin, hiv, adk_md, adk_closed, adk_open, pairs, crystals, turns, clashes, "
        "cost (default: all)"
    )
    add("--only", metavar="NAME,...", type=console.words, default=(), help=text)
    text = "look for files in this folder and its subfolders first, then in packages"
    add("--data", metavar="FOLDER", help=text)
    add(
        "--pairs",
        metavar="FOLDER",
        help="folder of subfolders, each with two structures of a protein, compared in both "
        "directions",
    )
    text = "frames of each ensemble (default 200)"
    add("--frames", metavar="N", type=console.whole_number(12), default=200, help=text)
    text = "ensembles of different seeds that are compared (default 3)"
    add("--repeats", metavar="N", type=console.whole_number(1), default=3, help=text)
    add("--csv", metavar="FILE", help="write the rows as CSV")
    add("-o", "--output", metavar="FILE", help="draw profiles and overlaps (PNG)")


def run(arguments: argparse.Namespace) -> int:
    """Measures and prints; returns the exit code."""
    from pliant.base.extras import need

    need("pliant lab bench validity", "MDAnalysis", "scipy")
    from pliant.lab.bench.rows import write_csv
    from pliant.lab.validity.ladder import validity
    from pliant.lab.validity.report import print_report

    with console.progress("groups", arguments.quiet or arguments.json) as show:
        found = validity(
            arguments.only,
            data=arguments.data,
            pairs=arguments.pairs,
            frames=arguments.frames,
            seeds=arguments.repeats,
            progress=show,
        )
    if arguments.csv:
        write_csv(found.rows, arguments.csv)
    if arguments.output:
        from pliant.lab.validity.picture import draw

        draw(found, arguments.output)
    console.print_json(found.as_json()) if arguments.json else print_report(found)
    return console.EXIT_FAILED if found.broken else console.EXIT_OK
