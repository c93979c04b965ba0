# SPDX-License-Identifier: MIT
"""Ranked conformers of small molecules: ``pliant conformers``, ``pliant.conformers``."""

from typing import TYPE_CHECKING

from pliant._callable_package import make_callable

if TYPE_CHECKING:
    from pliant._core import conformers
    from pliant.conformers.results import Conformers

__all__ = ["Conformers", "conformers"]

make_callable(__name__, {"conformers": "pliant._core", "Conformers": "results"})
