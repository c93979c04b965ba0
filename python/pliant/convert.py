# SPDX-License-Identifier: MIT
"""``pliant convert``: an H5MD trajectory in a format that other programs read."""

from __future__ import annotations

import argparse
import os
import pathlib
import sys
import tempfile
import warnings
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from typing import TypeAlias

import numpy as np

from pliant import _core, console
from pliant._cif_models import write_models
from pliant._core import InputError, OptionError
from pliant._extras import need
from pliant._superposition import Superposition
from pliant.ensemble.plan import is_ensemble
from pliant.ensemble.shards_reader import ShardsReader

EPILOG = """\
The name of OUT says the format: .pdb or .cif (one model per frame), .dcd, .xtc, .trr or .xyz. PDB
and mmCIF are written by Pliant itself, the others by MDAnalysis (pip install "pliant[analysis]").
H5MD keeps every digit; PDB keeps 0.001 Angstrom, mmCIF and XYZ 0.00001, XTC 0.01, DCD and TRR
32-bit floats. Observables and bars are left out. mmCIF has no bonds: programs know them from the
names of residues. DCD, XTC and TRR have only positions: open them with the PDB file that pliant
run writes beside its trajectory.

exit codes: 0 done, 1 bad input or file, 2 bad option or missing package

examples:
  pliant convert out.h5md -o out.xtc
  pliant convert out.h5md -o ca.pdb --select "name CA" --every 10 --superpose
  pliant convert many -o many.dcd          the folder of pliant ensemble, walker after walker
"""


Reader: TypeAlias = "_core.H5mdReader | ShardsReader"


@dataclass
class Converted:
    """What was written."""

    path: str
    format: str
    frames: int
    atoms: int


def convert(
    source: str | os.PathLike[str],
    output: str | os.PathLike[str],
    *,
    select: str = "",
    every: int = 1,
    superpose: bool = False,
    overwrite: bool = False,
) -> Converted:
    """Writes the frames of an H5MD file, or of an ensemble, in the format that `output` asks for.

    Parameters
    ----------
    source, output : path
        An ensemble is a folder of ``pliant ensemble``, or the ``ensemble.pliant`` in it.
        Endings of `output`: .pdb, .ent, .cif, .mmcif, .dcd, .xtc, .trr, .xyz.
    select : str
        Atoms that are written; "": all.
    every : int
        Only each so manyth frame, from the first.
    superpose : bool
        Each frame is laid on the first, by least squares over the atoms that are written.
    overwrite : bool
        Replace an existing file.

    Raises
    ------
    OptionError
        The format is not known, or `select` chooses nothing.
    MissingPackageError
        MDAnalysis is needed and not there.
    InputError, FileError
        The files cannot be read or written. `output` is then as it was before.
    """
    ending = pathlib.Path(output).suffix.lower()
    if ending not in FORMATS:
        known = ", ".join(FORMATS)
        raise OptionError(f"{os.fspath(output)}: expected a name that ends in {known}")
    name, write = FORMATS[ending]
    if write is _write_with_mdanalysis:
        need(f"writing {name}", "MDAnalysis")
    _refuse(source, output, overwrite)
    reader = ShardsReader(source) if is_ensemble(source) else _core.H5mdReader(os.fspath(source))
    if len(reader) == 0:
        raise InputError(f"{os.fspath(source)}: holds no frame")
    structure = _structure_of(reader)
    atoms = _chosen(structure, select)
    part = structure if len(atoms) == len(structure) else _part_of(structure, select)
    frames = _frames(reader, atoms, every, superpose)
    count = write(os.fspath(output), part, frames, overwrite)
    return Converted(os.fspath(output), name, count, len(atoms))


def _refuse(
    source: str | os.PathLike[str], output: str | os.PathLike[str], overwrite: bool
) -> None:
    if os.path.exists(source) and os.path.exists(output) and os.path.samefile(source, output):
        raise OptionError(f"{os.fspath(output)}: is both input and output")
    if not overwrite and os.path.exists(output):
        raise _core.FileError(f"{os.fspath(output)}: exists; --overwrite replaces it")


def _structure_of(reader: Reader) -> _core.Structure:
    """The atoms that were recorded; nameless ones of files that have no names."""
    try:
        return reader.structure(0)
    except InputError as error:
        if "no atom table" not in str(error):
            raise
        return _core.Structure(reader.positions(0))


def _chosen(structure: _core.Structure, select: str) -> np.ndarray:
    if not select:
        return np.arange(len(structure))
    atoms: np.ndarray = np.asarray(_core.select_atoms(structure, select), dtype=np.int64)
    if len(atoms) == 0:
        raise OptionError(f'--select "{select}": chooses none of {len(structure)} atoms')
    return atoms


@dataclass
class _Moment:
    """A frame on its way: positions (n, 3) Angstrom, step, time in ps."""

    positions: np.ndarray
    step: int
    time: float


def _part_of(structure: _core.Structure, select: str) -> _core.Structure:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", _core.PliantWarning)  # bonds that a selection cuts are gone
        return structure.select(select)


def _frames(reader: Reader, atoms: np.ndarray, every: int, superpose: bool) -> Iterator[_Moment]:
    fit: Superposition | None = None
    for frame in range(0, len(reader), every):
        positions = np.asarray(reader.positions(frame))[atoms]
        if superpose and fit is None:
            fit = Superposition(positions, np.ones(len(atoms)))
        elif fit is not None:
            positions = fit.apply(positions)
        yield _Moment(positions, reader.step(frame), _time(reader, frame))


def _time(reader: Reader, frame: int) -> float:
    try:
        return reader.time(frame)
    except InputError:  # the file has none
        return float(frame)


def _write_pdb(
    output: str, structure: _core.Structure, frames: Iterator[_Moment], overwrite: bool
) -> int:
    with _core.PdbRecorder(output, structure, overwrite=overwrite) as recorder:
        for moment in frames:
            recorder.record(moment.positions)
    return int(recorder.models)


def _write_cif(
    output: str, structure: _core.Structure, frames: Iterator[_Moment], overwrite: bool
) -> int:
    with (
        _beside(output, overwrite) as path,
        open(path, "w", encoding="utf-8", newline="\n") as file,
    ):
        return write_models(file, structure, (moment.positions for moment in frames))


def _write_with_mdanalysis(
    output: str, structure: _core.Structure, frames: Iterator[_Moment], overwrite: bool
) -> int:
    import MDAnalysis

    from pliant.adapters import to_mdanalysis

    universe = to_mdanalysis(structure)
    options = {"precision": 5} if output.lower().endswith(".xyz") else {}
    count = 0
    with _beside(output, overwrite) as path, warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of boxes and names that are not there
        with MDAnalysis.Writer(path, n_atoms=len(structure), **options) as writer:
            for moment in frames:
                step = universe.trajectory.ts
                step.positions = moment.positions
                step.time, step.frame = moment.time, count
                step.data["step"] = moment.step
                writer.write(universe.atoms)
                count += 1
    return count


_PDB, _CIF = ("PDB, a model a frame", _write_pdb), ("mmCIF, a model a frame", _write_cif)

#: Endings of names -> what they are, and what writes them.
FORMATS = {
    ".pdb": _PDB,
    ".ent": _PDB,
    ".cif": _CIF,
    ".mmcif": _CIF,
    ".dcd": ("DCD", _write_with_mdanalysis),
    ".xtc": ("XTC", _write_with_mdanalysis),
    ".trr": ("TRR", _write_with_mdanalysis),
    ".xyz": ("XYZ", _write_with_mdanalysis),
}


@contextmanager
def _beside(output: str, overwrite: bool) -> Iterator[str]:
    """A name in the folder of `output`, whose file takes its name at the end, or goes."""
    folder, name = os.path.split(os.path.abspath(output))
    if not os.path.isdir(folder):
        raise _core.FileError(f"{output}: the directory {folder} does not exist")
    with tempfile.TemporaryDirectory(prefix=f".{name}.", dir=folder) as own:
        path = os.path.join(own, name)
        yield path
        _take_name(path, output, overwrite)


def _take_name(path: str, output: str, overwrite: bool) -> None:
    if overwrite:
        os.replace(path, output)
        return
    try:
        os.link(path, output)
    except FileExistsError:
        raise _core.FileError(f"{output}: exists; --overwrite replaces it") from None
    except OSError:  # a file system without hard links
        os.rename(path, output)


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
    text = "superpose each frame on the first, by least squares over these atoms"
    add("--superpose", action="store_true", help=text)
    add("--overwrite", action="store_true", help="replace an existing OUT")
    add("--json", action="store_true", help="print what was written as one JSON object")
    add("--quiet", action="store_true", help="print nothing but errors")
    return parser


def _file_name(text: str) -> str:
    if not text:
        raise argparse.ArgumentTypeError("expected the name of a file, found nothing")
    return text


def main(words: Sequence[str] | None = None) -> int:
    """Runs the command; returns its exit code."""
    arguments = make_parser().parse_args(words)
    return console.run_command("convert", lambda: _convert(arguments))


def _convert(arguments: argparse.Namespace) -> int:
    done = convert(
        arguments.file,
        arguments.output,
        select=arguments.select,
        every=arguments.every,
        superpose=arguments.superpose,
        overwrite=arguments.overwrite,
    )
    if arguments.json:
        console.print_json(vars(done))
    elif not arguments.quiet:
        frames = console.counted(done.frames, "frame")
        print(f"{done.path}: {frames} of {done.atoms} atoms, {done.format}")
    return console.EXIT_OK


if __name__ == "__main__":
    sys.exit(main())
