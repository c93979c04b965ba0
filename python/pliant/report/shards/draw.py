# SPDX-License-Identifier: MIT
"""The figure of an ensemble's report: how flexible each residue is, and whether halves agree."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from pliant.base.png import save_png
from pliant.report.figures.flexibility_figures import NAMED_BARS, chain_parts
from pliant.report.figures.style import (
    BLUE,
    GREY,
    ORANGE,
    SKY,
    chain_axis,
    named_axis,
    new_figure,
    styled,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from pliant.measure.stages.parts import Units
    from pliant.shards.flexibility import EnsembleFlexibility

SIZE = (9, 3.2)  #: inches; the legend stands beside the lines


def draw_flexibility(found: EnsembleFlexibility, path: Path, dpi: int) -> Path:
    """Writes the figure as a PNG."""
    with styled():
        save_png(flexibility_figure(found), path, dpi)
    return path


def flexibility_figure(found: EnsembleFlexibility) -> Figure:
    """RMSF of each unit with twice its error, and of both halves."""
    figure, axes = new_figure(SIZE)
    for k, part in enumerate(chain_parts(found.units.chains)):
        _draw_part(axes, found, part, is_first=k == 0)
    _label_axis(axes, found.units)
    axes.set_ylabel("RMSF (Å)")
    axes.set_ylim(0, 1.04 * float((found.rmsf + 2 * found.error).max()) or 1.0)
    axes.legend(loc="upper left", bbox_to_anchor=(1.0, 1.0))
    if found.still:
        axes.set_title("Nothing moves")
    return figure


def _draw_part(axes: Axes, found: EnsembleFlexibility, part: slice, is_first: bool) -> None:
    """The lines of a chain; the first is named in the legend."""
    place = np.arange(len(found.rmsf))[part]
    low, high = found.rmsf - 2 * found.error, found.rmsf + 2 * found.error
    what = found.what
    names = [
        f"all {found.walkers} {what}",
        f"even-numbered {what}",
        f"odd-numbered {what}",
        f"2 standard errors, between {what}",
    ]
    labels = names if is_first else [None] * len(names)
    axes.plot(place, found.rmsf[part], color=BLUE, label=labels[0])
    for half, colour, label in zip(found.halves, (ORANGE, GREY), labels[1:3], strict=True):
        axes.plot(place, half[part], color=colour, lw=0.8, label=label)
    axes.fill_between(
        place, np.maximum(low[part], 0), high[part], color=SKY, alpha=0.45, lw=0, label=labels[3]
    )


def _label_axis(axes: Axes, units: Units) -> None:
    if len(units.labels) <= NAMED_BARS:
        named_axis(axes, units.labels)
        axes.set_xlabel(units.what)
    else:
        chain_axis(axes, units.numbers, units.chains, units.what)
