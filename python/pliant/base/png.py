# SPDX-License-Identifier: MIT
"""Pictures."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING

from pliant.base.extras import late
from pliant.base.new_file import new_file

if TYPE_CHECKING:
    from matplotlib.figure import Figure

agg, pil = map(late, ("matplotlib.backends.backend_agg", "PIL.Image"))

#: of 1 to 9: more takes longer than it saves
COMPRESSION = 4


def save_png(figure: Figure, place: str | os.PathLike[str], dpi: int) -> None:
    """Writes a figure as PNG, in place of an earlier one. Raises FileError as `new_file` does.

    `savefig` draws all twice, first for the layout alone, and takes longer to write more bytes.
    """
    figure.set_dpi(dpi)
    figure.set_facecolor("white")
    canvas = agg.FigureCanvasAgg(figure)
    canvas.draw()
    size = canvas.get_width_height()  # nothing is transparent
    drawn = pil.frombuffer("RGBA", size, canvas.buffer_rgba(), "raw", "RGBA", 0, 1)
    with new_file(place, overwrite=True) as file:
        drawn.convert("RGB").save(file, "png", compress_level=COMPRESSION, dpi=(dpi, dpi))
