# SPDX-License-Identifier: MIT
"""What is to be done once another package is imported, by whomever: no import before its time."""

from __future__ import annotations

import importlib
import importlib.util
import sys
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Sequence
    from importlib.abc import Loader, MetaPathFinder
    from importlib.machinery import ModuleSpec
    from types import ModuleType
else:
    # At run time these bases would only cost: importlib.abc imports tempfile and twenty more.
    Loader = MetaPathFinder = object


def import_after(package: str, module: str) -> None:
    """Import `module` right after `package`, or now if `package` is there already."""
    if package in sys.modules:
        importlib.import_module(module)
    else:
        sys.meta_path.insert(0, _Finder(package, module))


class _Finder(MetaPathFinder):
    """Finds one package as the other finders do, but with a loader that does more. Once only."""

    def __init__(self, package: str, module: str) -> None:
        self._package = package
        self._module = module

    def find_spec(
        self, name: str, path: Sequence[str] | None, target: ModuleType | None = None
    ) -> ModuleSpec | None:
        if name != self._package:
            return None
        sys.meta_path.remove(self)
        spec = importlib.util.find_spec(name)
        if spec is not None and spec.loader is not None:
            spec.loader = _Loader(spec.loader, self._module)
        return spec


class _Loader(Loader):
    """Loads a package, then imports a module that builds on it."""

    def __init__(self, loader: Loader, module: str) -> None:
        self._loader = loader
        self._module = module

    def __getattr__(self, name: str) -> object:
        return getattr(self._loader, name)

    def create_module(self, spec: ModuleSpec) -> ModuleType | None:
        return self._loader.create_module(spec)

    def exec_module(self, module: ModuleType) -> None:
        module.__loader__ = self._loader
        if module.__spec__ is not None:
            module.__spec__.loader = self._loader
        self._loader.exec_module(module)
        importlib.import_module(self._module)
