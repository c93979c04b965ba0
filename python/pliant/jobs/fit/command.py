# SPDX-License-Identifier: MIT
"""The command ``pliant fit``."""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Sequence
from pathlib import Path

from pliant._core import OptionError, path_rows
from pliant.base import console
from pliant.base.said import notes_shown_by
from pliant.jobs.fit.fit import fit
from pliant.jobs.fit.fitted import FittedStructure
from pliant.jobs.fit.saxs.explained import FittedCurve

EXIT_OFF = 3  #: data do not hold

DESCRIPTION = """\
Fits a structure to measured distances, a density map, or both, or to a SAXS curve: shapes in reach
of START that agree with the data, all atoms with exact bonds and angles, and what the data do not
tell."""

EPILOG = """\
The table (CSV) has a header and a row for each distance, in Angstrom between alpha carbons (P of
nucleotides), labels or atoms.

  site1,site2   residues: A:45, 45, or a selection of one residue; of atoms: selections
  distance,error   or low,high: the interval in which it lies; high alone is an upper limit
  kind   CA (the default); cross-links: DSS, BS3, DSSO, DSBU (up to 30 A), SDA (25), EDC (20);
         MTSL: between spin labels of DEER, as 4.1 A beyond alpha carbons: add 5 A to the error;
         FRET: between mean positions of dyes, by their accessible volumes;
         atom: of two atoms; NOE: of hydrogens, of several residues if need be, (sum of r^-6)^(-1/6)

Each distance is also predicted by fits to the others. One that they put 5 A or more outside of its
interval, and without which START has to change much less, is let go and named. The spread by
residue is precision: fits that agree may all be wrong where nothing was measured.

A map is MRC or CCP4. START must lie in it, as after ChimeraX' fitmap, or is put there by --place;
the result lies there, too. Correlations are about the means, near to atoms. --half is the other
half of the data, as a map: nothing is fitted to it, so it tells what a fit is worth.

With --saxs nothing is deformed: frames of an ensemble are chosen by their curves, computed with the
water around them. "#" begins comments; q is in 1/Angstrom. A curve is some ten numbers: many shapes
have the same.

exit codes: 0 data are met (all distances but those let go; a map that correlates by 0.5, and no
less than with START; chi^2 of a curve up to 1.5), 1 bad input or file, 2 bad option, 3 data are not
met

examples:
  pliant design open.pdb --distances 10
  pliant fit open.pdb --distances measured.csv -o fitted.pdb
  pliant fit open.pdb --saxs curve.dat -o chosen.h5md --ensemble
  pliant fit open.cif --distances links.csv -o fitted.h5md --keep 20 --json
  pliant fit open.pdb --map half1.mrc --half half2.mrc --resolution 6 --place -o fitted.cif
  pliant path open.pdb fitted.pdb -o closing.h5md
"""

#: options that --help shows
COMMON = ("--distances", "--map", "--resolution", "--place", "--saxs", "--output", "--select")
#: of a path alone
NOT_OURS = ("atoms", "step", "both", "backtrack", "seed")


def molecule_rows() -> list[dict[str, object]]:
    """Options about the molecule and its model."""
    return [row for row in path_rows() if row["name"] not in (*NOT_OURS, "keep")]


def make_parser() -> console.Parser:
    """The options of pliant fit."""
    parser = console.Parser("fit", DESCRIPTION, EPILOG, COMMON)
    add = parser.add_argument
    add("start", metavar="START", help="PDB or mmCIF file of a protein or nucleic acid")
    add("--distances", metavar="FILE", help="table of measured distances (CSV)")
    add("--map", metavar="FILE", help="density map (MRC, CCP4), into which START has been put")
    text = "of the map, Angstrom; needed with --map"
    add("--resolution", metavar="A", type=float, help=text)
    add("--half", metavar="FILE", help="the other half of the data as a map, to judge by")
    add("--place", action="store_true", help="put START into the map first")
    add("--saxs", metavar="FILE", help="SAXS curve (text): q, I and sigma in each line")
    text = "of a curve: the least number of frames that explain it together, and their weights"
    add("--ensemble", action="store_true", help=text)
    add("--background", action="store_true", help="of a curve: fit a constant, too")
    text = "file of the fitted structures: .pdb, .cif, .h5md ..."
    add("-o", "--output", metavar="FILE", required=True, help=text)
    text = "how many fitted structures are written, the best first (default: 1)"
    add("--keep", metavar="N", type=console.whole_number(1, most=40), default=1, help=text)
    text = "frames of the ensemble that fits start from (default: 400)"
    add("--frames", metavar="N", type=console.whole_number(50), default=400, help=text)
    text = "take starts from a file of frames, as pliant sample writes it"
    add("--from", metavar="FILE", dest="taken", help=text)
    text = "of the ensemble (default: 0)"
    add("--seed", metavar="N", type=console.whole_number(0), default=0, help=text)
    console.add_rows(parser, molecule_rows())
    add("--overwrite", action="store_true", help="replace the output")
    add("--json", action="store_true", help="print the report as one JSON object")
    return parser


def main(words: Sequence[str] | None = None) -> int:
    """Runs the command; returns its exit code."""
    arguments = make_parser().parse_args(words)
    return console.run_command("fit", lambda: _fit(arguments))


def _fit(arguments: argparse.Namespace) -> int:
    _check_outputs(arguments)
    with notes_shown_by(console.note):
        found = fit(
            arguments.start,
            arguments.distances,
            map=arguments.map,
            resolution=arguments.resolution,
            half=arguments.half,
            place=arguments.place,
            saxs=arguments.saxs,
            ensemble=arguments.ensemble,
            background=arguments.background,
            frames=arguments.taken or arguments.frames,
            keep=arguments.keep,
            seed=arguments.seed,
            output=arguments.output,
            overwrite=arguments.overwrite,
            **console.given(arguments, molecule_rows()),
        )
    if arguments.json:
        console.print_json({"output": arguments.output, **found.as_json()})
    elif isinstance(found, FittedCurve):
        _print_curve(found, arguments.output)
    else:
        _print(found, arguments.output)
    return console.EXIT_OK if found.agrees else EXIT_OFF


def _check_outputs(arguments: argparse.Namespace) -> None:
    if Path(arguments.output).exists() and not arguments.overwrite:
        raise OptionError(f"output {arguments.output}: exists; --overwrite replaces it")
    given = (
        arguments.start,
        arguments.distances,
        arguments.map,
        arguments.half,
        arguments.saxs,
        arguments.output,
    )
    names = [name for name in given if name is not None]
    if len({os.path.realpath(name) for name in names}) < len(names):
        raise OptionError("two of the files are one: START, data and --output must differ")


def _print(found: FittedStructure, output: str) -> None:
    for one in found.data:
        predicted = "-" if one.predicted is None else f"{one.predicted:.1f}"
        off = "let go" if one.contradicts else f"{one.violation:+.2f}" if one.violation else "holds"
        print(
            f"{one.name:23s} asked {one.low:5.1f} to {one.high:5.1f}  START {one.at_start:5.1f}  "
            f"found {one.found:5.1f}  {off:7s} by the others {predicted:>5s}"
        )
    _print_facts(found, output)


def _print_curve(found: FittedCurve, output: str) -> None:
    print("frame  weight  Rg, A  RMSD from START, A")
    for one in found.members:
        print(f"{one.frame:5d}  {one.weight:6.3f}  {one.rg:5.2f}  {one.rmsd:.2f}")
    _print_facts(found, output)


def _print_facts(found: FittedStructure | FittedCurve, output: str) -> None:
    for label, text in found.facts():
        print(f"{label:15s} {text}")
    print(f"{'written':15s} {console.printable_name(output)}, in {found.seconds:.1f} s")


if __name__ == "__main__":
    sys.exit(main())
