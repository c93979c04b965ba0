# SPDX-License-Identifier: MIT
"""How our figures look: colours for every eye, sizes for page and screen, PNG without a display."""

from __future__ import annotations

import contextlib
import os
import textwrap
from collections.abc import Iterator
from typing import Any

import numpy as np

from pliant.base.extras import needed_by
from pliant.base.png import save_png

with needed_by("pliant.base.plotting"):
    import matplotlib as mpl
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

# Okabe and Ito, "Color universal design" (2008): colour-blind readers see the difference too.
BLUE, VERMILION, GREEN = "#0072B2", "#D55E00", "#009E73"
ORANGE, SKY, PURPLE, GREY = "#E69F00", "#56B4E9", "#CC79A7", "#999999"
PALETTE = (BLUE, GREEN, VERMILION, ORANGE, PURPLE, SKY)
DASHED = (0, (4, 2))
DPI = 150
PANEL = (5.4, 3.6)  #: inches

_STYLE: dict[Any, Any] = {
    "font.size": 9.5,
    "axes.titlesize": 10,
    "axes.titleweight": "bold",
    "axes.titlelocation": "left",
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "grid.alpha": 0.25,
    "grid.linewidth": 0.6,
    "lines.linewidth": 1.6,
    "legend.fontsize": 9,
}


@contextlib.contextmanager
def figure(
    rows: int, columns: int, title: str = "", panel: tuple[float, float] = PANEL
) -> Iterator[tuple[Figure, np.ndarray]]:
    """A figure and its (rows, columns) panels, in our style; draw and save within the context."""
    with mpl.rc_context(_STYLE):
        width, height = panel[0] * columns, panel[1] * rows
        plot = Figure(figsize=(width, height + 0.5 * bool(title)), layout="constrained")
        FigureCanvasAgg(plot)
        if title:
            plot.suptitle(textwrap.fill(title, int(10 * width)), fontsize=11)
        yield plot, plot.subplots(rows, columns, squeeze=False)


def save(plot: Figure, path: str | os.PathLike[str]) -> None:
    """Writes a PNG; makes the folder if it is missing."""
    folder = os.path.dirname(os.fspath(path))
    if folder:
        os.makedirs(folder, exist_ok=True)
    save_png(plot, path, DPI)
