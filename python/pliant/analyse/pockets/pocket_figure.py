# SPDX-License-Identifier: MIT
"""The volume of each pocket against the frame."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pliant.analyse.figures.style import BLUE, FAINT, INK, ORANGE, WIDE, new_figure
from pliant.analyse.kind import ENSEMBLE
from pliant.analyse.pockets.pocket_volumes import PocketVolumes

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from pliant.analyse.analysis import Analysis


def pocket_volume_figure(analysis: Analysis) -> Figure:
    """One panel a pocket: frames around the start and others, and the start's volume as a line."""
    part, (x, label) = analysis[PocketVolumes], analysis.axis
    count, x = len(part.pockets), x[part.places]
    far = np.zeros(len(x), bool) if analysis.reaches is None else analysis.reaches[part.places]
    size = (WIDE[0], 0.5 + 1.25 * count)
    figure, axes = new_figure(size, count, 1, sharex=True, squeeze=False)
    marks = {"lw": 0, "marker": "o", "ms": 3.5, "mew": 0}
    for panel, pocket in zip(axes[:, 0], part.pockets, strict=True):
        start, error = pocket.at_start, pocket.error
        panel.axhspan(start - error, start + error, color=FAINT, lw=0)
        panel.axhline(start, color=INK, lw=1.1, ls=(0, (5, 3)), label="start")
        if analysis.kind == ENSEMBLE:
            panel.plot(x[~far], pocket.volumes[~far], color=BLUE, label="around the start", **marks)
            if far.any():
                panel.plot(
                    x[far], pocket.volumes[far], color=ORANGE, label="further from it", **marks
                )
        else:
            panel.plot(x, pocket.volumes, color=BLUE)
        ends = [pocket.smallest, pocket.largest]
        panel.plot(x[ends], pocket.volumes[ends], lw=0, marker="o", ms=8, mfc="none", mec=INK)
        panel.set(ylabel="Å³", title=pocket.name)
        panel.set_ylim(0, 1.12 * max(pocket.volumes.max(), start + error))
    axes[-1, 0].set_xlabel(label)
    place = {"loc": "lower right", "bbox_to_anchor": (1, 1.01), "ncols": 3}
    axes[0, 0].legend(columnspacing=1.3, handlelength=1.6, **place)
    return figure
