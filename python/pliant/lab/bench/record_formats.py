# SPDX-License-Identifier: MIT
"""What frames cost in each format: bytes, times to write and to read, and how far they are off."""

from __future__ import annotations

import os
import tempfile
import time
import warnings
from collections.abc import Callable, Iterator, Sequence
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

import pliant
from pliant import _core, console
from pliant.lab.bench.record import default_molecule

if TYPE_CHECKING:
    from MDAnalysis import Universe

FRAMES, REPEATS = 200, 5

#: name -> options of H5mdRecorder
H5MD: dict[str, dict[str, Any]] = {
    "H5MD": {},
    "H5MD --compress": {"compress": True},
    "H5MD --single": {"single": True},
    "H5MD --precision 1e-3": {"precision": 1e-3},
    "H5MD --precision 1e-2": {"precision": 1e-2},
    "H5MD --save 'not element H'": {"save": "not element H"},
    "H5MD --save 'name CA'": {"save": "name CA"},
}
#: by MDAnalysis: the extension of the name; XTC keeps 0.01 Angstrom
OTHERS = {"DCD": "dcd", "XTC": "xtc"}


@dataclass
class FormatRow:
    """One format. Times are medians over the rounds."""

    format: str
    atoms: int = 0
    bytes_a_frame: float = 0.0  #: of the whole file
    write_microseconds: float = 0.0  #: a frame, opening and closing the file included
    read_microseconds: float = 0.0  #: a frame, one after another, opening the file included
    off: float = 0.0  #: largest error of a coordinate that is read back, Angstrom


@dataclass
class Formats:
    """All rows, and what they belong to."""

    input: str
    joints: int
    frames: int
    rows: list[FormatRow] = field(default_factory=list)

    def as_json(self) -> dict[str, Any]:
        """All of it as one JSON object."""
        return {"pliant": pliant.__version__, **asdict(self)}


@dataclass
class _Subject:
    """A sampled molecule, and where its files go."""

    model: pliant.MolecularModel
    positions: np.ndarray  #: (F, N, 3)
    folder: Path

    def write(self, name: str) -> Path:
        path = self.folder / f"frames.{OTHERS.get(name, 'h5md')}"
        if name in OTHERS:
            self._write_other(path)
        else:
            self._write_h5md(path, H5MD[name])
        return path

    def _write_h5md(self, path: Path, options: dict[str, Any]) -> None:
        framework, structure = self.model.framework, self.model.structure
        with pliant.H5mdRecorder(
            path, framework, structure=structure, overwrite=True, **options
        ) as recorder:
            for step, positions in enumerate(self.positions):
                recorder.record(pliant.Frame(step, float(step), positions))

    def _write_other(self, path: Path) -> None:
        import MDAnalysis

        universe = MDAnalysis.Universe.empty(self.positions.shape[1], trajectory=True)
        with warnings.catch_warnings(), MDAnalysis.Writer(str(path), len(universe.atoms)) as writer:
            warnings.simplefilter("ignore")  # there is no unit cell
            for positions in self.positions:
                universe.atoms.positions = positions
                writer.write(universe.atoms)

    def kept(self, name: str) -> np.ndarray:
        """The frames of the atoms that this format was asked to keep."""
        save = H5MD.get(name, {}).get("save", "")
        if not save:
            return self.positions
        return self.positions[:, _core.select_atoms(self.model.structure, save)]


def record_formats(
    path: str | os.PathLike[str] = "",
    *,
    frames: int = FRAMES,
    repeats: int = REPEATS,
    folder: str | os.PathLike[str] | None = None,
    progress: Callable[[int, int], None] = lambda *_: None,
) -> Formats:
    """Writes the same sampled frames in each format, in rounds that take turns, and reads them."""
    path = path or default_molecule()
    model = pliant.build_model(pliant.read(path))
    positions = pliant.sample(model, frames).positions
    found = Formats(os.path.basename(os.fspath(path)), positions.shape[1], len(positions))
    found.rows = [FormatRow(name) for name in (*H5MD, *OTHERS)]
    with tempfile.TemporaryDirectory(prefix="pliant-bench-", dir=folder) as own:
        subject = _Subject(model, positions, Path(own))
        times: list[list[tuple[float, float]]] = [[] for _ in found.rows]
        for turn in range(repeats):
            for k, row in enumerate(found.rows):
                progress(turn * len(found.rows) + k, repeats * len(found.rows))
                times[k].append(_measure(subject, row))
    for row, all_times in zip(found.rows, times, strict=True):
        written, read = np.median(all_times, axis=0)
        row.write_microseconds, row.read_microseconds = float(written), float(read)
    return found


def _measure(subject: _Subject, row: FormatRow) -> tuple[float, float]:
    """Microseconds a frame to write and to read; fills in what does not change."""
    start = time.perf_counter()
    path = subject.write(row.format)
    written = time.perf_counter()
    kept = subject.kept(row.format)
    wrote_at = time.perf_counter()
    off = max(
        float(np.abs(read - wanted).max())
        for read, wanted in zip(_read(path, kept.shape[1]), kept, strict=True)
    )
    end = time.perf_counter()
    row.atoms, row.off = kept.shape[1], off
    row.bytes_a_frame = path.stat().st_size / len(kept)
    path.unlink()
    return 1e6 * (written - start) / len(kept), 1e6 * (end - wrote_at) / len(kept)


def _read(path: Path, atoms: int) -> Iterator[np.ndarray]:
    if path.suffix == ".h5md":
        reader = pliant.H5mdReader(path)
        for frame in range(len(reader)):
            yield reader.positions(frame)
        return
    for timestep in _universe(path, atoms).trajectory:
        yield timestep.positions


def _universe(path: Path, atoms: int) -> Universe:
    import MDAnalysis

    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        universe = MDAnalysis.Universe.empty(atoms)
        universe.load_new(str(path))
    return universe


def print_formats(found: Formats) -> None:
    """The table for people."""
    print(f"{found.input}: {found.frames} frames of {found.joints} atoms")
    columns = ["format", "atoms", "bytes a frame", "us to write", "us to read", "off, Angstrom"]
    table = console.Table("", columns)
    table.rows = [_cells(row) for row in found.rows]
    table.print()
    print("bytes of the whole file, divided by its frames; times include opening it and, of")
    print("reading, a comparison of all coordinates; DCD and XTC by MDAnalysis")


def _cells(row: FormatRow) -> Sequence[str]:
    return [
        row.format,
        str(row.atoms),
        f"{row.bytes_a_frame:.0f}",
        f"{row.write_microseconds:.0f}",
        f"{row.read_microseconds:.0f}",
        f"{row.off:.1e}" if row.off else "0",
    ]
