# SPDX-License-Identifier: MIT
"""Frames in a format that other programs read: ``pliant convert``, ``pliant.convert``."""

from typing import TYPE_CHECKING

from pliant._callable_package import make_callable

if TYPE_CHECKING:
    from pliant.convert.write import convert

__all__ = ["convert"]

make_callable(__name__, {"convert": "write"})
