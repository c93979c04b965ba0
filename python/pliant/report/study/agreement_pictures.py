# SPDX-License-Identifier: MIT
"""Pictures of a structure that was fitted to data: over START, and residue by residue."""

from __future__ import annotations

import numpy as np
from matplotlib.collections import LineCollection
from matplotlib.figure import Figure

from pliant.base import style
from pliant.report.figures.profile import draw_profile
from pliant.report.sections.shape_pictures import draw_shape, seen
from pliant.report.study.data_fit import DataFit

SIZE = (4.4, 2.9)  #: inches


def fitted_picture(fit: DataFit) -> Figure:
    """The fitted structure over START, with the distances."""
    pair = seen(fit.start[fit.atoms], fit.turns)
    figure, axes = style.new_figure(SIZE)
    axes.set_axis_off()
    draw_shape(axes, pair, fit.turns)
    ends = pair[1][fit.pairs][..., :2]
    colours = np.where(fit.off, style.VERMILION, style.SKY)
    axes.add_collection(LineCollection(ends, colors=colours, lw=1.8, linestyles="--", zorder=4))
    axes.set_aspect("equal", adjustable="datalim")
    axes.autoscale_view()
    return figure


def residues_picture(fit: DataFit) -> Figure:
    """Along the chain: correlation with the map, and what is determined."""
    density = fit.found.density
    figure, axes = style.new_figure(
        (style.WIDE[0], style.WIDE[1] * (1.6 if density else 1)),
        rows=1 if density is None else 2,
        squeeze=False,
        sharex=True,
    )
    *above, below = axes[:, 0]
    if density is not None:
        names = ("fitted", "START")
        both = density.by_residue, [density.by_residue_at_start]
        draw_profile(above[0], fit.chains, both[0], halves=both[1], names=names)
        above[0].set_ylabel("correlation")
        style.legend_above(above[0])
    draw_profile(below, fit.chains, fit.found.spread)
    below.set_ylim(bottom=0)
    below.set_ylabel("spread of fits (Å)")
    style.chain_axis(below, fit.numbers, fit.found.structure.chains[fit.atoms])
    return figure
