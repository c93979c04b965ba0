# SPDX-License-Identifier: MIT
"""The look of all figures: colours that colour-blind readers tell apart, quiet axes, PNG."""

from __future__ import annotations

import itertools
import os
import textwrap
from collections.abc import Iterator, Sequence
from contextlib import AbstractContextManager, contextmanager
from typing import TYPE_CHECKING, Any

import numpy as np

from pliant.base.extras import needed_by
from pliant.base.png import save_png

with needed_by("pliant.base.style"):
    from matplotlib import rc_context
    from matplotlib.figure import Figure
    from matplotlib.layout_engine import ConstrainedLayoutEngine

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.cm import ScalarMappable

# M. Okabe, K. Ito, Color Universal Design (2008); grey for what is only a frame of reference.
BLUE = "#0072B2"
ORANGE = "#E69F00"
VERMILION = "#D55E00"
GREEN = "#009E73"
SKY = "#56B4E9"
PURPLE = "#CC79A7"
GREY = "#8A929B"
INK = "#2B333B"
FAINT = "#E3E7EB"

PALETTE = (BLUE, GREEN, VERMILION, ORANGE, PURPLE, SKY)
#: of domains, largest first, as the 3-D view has them (apps/play/page/view/colours.mjs); more than
#: sixteen, up to the twenty there can be, share them
DOMAIN_COLOURS = 2 * (
    *(BLUE, ORANGE, GREEN, PURPLE, SKY, VERMILION, "#F0E442", "#332288"),
    *("#8020F0", "#802020", "#A8F0A8", "#A8A850", "#A850F0", "#A82080", "#A85020", "#A82050"),
)

#: perceptually even and readable without colour (J. Nunez et al., PLoS ONE 13 (2018) e0199239)
MAP = "cividis"

WIDE = (6.4, 2.75)  #: inches: a figure as wide as a page
PANEL = (5.4, 3.6)  #: of several
DPI = 150
DASHED = (0, (4, 2))

_SETTINGS: dict[Any, Any] = {
    "font.family": "DejaVu Sans",
    "font.size": 9.5,
    "axes.titlesize": 10.5,
    "axes.titleweight": "bold",
    "axes.titlelocation": "left",
    "axes.titlecolor": INK,
    "axes.titlepad": 12,  # above the names of chains
    "axes.titley": 1.0,  # else it is looked for at each drawing, below what stands above the axes
    "axes.labelcolor": INK,
    "axes.edgecolor": GREY,
    "axes.linewidth": 0.8,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "axes.axisbelow": True,
    "axes.formatter.useoffset": False,
    "grid.color": FAINT,
    "grid.linewidth": 0.8,
    "xtick.color": INK,
    "ytick.color": INK,
    "xtick.major.size": 0,
    "ytick.major.size": 0,
    "text.color": INK,
    "legend.frameon": False,
    "legend.fontsize": 9,
    "legend.borderaxespad": 0.2,
    "lines.linewidth": 1.3,
    "lines.solid_capstyle": "round",
    "figure.facecolor": "white",
    "savefig.facecolor": "white",
    "figure.constrained_layout.use": True,
}


def styled() -> AbstractContextManager[None]:
    """Context in which figures are made and saved."""
    return rc_context(_SETTINGS)


def new_figure(
    size: tuple[float, float] = WIDE, rows: int = 1, columns: int = 1, **options: Any
) -> tuple[Figure, Any]:
    """A Figure and its axes; no window and no global state are involved."""
    figure = Figure(figsize=size)
    return figure, figure.subplots(rows, columns, **options)


def panels(
    rows: int, columns: int, title: str = "", panel: tuple[float, float] = PANEL
) -> tuple[Figure, Any]:
    """A figure and its (rows, columns) panels of that size, under a title."""
    width, height = panel[0] * columns, panel[1] * rows
    size = width, height + 0.5 * bool(title)
    figure, axes = new_figure(size, rows, columns, squeeze=False)
    if title:
        figure.suptitle(textwrap.fill(title, int(10 * width)), fontsize=11)
    return figure, axes


@contextmanager
def figure(*shape: Any, **options: Any) -> Iterator[tuple[Figure, Any]]:
    """`panels`, drawn and saved within the context, in our style."""
    with styled():
        yield panels(*shape, **options)


def save(plot: Figure, path: str | os.PathLike[str]) -> None:
    """Writes a PNG; makes the folder if it is missing."""
    if folder := os.path.dirname(os.fspath(path)):
        os.makedirs(folder, exist_ok=True)
    save_png(plot, path, DPI)


def pad(figure: Figure, width: float) -> None:
    """Leaves more room, in inches, beside the panels of a figure."""
    engine = figure.get_layout_engine()
    assert isinstance(engine, ConstrainedLayoutEngine)
    engine.set(w_pad=width)


def colour_bar(axes: Axes, drawn: ScalarMappable, label: str) -> None:
    """What the colours of an image or of dots mean, beside the axes."""
    bar = axes.figure.colorbar(drawn, ax=axes, label=label, pad=0.02, aspect=30)
    bar.outline.set_visible(False)


def legend_above(axes: Axes, *drawn: Any) -> None:
    """Names what is drawn, above it on the right; drawn: handles and names, instead of its own."""
    place: dict[str, Any] = {"loc": "lower right", "bbox_to_anchor": (1, 1.01), "ncols": 5}
    axes.legend(*drawn, columnspacing=1.3, handlelength=1.6, **place)


def line_width(count: int) -> float:
    """Thinner lines for longer series, so that they stay lines."""
    return 1.4 if count <= 500 else 0.9 if count <= 5000 else 0.5


def mark_size(count: int) -> int:
    """Smaller marks for more of them."""
    return 22 if count <= 300 else 10 if count <= 3000 else 3


def named_bars(
    axes: Axes, names: Sequence[str], values: np.ndarray, colours: str | np.ndarray
) -> None:
    """One bar for each name."""
    axes.bar(np.arange(len(values)), values, color=colours, width=0.72)
    named_axis(axes, names)


def named_axis(axes: Axes, names: Sequence[str]) -> None:
    """Labels each place of the axis with a name."""
    slanted = max(map(len, names)) * len(names) > 90
    axes.set_xticks(np.arange(len(names)), names, rotation=90 if slanted else 0, fontsize=8)
    axes.grid(False, axis="x")
    axes.margins(x=0.01)


def chain_axis(axes: Axes, numbers: np.ndarray, chains: np.ndarray, what: str = "residue") -> None:
    """Labels the axis of residues (or atoms), one after the other; chains are named above."""
    starts = [0, *(np.flatnonzero(chains[1:] != chains[:-1]) + 1).tolist(), len(chains)]
    for first, last in itertools.pairwise(starts):
        if len(starts) > 2 and chains[first]:
            place, across = (first + last - 1) / 2, axes.get_xaxis_transform()
            look: dict[str, Any] = {"ha": "center", "va": "bottom", "color": GREY, "fontsize": 8}
            axes.text(place, 1.0, chains[first], transform=across, **look)
    ticks = _round_numbers(numbers)
    axes.set_xticks(ticks, [str(numbers[tick]) for tick in ticks])
    axes.margins(x=0.01)
    axes.set_xlabel(f"{what} number")


def _round_numbers(numbers: np.ndarray, wanted: int = 9) -> np.ndarray:
    """Places of the numbers that are multiples of 1, 2, 5, 10, 20 ...: about `wanted` of them."""
    for step in (factor * 10**power for power in range(8) for factor in (1, 2, 5)):
        places = np.flatnonzero(np.asarray(numbers) % step == 0)
        if len(places) <= wanted:
            return places
    return np.zeros(0, dtype=np.int64)
