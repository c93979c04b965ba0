# SPDX-License-Identifier: MIT
"""Coverage drawn: how near frames come to the other structure, by how far away it is."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING

from pliant._core import InputError
from pliant.base.style import BLUE, DASHED, GREY, VERMILION, figure, save
from pliant.lab.pairs.coverage import Coverage, Nearest
from pliant.lab.pairs.directions import COVERED

if TYPE_CHECKING:
    from matplotlib.axes import Axes

DRAWN = {"ANM": VERMILION, "reach": BLUE}  #: ensembles, if they were measured
NAMES = {"reach": "Pliant (sampler reach)"}  #: in the legend, of those that are no name by itself


def draw(found: Coverage, path: str | os.PathLike[str]) -> None:
    """Writes a PNG. Raises InputError where nothing was measured."""
    kinds = list(dict.fromkeys(row.kind for row in found.rows))
    if not kinds:
        raise InputError("--output: no direction was measured")
    most = max(row.frames for row in found.rows)
    with figure(1, len(kinds), panel=(4.6, 4.0)) as (plot, axes):
        for kind, panel in zip(kinds, axes[0], strict=True):
            _panel(panel, [r for r in found.rows if (r.kind, r.frames) == (kind, most)])
        save(plot, path)


def _panel(axes: Axes, rows: list[Nearest]) -> None:
    kind, frames = rows[0].kind, rows[0].frames
    furthest = 1.05 * max(row.at_start for row in rows)
    axes.plot(
        [0, furthest], [0, furthest], color=GREY, linestyle=DASHED, label="no nearer than the start"
    )
    within = f"within {COVERED[kind]:g} Å: found"
    axes.axhspan(0, COVERED[kind], color=GREY, alpha=0.25, linewidth=0, label=within)
    for name in DRAWN if any(row.ensemble in DRAWN for row in rows) else {rows[0].ensemble: BLUE}:
        mine = [row for row in rows if row.ensemble == name]
        if not mine:
            continue
        covered = sum(row.is_covered for row in mine)
        axes.plot(
            [row.at_start for row in mine],
            [row.nearest for row in mine],
            "o",
            color=DRAWN.get(name, BLUE),
            markersize=5,
            label=f"{NAMES.get(name, name)}: {covered} of {len(mine)} found",
        )
    axes.set(
        title=f"{kind}, {frames} frames",
        xlabel="distance between the two known structures (Å)",
        ylabel="distance of the nearest frame (Å)",
        xlim=(0, furthest),
        ylim=(0, furthest),
    )
    axes.legend(frameon=False, loc="upper left")
