# SPDX-License-Identifier: MIT
"""Pictures."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any

from pliant.base.new_file import new_file

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def save_png(figure: Figure, place: str | os.PathLike[str], dpi: int) -> None:
    """Writes a figure as PNG, in place of an earlier one. Raises FileError as `new_file` does.

    It writes what `savefig` writes, which draws all twice, first for the layout alone.
    """
    from matplotlib.backends.backend_agg import FigureCanvasAgg

    figure.set_dpi(dpi)
    figure.set_facecolor("white")
    canvas: Any = FigureCanvasAgg(figure)
    with new_file(place, overwrite=True) as file:
        canvas.print_png(file, metadata={"Software": None})
