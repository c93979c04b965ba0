# SPDX-License-Identifier: MIT
"""How what will go in a later version says so: one warning, with what to use."""

from __future__ import annotations

import warnings

from pliant._core import PliantWarning


class PliantDeprecationWarning(PliantWarning, DeprecationWarning):
    """Something works as before, and will not in the next major version."""


def warn_deprecated(name: str, since: str, instead: str) -> None:
    """Warns the caller of the function that calls this.

    Parameters
    ----------
    name : str
        What is deprecated, as the caller wrote it.
    since : str
        The version that deprecated it.
    instead : str
        What to use.
    """
    text = f"{name} is deprecated since {since}: use {instead}"
    warnings.warn(text, PliantDeprecationWarning, stacklevel=3)
