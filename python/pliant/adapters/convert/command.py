# SPDX-License-Identifier: MIT
"""The command ``pliant convert``."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence

from pliant._core import OptionError
from pliant.adapters.convert.write import TARGETS, Converted, convert
from pliant.base import console
from pliant.base.force_field_options import add_options, taken
from pliant.base.said import notes_shown_by
from pliant.trajectory.recover.recover import recover

EPILOG = """\
The name of OUT says the format: .h5md, .pdb or .cif (one model per frame), .sdf (one record per
frame), .dcd, .xtc, .trr, .xyz or .zarr. DCD, XTC and TRR are written by MDAnalysis (pip
install "pliant[analysis]"), SDF by RDKit ("pliant[rdkit]"), Zarr by xarray ("pliant[zarr]"), the
others by Pliant itself.
H5MD keeps every digit; PDB keeps 0.001 Angstrom, mmCIF and XYZ 0.00001, XTC 0.01, DCD and TRR
32-bit floats. Observables and bars are left out. mmCIF has no bonds: programs know them from the
names of residues. DCD, XTC and TRR have only positions: open them with the PDB file that pliant
run writes beside its trajectory. A Zarr store has positions(frame, atom, xyz) with names of atoms
and residues, and walker and step of each frame: xarray.open_zarr("many.zarr").

Representatives are chosen by k-medoids: by RMSD, superposed pair by pair, the frames are on average
as close as possible to one of those chosen. Nothing is random. How many frames are closest to each
says nothing about how often a shape occurs. pliant analyse --representatives takes other atoms
to superpose, and trajectories of other programs.

With --to openmm, gromacs or amber OUT is a folder: one topology with parameters (amber14, GAFF2 of
ligands: see pliant check), and positions of each frame, minimised for 100 steps. OpenMM's system
has implicit water, the others are in a vacuum, ready for a box of water. ParmEd writes those of
GROMACS and AMBER (pip install "pliant[export]").

With --to vina OUT is a folder for AutoDock Vina: a rigid receptor in PDBQT of each frame, by Meeko
(pip install "pliant[docking]"), all superposed by --site, and box.txt, the box around it, for its
--config. What Meeko does not know (ligands, most cofactors) is left out, and named.

--recover keeps every frame of a damaged H5MD file that can be read, wherever it is, with its step
and time, and the observables, names, bonds, bars and options that can be read; it says what was
lost. Coordinates have no checksums: a wrong digit looks like a right one. IN is not changed.

exit codes: 0 done, 1 bad input or file, 2 bad option or missing package

examples:
  pliant convert out.h5md -o out.xtc
  pliant convert out.h5md -o ca.pdb --select "name CA" --every 10 --superpose
  pliant convert out.h5md -o twenty.pdb --representatives 20
  pliant convert complex.h5md -o md --to gromacs -k 5
  pliant convert apo.h5md -o dock --to vina -k 8 --site "resid 30:36 96:101"
  pliant convert broken.h5md -o good.h5md --recover
  pliant convert many -o many.dcd          the folder of pliant ensemble, walker after walker
  pliant convert many -o many.zarr         for xarray: all of it, in one store
"""


#: options that --recover heeds; any other is refused beside it
WITH_RECOVER = ("file", "output", "recover", "overwrite", "json", "quiet")


def make_parser() -> console.Parser:
    """The options of pliant convert."""
    parser = console.Parser(
        "convert", "Writes an H5MD trajectory in a format that other programs read.", EPILOG
    )
    add = parser.add_argument
    add(
        "file",
        metavar="IN",
        help="H5MD trajectory of pliant run or sample, or the folder of an ensemble",
    )
    text = "file to write; its ending says the format"
    add("-o", "--output", metavar="OUT", required=True, type=_file_name, help=text)
    text = 'atoms that are written, such as "protein and name CA" (default: all)'
    add("--select", metavar="WORDS", default="", help=text)
    text = "only each Nth frame, from the first (default 1)"
    add("--every", metavar="N", type=console.whole_number(1), default=1, help=text)
    text = "only N frames that represent all others: for docking, or to start simulations from"
    add("-k", "--representatives", metavar="N", type=console.whole_number(1), help=text)
    text = "the site that representatives differ in, and that is docked into: residues, or a ligand"
    add("--site", metavar="WORDS", default="", help=text)
    text = "superpose each frame on the first, by least squares over these atoms"
    add("--superpose", action="store_true", help=text)
    text = "copy what can be read of IN, an H5MD file that other commands call damaged"
    add("--recover", action="store_true", help=text)
    _add_force_field(parser)
    add("--overwrite", action="store_true", help="replace an existing OUT")
    add("--json", action="store_true", help="print what was written as one JSON object")
    add("--quiet", action="store_true", help="print nothing but errors")
    return parser


def _add_force_field(parser: console.Parser) -> None:
    add = parser.add_argument_group("input of other programs").add_argument
    text = (
        "systems that run, of a protein and its ligands, with parameters; vina: receptors to dock "
        "into; OUT is a folder"
    )
    add("--to", choices=TARGETS, help=text)
    add_options(add)


def _file_name(text: str) -> str:
    if not text:
        raise argparse.ArgumentTypeError("expected the name of a file, found nothing")
    return text


def main(words: Sequence[str] | None = None) -> int:
    """Runs the command; returns its exit code."""
    arguments = make_parser().parse_args(words)
    return console.run_command("convert", lambda: _convert(arguments))


def _convert(arguments: argparse.Namespace) -> int:
    if arguments.recover:
        return _recover(arguments)
    if arguments.representatives is not None and arguments.every != 1:
        raise OptionError("--every, --representatives: expected one of the two")
    with notes_shown_by((lambda _: None) if arguments.quiet else console.note):
        done = _converted(arguments)
    if arguments.json:
        console.print_json(vars(done))
    elif not arguments.quiet:
        frames = console.counted(done.frames, "frame")
        print(f"{done.path}: {frames} of {done.atoms} atoms, {done.format}")
        print(*done.notes, sep="\n", end="\n" * bool(done.notes))
    return console.EXIT_OK


def _converted(arguments: argparse.Namespace) -> Converted:
    return convert(
        arguments.file,
        arguments.output,
        select=arguments.select,
        every=arguments.every,
        representatives=arguments.representatives,
        superpose=arguments.superpose,
        overwrite=arguments.overwrite,
        to=arguments.to,
        site=arguments.site,
        **taken(arguments),
    )


def _recover(arguments: argparse.Namespace) -> int:
    if given := make_parser().given_besides(arguments, WITH_RECOVER):
        raise OptionError(f"{given}: does not go with --recover")
    recovery = recover(arguments.file, arguments.output, overwrite=arguments.overwrite)
    if arguments.json:
        console.print_json(vars(recovery))
    elif not arguments.quiet:
        print("\n".join(recovery.lines()))
    return console.EXIT_OK


if __name__ == "__main__":
    sys.exit(main())
