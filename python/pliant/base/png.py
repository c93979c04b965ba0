# SPDX-License-Identifier: MIT
"""Pictures."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING

from pliant.base.new_file import new_file

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def save_png(figure: Figure, place: str | os.PathLike[str], dpi: int) -> None:
    """Writes a figure as PNG, in place of an earlier one. Raises FileError as `new_file` does."""
    with new_file(place, overwrite=True) as file:
        figure.savefig(file, format="png", dpi=dpi, metadata={"Software": None})
