# SPDX-License-Identifier: MIT
"""Figures of what is flexible and what moves together."""

from __future__ import annotations

import itertools
from typing import TYPE_CHECKING, Any

import numpy as np

from pliant.measure.collective import participation
from pliant.measure.domains import LOOSE
from pliant.measure.stages.parts import (
    Components,
    ContactFrequencies,
    Correlations,
    Distances,
    RigidDomains,
    UnitFlexibility,
    Units,
    UnitsInComponents,
)
from pliant.report.figures.style import (
    BLUE,
    DOMAIN_COLOURS,
    FAINT,
    GREY,
    INK,
    ORANGE,
    SKY,
    WIDE,
    chain_axis,
    named_bars,
    new_figure,
)
from pliant.trajectory.kind import TRANSITION

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from pliant.measure.stages.analysis import Analysis

#: up to this many units are drawn one by one, each with its name
NAMED_BARS = 40
#: of a line; more cannot be seen apart at the usual width and resolution
MOST_CORNERS = 4000
#: sites up to which each pair is drawn as a square; more take a hundred bytes each
MOST_SQUARES = 500


def flexibility(analysis: Analysis) -> Figure:
    """RMSF of each unit with twice its error; the halves where they do not agree. The way from one
    structure to another is one: it has neither."""
    found, units = analysis[UnitFlexibility].found, analysis[Units]
    figure, axes = new_figure()
    if len(units.labels) <= NAMED_BARS:
        named_bars(axes, units.labels, found.rmsf, BLUE)
        axes.set_xlabel(units.what)
    else:
        _lines(axes, analysis)
    axes.set_ylabel("RMSF (Å)")
    if analysis.kind == TRANSITION:
        axes.set_title(f"How far {units.what}s move on the way")
        axes.set_ylim(0, 1.04 * float(found.rmsf.max()) or 1.0)
    else:
        _errors(axes, analysis)
    return figure


def _lines(axes: Axes, analysis: Analysis) -> None:
    found, units = analysis[UnitFlexibility].found, analysis[Units]
    place = np.arange(len(found.rmsf))
    for part in chain_parts(units.chains):
        axes.plot(*outline(place[part], found.rmsf[part]), color=BLUE, lw=1.3)
    _domain_strip(axes, analysis)
    chain_axis(axes, units.numbers, units.chains, units.what)


def _errors(axes: Axes, analysis: Analysis) -> None:
    found, units = analysis[UnitFlexibility].found, analysis[Units]
    if len(units.labels) <= NAMED_BARS:
        place = np.arange(len(found.rmsf))
        axes.errorbar(place, found.rmsf, 2 * found.error, fmt="none", ecolor=INK, lw=1, capsize=2)
    else:
        _bands(axes, analysis)
    agree = "halves agree" if found.converged else "not converged: halves differ"
    error = f"2 standard errors {2 * found.error.mean():.1g} Å on average"
    axes.set_title(f"Flexibility: {agree}, {error}")
    axes.set_ylim(0, 1.04 * float((found.rmsf + 2 * found.error).max()) or 1.0)


def _bands(axes: Axes, analysis: Analysis) -> None:
    found, units = analysis[UnitFlexibility].found, analysis[Units]
    place = np.arange(len(found.rmsf))
    for part in chain_parts(units.chains):
        band = found.rmsf[part] - 2 * found.error[part], found.rmsf[part] + 2 * found.error[part]
        low, high = outline(place[part], np.maximum(band[0], 0)), outline(place[part], band[1])
        axes.fill_between(*low, high[1], color=SKY, alpha=0.45, lw=0)
        if not found.converged:
            for half, colour in zip(found.halves, (ORANGE, GREY), strict=True):
                axes.plot(*outline(place[part], half[part]), color=colour, lw=0.8)


def outline(place: np.ndarray, values: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """What to draw of a long line: the lowest and highest value of each stretch, as many as there
    are dots across a figure. A line with more corners takes memory and shows no more."""
    stretch = 2 * len(values) // MOST_CORNERS
    if stretch < 2:
        return place, values
    count = len(values) // stretch * stretch
    rows = values[:count].reshape(-1, stretch)
    ends = np.stack([rows.min(axis=1), rows.max(axis=1)], axis=1).ravel()
    first = place[:count:stretch]
    at = np.stack([first, first + stretch // 2], axis=1).ravel()
    return np.append(at, place[count:]), np.append(ends, values[count:])


def chain_parts(chains: np.ndarray) -> list[slice]:
    """The stretches of units that are of one chain; chains: (n,) of each."""
    edges = np.flatnonzero(chains[1:] != chains[:-1]) + 1
    starts = [0, *edges.tolist(), len(chains)]
    return [slice(a, b) for a, b in itertools.pairwise(starts)]


def _domain_strip(axes: Axes, analysis: Analysis) -> None:
    """A line of the domains' colours along the axis, where there are several."""
    domains = analysis.get(RigidDomains)
    if domains is None or domains.found.count < 2:
        return
    domain = domains.of_unit
    edges = [0, *(np.flatnonzero(np.diff(domain)) + 1).tolist(), len(domain)]
    for first, last in itertools.pairwise(edges):
        if domain[first] != LOOSE:
            axes.plot(
                [first - 0.5, last - 0.5],
                [0.012, 0.012],
                lw=6,
                solid_capstyle="butt",
                color=DOMAIN_COLOURS[domain[first]],
                transform=axes.get_xaxis_transform(),
            )


def together(analysis: Analysis) -> Figure:
    """The correlation matrix, with the domains along its edge."""
    matrix, units = analysis[Correlations].matrix, analysis[Units]
    figure, axes = new_figure((4.9, 4.1))
    colours: dict[str, Any] = {"cmap": "PuOr_r", "vmin": -1, "vmax": 1}
    edges = np.arange(len(matrix) + 1) * units.site_stride - 0.5
    if len(matrix) <= MOST_SQUARES:
        image = axes.pcolormesh(edges, edges, matrix, rasterized=True, **colours)
    else:
        extent = (edges[0], edges[-1], edges[0], edges[-1])
        rounded = matrix.astype(np.float32)
        image = axes.imshow(rounded, origin="lower", extent=extent, **colours)
    if len(units.labels) <= NAMED_BARS:
        place = np.arange(len(units.labels))
        axes.set_xticks(place, units.labels, rotation=90, fontsize=7)
        axes.set_yticks(place, units.labels, fontsize=7)
    else:
        chain_axis(axes, units.numbers, units.chains, units.what)
        axes.set_yticks(axes.get_xticks(), [t.get_text() for t in axes.get_xticklabels()])
        axes.set_ylabel(f"{units.what} number")
    _domain_strip(axes, analysis)
    axes.set(title="What moves together", aspect="equal")
    axes.grid(False)
    bar = figure.colorbar(image, ax=axes, label="correlation of displacements", pad=0.02, aspect=30)
    bar.outline.set_visible(False)
    return figure


def motions(analysis: Analysis) -> Figure:
    """How far each of the first three components moves each unit."""
    found, units = analysis[Components].found, analysis[Units]
    count, moved = min(3, len(found.eigenvalues)), analysis[UnitsInComponents].units
    chains = units.chains[moved]
    figure, axes = new_figure((WIDE[0], 0.6 + 1.15 * count), count, 1, sharex=True, squeeze=False)
    for k, row in enumerate(axes[:, 0]):
        share = participation(found.components[k : k + 1])[0]
        height = np.sqrt(share * found.eigenvalues[k])
        for part in chain_parts(chains):
            place = np.arange(len(height))[part]
            place, heights = outline(place, height[part])
            row.fill_between(place, heights, color=FAINT, lw=0)
            row.plot(place, heights, color=BLUE, lw=1.2)
        row.set_ylabel(f"PC{k + 1} (Å)")
        row.set_ylim(bottom=0)
        share = f"{100 * found.explained[k]:.0f} % of the motion"
        place = row.transAxes
        row.text(0.995, 0.93, share, ha="right", va="top", transform=place, fontsize=8.5, color=INK)
    chain_axis(axes[-1, 0], units.numbers[moved], chains)
    axes[0, 0].set_title("Collective motions: what each moves")
    return figure


def contacts(analysis: Analysis) -> Figure:
    """The contact map: share of frames above the diagonal, the start structure below."""
    found, units = analysis[ContactFrequencies], analysis[Units]
    figure, axes = new_figure((4.9, 4.1))
    first, second = found.pairs.T
    start = found.at_start
    size = float(np.clip(900 / len(units.labels), 1.0, 14))
    axes.scatter(second[start], first[start], s=size, c=GREY, marker="s", lw=0)
    seen = found.share > 0
    c = 100 * found.share[seen]
    dots = axes.scatter(
        first[seen], second[seen], c=c, s=size, marker="s", lw=0, cmap="cividis_r", vmin=0, vmax=100
    )
    ends = -0.5, len(units.labels) - 0.5
    axes.plot(ends, ends, color=FAINT, lw=1)
    chain_axis(axes, units.numbers, units.chains)
    axes.set_yticks(axes.get_xticks(), [t.get_text() for t in axes.get_xticklabels()])
    axes.set(xlim=ends, ylim=ends, aspect="equal", ylabel="residue number", title="Contacts")
    bar = figure.colorbar(dots, ax=axes, label="kept (% of frames)", pad=0.02, aspect=30)
    bar.outline.set_visible(False)
    return figure


def distances(analysis: Analysis) -> Figure:
    """How often each distance that was asked for was taken."""
    found = analysis[Distances]
    count = len(found.ends)
    figure, axes = new_figure((WIDE[0], 1.9 * count + 0.4), count, 1, squeeze=False)
    for row, (first, second), values in zip(axes[:, 0], found.ends, found.values, strict=True):
        row.hist(values, bins="sqrt", color=BLUE, rwidth=0.92)
        row.axvline(values.mean(), color=INK, lw=1.1, ls=(0, (5, 3)))
        row.set(xlabel="distance (Å)", ylabel="frames", title=f"{first} to {second}")
    return figure
