# SPDX-License-Identifier: MIT
"""``pliant compare``: our ensemble beside others, on the command line."""

from __future__ import annotations

import argparse
import pathlib
import sys
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from pliant._core import OptionError
from pliant.base import console
from pliant.report.build import Report, print_lines

if TYPE_CHECKING:
    from pliant.measure.compared.paths import PathComparison
    from pliant.report.compare.comparison_report import ComparisonReport

EPILOG = """\
Exit code: 0 if they were compared, 1 if they cannot be, 2 for a bad option.

The ceiling is how well two halves of THEIRS agree with each other: OURS cannot be shown to agree
better than that. How far OURS goes (--amplitude of pliant sample) was an input, so only which parts
move, and in what directions, counts.

examples:
  pliant compare out.h5md nmr_models.pdb -o pictures
  pliant compare out.h5md 4ake.cif 1ake.pdb.gz 2eck.cif
  pliant compare out.h5md dynamics.dcd
  pliant compare opening.h5md dims.dcd --path
  pliant compare out.h5md dynamics.xtc --topology start.pdb --select 'not name H*'
"""


def make_parser() -> console.Parser:
    """The options of pliant compare."""
    parser = console.Parser(
        "compare",
        "Compares an ensemble made by Pliant with experiment or another program: NMR models,\n"
        "crystal structures, a trajectory of molecular dynamics. It says which residues move (r\n"
        "of RMSF), in what directions (RMSIP, overlaps of modes), what one has and the other\n"
        "lacks, and what cannot be concluded. Residues are matched by sequence. If the atoms are\n"
        "the same, torsions and the lengths of bars (pairs of atoms at a fixed distance) are\n"
        "compared as well.",
        EPILOG,
    )
    add = parser.add_argument
    add("ours", metavar="OURS", help="H5MD file of pliant sample or pliant run")
    add(
        "theirs",
        metavar="THEIRS",
        nargs="+",
        help="a PDB or mmCIF file with models, several files of one structure each (.gz too), "
        "or a trajectory: DCD, XTC, ...",
    )
    text = "file with the atom names of THEIRS (default: THEIRS itself, else OURS)"
    add("--topology", metavar="FILE", help=text)
    text = "MDAnalysis selection for both (default all)"
    add("--select", metavar="TEXT", default="all", help=text)
    text = "frames to read of each at most, evenly spaced, or all (default 2000; 500 with --path)"
    add("--frames", metavar="N", type=console.whole_number(2, "all"), help=text)
    text = "draw pictures into this folder"
    add("-o", "--output", metavar="FOLDER", type=pathlib.Path, help=text)
    add(
        "--path",
        action="store_true",
        help="compare OURS and one file of THEIRS as paths: mean nearest, Hausdorff and "
        "Frechet distances of their frames, beside those of a straight line",
    )
    add("--json", action="store_true", help="print the comparison as one JSON object")
    return parser


def main(words: Sequence[str] | None = None) -> int:
    """Runs the command; returns its exit code."""
    arguments = make_parser().parse_args(words)
    return console.run_command("compare", lambda: _compare(arguments))


def _compare(arguments: argparse.Namespace) -> int:
    report: Report[Any] = _of_paths(arguments) if arguments.path else _of_ensembles(arguments)
    if arguments.json:
        console.print_json(report.values)
    else:
        print_lines(report.lines())
    return console.EXIT_OK


def _of_ensembles(arguments: argparse.Namespace) -> Report[ComparisonReport]:
    from pliant.report.compare.sections import SECTIONS
    from pliant.report.compare.suite import FRAMES, compare

    found = compare(
        arguments.ours,
        arguments.theirs,
        topology=arguments.topology,
        select=arguments.select,
        frames=FRAMES if arguments.frames is None else arguments.frames,
        pictures=arguments.output,
    )
    return Report(found, SECTIONS)


def _of_paths(arguments: argparse.Namespace) -> Report[PathComparison]:
    from pliant.measure.compared.paths import FRAMES, compare_paths
    from pliant.report.compare.path_sections import PATHS

    if len(arguments.theirs) > 1:
        raise OptionError(f"--path: expected one file of THEIRS, found {len(arguments.theirs)}")
    if arguments.output is not None:
        raise OptionError("--output: --path draws no picture")
    found = compare_paths(
        arguments.ours,
        arguments.theirs[0],
        topology=arguments.topology,
        select=arguments.select,
        frames=FRAMES if arguments.frames is None else arguments.frames,
    )
    return Report(found, PATHS)


if __name__ == "__main__":
    sys.exit(main())
