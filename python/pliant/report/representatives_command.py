# SPDX-License-Identifier: MIT
"""The subcommand ``pliant representatives``: a few frames that stand for all, as a PDB file."""

from __future__ import annotations

import argparse
import sys
import warnings
from collections.abc import Sequence

from pliant.base.console import EXIT_OK, Parser, note, print_json, run_command, whole_number

DESCRIPTION = """\
Chooses a few frames that represent all the others, and writes them as the models of a PDB file:
for docking, for simulations that start from different shapes, or to look at.

Frames are compared by their RMSD, superposed pair by pair, and chosen by k-medoids: the frames of
the file are, on average, as close as possible to one of those chosen. Nothing is random. How many
frames are closest to each says nothing about populations: how often a shape occurs is not known."""

EPILOG = """\
examples:
  pliant representatives ensemble.h5md -k 20 -o twenty.pdb
  pliant representatives ensemble.h5md --shapes -o shapes.pdb
  pliant representatives ensemble.h5md -k 10 -o site.pdb --superpose "name CA and resid 8:14 80:90"
  pliant representatives many -k 10 -o ten.pdb          the folder of pliant ensemble
  pliant representatives run.xtc --topology run.pdb -k 5 -o five.pdb

Exit code: 0 written, 1 a file cannot be read or written, 2 wrong usage."""

#: options that --help shows
COMMON = ("-k", "--shapes", "--output", "--select", "--superpose")


def main(arguments: Sequence[str] | None = None) -> int:
    """Runs the subcommand with a list of arguments (default: sys.argv); returns the exit code."""
    options = _parser().parse_args(arguments)
    return run_command("representatives", lambda: _representatives(options))


def _parser() -> Parser:
    parser = Parser("representatives", DESCRIPTION, EPILOG, COMMON)
    add = parser.add_argument
    add(
        "file",
        metavar="FILE",
        help="trajectory of pliant sample or run (H5MD), the folder of an ensemble, or another\n"
        "program's trajectory",
    )
    which = parser.add_mutually_exclusive_group(required=True)
    which.add_argument("-k", dest="count", type=whole_number(1), metavar="K", help="how many")
    text = "one for each other shape in an ensemble of sampler reach or pocket (see pliant analyse)"
    which.add_argument("--shapes", action="store_true", help=text)
    add("-o", "--output", metavar="FILE", required=True, help="PDB file with a model for each")
    add("--topology", metavar="FILE", help="file of atoms, if FILE holds none (PDB, GRO, PSF ...)")
    add("--select", metavar="SELECTION", default="all", help="atoms to write (default: all)")
    add(
        "--superpose",
        metavar="SELECTION",
        help="atoms to superpose and compare (default: CA and P atoms if they form chains, else "
        "all but hydrogens)",
    )
    add("--overwrite", action="store_true", help="replace an existing output")
    add("--json", action="store_true", help="print the results as one JSON object")
    add("--quiet", action="store_true", help="print nothing but errors")
    return parser


def _representatives(options: argparse.Namespace) -> int:
    # Imported here, so that --help and errors of usage are immediate.
    from pliant.report.representatives import representatives

    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        found = representatives(
            options.file,
            options.count,
            options.output,
            topology=options.topology,
            select=options.select,
            superpose=options.superpose,
            shapes=options.shapes,
            overwrite=options.overwrite,
        )
    if options.json:
        print_json(found.as_json())
        return EXIT_OK
    if options.quiet:
        return EXIT_OK
    for text in found.notes:
        note(text)
    print(f"frames          {', '.join(map(str, found.frames))}")
    print(f"stand for       {found.nearest.sum()} frames, by RMSD of {found.superposed_on}")
    print(
        f"distance        {found.mean_distance:.2f} Angstrom on average, "
        f"{found.largest_distance:.2f} at most"
    )
    print("populations     not claimed: the share of frames nearest to each is not a share of time")
    print(f"written         {found.output}")
    return EXIT_OK


if __name__ == "__main__":
    sys.exit(main())
