# SPDX-License-Identifier: MIT
"""Figures of torsion angles: roses of the most mobile ones, and the Ramachandran plot."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pliant.measure.ramachandran import judged
from pliant.measure.stages.names import greek, phi_psi_pairs
from pliant.measure.stages.parts import Torsions
from pliant.report.figures.style import (
    BLUE,
    GREEN,
    GREY,
    INK,
    MAP,
    VERMILION,
    WIDE,
    new_figure,
    pad,
)

if TYPE_CHECKING:
    from matplotlib.figure import Figure
    from matplotlib.projections.polar import PolarAxes

    from pliant.measure.stages.analysis import Analysis
    from pliant.measure.torsions import TorsionDistributions


#: roses drawn at most; tables have all torsions
ROSES = 12
#: of a molecule with more torsions none are drawn: the most mobile are side chains at its surface
MOST_TORSIONS = 100


def most_mobile(torsions: TorsionDistributions, count: int = ROSES) -> np.ndarray:
    """Numbers of the `count` torsions with the largest spread, in their own order."""
    order = np.argsort(-torsions.results.spread, kind="stable")[:count]
    return np.sort(order)


def are_few(analysis: Analysis) -> bool:
    """Whether torsions are few enough to be drawn."""
    return len(analysis[Torsions].measured.torsions) <= MOST_TORSIONS


def torsions(analysis: Analysis) -> Figure:
    """A rose (circular histogram) for each of the most mobile torsions."""
    measured = analysis[Torsions].measured
    chosen = most_mobile(measured)
    columns = min(3, len(chosen))
    rows = -(-len(chosen) // columns)
    polar = {"squeeze": False, "subplot_kw": {"projection": "polar"}}
    figure, axes = new_figure((WIDE[0], 2.1 * rows + 0.4), rows, columns, **polar)
    for place, rose in enumerate(axes.flat):
        if place < len(chosen):
            _rose(rose, measured, chosen[place])
        else:
            rose.set_visible(False)
    pad(figure, 0.12)
    total = len(measured.torsions)
    shown = "" if len(chosen) == total else f": the {len(chosen)} most mobile of {total}"
    figure.suptitle(
        f"Torsions of rotatable bonds{shown}", x=0.01, ha="left", fontsize=10.5, fontweight="bold"
    )
    return figure


def _rose(axes: PolarAxes, torsions: TorsionDistributions, k: int) -> None:
    """Areas are proportional to the share of frames, hence radii to its root."""
    found = torsions.results
    width = np.radians(found.edges[1] - found.edges[0])
    share = found.density[k] * (found.edges[1] - found.edges[0])
    centres = np.radians(0.5 * (found.edges[:-1] + found.edges[1:]))
    axes.set_theta_zero_location("N")
    axes.set_theta_direction(-1)
    axes.bar(centres, np.sqrt(share), width=width, color=BLUE, alpha=0.85, linewidth=0)
    top = np.sqrt(share.max()) * 1.02
    start = np.radians(found.angles[0, k])
    axes.plot([start, start], [0, top], color=VERMILION, lw=1.4)
    axes.set_ylim(0, top)
    axes.set_yticks([])
    axes.set_xticks(np.radians([0, 90, 180, 270]), ["0°", "90°", "180°", "−90°"], fontsize=7.5)
    axes.tick_params(pad=-1, colors=GREY)
    axes.spines["polar"].set_color(GREY)
    axes.spines["polar"].set_linewidth(0.6)
    label = greek(torsions.torsions[k].label)
    axes.set_title(label, fontsize=8.5, fontweight="normal", loc="center", pad=7)


def ramachandran(analysis: Analysis) -> Figure:
    """All phi, psi of a protein in all frames, and where the first frame has them."""
    torsions = analysis[Torsions].measured
    phi, psi = phi_psi_pairs(torsions.torsions)
    angles = torsions.results.angles
    figure, axes = new_figure((4.7, 4.1))
    counts, *_ = np.histogram2d(
        angles[:, phi].ravel(), angles[:, psi].ravel(), bins=72, range=[[-180, 180]] * 2
    )
    shares = np.ma.masked_equal(counts.T / counts.sum() / 25.0 * 1e4, 0)
    edges = np.linspace(-180, 180, 73)
    image = axes.pcolormesh(edges, edges, shares, cmap=MAP + "_r", rasterized=True)
    cells = np.linspace(-180, 180, 361)
    axes.contour(
        cells[:-1] + 0.5,
        cells[:-1] + 0.5,
        judged(*np.meshgrid(cells[:-1] + 0.5, cells[:-1] + 0.5)),
        levels=[0.5, 1.5],
        colors=[VERMILION, GREEN],
        linewidths=0.8,
    )
    x, y = angles[0, phi], angles[0, psi]
    axes.scatter(x, y, s=7, facecolors="none", edgecolors=INK, linewidths=0.5, label="first frame")
    axes.set(xlabel="φ (degrees)", ylabel="ψ (degrees)", title="Ramachandran plot", aspect="equal")
    axes.set_xticks(range(-180, 181, 60))
    axes.set_yticks(range(-180, 181, 60))
    axes.legend(loc="lower right", bbox_to_anchor=(1, 1.01))
    bar = figure.colorbar(
        image, ax=axes, label="share (10⁻⁴ per square degree)", pad=0.02, aspect=30
    )
    bar.outline.set_visible(False)
    return figure
