# SPDX-License-Identifier: MIT
"""The frames along the principal components."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from pliant.measure.stages.parts import Components
from pliant.report.figures.style import (
    BLUE,
    GREY,
    INK,
    MAP,
    ORANGE,
    WIDE,
    mark_size,
    new_figure,
    pad,
)
from pliant.trajectory.kind import ENSEMBLE

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from MDAnalysis.analysis.base import Results

    from pliant.measure.stages.analysis import Analysis


def principal_components(analysis: Analysis) -> Figure:
    """The frames along the first two components, and how much each component explains."""
    components = analysis[Components]
    found = components.found
    count = min(10, len(found.explained))
    x, label = analysis.axis
    figure, (plane, scree) = new_figure((WIDE[0], 3.1), 1, 2, width_ratios=[1.3, 1])
    pad(figure, 0.1)
    if analysis.kind == ENSEMBLE:
        _cloud(plane, found)
    else:
        _path(figure, plane, found, x[:: components.stride], label)
    numbers = np.arange(1, count + 1)
    scree.bar(numbers, 100 * found.explained[:count], color=BLUE, width=0.7, label="each")
    scree.plot(
        numbers,
        100 * np.cumsum(found.explained[:count]),
        color=ORANGE,
        marker="o",
        ms=4,
        label="together",
    )
    scree.set(xlabel="component", ylabel="share of the variance (%)", title="Scree")
    scree.set_ylim(0, 104)
    scree.set_xticks(numbers)
    scree.grid(False, axis="x")
    scree.legend(loc="center right")
    return figure


def _first_two(found: Results) -> tuple[np.ndarray, np.ndarray]:
    first = found.projections[:, 0]
    one_only = found.projections.shape[1] < 2
    return first, np.zeros_like(first) if one_only else found.projections[:, 1]


def _name_plane(plane: Axes, found: Results, title: str) -> None:
    shares = [f"PC{k + 1} (Å), {100 * share:.0f} %" for k, share in enumerate(found.explained[:2])]
    plane.set(xlabel=shares[0], ylabel=shares[1] if len(shares) > 1 else "", title=title)
    plane.set_aspect("equal", adjustable="datalim")


def _cloud(plane: Axes, found: Results) -> None:
    """Independent frames: dots, in no order."""
    first, second = _first_two(found)
    plane.scatter(first, second, color=BLUE, alpha=0.6, s=mark_size(len(first)), linewidths=0)
    _name_plane(plane, found, "Frames in PCA")


def _path(figure: Figure, plane: Axes, found: Results, x: np.ndarray, label: str) -> None:
    first, second = _first_two(found)
    plane.plot(first, second, color=GREY, alpha=0.45, lw=0.7, zorder=1)
    dots = plane.scatter(first, second, c=x, cmap=MAP, s=mark_size(len(x)), linewidths=0, zorder=2)
    ring: dict[str, Any] = {
        "s": 70,
        "facecolors": "none",
        "edgecolors": INK,
        "linewidths": 1.1,
        "zorder": 3,
    }
    plane.scatter(first[:1], second[:1], label="start", **ring)
    plane.legend(loc="lower right", bbox_to_anchor=(1, 1.01), handletextpad=0.2)
    _name_plane(plane, found, "Path in PCA")
    bar = figure.colorbar(dots, ax=plane, label=label, pad=0.02, aspect=30)
    bar.outline.set_visible(False)
