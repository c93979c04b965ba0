# SPDX-License-Identifier: MIT
"""Figures of where a molecule moves: RMSF of atoms and residues, and principal components."""

from __future__ import annotations

import itertools
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from pliant.analyse.figures.style import (
    BLUE,
    FAINT,
    GREY,
    INK,
    MAP,
    ORANGE,
    SKY,
    WIDE,
    line_width,
    mark_size,
    new_figure,
    pad,
)
from pliant.analyse.names import atom_labels, chains_of, numbers_of, residue_labels
from pliant.analyse.study import known
from pliant.analysis.rotatable import is_hydrogen

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from MDAnalysis.analysis.base import Results

    from pliant.analyse.study import Study


#: up to this many bars are drawn one by one, each with its name
NAMED_BARS = 40


def rmsf_atoms(study: Study) -> Figure:
    """RMSF of each atom: named bars for a small molecule, a line for a large one."""
    values = known(study.rmsf).results.rmsf
    figure, axes = new_figure()
    if len(values) <= NAMED_BARS:
        hydrogen = is_hydrogen(study.atoms)
        _named_bars(axes, atom_labels(study.atoms), values, np.where(hydrogen, SKY, BLUE))
        if hydrogen.any() and not hydrogen.all():
            _legend_of(axes, {"hydrogens": SKY, "other atoms": BLUE})
        axes.set_xlabel("atom")
    else:
        axes.fill_between(np.arange(len(values)), values, color=FAINT, lw=0)
        axes.plot(np.arange(len(values)), values, color=BLUE, lw=line_width(len(values)))
        axes.set_xlabel("atom (index from 0)")
        axes.margins(x=0.01)
    axes.set(ylabel="RMSF (Å)", title="Mobility of the atoms")
    axes.set_ylim(bottom=0)
    return figure


def rmsf_residues(study: Study) -> Figure:
    """RMSF of each residue, chain after chain."""
    found = known(study.rmsf).results
    residues = study.universe.residues[found.residues]
    chains = chains_of(residues)
    figure, axes = new_figure()
    if len(residues) <= NAMED_BARS:
        names = residue_labels(residues)
        _named_bars(axes, names, found.residue_rmsf, BLUE)
        axes.set_xlabel("residue")
    else:
        _chain_lines(axes, numbers_of(residues), chains, found.residue_rmsf)
    axes.set(ylabel="RMSF (Å)", title="Mobility of the residues")
    axes.set_ylim(bottom=0)
    return figure


def _named_bars(
    axes: Axes, names: Sequence[str], values: np.ndarray, colours: str | np.ndarray
) -> None:
    axes.bar(np.arange(len(values)), values, color=colours, width=0.72)
    slanted = max(map(len, names)) * len(names) > 90
    axes.set_xticks(np.arange(len(values)), names, rotation=90 if slanted else 0, fontsize=8)
    axes.grid(False, axis="x")
    axes.margins(x=0.01)


def _legend_of(axes: Axes, entries: Mapping[str, str]) -> None:
    for label, colour in entries.items():
        axes.bar([0], [0], color=colour, label=label)
    axes.legend(loc="lower right", bbox_to_anchor=(1, 1.01), ncols=2)


def _chain_lines(axes: Axes, numbers: np.ndarray, chains: np.ndarray, values: np.ndarray) -> None:
    """One line for each chain; along the axis chains follow each other."""
    starts = [0, *(np.flatnonzero(chains[1:] != chains[:-1]) + 1), len(chains)]
    places = np.arange(len(values))
    for k, (first, last) in enumerate(itertools.pairwise(starts)):
        part = slice(first, last)
        axes.fill_between(places[part], values[part], color=FAINT, lw=0)
        axes.plot(places[part], values[part], color=(BLUE, ORANGE)[k % 2], lw=1.3)
        if len(starts) > 2 and chains[first]:
            axes.text(
                (first + last - 1) / 2, 1.0, chains[first], ha="center", va="bottom",
                transform=axes.get_xaxis_transform(), color=GREY,
            )  # fmt: skip
    ticks = _round_numbers(numbers)
    axes.set_xticks(ticks, [str(numbers[tick]) for tick in ticks])
    axes.margins(x=0.01)
    axes.set_xlabel("residue number")


def _round_numbers(numbers: np.ndarray, wanted: int = 9) -> np.ndarray:
    """Places of the numbers that are multiples of 1, 2, 5, 10, 20 ...: about `wanted` of them."""
    for step in (factor * 10**power for power in range(8) for factor in (1, 2, 5)):
        places = np.flatnonzero(np.asarray(numbers) % step == 0)
        if len(places) <= wanted:
            return places
    return np.zeros(0, dtype=np.int64)


def principal_components(study: Study) -> Figure:
    """The frames along the first two components, and how much each component explains."""
    found = known(study.pca).results
    count = min(10, len(found.explained))
    x, label = study.axis
    figure, (plane, scree) = new_figure((WIDE[0], 3.1), 1, 2, width_ratios=[1.3, 1])
    pad(figure, 0.1)
    _projection(figure, plane, found, x[:: study.pca_stride], label)
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


def _projection(figure: Figure, plane: Axes, found: Results, x: np.ndarray, label: str) -> None:
    first = found.projections[:, 0]
    one_only = found.projections.shape[1] < 2
    second = np.zeros_like(first) if one_only else found.projections[:, 1]
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
    shares = [f"PC{k + 1} (Å), {100 * share:.0f} %" for k, share in enumerate(found.explained[:2])]
    plane.set(xlabel=shares[0], ylabel=shares[1] if len(shares) > 1 else "", title="Path in PCA")
    plane.set_aspect("equal", adjustable="datalim")
    bar = figure.colorbar(dots, ax=plane, label=label, pad=0.02, aspect=30)
    bar.outline.set_visible(False)
