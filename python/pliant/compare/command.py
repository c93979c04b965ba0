# SPDX-License-Identifier: MIT
"""``pliant compare``: our trajectory beside one of another program, on the command line."""

from __future__ import annotations

import argparse
import pathlib
import sys
from collections.abc import Sequence

from pliant import console

EPILOG = """\
Exit code: 0 if they were compared, 1 if they cannot be, 2 for a bad option.

examples:
  pliant compare out.h5md dynamics.dcd
  pliant compare out.h5md dynamics.xtc --topology start.pdb --select 'not name H*'
"""


def make_parser() -> console.Parser:
    """The options of pliant compare."""
    parser = console.Parser(
        "compare",
        "Compares a trajectory of Pliant with any that MDAnalysis reads, such as one of OpenMM:\n"
        "fluctuations of atoms, principal modes, torsions, lengths of bars. To tell differences\n"
        "from noise, it also compares the first half of THEIRS with its second half.",
        EPILOG,
    )
    add = parser.add_argument
    add("ours", metavar="OURS", help="H5MD trajectory of pliant run")
    add("theirs", metavar="THEIRS", help="trajectory: DCD, XTC, PDB, ...")
    add("--topology", metavar="FILE",
        help="file with the atom names of THEIRS (default: THEIRS itself, else OURS)")  # fmt: skip
    add("--select", metavar="TEXT", default="all",
        help="MDAnalysis selection for both (default all)")  # fmt: skip
    add("--frames", metavar="N", type=console.whole_number(2, "all"), default=2000,
        help="most frames to read of each, spread evenly, or all (default 2000)")  # fmt: skip
    add("-o", "--output", metavar="FOLDER", type=pathlib.Path,
        help="folder for the pictures (default: that of OURS)")  # fmt: skip
    add("--no-picture", action="store_true", help="draw no picture")
    add("--json", action="store_true", help="print the comparison as one JSON object")
    return parser


def main(words: Sequence[str] | None = None) -> int:
    """Runs the command; returns its exit code."""
    arguments = make_parser().parse_args(words)
    return console.run_command("compare", lambda: _compare(arguments))


def _compare(arguments: argparse.Namespace) -> int:
    from pliant.compare.report import as_json, print_report
    from pliant.compare.suite import compare

    folder = arguments.output or pathlib.Path(arguments.ours).parent
    report = compare(
        arguments.ours,
        arguments.theirs,
        topology=arguments.topology,
        select=arguments.select,
        frames=arguments.frames,
        pictures=None if arguments.no_picture else folder,
    )
    if arguments.json:
        console.print_json(as_json(report))
    else:
        print_report(report)
    return console.EXIT_OK


if __name__ == "__main__":
    sys.exit(main())
