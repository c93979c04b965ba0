# SPDX-License-Identifier: MIT
"""The volume of each pocket against the frame."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from pliant.measure.pockets.pocket_volumes import Pocket, PocketVolumes
from pliant.report.figures.style import BLUE, FAINT, GREY, INK, ORANGE, WIDE, new_figure
from pliant.trajectory.kind import ENSEMBLE

if TYPE_CHECKING:
    from matplotlib.artist import Artist
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from pliant.measure.stages.analysis import Analysis

DOTS: dict[str, Any] = {"lw": 0, "marker": "o", "ms": 3.5, "mew": 0}
CROSSES: dict[str, Any] = {"lw": 0, "marker": "x", "ms": 4, "color": GREY, "clip_on": False}


def pocket_volume_figure(analysis: Analysis) -> Figure:
    """One panel a pocket: frames around the start and others, and the start's volume as a line."""
    part, (x, label) = analysis[PocketVolumes], analysis.axis
    count, x = len(part.pockets), x[part.places]
    far = np.zeros(len(x), bool) if analysis.reaches is None else analysis.reaches[part.places]
    size = (WIDE[0], 0.5 + 1.25 * count)
    figure, axes = new_figure(size, count, 1, sharex=True, squeeze=False)
    named: dict[str, Artist] = {}
    for panel, pocket in zip(axes[:, 0], part.pockets, strict=True):
        _draw_start(panel, pocket)
        if analysis.kind == ENSEMBLE:
            _draw_dots(panel, pocket, x, far)
        else:
            panel.plot(x, np.where(pocket.is_gap, np.nan, pocket.volumes), color=BLUE)
            _draw(panel, x, 0 * x, pocket.is_gap, "a gap", CROSSES)
        ends = [pocket.smallest, pocket.largest]
        panel.plot(x[ends], pocket.volumes[ends], lw=0, marker="o", ms=8, mfc="none", mec=INK)
        handles, names = panel.get_legend_handles_labels()
        named |= dict(zip(names, handles, strict=True))
    axes[-1, 0].set_xlabel(label)
    place = {"loc": "lower right", "bbox_to_anchor": (1, 1.01), "ncols": 4}
    axes[0, 0].legend(named.values(), named, columnspacing=1.3, handlelength=1.6, **place)
    return figure


def _draw_start(panel: Axes, pocket: Pocket) -> None:
    start, error = pocket.at_start, pocket.error
    panel.axhspan(start - error, start + error, color=FAINT, lw=0)
    panel.axhline(start, color=INK, lw=1.1, ls=(0, (5, 3)), label="start")
    panel.set(ylabel="Å³", title=pocket.name)
    panel.set_ylim(0, 1.12 * max(pocket.volumes[pocket.largest], start + error, 1.0))


def _draw_dots(panel: Axes, pocket: Pocket, x: np.ndarray, far: np.ndarray) -> None:
    gap, volumes = pocket.is_gap, pocket.volumes
    _draw(panel, x, volumes, ~far & ~gap, "around the start", DOTS | {"color": BLUE})
    _draw(panel, x, volumes, far & ~gap, "further from it", DOTS | {"color": ORANGE})
    _draw(panel, x, 0 * x, gap, "a gap", CROSSES)


def _draw(
    panel: Axes, x: np.ndarray, y: np.ndarray, some: np.ndarray, label: str, style: dict[str, Any]
) -> None:
    if some.any():
        panel.plot(x[some], y[some], label=label, **style)
