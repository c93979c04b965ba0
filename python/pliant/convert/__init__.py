# SPDX-License-Identifier: MIT
"""Frames in a format that other programs read: ``pliant convert``, ``pliant.convert``."""

from typing import TYPE_CHECKING

from pliant._callable_package import make_callable

if TYPE_CHECKING:
    from pliant.convert.command import main
    from pliant.convert.write import FORMATS, Converted, convert

__all__ = ["FORMATS", "Converted", "convert", "main"]

make_callable(
    __name__, {"FORMATS": "write", "Converted": "write", "convert": "write", "main": "command"}
)
