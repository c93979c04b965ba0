# SPDX-License-Identifier: MIT
"""Modules that were moved or renamed: their old names are imported still, with a warning."""

from __future__ import annotations

import importlib
import importlib.abc
import importlib.util
import sys
import warnings
from importlib.machinery import ModuleSpec
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Sequence
    from types import CodeType, ModuleType

#: Old names and new ones, of packages with all that is in them; the longest that fits counts.
MOVED = {
    "pliant.analysis.sequence": "pliant._sequence",  # 0.3.0
    "pliant.lab.peers.child": "pliant._openmm.child",  # 0.3.0
    "pliant.lab.peers.measure": "pliant._bars",  # 0.3.0
    "pliant.lab.peers.worker": "pliant._openmm.worker",  # 0.3.0
    "pliant.lab.thesis": "pliant._weightings",  # 0.3.0
    "pliant.bench": "pliant.lab.bench",  # 0.2.0, as all below
    "pliant.bench.run_subcommands": "pliant.lab.bench.subcommands",
    "pliant.cli_analyse": "pliant.analyse.command",
    "pliant.comparison": "pliant.compare",
    "pliant.experiment": "pliant.lab.experiment",
    "pliant.openmm_check": "pliant.check",
    "pliant.peers": "pliant.lab.peers",
    "pliant.peers.child": "pliant._openmm.child",
    "pliant.peers.measure": "pliant._bars",
    "pliant.peers.worker": "pliant._openmm.worker",
    "pliant.report": "pliant.analyse",
    "pliant.report.page": "pliant.analyse.page.page",
    "pliant.report.scene": "pliant.analyse.page.scene",
}


def new_name(name: str) -> str:
    """The name that a module bears now; the same if it was not moved."""
    old = name
    while old and old not in MOVED:
        old = old.rpartition(".")[0]
    return MOVED[old] + name.removeprefix(old) if old else name


def keep_old_names() -> None:
    """Has old names imported as the modules that they became: the same objects, no copies."""
    sys.meta_path.insert(0, _Finder())


class _Finder(importlib.abc.MetaPathFinder):
    """Finds modules by their old names."""

    def find_spec(
        self, name: str, path: Sequence[str] | None, target: ModuleType | None = None
    ) -> ModuleSpec | None:
        """The module by its new name; None if it was not moved or is not there."""
        moved = new_name(name)
        if moved == name or (spec := importlib.util.find_spec(moved)) is None:
            return None
        is_package = spec.submodule_search_locations is not None
        return ModuleSpec(name, _Loader(moved), origin=spec.origin, is_package=is_package)


class _Loader(importlib.abc.InspectLoader):
    """Gives the module of the new name, and warns whoever imports the old one."""

    def __init__(self, moved: str) -> None:
        self._moved = moved

    def exec_module(self, module: ModuleType) -> None:
        """Puts the module of the new name in the place of `module`, which stays empty."""
        warnings.warn(f"{module.__name__} is now {self._moved}", DeprecationWarning, stacklevel=2)
        sys.modules[module.__name__] = importlib.import_module(self._moved)

    def get_code(self, fullname: str) -> CodeType | None:
        """For ``python -m``: the code of the new name."""
        spec = importlib.util.find_spec(self._moved)
        assert spec is not None and isinstance(spec.loader, importlib.abc.InspectLoader)
        return spec.loader.get_code(self._moved)

    def get_source(self, fullname: str) -> str | None:
        """For tracebacks: the text of the new name."""
        spec = importlib.util.find_spec(self._moved)
        assert spec is not None and isinstance(spec.loader, importlib.abc.InspectLoader)
        return spec.loader.get_source(self._moved)
