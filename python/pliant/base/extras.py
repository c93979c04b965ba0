# SPDX-License-Identifier: MIT
"""Optional packages: where one is missing, one line says so, with the pip command. Modules that are
imported when they are used."""

from __future__ import annotations

import contextlib
import importlib.util
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Iterator

#: Packages by the name under which they are imported: what people call them, and the extra of
#: pyproject.toml that brings them.
_EXTRAS = {
    "MDAnalysis": ("MDAnalysis", "analysis"),
    "anywidget": ("anywidget", "notebook"),
    "dask": ("Dask", "ensemble"),
    "dask_jobqueue": ("dask-jobqueue", "ensemble"),
    "distributed": ("dask.distributed", "ensemble"),
    "matplotlib": ("matplotlib", "plot"),
    "meeko": ("Meeko", "docking"),
    "mdtraj": ("MDTraj", "mdtraj"),
    "openmm": ("OpenMM", "openmm"),
    "parmed": ("ParmEd", "export"),
    "prody": ("ProDy", "prody"),
    "rdkit": ("RDKit", "rdkit"),
    "scipy": ("SciPy", "lab"),
    "tblite": ("tblite", "gfn2"),
    "websockets": ("websockets", "play"),
    "xarray": ("xarray", "zarr"),
    "zarr": ("Zarr", "zarr"),
}


class MissingPackageError(ImportError):
    """An optional package is not installed; the message has the pip command."""


def need(what: str, *packages: str, extra: str = "") -> None:
    """Raises MissingPackageError if `what` lacks one of the packages, without importing any.

    `extra` is what to install; that of the package by default.
    """
    for package in packages:
        if not is_there(package):
            raise _missing(what, package, extra)


@contextlib.contextmanager
def needed_by(what: str, extra: str = "", inside: bool = False) -> Iterator[None]:
    """Imports of packages that are missing raise MissingPackageError within this context.

    `inside`: also where a part of ours that `what` uses has said so of itself.
    """
    try:
        yield
    except (ModuleNotFoundError, MissingPackageError) as error:
        if isinstance(error, MissingPackageError) and not inside:
            raise
        package = (error.name or "").partition(".")[0]
        if package not in _EXTRAS:
            raise
        raise _missing(what, package, extra) from None


class _LateModule:
    def __init__(self, name: str) -> None:
        self.__name__ = name

    def __getattr__(self, name: str) -> Any:
        found = getattr(importlib.import_module(self.__name__), name)
        setattr(self, name, found)  # is looked for once
        return found


def late(module: str) -> Any:
    """A module that is imported when something of it is used: one that is slow to import, or of a
    package that may be missing."""
    return _LateModule(module)


def is_there(package: str) -> bool:
    """Whether a package is installed, without importing it."""
    try:
        return importlib.util.find_spec(package) is not None
    except (ImportError, ValueError):  # hidden by a finder, or by None in sys.modules
        return False


def _missing(what: str, package: str, extra: str) -> MissingPackageError:
    name, usual = _EXTRAS[package]
    return MissingPackageError(
        f'{what} needs {name}: pip install "pliant[{extra or usual}]"', name=package
    )
