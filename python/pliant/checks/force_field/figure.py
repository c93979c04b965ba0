# SPDX-License-Identifier: MIT
"""Two panels: energies of frames above the start's, and how far minimising moves them."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from pliant.base.plotting import BLUE, DASHED, GREEN, GREY, VERMILION
from pliant.checks.force_field.minimised import LONG, SHORT, ForceFieldReport, Minimised
from pliant.checks.force_field.verdicts import MOST_ABOVE, MOST_MOVED

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.axes import Axes


def note(axes: Axes, text: str, place: tuple[float, float], up: int = 3, **look: Any) -> None:
    """Small text at a share of the width and a height of the data, some points above it."""
    axes.annotate(
        text,
        place,
        (0, up),
        textcoords="offset points",
        fontsize="small",
        **({"xycoords": ("axes fraction", "data")} | look),
    )


def draw_energies(axes: Axes, report: ForceFieldReport) -> None:
    """Strips of frames and of MD, after 100 and after 500 steps, with the limits."""
    places = {(SHORT, 0): 0.0, (SHORT, 1): 0.8, (LONG, 0): 2.0, (LONG, 1): 2.8}
    for (steps, kind), x in places.items():
        structures, colour, _ = _groups(report)[kind]
        values = report.above_start(structures, steps)
        _strip(axes, x, values, colour)
        if len(values) == 0:
            axes.text(x, 0.1, "none", ha="center", fontsize="small", color=GREY)
    for steps, x in ((SHORT, 0.4), (LONG, 2.4)):
        ends, limit = [x - 0.75, x + 0.75], [MOST_ABOVE[steps]] * 2
        axes.plot(ends, limit, color="black", linewidth=1, linestyle=DASHED)
        note(axes, "limit", (x + 0.75, MOST_ABOVE[steps]), xycoords="data", ha="right")
    axes.axhline(0, color=GREY, linewidth=1)
    axes.set(
        ylabel="kJ/mol a residue above the start",
        title="Energy once minimised, start minimised alike",
        xlim=(-0.6, 3.4),
    )
    axes.set_xticks(
        list(places.values()), [f"{_groups(report)[k][2]}\n{s} steps" for s, k in places]
    )


def draw_moves(axes: Axes, report: ForceFieldReport) -> None:
    """How far 100 steps move the alpha carbons of frames, of MD, and of the start."""
    groups = _groups(report)
    for x, (structures, colour, _) in enumerate(groups):
        _strip(axes, x, report.moved(structures), colour)
    if np.isfinite(report.start.moved):
        axes.axhline(report.start.moved, color=VERMILION, linewidth=1.2)
        note(axes, "the start", (0.01, report.start.moved), color=VERMILION)
    axes.axhline(MOST_MOVED, color="black", linewidth=1, linestyle=DASHED)
    note(axes, "limit", (0.99, MOST_MOVED), ha="right")
    top = axes.get_ylim()[1]
    axes.set(
        ylabel="RMSD of alpha carbons (Å)",
        title="What 100 steps of minimising move",
        xlim=(-0.6, 1.6),
        ylim=(0, max(top, 1.2 * MOST_MOVED)),
    )
    axes.set_xticks([0, 1], [name for _, _, name in groups])


def _groups(report: ForceFieldReport) -> list[tuple[Sequence[Minimised], str, str]]:
    return [(report.frames, BLUE, "frames"), (report.dynamics, GREEN, "MD")]


def _strip(axes: Axes, x: float, values: np.ndarray, colour: str) -> None:
    """Points beside each other, their mean as a line; what has no number is left out."""
    finite = values[np.isfinite(values)]
    if len(finite) == 0:
        return
    spread = x + 0.4 * (np.arange(len(finite)) / max(len(finite) - 1, 1) - 0.5)
    axes.plot(spread, finite, "o", color=colour, alpha=0.75, markersize=5, zorder=3)
    axes.plot([x - 0.27, x + 0.27], [finite.mean()] * 2, color=colour, linewidth=2.4, zorder=4)
