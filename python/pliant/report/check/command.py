# SPDX-License-Identifier: MIT
"""``pliant check``: a trajectory checked against OpenMM, on the command line."""

from __future__ import annotations

import argparse
import pathlib
import sys
from collections.abc import Sequence

from pliant.base import console
from pliant.base.extras import late
from pliant.base.force_field_options import add_options, taken
from pliant.base.said import notes_shown_by
from pliant.report.build import Report, print_lines

reports, suite = late("pliant.report.check.check_report"), late("pliant.report.check.suite")

EPILOG = """\
Exit code: 0 if every check passed, 1 if one failed, 2 for a bad option. If OpenMM cannot do
something, such as repair frameworks that fix bond angles, the report says so; it is not a failure.
Frames can be used to start MD if all numbers stay finite, no two atoms are in the same place, each
residue keeps its chirality, and in 95 % of the frames the energy ends at most 3 (100 steps) and 1
(500 steps) kJ/mol per residue above that of the start structure, and alpha carbons move by at most
0.4 Angstrom in 100 steps. It is best to add hydrogens before sampling: pliant sample
--all-hydrogens keeps them clear of other atoms.

Ligands and modified residues get GAFF2 parameters where AmberTools is installed (pip install
"pliant[ligands]"; they are kept in ~/.cache/pliant), ions those of amber14. A ligand must move by
at most 1 Angstrom, and end at most 50 kJ/mol more strained than in the start. What has no
parameters is left out, the report says why, and the verdict is then of the rest alone.

The atoms are those of the file. Which are selected, kept, added or protonated is said to pliant
sample (--select, --keep, --fill-side-chains, --all-hydrogens, --protonate), whose file says it
again; pliant check has none of the options of a molecule.

examples:
  pliant check out.h5md
  pliant check ensemble.h5md --thorough
  pliant check out.h5md --frames all --json > check.json
  pliant check complex.h5md --ligand "STR=CC(=O)C1CCC2C3CCC4=CC(=O)CCC4(C)C3CCC12C"
  pliant check ensemble.h5md --no-force-field
"""

#: options that --help shows
COMMON = ("--thorough", "--frames", "--output", "--force-field")


def make_parser() -> console.Parser:
    """The options of pliant check."""
    parser = console.Parser(
        "check",
        "Checks a trajectory with OpenMM. Every bar (two atoms at a fixed distance) of every\n"
        "frame is measured. OpenMM's constraints must leave the frames unchanged and notice the\n"
        "smallest break, and its harmonic bonds must have the energy that Pliant computes. Copies\n"
        "of a run's frames are broken, and Pliant and OpenMM's CCMA repair them. For an ensemble\n"
        "of a protein, OpenMM minimises 3 to 5 frames and the start structure in the same way\n"
        "(amber14, implicit water OBC2): can they be used to start MD? --thorough looks at 20\n"
        "frames, for longer, and at frames of a short MD, which takes minutes.\n"
        "OpenMM runs in separate processes.",
        EPILOG,
        COMMON,
    )
    add = parser.add_argument
    add("file", metavar="FILE", help="H5MD trajectory of pliant run or pliant sample")
    text = "number of frames given to OpenMM, evenly spaced, or all (default 20)"
    add("--frames", metavar="N", type=console.whole_number(1, "all"), default=20, help=text)
    _add_force_field(parser)
    add("-o", "--output", metavar="FOLDER", help="draw a picture into this folder")
    add("--json", action="store_true", help="print the report as one JSON object")
    add("--quiet", action="store_true", help="show no progress")
    return parser


def _add_force_field(parser: console.Parser) -> None:
    add = parser.add_argument_group("force field").add_argument
    text = "minimise frames (default: if the file is an ensemble of a protein)"
    add("--force-field", action=argparse.BooleanOptionalAction, default=None, help=text)
    text = "more frames, for longer, beside frames of a short MD: minutes instead of seconds"
    add("--thorough", action="store_true", help=text)
    text = (
        "frames minimised for 100 steps, evenly spaced, or all (default: 5 of up to 2000 atoms, "
        "else 3; 20 with --thorough)"
    )
    add("--starts", metavar="N", type=console.whole_number(1, "all"), help=text)
    text = "structure that the ensemble began with (default: the PDB beside it)"
    add("--reference", metavar="FILE", help=text)
    add_options(add)


def main(words: Sequence[str] | None = None) -> int:
    """Runs the command; returns its exit code."""
    arguments = make_parser().parse_args(words)
    return console.run_command("check", lambda: _check(arguments))


def _check(arguments: argparse.Namespace) -> int:
    with notes_shown_by(console.note):
        report = suite.check(
            arguments.file,
            frames=arguments.frames,
            force_field=arguments.force_field,
            thorough=arguments.thorough,
            starts=arguments.starts,
            start=arguments.reference,
            **taken(arguments),
            picture=_picture_path(arguments),
            quiet=arguments.quiet or arguments.json,
        )
    if arguments.json:
        console.print_json(report.as_json())
    else:
        print_lines(Report(report, reports.SECTIONS).lines())
    return console.EXIT_OK if report.passed else console.EXIT_FAILED


def _picture_path(arguments: argparse.Namespace) -> pathlib.Path | None:
    if arguments.output is None:
        return None
    return pathlib.Path(arguments.output, f"{pathlib.Path(arguments.file).stem}.check.png")


if __name__ == "__main__":
    sys.exit(main())
