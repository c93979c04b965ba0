# SPDX-License-Identifier: MIT
"""How many sweeps over all bars each recorded step took."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from pliant.base import style
from pliant.measure.stages.analysis import Analysis
from pliant.measure.stages.parts import Part
from pliant.report.section import Picture
from pliant.report.sections.headings import EXACT
from pliant.report.sections.measured import Measured, has


@dataclass(frozen=True)
class Sweeps(Part):
    """Sweeps that resolving each frame took."""

    counts: np.ndarray  #: (F,)


def _measure(analysis: Analysis) -> Iterator[Sweeps]:
    """The sweeps that the run counted."""
    counts = analysis.observable("sweeps")
    if counts is None:
        raise ValueError("the file holds no /observables/sweeps")
    yield Sweeps(counts)


def _draw(analysis: Analysis) -> Figure:
    """Sweeps of each recorded step, and how often each number occurs."""
    counts = analysis[Sweeps].counts.astype(float)
    x, label = analysis.axis
    figure, (along, beside) = style.new_figure(style.WIDE, 1, 2, sharey=True, width_ratios=[4, 1])
    dots = {"s": style.mark_size(len(x)) * 0.6, "color": style.BLUE, "alpha": 0.75, "linewidths": 0}
    along.scatter(x, counts, label="a recorded step", **dots)
    if analysis.converged is not None and not analysis.converged.all():
        bad = ~analysis.converged
        along.scatter(
            x[bad], counts[bad], s=30, marker="x", color=style.ORANGE, label="not converged"
        )
    mean = counts.mean()
    along.axhline(mean, color=style.INK, lw=1.1, ls=(0, (5, 3)), label=f"mean {mean:.1f}")
    along.set(xlabel=label, ylabel="sweeps in the step", title="Effort")
    along.set_ylim(0, counts.max() * 1.08 + 1)
    along.yaxis.set_major_locator(MaxNLocator(integer=True))
    style.legend_above(along)
    _counts_beside(beside, counts.astype(np.int64))
    return figure


def _counts_beside(axes: Axes, counts: np.ndarray) -> None:
    """How many frames took how many sweeps, lying beside the series."""
    width = max(1, int(counts.max() - counts.min()) // 30)
    places, heights = np.unique(counts // width * width, return_counts=True)
    axes.barh(places + 0.5 * (width - 1), heights, height=0.8 * width, color=style.BLUE)
    axes.set_xlabel("frames")
    axes.xaxis.set_major_locator(MaxNLocator(3, integer=True))


SWEEPS = Measured(
    stage="sweeps",
    measure=_measure,
    heading=EXACT,
    applies=has(Sweeps),
    values=lambda analysis: {
        "sweeps_mean": float(np.mean(analysis[Sweeps].counts)),
        "sweeps_max": int(np.max(analysis[Sweeps].counts)),
    },
    pictures=[
        Picture(
            "sweeps", _draw, "How many sweeps over all bars it took to mend each recorded step."
        )
    ],
)
