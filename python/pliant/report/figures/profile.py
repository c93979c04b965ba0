# SPDX-License-Identifier: MIT
"""Lines along the residues of chains: how far each moves, with its error, and domains."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from pliant.base import style
from pliant.measure.domains import LOOSE

if TYPE_CHECKING:
    from matplotlib.axes import Axes

#: up to this many units are drawn one by one, each with its name
NAMED_BARS = 40
#: of a line; more cannot be seen apart at the usual width and resolution
MOST_CORNERS = 4000


def draw_profile(
    axes: Axes,
    chains: np.ndarray,
    values: np.ndarray,
    error: np.ndarray | None = None,
    halves: Sequence[np.ndarray] | np.ndarray = (),
    names: Sequence[str] = (),
) -> None:
    """A value of each unit, twice its error as a band, and that of both halves; a line a chain.

    chains: (n,) of the units; names: of values, halves and error in the legend.
    """
    place = np.arange(len(values))
    looks = ((style.BLUE, 1.3), (style.ORANGE, 0.8), (style.GREY, 0.8))
    for part in chain_parts(chains):
        labels = itertools.chain(names, itertools.repeat(None))
        for line, (colour, width) in zip([values, *halves], looks, strict=False):
            x, y = outline(place[part], line[part])
            axes.plot(x, y, color=colour, lw=width, label=next(labels))
        if error is not None:
            low, high = values[part] - 2 * error[part], values[part] + 2 * error[part]
            x, low = outline(place[part], np.maximum(low, 0))
            _, high = outline(place[part], high)
            label = next(labels)
            axes.fill_between(x, low, high, color=style.SKY, alpha=0.45, lw=0, label=label)
        names = ()


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
    """The stretches of units that are of one chain, or of one of whatever is given of each."""
    edges = np.flatnonzero(chains[1:] != chains[:-1]) + 1
    starts = [0, *edges.tolist(), len(chains)]
    return [slice(a, b) for a, b in itertools.pairwise(starts)]


def domain_strip(axes: Axes, domain: np.ndarray) -> None:
    """A line along the axis in the colours of the domains (n,) of the units."""
    look: dict[str, Any] = {"lw": 6, "solid_capstyle": "butt"}
    for part in chain_parts(domain):
        if domain[part.start] != LOOSE:
            ends, place = [part.start - 0.5, part.stop - 0.5], axes.get_xaxis_transform()
            colour = style.DOMAIN_COLOURS[domain[part.start]]
            axes.plot(ends, [0.012, 0.012], color=colour, transform=place, **look)
