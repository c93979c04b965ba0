# SPDX-License-Identifier: MIT
"""Figures of what happens along a run: residuals, sweeps, RMSD, radius of gyration."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.ticker import MaxNLocator

from pliant.measure.stages.parts import Gyration, Residuals, Rmsd, Sweeps
from pliant.report.figures.style import (
    BLUE,
    FAINT,
    GREEN,
    GREY,
    INK,
    ORANGE,
    SKY,
    VERMILION,
    WIDE,
    line_width,
    mark_size,
    new_figure,
)
from pliant.trajectory.kind import ENSEMBLE

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from pliant.measure.stages.analysis import Analysis


#: what a residual of 0 is drawn as on a logarithmic axis
SMALLEST = 1e-17


def residuals(analysis: Analysis) -> Figure:
    """Largest and RMS residual of each frame, the tolerance, and frames beyond it."""
    measured = analysis[Residuals].measured
    found = measured.results
    x, label = analysis.axis
    figure, axes = new_figure()
    width = line_width(len(x))
    largest = np.maximum(found.max_relative, SMALLEST)
    axes.plot(x, largest, color=BLUE, lw=width, label="largest")
    axes.plot(x, np.maximum(found.rms_relative, SMALLEST), color=SKY, lw=width, label="RMS")
    if measured.tolerance_length == 0:
        axes.axhline(measured.tolerance, color=INK, lw=1.1, ls=(0, (5, 3)), label="tolerance")
    _mark_frames(axes, x, largest, analysis)
    axes.set_yscale("log")
    _pad_log(axes, largest, found.rms_relative, measured.tolerance)
    axes.set(xlabel=label, ylabel="|length − rest| / rest", title="Bar residuals")
    _legend_above(axes)
    return figure


def _mark_frames(axes: Axes, x: np.ndarray, largest: np.ndarray, analysis: Analysis) -> None:
    beyond = ~analysis[Residuals].found.within
    given_up = ~analysis.converged if analysis.converged is not None else np.zeros_like(beyond)
    size = mark_size(int(np.count_nonzero(beyond | given_up))) + 14
    groups = (
        (given_up, "x", ORANGE, "not converged"),
        (beyond & ~given_up, "o", VERMILION, "beyond tolerance"),
    )
    for chosen, marker, colour, label in groups:
        if chosen.any():
            axes.scatter(
                x[chosen],
                largest[chosen],
                s=size,
                marker=marker,
                color=colour,
                label=label,
                zorder=4,
            )


def _pad_log(axes: Axes, largest: np.ndarray, rms: np.ndarray, tolerance: float) -> None:
    positive = np.concatenate([largest[largest > SMALLEST], rms[rms > SMALLEST], [tolerance]])
    axes.set_ylim(positive.min() / 3, positive.max() * 4)


def _legend_above(axes: Axes) -> None:
    axes.legend(
        loc="lower right", bbox_to_anchor=(1, 1.01), ncols=5, columnspacing=1.3, handlelength=1.6
    )


def sweeps(analysis: Analysis) -> Figure:
    """Sweeps that resolving took in each recorded step, and how often each number occurs."""
    counts = analysis[Sweeps].counts.astype(float)
    x, label = analysis.axis
    figure, (along, beside) = new_figure(WIDE, 1, 2, sharey=True, width_ratios=[4, 1])
    dots = {"s": mark_size(len(x)) * 0.6, "color": BLUE, "alpha": 0.75, "linewidths": 0}
    along.scatter(x, counts, label="a recorded step", **dots)
    if analysis.converged is not None and not analysis.converged.all():
        bad = ~analysis.converged
        along.scatter(x[bad], counts[bad], s=30, marker="x", color=ORANGE, label="not converged")
    along.axhline(
        counts.mean(), color=INK, lw=1.1, ls=(0, (5, 3)), label=f"mean {counts.mean():.1f}"
    )
    along.set(xlabel=label, ylabel="sweeps in the step", title="Effort")
    along.set_ylim(0, counts.max() * 1.08 + 1)
    along.yaxis.set_major_locator(MaxNLocator(integer=True))
    _legend_above(along)
    _counts_beside(beside, counts.astype(np.int64))
    return figure


def _counts_beside(axes: Axes, counts: np.ndarray) -> None:
    """How many frames took how many sweeps, lying beside the series."""
    width = max(1, int(counts.max() - counts.min()) // 30)
    places, heights = np.unique(counts // width * width, return_counts=True)
    axes.barh(places + 0.5 * (width - 1), heights, height=0.8 * width, color=BLUE)
    axes.set_xlabel("frames")
    axes.xaxis.set_major_locator(MaxNLocator(3, integer=True))


def rmsd(analysis: Analysis) -> Figure:
    """RMSD from the first frame analysed."""
    found, (x, label) = analysis[Rmsd], analysis.axis
    figure, axes = new_figure()
    style = _style(analysis)
    if found.analysed is not None:
        axes.plot(x, found.analysed, color=SKY, label=_analysed_name(analysis), **style)
    axes.plot(x, found.fitted, color=BLUE, label=analysis.fitted_name, **style)
    axes.set(xlabel=label, ylabel="RMSD (Å)", title="Distance from the start")
    axes.set_ylim(bottom=0)
    _legend_above(axes)
    return figure


def _style(analysis: Analysis) -> dict[str, Any]:
    """A line along a path; dots for frames that do not follow each other."""
    if analysis.kind == ENSEMBLE:
        return {
            "lw": 0,
            "marker": "o",
            "mew": 0,
            "ms": 0.5 * mark_size(len(analysis.frames)) ** 0.5,
        }
    return {"lw": line_width(len(analysis.frames))}


def _analysed_name(analysis: Analysis) -> str:
    return "all atoms" if analysis.options.select == "all" else f"atoms '{analysis.options.select}'"


def radius_of_gyration(analysis: Analysis) -> Figure:
    """Radius of gyration along the run, with its mean and standard deviation."""
    found = analysis[Gyration]
    radius = found.radius
    x, label = analysis.axis
    mean, spread = radius.mean(), radius.std()
    figure, axes = new_figure()
    axes.axhspan(mean - spread, mean + spread, color=FAINT, lw=0, zorder=0.5)
    axes.axhline(mean, color=GREY, lw=1, zorder=1, label=f"mean {mean:.2f} ± {spread:.2g} Å")
    axes.plot(x, radius, color=GREEN, **_style(analysis))
    what = "mass-weighted" if found.weights == "mass" else "equal weights"
    axes.set(xlabel=label, ylabel="radius of gyration (Å)", title=f"Size ({what})")
    _legend_above(axes)
    return figure
