# SPDX-License-Identifier: MIT
"""Names of a package whose modules need more than NumPy and h5py: imported when they are used."""

from __future__ import annotations

import importlib
import sys
from typing import TYPE_CHECKING, Any

from pliant.base.extras import needed_by

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping


def late_names(package: str, where: Mapping[str, str]) -> Callable[[str], Any]:
    """The ``__getattr__`` of a package (PEP 562): `where` has the module of each late name.

    A name is looked for once. Raises MissingPackageError if its module needs what is not installed.
    """

    def find(name: str) -> Any:
        if name not in where:
            raise AttributeError(f"module '{package}' has no attribute '{name}'")
        with needed_by(f"{package}.{name}", inside=True):
            value = getattr(importlib.import_module(where[name]), name)
        setattr(sys.modules[package], name, value)
        return value

    return find
