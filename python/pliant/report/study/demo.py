# SPDX-License-Identifier: MIT
"""The command ``pliant demo``: a first ensemble, from nothing but the package."""

from __future__ import annotations

import argparse
from collections.abc import Iterator, Sequence
from pathlib import Path

import numpy as np

import pliant
from pliant.base import console
from pliant.base.extras import MissingPackageError, need
from pliant.base.new_file import write_bytes

EPILOG = """\
The molecule is a helix of 20 residues that the package brings along. What is written:
  DIR/peptide_20.pdb    the helix
  DIR/ensemble.h5md     its ensemble; MDAnalysis opens it with DIR/ensemble.pdb
  DIR/report.html       the report, where pliant[analysis] is installed

exit codes: 0 done, 1 a file cannot be written or is there already, 2 bad option

examples:
  pliant demo
  pliant demo -o first --overwrite
"""

#: where the build puts it (python/CMakeLists.txt)
MOLECULE = Path(pliant.__file__).with_name("static") / "examples" / "peptide_20.pdb"

#: letters of the longest bar
BAR = 40

FRAMES = 200  #: enough for errors of each number, in some seconds


def make_parser() -> console.Parser:
    """The options of pliant demo."""
    parser = console.Parser(
        "demo",
        "Makes a first ensemble and says which residues move, with the error of each number.",
        EPILOG,
    )
    add = parser.add_argument
    text = "folder to write to (default: pliant-demo)"
    add("-o", "--output", metavar="DIR", default="pliant-demo", help=text)
    text = f"number of frames (default: {FRAMES})"
    add("--frames", metavar="N", type=int, default=FRAMES, help=text)
    add("--overwrite", action="store_true", help="replace what is in DIR")
    return parser


def main(words: Sequence[str] | None = None) -> int:
    """Runs the command; returns its exit code."""
    arguments = make_parser().parse_args(words)
    return console.run_command("demo", lambda: _demo(arguments))


def _demo(arguments: argparse.Namespace) -> int:
    folder = Path(arguments.output)
    molecule, output = folder / MOLECULE.name, folder / "ensemble.h5md"
    _refuse_to_replace([molecule, output], arguments.overwrite)
    folder.mkdir(parents=True, exist_ok=True)
    write_bytes(molecule, MOLECULE.read_bytes(), overwrite=arguments.overwrite)
    _show(f'>>> structure = pliant.read("{molecule}")')
    structure = pliant.read(molecule)
    print(structure)
    _show(f'>>> pliant.sample(structure, {arguments.frames}, output="{output}")')
    ensemble = pliant.sample(
        structure, arguments.frames, output=output, overwrite=arguments.overwrite
    )
    print(ensemble)
    print("\n".join(_flexibility(structure, ensemble)))
    code = _report(output, folder)
    print("\nYour own molecule:  pliant sample protein.pdb -o ensemble.h5md")
    return code


def _show(call: str) -> None:
    print(f"\n{call}", flush=True)


def _refuse_to_replace(files: Sequence[Path], overwrite: bool) -> None:
    for file in files:
        if file.exists() and not overwrite:
            name = console.printable_name(file)
            raise pliant.Error(f"{name}: is there already; --overwrite replaces it")


def _flexibility(structure: pliant.Structure, ensemble: pliant.SampledEnsemble) -> Iterator[str]:
    """One line for each residue: how far its C-alpha moves, and the error of that."""
    atoms = [atom for atom, name in enumerate(structure.names) if name == "CA"]
    rmsf, error = ensemble.rmsf[atoms], ensemble.rmsf_error[atoms]
    yield "\nHow far the C-alpha of each residue moves about its mean place (RMSF, Å)"
    yield "The error is half the difference between the first and the second half of the frames."
    for atom, moved, off in zip(atoms, rmsf, error, strict=True):
        residue = f"{structure.residue_names[atom]}{structure.residue_ids[atom]}"
        bar = "█" * round(BAR * moved / np.max(rmsf))
        yield f"  {residue:<8}{moved:5.2f} ± {off:.2f}  {bar}"


def _report(ensemble: Path, folder: Path) -> int:
    words = [str(ensemble), "-o", str(folder)]
    _show(f"$ pliant analyse {' '.join(words)}")
    try:
        need("the report", "MDAnalysis", "matplotlib", "scipy", extra="analysis")
    except MissingPackageError as missing:
        print(f"left out: {missing}")
        return console.EXIT_OK
    from pliant.report import command

    return command.main(words)
