# SPDX-License-Identifier: MIT
"""Molecular flexibility by geometric constraints."""

from pliant._core import __version__

__all__ = ["__version__"]
